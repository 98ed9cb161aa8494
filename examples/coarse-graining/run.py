# SPDX-License-Identifier: BSD-3-Clause
"""Raises the gas through one bed of cohesive grains as it is, and as parcels of 8, 27 and 64 grains, with some seeds,
as many runs at a time as there are cores, and ends in a table of what coarse graining changes, figures beside those
expected, and a picture. Runs that are finished are not made again.

    run.py [--ratios 1 2 3 4] [--seeds N ...] [--width METRES] [--cell DIAMETERS] [--out FOLDER] [--overwrite]
           [--build FOLDER] [--together N]
"""

import argparse
from pathlib import Path

import analyse
import picture
from cohesion_studies import expected, program, study_table
from cohesion_studies.case_job import MARK
from cohesion_studies.foam_case import environment
from cohesion_studies.job_pool import RunError, carry_out, require_ours
from cohesion_studies.powder_program import PowderError, PowderProgram
from cohesion_studies.raised_bed import RaisedBed

HERE = Path(__file__).resolve().parent
EXPECTED = HERE / "expected.csv"

# Grains of the thesis's size and density, softer, with a quarter of its cohesion; SI units. The box is a whole number
# of cells at every ratio.
POWDER = {"--diameter": 1e-3, "--density": 2650, "--stiffness": 100, "--hamaker": 2e-19, "--void-fraction": 0.43,
          "--width": 0.036, "--depth": 0.036, "--height": 0.024, "--grains": 1e6}
# Cells over the diameter of what is computed: in three parcels a bed locks to the rows of cells. At a ratio of 4 two do
# not fit the box.
CELL, CELL_OF = 2, {4: 1.8}
# Superficial velocity: from rest to the fastest, and then as it is [m/s, s].
COURSE = {"fastest": 1.2, "ramp": 1.0, "hold": 0.3}


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--ratios", type=float, nargs="+", default=[1, 2, 3, 4], metavar="L",
                        help="diameters of parcels over that of grains (%(default)s)")
    parser.add_argument("--seeds", type=int, nargs="+", default=[1, 2, 3], metavar="N",
                        help="of the places from which they are poured (%(default)s)")
    parser.add_argument("--width", type=float, default=POWDER["--width"], metavar="METRES",
                        help="edge of the box; another one takes a folder of its own, --out (%(default)s)")
    parser.add_argument("--cell", type=float, metavar="DIAMETERS",
                        help="edge of the cells over the diameter of what is computed; takes a folder of its own, too "
                             f"({CELL}, at a ratio of 4 {CELL_OF[4]})")
    parser.add_argument("--overwrite", action="store_true", help="replace runs of other settings")
    program.folder_words(parser, "BUILD/coarse-graining", "cases and results")
    program.together_words(parser)
    return parser.parse_args()


def bed(out, env, powder, ratio, seed, changed=None, course=COURSE):
    """As parcels of the diameter `ratio` over that of grains. `changed`: other options of cohesion-powder."""
    options = {**POWDER, "--cell": CELL_OF.get(ratio, CELL), **(changed or {}), "--coarse-graining": ratio, "--seed": seed}
    return RaisedBed(out / f"l-{ratio:g}-seed-{seed}", f"l {ratio:g}", env, powder, options, course, work=ratio**-4)


def main():
    args = arguments()
    expected.rows(EXPECTED)  # refused before anything is run
    args.build = args.build.resolve()
    out = program.out_folder(args, "coarse-graining").resolve()
    out.mkdir(parents=True, exist_ok=True)
    env, powder = environment(args.build, ["lammps"]), PowderProgram(args.build)
    changed = {"--width": args.width, "--depth": args.width, **({"--cell": args.cell} if args.cell else {})}
    jobs = [bed(out, env, powder, ratio, seed, changed) for seed in args.seeds for ratio in args.ratios]
    require_ours(jobs, MARK, args.overwrite)
    kinds = study_table.by_kind(jobs, carry_out(jobs, args.together))
    program.leave_table(out, study_table.side_by_side(kinds, digits=3) + "\n\n" + analyse.changes(kinds) + "\n\n"
                        + expected.text(EXPECTED, study_table.means_of(kinds)))
    picture.draw(out / "result.png", jobs)


if __name__ == "__main__":
    program.run(main, RunError, PowderError, expected.ExpectationError)
