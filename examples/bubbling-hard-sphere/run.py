# SPDX-License-Identifier: BSD-3-Clause
"""Runs the hard-sphere beds of Hoomans et al. (1996), each with and without dissipation in collisions and with some
seeds, as many at a time as there are cores, and ends in a table beside the expectations, and a picture. Beds that are
finished are not run again.

    run.py [--beds b c d] [--seeds N ...] [--time SECONDS] [--out FOLDER] [--overwrite] [--build FOLDER]
           [--together N] [--dissipation SHARE[:SHARE] ...]
"""

import argparse
import shutil
from pathlib import Path

import analyse
import first_second
import picture
from cohesion_studies import case_entries, cavities, ergun, expected, foam_results, program, study_table
from cohesion_studies.case_job import MARK, CaseJob, fingerprint
from cohesion_studies.foam_case import environment
from cohesion_studies.job_pool import RunError, carry_out, require_ours

HERE = Path(__file__).resolve().parent
CASE = HERE / "case"

BEDS = ("b", "c", "d", "b-start", "b-weak", "c-start", "d-pulse")
SCRIPT = "constant/couplingProperties", "lammpsCoeffs/variables"
# What the figures depend on besides the run
READERS = (analyse, first_second, case_entries, cavities, ergun, foam_results)


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--beds", nargs="+", choices=BEDS, default=["b", "c"],
                        help="b: jet, c: uniform gas, d: 40,000 spheres, which takes long; -start, -weak (jet of 2.6 "
                        "m/s), -pulse: from minimum fluidisation (%(default)s)")
    parser.add_argument("--dissipation", nargs="+", type=shares, default=[(1, 1), (0, 0)], metavar="SHARE[:SHARE]",
                        help="0 to 1, of spheres and of walls: share s means restitution 1 - s (1 - e) and friction "
                        "s mu (1 0)")
    parser.add_argument("--time", type=float, default=None, metavar="SECONDS",
                        help="to simulate (that of each bed, which is what expected.csv is of)")
    parser.add_argument("--seeds", type=int, nargs="+", default=[1, 2, 3], metavar="N",
                        help="of the places from which the spheres are poured (%(default)s)")
    parser.add_argument("--overwrite", action="store_true", help="replace beds of other settings")
    program.folder_words(parser, "BUILD/bubbling-hard-sphere", "cases and results")
    program.together_words(parser)
    return parser.parse_args()


def shares(text):
    """Dissipation of spheres and of walls, for argparse."""
    spheres, _, walls = text.partition(":")
    found = tuple(study_table.number(part) for part in (spheres, walls or spheres))
    if not all(isinstance(share, (int, float)) and 0 <= share <= 1 for share in found):
        raise argparse.ArgumentTypeError(f"{text}: shares are 0 to 1")
    return found


def kind_of(bed, dissipation):
    """Name of a bed with shares(): with all dissipation, with none, or with the shares."""
    return {(1, 1): bed, (0, 0): f"{bed}-elastic"}.get(dissipation, f"{bed}-{dissipation[0]:g}-{dissipation[1]:g}")


def tables(kinds):
    """Text: a table of the beds with the same figures."""
    groups = {}
    for kind, results in kinds.items():
        groups.setdefault(tuple(results[0]), {})[kind] = results
    return "\n\n".join(study_table.side_by_side(group, digits=3) for group in groups.values())


class HardBed(CaseJob):
    """One bed. `dissipation`: shares(); `changed`: entries of constant/bed that differ from the case."""

    def __init__(self, out, env, mark, bed, dissipation, seed, changed=None):
        self.bed, self.changed = bed, changed or {}
        self.variables = {"dissipation": dissipation[0], "wall_dissipation": dissipation[1], "seed": seed}
        kind = kind_of(bed, dissipation)
        size = {**case_entries.entries(CASE / f"constant/bed.{bed}"), **self.changed}
        super().__init__(out / f"{kind}-seed-{seed}", kind, env,
                         {"bed": bed, **self.changed, **self.variables, "fingerprint": mark}, READERS, CASE,
                         work=size["endTime"] * size["count"])

    def change(self):
        shutil.copy(self.folder / f"constant/bed.{self.bed}", self.folder / "constant/bed")
        for name, value in self.changed.items():
            self.case.set("constant/bed", name, value)
        for name, value in self.variables.items():
            self.case.set(SCRIPT[0], f"{SCRIPT[1]}/{name}", value)

    def figures(self):
        bed = analyse.Bed(self.folder)
        return {**analyse.figures(self.folder), **(first_second.figures(bed) if "begin" in bed.size else {})}


def main():
    args = arguments()
    expected.rows(HERE / "expected.csv")
    args.build = args.build.resolve()
    out = program.out_folder(args, "bubbling-hard-sphere").resolve()
    env = environment(args.build, ["lammps"])
    mark = fingerprint(CASE, args.build, env)
    changed = {} if args.time is None else {"endTime": args.time}
    jobs = [HardBed(out, env, mark, bed, dissipation, seed, changed)
            for seed in args.seeds for bed in args.beds for dissipation in args.dissipation]
    require_ours(jobs, MARK, args.overwrite)
    kinds = study_table.by_kind(jobs, carry_out(jobs, args.together))
    # Peaks per second and shares of the written times are expected of a whole run alone.
    held = "" if changed else "\n\n" + expected.text(HERE / "expected.csv", study_table.means_of(kinds))
    program.leave_table(out, tables(kinds) + held)
    picture.draw(out / "result.png", [job.folder for job in jobs[:len(kinds)]])
    print(f"ParaView: {out}/*/case.foam, gas and particles together")


if __name__ == "__main__":
    program.run(main, RunError, expected.ExpectationError)
