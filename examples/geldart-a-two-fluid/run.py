# SPDX-License-Identifier: BSD-3-Clause
"""A bed of fine powder as two fluids, by OpenFOAM's twoPhaseEulerFoam with the drag and the kinetic theory of this
package: four combinations of gas velocity and drag, as many at a time as there are cores, ending in a table of how far
they expand beside those expected, and a picture. Runs that are finished are not made again.

    run.py [--beds NAME ...] [--time SECONDS] [--step SECONDS] [--cell METRES] [--out FOLDER] [--overwrite]
           [--build FOLDER] [--together N]
"""

import argparse
import json
import re
import subprocess
from pathlib import Path

import numpy as np

import analyse
import picture
from cohesion_studies import case_entries, expected, foam_results, package_tree, program, study_table
from cohesion_studies.build_summary import missing
from cohesion_studies.case_job import MARK
from cohesion_studies.foam_case import FoamCase, environment
from cohesion_studies.job_pool import Job, RunError, carry_out, dies_with_us, digest_of, require_ours

HERE = Path(__file__).resolve().parent
CASE, EXPECTED = HERE / "case", HERE / "expected.csv"
SOLVER, LIBRARY = "twoPhaseEulerFoam", "openfoam/libcohesionTwoFluid.so"
REST, VOID, NOISE = 0.15, 0.4, 0.05  # height [m] and void fraction at the start, and by how much cells differ from it
WIDTH = 0.15

# Superficial velocity [m/s], exponent and factor of Wen and Yu's drag, height of the column [m]
BEDS = {
    "slow-n4.65": {"velocity": 0.009, "dragExponent": 4.65, "dragFactor": 1, "height": 0.4},
    "slow-n9.6": {"velocity": 0.009, "dragExponent": 9.6, "dragFactor": 1, "height": 0.4},
    "fast-n4.65": {"velocity": 0.2, "dragExponent": 4.65, "dragFactor": 1, "height": 0.6},
    "fast-scaled": {"velocity": 0.2, "dragExponent": 4.65, "dragFactor": 0.15, "height": 0.6},
}


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--beds", nargs="+", choices=BEDS, default=list(BEDS), help="(all)")
    parser.add_argument("--time", type=float, default=10.0, metavar="SECONDS", help="to simulate (%(default)s)")
    parser.add_argument("--step", type=float, default=5e-4, metavar="SECONDS", help="(%(default)s)")
    parser.add_argument("--cell", type=float, default=0.005, metavar="METRES", help="edge of a cell (%(default)s)")
    parser.add_argument("--overwrite", action="store_true", help="replace runs of other settings")
    program.folder_words(parser, "BUILD/geldart-a-two-fluid", "cases and results")
    program.together_words(parser)
    return parser.parse_args()


class Bed(Job):
    """One row of BEDS."""

    case = None

    def __init__(self, out, env, build, kind, step, end, cell):
        self.kind, self.env, self.row = kind, env, BEDS[kind]
        self.step, self.end, self.cell = step, end, cell
        mark = digest_of([*CASE.rglob("*"), package_tree.tree(build) / LIBRARY])
        settings = {**self.row, "step": step, "time": end, "cell": cell, "fingerprint": mark}
        readers = digest_of([module.__file__ for module in (analyse, case_entries, foam_results)])
        super().__init__(out / kind, settings, work=self.row["height"] / step * end, readers=readers)

    def edit(self, file, **words):
        path = self.folder / file
        text = path.read_text()
        for name, value in words.items():
            text, found = re.subn(rf"(?m)^(\s*{name}\s+)[^;]*;", lambda m, new=value: f"{m[1]}{new};", text)
            if found != 1:
                raise RunError(f"{path}: {found} entries '{name}'")
        path.write_text(text)

    def prepare(self):
        self.case = FoamCase(CASE, self.folder, self.env, overwrite=True)
        (self.folder / MARK).write_text(json.dumps(self.settings))
        columns, rows = round(WIDTH / self.cell), round(self.row["height"] / self.cell)
        self.edit("system/blockMeshDict", height=self.row["height"], columns=columns, rows=rows)
        self.edit("system/controlDict", deltaT=repr(self.step), endTime=self.end)
        self.edit("constant/gasVelocity", velocity=self.row["velocity"])
        self.edit("constant/phaseProperties", dragExponent=self.row["dragExponent"], dragFactor=self.row["dragFactor"])
        self.case.mesh()
        self.fill(columns, rows)
        (self.folder / "case.foam").touch()

    def fill(self, columns, rows):
        """The bed, in its cells void fractions that differ a little: what is even stays even in two dimensions."""
        noise = np.random.default_rng(1).uniform(-1, 1, (rows, columns))
        y = (np.arange(rows) + 0.5) * self.row["height"] / rows
        void = np.where((y < REST)[:, None], VOID * (1 + NOISE * noise), 1.0).ravel()
        for name, values in (("alpha.air", void), ("alpha.particles", 1 - void)):
            file = self.folder / "0" / name
            words = f"nonuniform List<scalar> {len(values)} ({' '.join(f'{value:.8g}' for value in values)})"
            file.write_text(re.sub(r"internalField uniform \d;", f"internalField {words};", file.read_text()))

    def start(self):
        self.prepare()
        with open(self.case.log(SOLVER), "w") as log:
            return subprocess.Popen(dies_with_us([SOLVER]), cwd=self.folder, env=self.case.env, stdout=log, stderr=log,
                                    stdin=subprocess.DEVNULL)

    def share(self):
        with open(self.case.log(SOLVER), "rb") as log:
            log.seek(0, 2)
            log.seek(max(0, log.tell() - 4000))
            found = re.findall(r"^Time = (\S+)", log.read().decode(errors="replace"), re.M)
        return float(found[-1]) / self.end if found else 0.0

    def tail(self):
        return self.case.tail(SOLVER)

    def figures(self):
        return analyse.figures(self.folder)


def main():
    args = arguments()
    expected.rows(EXPECTED)
    args.build = args.build.resolve()
    out = program.out_folder(args, "geldart-a-two-fluid").resolve()
    reason = missing(package_tree.tree(args.build), LIBRARY, "two-fluid models")
    if reason:
        raise RunError(reason)
    env = environment(args.build)
    jobs = [Bed(out, env, args.build, kind, args.step, args.time, args.cell) for kind in args.beds]
    require_ours(jobs, MARK, args.overwrite)
    kinds = study_table.by_kind(jobs, carry_out(jobs, args.together))
    program.leave_table(out, study_table.side_by_side(kinds, digits=3) + "\n\n"
                        + expected.text(EXPECTED, study_table.means_of(kinds)))
    picture.draw(out / "result.png", [job.folder for job in jobs])
    print(f"ParaView: {out}/*/case.foam")


if __name__ == "__main__":
    program.run(main, RunError, expected.ExpectationError)
