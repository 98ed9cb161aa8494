# SPDX-License-Identifier: BSD-3-Clause
"""Raises the gas through a round column of glass beads, in LAMMPS with a cylinder as its wall and in LIGGGHTS with a
mesh, as many runs at a time as there are cores, and ends in a table, figures beside those expected, and a picture.
Runs that are finished are not made again.

    run.py [--engines lammps liggghts] [--seeds N ...] [--out FOLDER] [--overwrite] [--build FOLDER] [--together N]
"""

import argparse
from pathlib import Path

import numpy as np

import picture
import wall
from cohesion_studies import expected, program, study_table
from cohesion_studies.case_entries import entries
from cohesion_studies.case_job import MARK
from cohesion_studies.foam_case import environment
from cohesion_studies.foam_results import function_table, read_cloud, written_times
from cohesion_studies.job_pool import RunError, carry_out, digest_of, require_ours
from cohesion_studies.powder_program import PowderError, PowderProgram
from cohesion_studies.raised_bed import RaisedBed

HERE = Path(__file__).resolve().parent
EXPECTED = HERE / "expected.csv"
ENGINES = ("lammps", "liggghts")

# Glass beads with asperities, softer than glass; SI units.
BEADS = {"--diameter": 5e-4, "--density": 2500, "--stiffness": 50, "--hamaker": 6.5e-20, "--asperity": 1e-7,
         "--column": 0.018, "--height": 0.016, "--grains": 1e6}
# Superficial velocity: from rest to the fastest, and then as it is [m/s, s].
COURSE = {"fastest": 0.45, "ramp": 0.25, "hold": 0.15}


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--engines", nargs="+", choices=ENGINES, default=list(ENGINES), help="(%(default)s)")
    parser.add_argument("--seeds", type=int, nargs="+", default=[1], metavar="N",
                        help="of the places from which they are poured (%(default)s)")
    parser.add_argument("--overwrite", action="store_true", help="replace runs of other settings")
    program.folder_words(parser, "BUILD/round-column", "cases and results")
    program.together_words(parser)
    return parser.parse_args()


class Column(RaisedBed):
    """The column in an engine."""

    def __init__(self, out, env, powder, engine, seed, changed=None, course=COURSE):
        options = {**BEADS, **(changed or {}), "--seed": seed}
        super().__init__(out / f"{engine}-seed-{seed}", engine, env, powder, options, course, engine=engine,
                         work=1.0 if engine == "lammps" else 2.0)

    def others(self):
        return {"wall": digest_of([wall.__file__])}

    def change(self):
        """LIGGGHTS meets the wall as a mesh."""
        super().change()
        if self.engine == "liggghts":
            size = entries(self.folder / "constant/grains")
            wall.write_stl(self.folder / "column.stl", size["radius"], size["top"])
            script = self.folder / "grains.liggghts"
            script.write_text(wall.as_mesh(script.read_text()))

    def figures(self):
        found = super().figures()
        forces = np.loadtxt(function_table(self.folder, "forces", "forceBudget.dat"))
        held = forces[:, 0] > self.course["ramp"]
        weight = -forces[-1, 4]
        walls, gain = (float(forces[held, column].mean() / weight) for column in (13, 16))
        return {**found, "walls_carry": walls, "gain": gain, "pressure_unaccounted": found["pressure"] - (1 + gain - walls),
                "farthest": farthest(self.folder) / entries(self.folder / "constant/grains")["radius"]}


def farthest(case):
    """From the axis, of any grain's surface at any written time [m]."""
    radius = BEADS["--diameter"] / 2
    return max(float(np.hypot(*read_cloud(folder)[0][:, :2].T).max())
               for time, folder in written_times(case).items() if time > 0) + radius


def main():
    args = arguments()
    expected.rows(EXPECTED)  # refused before anything is run
    args.build = args.build.resolve()
    out = program.out_folder(args, "round-column").resolve()
    out.mkdir(parents=True, exist_ok=True)
    env, powder = environment(args.build, args.engines), PowderProgram(args.build)
    jobs = [Column(out, env, powder, engine, seed) for seed in args.seeds for engine in args.engines]
    require_ours(jobs, MARK, args.overwrite)
    kinds = study_table.by_kind(jobs, carry_out(jobs, args.together))
    program.leave_table(out, study_table.side_by_side(kinds, digits=3) + "\n\n"
                        + expected.text(EXPECTED, study_table.means_of(kinds)))
    picture.draw(out / "result.png", jobs)
    print(f"ParaView: {out}/*/case.foam, gas and particles together")


if __name__ == "__main__":
    program.run(main, RunError, PowderError, expected.ExpectationError)
