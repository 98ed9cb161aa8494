# SPDX-License-Identifier: BSD-3-Clause
"""Runs beds of two sizes of glass spheres at two gas velocities, between the minimum fluidisation velocities of the
sizes and above both, with some seeds, and a packed bed of each size alone, as many at a time as there are cores; ends
in a table beside the expectations, and a picture. Beds that are finished are not run again.

    run.py [--kinds between above ...] [--seeds N ...] [--time SECONDS] [--out FOLDER] [--overwrite] [--build FOLDER]
           [--together N]
"""

import argparse
from pathlib import Path

import analyse
import picture
from cohesion_studies import case_entries, ergun, expected, foam_results, program, study_table, vtk_screen
from cohesion_studies.case_job import MARK, CaseJob, fingerprint
from cohesion_studies.foam_case import environment
from cohesion_studies.job_pool import RunError, carry_out, require_ours

HERE = Path(__file__).resolve().parent
CASE = HERE / "case"

# Entries of constant/bed that differ from the case; those of one size have the solid volume of both.
PACKED = {"first": 0.4, "velocity": 0.4, "endTime": 0.1}
KINDS = {"between": {}, "above": {"velocity": 2.0},
         "small": {"small": 4439, "large": 0, **PACKED}, "large": {"small": 0, "large": 959, **PACKED}}
SEED = "constant/couplingProperties", "lammpsCoeffs/variables/seed"
READERS = (analyse, case_entries, ergun, foam_results)  # what the figures depend on besides the run


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--kinds", nargs="+", choices=KINDS, default=list(KINDS),
                        help="between, above: two sizes at that gas velocity; small, large: one size, packed (all)")
    parser.add_argument("--time", type=float, default=None, metavar="SECONDS",
                        help="to simulate of two sizes (that of the case, which is what expected.csv is of)")
    parser.add_argument("--seeds", type=int, nargs="+", default=[1, 2], metavar="N",
                        help="of who is where when the spheres are poured (%(default)s)")
    parser.add_argument("--overwrite", action="store_true", help="replace beds of other settings")
    program.folder_words(parser, "BUILD/binary-mixture", "cases and results")
    program.together_words(parser)
    return parser.parse_args()


class MixedBed(CaseJob):
    """One bed. `changed`: entries of constant/bed that differ from those of its kind."""

    def __init__(self, out, env, mark, kind, seed, changed=None):
        self.seed, self.changed = seed, {**KINDS[kind], **(changed or {})}
        size = {**case_entries.entries(CASE / "constant/bed"), **self.changed}
        super().__init__(out / f"{kind}-seed-{seed}", kind, env,
                         {"kind": kind, **self.changed, "seed": seed, "fingerprint": mark}, READERS, CASE,
                         work=(size["endTime"] + size["settle"]) * (size["small"] + size["large"]))

    @property
    def packed(self):
        return self.kind in ("small", "large")

    def change(self):
        for name, value in self.changed.items():
            self.case.set("constant/bed", name, value)
        self.case.set(*SEED, self.seed)

    def figures(self):
        return (analyse.packed_figures if self.packed else analyse.figures)(self.folder)


def main():
    args = arguments()
    expected.rows(HERE / "expected.csv")
    args.build = args.build.resolve()
    out = program.out_folder(args, "binary-mixture").resolve()
    env = environment(args.build, ["lammps"])
    vtk_screen.require()
    mark = fingerprint(CASE, args.build, env)
    changed = {} if args.time is None else {"endTime": args.time}
    jobs = [MixedBed(out, env, mark, kind, seed, changed if kind in ("between", "above") else None)
            for seed in args.seeds for kind in args.kinds]
    require_ours(jobs, MARK, args.overwrite)
    kinds = study_table.by_kind(jobs, carry_out(jobs, args.together))
    tables = [{kind: found for kind, found in kinds.items() if (kind in ("small", "large")) == packed}
              for packed in (False, True)]
    text = "\n\n".join(study_table.side_by_side(table, digits=3) for table in tables if table)
    # Segregation and means are expected of a whole run alone.
    held = "" if changed else "\n\n" + expected.text(HERE / "expected.csv", study_table.means_of(kinds))
    program.leave_table(out, text + held)
    mixed = [job for job in jobs if not job.packed]
    if mixed:
        picture.draw(out / "result.png", mixed)
    print(f"ParaView: {out}/*/case.foam, gas and particles together")


if __name__ == "__main__":
    program.run(main, RunError, expected.ExpectationError)
