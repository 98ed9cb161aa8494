# SPDX-License-Identifier: BSD-3-Clause
"""Runs a conical spouted bed, dry and wet, LIGGGHTS beside OpenFOAM in the same vessel, as many at a time as there are
cores, and ends in a table beside the expectations, and a picture. Beds that are finished are not run again.

    run.py [--beds dry wet] [--seed N] [--time SECONDS] [--out FOLDER] [--overwrite]
           [--build FOLDER] [--together N]
"""

import argparse
from pathlib import Path

import analyse
import picture
from cohesion_studies import case_entries, expected, foam_results, program, study_table, vtk_screen
from cohesion_studies.case_job import MARK, CaseJob, fingerprint
from cohesion_studies.foam_case import environment
from cohesion_studies.job_pool import RunError, carry_out, require_ours

HERE = Path(__file__).resolve().parent
CASE = HERE / "case"

# Variables of the script. Bridges of water between spheres of 4 mm: pi d times its surface tension [N]; scheme exact
# wants ten steps in the swing of the tangential spring.
BEDS = {"dry": {"bridge": 0, "dt": 2.5e-5}, "wet": {"bridge": 9.05e-4, "dt": 2e-5}}
VARIABLES = "constant/couplingProperties", "liggghtsCoeffs/variables"
WALLS = "(inlet plate sides)"  # patches that are the spheres' mesh
READERS = (analyse, case_entries, foam_results)  # what the figures depend on besides the run


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--beds", nargs="+", choices=BEDS, default=["dry"],
                        help="dry, wet: with bridges of water between the spheres, or both (%(default)s)")
    parser.add_argument("--seed", type=int, default=15485863, metavar="N",
                        help="of the places from which the spheres are poured, a prime above 10000 (%(default)s)")
    parser.add_argument("--time", type=float, default=None, metavar="SECONDS",
                        help="to simulate (that of constant/schedule, which is what expected.csv is of)")
    parser.add_argument("--overwrite", action="store_true", help="replace beds of other settings")
    program.folder_words(parser, "BUILD/spouted-bed", "cases and results")
    program.together_words(parser)
    return parser.parse_args()


class SpoutedBed(CaseJob):
    """One bed. `changed`: {file: {entry: value}} that differ from the case."""

    def __init__(self, out, env, mark, kind, seed, changed=None):
        self.changed, self.variables = changed or {}, {**BEDS[kind], "seed": seed}
        super().__init__(out / kind, kind, env, {**self.variables, "changed": self.changed, "fingerprint": mark}, READERS,
                         CASE)

    def change(self):
        for name, value in self.variables.items():
            self.case.set(VARIABLES[0], f"{VARIABLES[1]}/{name}", value)
        self.set_entries(self.changed)

    def prepare(self):
        """The case with its mesh, and the spheres' wall from the same."""
        super().prepare()
        self.case.run("surfaceMeshExtract", "-constant", "-time", "none", "-patches", WALLS, "wall.stl")

    def figures(self):
        return analyse.figures(self.folder)


def main():
    args = arguments()
    expected.rows(HERE / "expected.csv")
    args.build = args.build.resolve()
    out = program.out_folder(args, "spouted-bed").resolve()
    env = environment(args.build, ["liggghts"])
    vtk_screen.require()
    mark = fingerprint(CASE, args.build, env)
    changed = {} if args.time is None else {"constant/schedule": {"endTime": args.time}}
    jobs = [SpoutedBed(out, env, mark, kind, args.seed, changed) for kind in args.beds]
    require_ours(jobs, MARK, args.overwrite)
    kinds = study_table.by_kind(jobs, carry_out(jobs, args.together))
    # What is expected is of a whole run alone.
    held = "" if changed else "\n\n" + expected.text(HERE / "expected.csv", study_table.means_of(kinds))
    program.leave_table(out, study_table.side_by_side(kinds) + held)
    picture.draw(out / "result.png", [job.folder for job in jobs])
    print(f"ParaView: {out}/*/case.foam, gas and particles together")


if __name__ == "__main__":
    program.run(main, RunError, expected.ExpectationError)
