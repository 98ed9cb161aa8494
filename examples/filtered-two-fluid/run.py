# SPDX-License-Identifier: BSD-3-Clause
"""A fine powder and air as two fluids in a periodic box, by OpenFOAM's twoPhaseEulerFoam with the models of this package,
at some mean solid fractions, as many at a time as there are cores: the drag of squares of cells over that of the law at
their mean values, beside what is expected, and a picture. Runs that are finished are not made again.

    run.py [--fractions PHI ...] [--time SECONDS] [--from SECONDS] [--step SECONDS] [--cells N] [--out FOLDER]
           [--overwrite] [--build FOLDER] [--together N]
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
FRACTIONS = (0.05, 0.15, 0.40)
NOISE = 0.3  # by how much cells differ at the start from the mean: what is even stays even
WRITTEN = 0.05  # seconds between fields, in the case's controlDict


def fraction(text):
    number = float(text)
    if not 0 < number < 0.48:
        raise argparse.ArgumentTypeError(f"{text}: a mean solid fraction must be above 0 and below 0.48, so that no cell "
                                         "begins above that of packed spheres")
    return number


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--fractions", nargs="+", type=fraction, default=FRACTIONS, metavar="PHI",
                        help="mean solid fractions (%(default)s)")
    parser.add_argument("--time", type=float, default=1.2, metavar="SECONDS", help="to simulate (%(default)s)")
    parser.add_argument("--from", type=float, default=0.7, metavar="SECONDS", dest="start",
                        help="the fields from then on are looked at (%(default)s)")
    parser.add_argument("--step", type=float, default=1e-3, metavar="SECONDS", help="(%(default)s)")
    parser.add_argument("--cells", type=program.one_or_more, default=64, metavar="N",
                        help="along an edge of the box, a power of 2 (%(default)s)")
    parser.add_argument("--overwrite", action="store_true", help="replace runs of other settings")
    program.folder_words(parser, "BUILD/filtered-two-fluid", "cases and results")
    program.together_words(parser)
    args = parser.parse_args()
    if args.cells < 2 or args.cells & (args.cells - 1):
        parser.error(f"--cells {args.cells}: must be a power of 2, from 2 on, so that squares fill the box")
    if args.start > args.time - WRITTEN:
        parser.error(f"--from {args.start} leaves less than two of the fields, which are written every {WRITTEN} s to "
                     f"{args.time} s: take an earlier one")
    return args


class Box(TwoFluidJob):
    """Of one mean solid fraction."""

    def __init__(self, out, env, build, phi, cells, step, end, start):
        self.phi, self.cells, self.step, self.begin_at = phi, cells, step, start
        kind = f"box-{phi:.2f}" if round(phi, 2) == phi else f"box-{phi:g}"
        super().__init__(out / kind, kind, env, build, CASE, {"phi": phi, "cells": cells, "step": step, "from": start},
                         end, (analyse, case_entries, foam_results), work=cells**2 * end / step)

    def change(self):
        self.case.edit("system/blockMeshDict", columns=self.cells, rows=self.cells)
        self.case.edit("system/controlDict", deltaT=repr(self.step), endTime=self.end)

    def solid(self):
        return self.phi * (1 + NOISE * np.random.default_rng(1).uniform(-1, 1, self.cells**2))

    def figures(self):
        rows = analyse.by_size(self.folder, self.begin_at)
        found = {"one_cell": rows[0][1]}
        for size, ratio, error in rows:
            found[f"filtered_{size:g}"], found[f"error_{size:g}"] = ratio, error
        return found


def main():
    args = arguments()
    expected.rows(EXPECTED)
    args.build = args.build.resolve()
    out = program.out_folder(args, "filtered-two-fluid").resolve()
    require_library(args.build)
    env = environment(args.build)
    jobs = [Box(out, env, args.build, phi, args.cells, args.step, args.time, args.start) for phi in args.fractions]
    require_ours(jobs, MARK, args.overwrite)
    kinds = study_table.by_kind(jobs, carry_out(jobs, args.together))
    program.leave_table(out, study_table.side_by_side(kinds, digits=3) + "\n\n"
                        + expected.text(EXPECTED, study_table.means_of(kinds)))
    picture.draw(out / "result.png", args.start, [job.folder for job in jobs])
    print(f"ParaView: {out}/*/case.foam")


if __name__ == "__main__":
    program.run(main, RunError, expected.ExpectationError)
