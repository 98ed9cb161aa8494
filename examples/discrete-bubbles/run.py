# SPDX-License-Identifier: BSD-3-Clause
"""Blows bubbles into a reactor of emulsion, slowly and fast, that merge or do not, as many at a time as there are cores,
and ends in a table beside the expectations, and a picture. Reactors that are finished are not run again.

    run.py [--kinds slow fast slow-merging fast-merging] [--time SECONDS] [--out FOLDER] [--overwrite]
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

# Flow of gas [m3/s], of 1 m2, and the largest diameter that bubbles merge to [m]; below theirs, 0.12 m, none do
KINDS = {"slow": (0.1, 1e-3), "fast": (0.3, 1e-3), "slow-merging": (0.1, 0.3), "fast-merging": (0.3, 0.3)}
REACTOR, MERGE = "constant/reactor", ("constant/couplingProperties", "lammpsCoeffs/variables/merge")
READERS = (analyse, case_entries, foam_results)  # what the figures depend on besides the run


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--kinds", nargs="+", choices=KINDS, default=list(KINDS), help="of reactors (all)")
    parser.add_argument("--time", type=float, default=None, metavar="SECONDS",
                        help="to simulate (that of constant/reactor, which is what expected.csv is of)")
    parser.add_argument("--overwrite", action="store_true", help="replace reactors of other settings")
    program.folder_words(parser, "BUILD/discrete-bubbles", "cases and results")
    program.together_words(parser)
    return parser.parse_args()


class Reactor(CaseJob):
    """One reactor. `changed`: {file: {entry: value}} that differ from the case."""

    def __init__(self, out, env, mark, kind, changed=None):
        flow, merge = KINDS[kind]
        self.changed = {REACTOR: {"flow": flow}, MERGE[0]: {MERGE[1]: merge}}
        for file, entries in (changed or {}).items():
            self.changed[file] = {**self.changed.get(file, {}), **entries}
        super().__init__(out / kind, kind, env, {"changed": self.changed, "fingerprint": mark}, READERS, CASE,
                         work=flow)

    def change(self):
        self.set_entries(self.changed)

    def figures(self):
        return analyse.figures(self.folder)


def main():
    args = arguments()
    expected.rows(HERE / "expected.csv")
    args.build = args.build.resolve()
    out = program.out_folder(args, "discrete-bubbles").resolve()
    env = environment(args.build, ["lammps"])
    vtk_screen.require()
    mark = fingerprint(CASE, args.build, env)
    changed = {} if args.time is None else {REACTOR: {"endTime": args.time, "meanFrom": args.time / 3}}
    jobs = [Reactor(out, env, mark, kind, changed) for kind in args.kinds]
    require_ours(jobs, MARK, args.overwrite)
    kinds = study_table.by_kind(jobs, carry_out(jobs, args.together))
    # What is expected is of whole runs alone.
    held = "" if changed else "\n\n" + expected.text(HERE / "expected.csv", study_table.means_of(kinds))
    program.leave_table(out, study_table.side_by_side(kinds) + held)
    picture.draw(out / "result.png", [job.folder for job in jobs])
    print(f"ParaView: {out}/*/case.foam, emulsion and bubbles together")


if __name__ == "__main__":
    program.run(main, RunError, expected.ExpectationError)
