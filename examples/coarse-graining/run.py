# SPDX-License-Identifier: BSD-3-Clause
"""Raises the gas through one bed of cohesive grains as it is, and as parcels of 8, 27 and 64 grains, with some seeds,
as many runs at a time as there are cores, and ends in a table of what coarse graining changes, figures beside those
expected, and a picture. Runs that are finished are not made again.

    run.py [--ratios 1 2 3 4] [--seeds N ...] [--out FOLDER] [--overwrite] [--build FOLDER] [--together N]
"""

import argparse
import json
import tempfile
from pathlib import Path

import analyse
import picture
from cohesion_studies import expected, foam_results, program, study_table
from cohesion_studies.foam_case import FoamCase, environment
from cohesion_studies.job_pool import Job, RunError, carry_out, digest_of, require_ours
from cohesion_studies.powder_program import PowderError, PowderProgram

HERE = Path(__file__).resolve().parent
EXPECTED = HERE / "expected.csv"
MARK = "settings.json"  # in the folder of a case that was made here: it may be made anew

# Grains of the thesis's size and density, softer, with a quarter of its cohesion; SI units. The box is a whole number
# of cells at every ratio.
POWDER = {"--diameter": 1e-3, "--density": 2650, "--stiffness": 100, "--hamaker": 2e-19, "--void-fraction": 0.43,
          "--width": 0.036, "--depth": 0.036, "--height": 0.024, "--grains": 1e6}
# Superficial velocity: from rest to FASTEST in the time RAMP, and then as it is for HOLD [m/s, s].
FASTEST, RAMP, HOLD = 1.2, 1.0, 0.3


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--ratios", type=float, nargs="+", default=[1, 2, 3, 4], metavar="L",
                        help="diameters of parcels over that of grains (%(default)s)")
    parser.add_argument("--seeds", type=int, nargs="+", default=[1, 2, 3], metavar="N",
                        help="of the places from which they are poured (%(default)s)")
    parser.add_argument("--overwrite", action="store_true", help="replace runs of other settings")
    program.folder_words(parser, "BUILD/coarse-graining", "cases and results")
    program.together_words(parser)
    return parser.parse_args()


class Bed(Job):
    """The bed as parcels of the diameter `ratio` over that of grains. `changed`: other options of cohesion-powder."""

    def __init__(self, out, env, powder, ratio, seed, changed=None, fastest=FASTEST, ramp=RAMP, hold=HOLD):
        self.env, self.powder, self.kind = env, powder, f"l {ratio:g}"
        self.options = {**POWDER, **(changed or {}), "--coarse-graining": ratio, "--seed": seed}
        self.course = {"fastest": fastest, "ramp": ramp, "hold": hold}
        super().__init__(out / f"l-{ratio:g}-seed-{seed}",
                         {**self.options, **self.course, "program": digest_of([powder.file])},
                         work=ratio**-4,
                         readers=digest_of([analyse.__file__, foam_results.__file__]))

    def start(self):
        with tempfile.TemporaryDirectory() as scratch:
            written = Path(scratch) / "case"
            self.powder.write(written, self.options)
            self.case = FoamCase(written, self.folder, self.env, overwrite=True)
        (self.folder / MARK).write_text(json.dumps(self.settings))
        fastest, ramp, hold = self.course.values()
        course = f"table ((0 (0 0 0)) ({ramp} (0 0 {fastest})) ({ramp + hold} (0 0 {fastest})))"
        self.case.set("0.orig/U", "boundaryField/plate/superficialVelocity", course)
        self.case.set("0.orig/U", "internalField", "uniform (0 0 0)")
        self.case.set("system/controlDict", "endTime", ramp + hold)
        self.case.set("system/controlDict", "writeInterval", (ramp + hold) / 5)
        self.case.mesh()
        (self.folder / "case.foam").touch()  # what ParaView opens
        return self.case.start()

    def figures(self):
        area = self.options["--width"] * self.options["--depth"]
        found = analyse.figures(self.folder, area, self.options, self.course["ramp"])
        known = self.powder.values({**self.options, "--void-fraction": found["void_fraction"]})
        return {**found, "U_mf_of_the_closure": known["u_mf_beetstra"]}

    def share(self):
        progress = self.case.progress()
        return progress[0] if progress else 0.0

    def tail(self):
        return self.case.tail()


def main():
    args = arguments()
    expected.rows(EXPECTED)  # refused before anything is run
    args.build = args.build.resolve()
    out = program.out_folder(args, "coarse-graining").resolve()
    out.mkdir(parents=True, exist_ok=True)
    env, powder = environment(args.build, ["lammps"]), PowderProgram(args.build)
    jobs = [Bed(out, env, powder, ratio, seed) for seed in args.seeds for ratio in args.ratios]
    require_ours(jobs, MARK, args.overwrite)
    kinds = study_table.by_kind(jobs, carry_out(jobs, args.together))
    program.leave_table(out, study_table.side_by_side(kinds, digits=3) + "\n\n" + analyse.changes(kinds) + "\n\n"
                        + expected.text(EXPECTED, study_table.means_of(kinds)))
    picture.draw(out / "result.png", jobs)


if __name__ == "__main__":
    program.run(main, RunError, PowderError, expected.ExpectationError)
