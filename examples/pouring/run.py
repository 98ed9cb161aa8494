# SPDX-License-Identifier: BSD-3-Clause
"""Drops 500 hard spheres in a plane into a box, with several seeds and time steps, as many runs at a time as there
are cores, and ends in a table, figures beside those expected, and a picture. Runs that are finished are not run
again.

    run.py [--build FOLDER] [--out FOLDER] [--seeds N ...] [--together N] [--overwrite]
"""

import argparse
from pathlib import Path

import analyse
import picture
from cohesion_studies import expected, program
from cohesion_studies.expected_study import carry_out_study
from cohesion_studies.job_pool import RunError, digest_of
from cohesion_studies.lammps_run import NotBuilt, ScriptRun, launcher

HERE = Path(__file__).resolve().parent
EXPECTED = HERE / "expected.csv"

# Variables of in.pouring. The columns, 1.5 diameters apart, fill a box 24 diameters wide.
BED = {"count": 500, "columns": 16, "height": 48, "e": 0.9, "mu": 0.3, "time": 0.6}
SPACING = 1.5 * analyse.DIAMETER
STEP = 1e-4  # s; of Hoomans et al.
STEPS = (STEP, STEP / 5, STEP / 2, 2 * STEP)


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--seeds", type=int, nargs="+", default=list(range(1, 11)), metavar="N",
                        help="of the places from which the spheres fall (%(default)s)")
    parser.add_argument("--overwrite", action="store_true", help="replace runs of other settings")
    program.folder_words(parser, "BUILD/pouring")
    program.together_words(parser)
    return parser.parse_args()


class Pouring(ScriptRun):
    """One run of in.pouring."""

    def __init__(self, out, engine, seed, dt, **changed):
        self.given = {**BED, **changed, "seed": seed, "dt": dt}
        self.dt, self.kind = dt, f"dt {dt:g} s"
        self.width = self.given["columns"] * SPACING
        programs = digest_of([HERE / "in.pouring", engine[1]])
        super().__init__(out / f"dt-{dt:g}-seed-{seed}", HERE / "in.pouring", engine,
                         {**self.given, "programs": programs}, work=1 / dt, readers=digest_of([analyse.__file__]))

    def variables(self):
        return self.given

    def figures(self):
        return analyse.figures(self.folder, self.log(), self.width, self.dt)

    def share(self):
        row = self.last_row(columns=9)
        return row[0] * self.dt / self.given["time"] if row else 0.0


def main():
    args = arguments()
    expected.rows(EXPECTED)  # refused before anything is run
    out = program.out_folder(args, "pouring").resolve()
    engine = launcher(args.build)
    jobs = [Pouring(out, engine, seed, dt) for dt in STEPS for seed in args.seeds]
    carry_out_study(jobs, args, out, EXPECTED)
    picture.draw(out / "result.png", jobs)


if __name__ == "__main__":
    program.run(main, NotBuilt, RunError, expected.ExpectationError)
