# SPDX-License-Identifier: BSD-3-Clause
"""Grains that fall through gas in a periodic box, in fine cells and in coarse ones, those with `dragFilter` and without,
as many at a time as there are cores, and ends in a table of the slip beside what is expected of it, and a picture. Boxes
that are finished are not run again.

    run.py [--kinds fine coarse-4 filtered-4 coarse-8 filtered-8] [--seeds N ...] [--time SECONDS] [--out FOLDER]
           [--overwrite] [--build FOLDER] [--together N]
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
CASE, EXPECTED = HERE / "case", HERE / "expected.csv"
BOX, COUPLING = "constant/box", "constant/couplingProperties"

# Edge of a cell over that of a fine one, and the filter
KINDS = {"fine": (1, "none"), "coarse-4": (4, "none"), "filtered-4": (4, "radlSundaresan"), "coarse-8": (8, "none"),
         "filtered-8": (8, "radlSundaresan")}
READERS = (analyse, case_entries, foam_results)  # what the figures depend on besides the run


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--kinds", nargs="+", choices=KINDS, default=list(KINDS), help="of cells (all)")
    parser.add_argument("--seeds", type=int, nargs="+", default=[1, 2, 3, 4, 5], metavar="N",
                        help="of the places from which grains start (%(default)s)")
    parser.add_argument("--time", type=float, default=None, metavar="SECONDS",
                        help="to simulate (that of constant/box, which is what expected.csv is of)")
    parser.add_argument("--overwrite", action="store_true", help="replace boxes of other settings")
    program.folder_words(parser, "BUILD/filtered-drag", "cases and results")
    program.together_words(parser)
    return parser.parse_args()


class Box(CaseJob):
    """One box. `changed`: {entry: value} of constant/box that differ from the case, beside what `kind` and `seed` do."""

    def __init__(self, out, env, mark, kind, seed=1, changed=None):
        coarser, self.filter = KINDS[kind]
        is_of = {**case_entries.entries(CASE / BOX), **(changed or {})}
        cells = {name: round(is_of[name] / coarser) for name in ("columns", "rows")}
        self.changed = {**(changed or {}), **cells, "seed": seed}
        super().__init__(out / f"{kind}-seed-{seed}", kind, env,
                         {"changed": self.changed, "filter": self.filter, "fingerprint": mark}, READERS, CASE,
                         work=is_of["endTime"] * (1 + is_of["columns"] * is_of["rows"] / coarser**2 / 500))

    def change(self):
        self.set_entries({BOX: self.changed, COUPLING: {"dragFilter": self.filter}})
        self.set_entries({BOX: {"drive": repr(analyse.Box(self.folder).drive)}})

    def figures(self):
        return analyse.figures(self.folder)


def main():
    args = arguments()
    expected.rows(EXPECTED)
    args.build = args.build.resolve()
    out = program.out_folder(args, "filtered-drag").resolve()
    env = environment(args.build, ["lammps"])
    mark = fingerprint(CASE, args.build, env)
    changed = {} if args.time is None else {"endTime": args.time}
    jobs = [Box(out, env, mark, kind, seed, changed) for seed in args.seeds for kind in args.kinds]
    require_ours(jobs, MARK, args.overwrite)
    kinds = study_table.by_kind(jobs, carry_out(jobs, args.together))
    means = study_table.means_of(kinds)
    differences = analyse.differences(kinds)
    text = study_table.side_by_side(kinds, digits=3) + "\n\n" + analyse.table(differences)
    # What is expected is of whole runs alone.
    program.leave_table(out, text + ("" if changed else "\n\n" + expected.text(EXPECTED, {**means, **differences})))
    picture.draw(out / "result.png", jobs)
    print(f"ParaView: {out}/*/case.foam")


if __name__ == "__main__":
    program.run(main, RunError, expected.ExpectationError)
