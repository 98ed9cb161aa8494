# SPDX-License-Identifier: BSD-3-Clause
"""Runs a measured bed at both velocities of the gas, as many at a time as there are cores, and ends in a table of the
comparison with the measured profiles and the expectations, and a picture. Beds that are finished are not run again.

    run.py [--gas 0.6 0.9] [--seeds N ...] [--time SECONDS] [--out FOLDER] [--overwrite] [--build FOLDER]
           [--together N]
"""

import argparse
from pathlib import Path

import analyse
import picture
from cohesion_studies import case_entries, expected, foam_results, program, study_table
from cohesion_studies.case_job import MARK, CaseJob, fingerprint
from cohesion_studies.foam_case import environment
from cohesion_studies.job_pool import RunError, carry_out, require_ours

HERE = Path(__file__).resolve().parent
CASE = HERE / "case"
MEASURED = HERE / "measured.csv"

GAS = ("0.6", "0.9")  # superficial velocities [m/s] with a measurement
SHORTEST = 2  # s
READERS = (analyse, case_entries, foam_results)  # modules that evaluate finished runs


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--gas", nargs="+", choices=GAS, default=list(GAS), metavar="U",
                        help="superficial velocity of the gas [m/s] (%(default)s)")
    parser.add_argument("--seeds", type=int, nargs="+", default=[1], metavar="N",
                        help="of the places from which the spheres are poured (%(default)s)")
    parser.add_argument("--time", type=float, default=None, metavar="SECONDS",
                        help=f"to simulate, {SHORTEST} or more (that of constant/bed, which is what expected.csv is of)")
    parser.add_argument("--overwrite", action="store_true", help="replace beds of other settings")
    program.folder_words(parser, "BUILD/measured-beds", "cases and results")
    program.together_words(parser)
    args = parser.parse_args()
    if args.time is not None and args.time < SHORTEST:
        parser.error(f"--time {args.time:g}: averages begin at 1 s, and their first second ends at {SHORTEST} s")
    return args


class MeasuredBed(CaseJob):
    """One bed. `changed`: entries of constant/bed that differ from the case."""

    def __init__(self, out, env, mark, gas, seed, changed=None):
        self.gas, self.seed, self.changed = gas, seed, changed or {}
        super().__init__(out / f"{gas}-seed-{seed}", gas, env,
                         {"gas": gas, "seed": seed, **self.changed, "fingerprint": mark}, READERS, CASE)

    def change(self):
        for name, value in {"gasVelocity": self.gas, **self.changed}.items():
            self.case.set("constant/bed", name, value)
        self.case.set("constant/couplingProperties", "lammpsCoeffs/variables/seed", self.seed)

    def figures(self):
        return analyse.figures(self.folder, MEASURED)


def main():
    args = arguments()
    expected.rows(HERE / "expected.csv")
    args.build = args.build.resolve()
    out = program.out_folder(args, "measured-beds").resolve()
    env = environment(args.build, ["lammps"])
    mark = fingerprint(CASE, args.build, env, [MEASURED])
    changed = {} if args.time is None else {"endTime": args.time}
    jobs = [MeasuredBed(out, env, mark, gas, seed, changed) for seed in args.seeds for gas in args.gas]
    require_ours(jobs, MARK, args.overwrite)
    kinds = study_table.by_kind(jobs, carry_out(jobs, args.together))
    # What is expected is of the whole time alone.
    held = "" if changed else "\n\n" + expected.text(HERE / "expected.csv", study_table.means_of(kinds))
    program.leave_table(out, study_table.side_by_side(kinds, digits=3) + held)
    picture.draw(out / "result.png", MEASURED, {gas: [job.folder for job in jobs if job.kind == gas] for gas in kinds})
    print(f"ParaView: {out}/*/case.foam, gas and particles together")


if __name__ == "__main__":
    program.run(main, RunError, expected.ExpectationError)
