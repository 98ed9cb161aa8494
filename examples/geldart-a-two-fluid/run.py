# SPDX-License-Identifier: BSD-3-Clause
"""A bed of fine powder as two fluids, by OpenFOAM's twoPhaseEulerFoam with the drag and the kinetic theory of this
package: four combinations of gas velocity and drag, as many at a time as there are cores, ending in a table of how far
they expand beside those expected, and a picture. Runs that are finished are not made again.

    run.py [--beds NAME ...] [--time SECONDS] [--step SECONDS] [--cell METRES] [--out FOLDER] [--overwrite]
           [--build FOLDER] [--together N]
"""

import argparse
from pathlib import Path

import numpy as np

import analyse
import picture
from cohesion_studies import case_entries, expected, foam_results, program, study_table
from cohesion_studies.case_job import MARK
from cohesion_studies.foam_case import environment
from cohesion_studies.job_pool import RunError, carry_out, require_ours
from cohesion_studies.two_fluid_job import TwoFluidJob, require_library

HERE = Path(__file__).resolve().parent
CASE, EXPECTED = HERE / "case", HERE / "expected.csv"
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


class Bed(TwoFluidJob):
    """One row of BEDS."""

    def __init__(self, out, env, build, kind, step, end, cell):
        self.row, self.step, self.cell = BEDS[kind], step, cell
        super().__init__(out / kind, kind, env, build, CASE, {**self.row, "step": step, "cell": cell}, end,
                         (analyse, case_entries, foam_results), work=self.row["height"] / step * end)

    def columns_and_rows(self):
        return round(WIDTH / self.cell), round(self.row["height"] / self.cell)

    def change(self):
        columns, rows = self.columns_and_rows()
        self.case.edit("system/blockMeshDict", height=self.row["height"], columns=columns, rows=rows)
        self.case.edit("system/controlDict", deltaT=repr(self.step), endTime=self.end)
        self.case.edit("constant/gasVelocity", velocity=self.row["velocity"])
        self.case.edit("constant/phaseProperties", dragExponent=self.row["dragExponent"], dragFactor=self.row["dragFactor"])

    def solid(self):
        """The bed, in its cells void fractions that differ a little: what is even stays even in two dimensions."""
        columns, rows = self.columns_and_rows()
        noise = np.random.default_rng(1).uniform(-1, 1, (rows, columns))
        y = (np.arange(rows) + 0.5) * self.row["height"] / rows
        return 1 - np.where((y < REST)[:, None], VOID * (1 + NOISE * noise), 1.0)

    def figures(self):
        return analyse.figures(self.folder)


def main():
    args = arguments()
    expected.rows(EXPECTED)
    args.build = args.build.resolve()
    out = program.out_folder(args, "geldart-a-two-fluid").resolve()
    require_library(args.build)
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
