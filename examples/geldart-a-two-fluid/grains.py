# SPDX-License-Identifier: BSD-3-Clause
"""The beds of run.py with parcels of grains in the place of the second fluid, by cohesiveBedFoam and LAMMPS, in the same
cells: as many at a time as there are cores, ending in a table beside the two fluids, where run.py has left them in the same
folder, and a picture. Runs that are finished are not made again.

    grains.py [--beds NAME ...] [--ratio L] [--time SECONDS] [--out FOLDER] [--overwrite] [--build FOLDER] [--together N]
"""

import argparse
import json
import math
from pathlib import Path

import analyse
import picture
from cohesion_studies import case_entries, expected, foam_results, program, study_table
from cohesion_studies.case_job import MARK, CaseJob, fingerprint
from cohesion_studies.foam_case import environment
from cohesion_studies.job_pool import RESULT, RunError, carry_out, require_ours
from run import BEDS

HERE = Path(__file__).resolve().parent
CASE, EXPECTED = HERE / "grains-case", HERE / "expected_grains.csv"


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--beds", nargs="+", choices=BEDS, default=list(BEDS), help="(all)")
    parser.add_argument("--ratio", type=float, default=30.0, metavar="L",
                        help="diameter of a parcel over that of a grain (%(default)s)")
    parser.add_argument("--time", type=float, default=5.0, metavar="SECONDS", help="to simulate (%(default)s)")
    parser.add_argument("--overwrite", action="store_true", help="replace runs of other settings")
    program.folder_words(parser, "BUILD/geldart-a-two-fluid", "cases and results")
    program.together_words(parser)
    return parser.parse_args()


def of_ratio(bed, ratio):
    """Entries of constant/bed for parcels of `ratio` grains' diameters, of those of the case (`bed`): contacts as
    docs/openfoam-coupling/coarse_graining.md has them, about as many in the lattice as the bed needs in a slab as deep
    over their diameter, and the depth that gives these its mass."""
    coarser = ratio / bed["ratio"]
    parcel = ratio * bed["grain"]
    across, up = (max(2, round(bed[name] / coarser)) for name in ("across", "up"))
    depth = 8 * across * up * math.pi / 6 * parcel**3 / (bed["solid"] * bed["width"] * bed["rest"])
    # Whole steps in a step of the gas, none longer over a contact than the case's
    dt = bed["step"] / math.ceil(bed["step"] / (bed["dt"] * coarser) - 1e-9)
    return {"ratio": ratio, "parcel": parcel, "stiffness": bed["stiffness"] * coarser, "across": across, "up": up,
            "depth": depth, "behind": -depth, "before": 2 * depth, "dt": dt}


class GrainBed(CaseJob):
    """One row of BEDS, of grains. `changed`: {entry: value} of constant/bed besides."""

    def __init__(self, out, env, mark, kind, ratio, end, changed=None):
        bed, row = case_entries.entries(CASE / analyse.BED), BEDS[kind]
        self.changed = {**of_ratio(bed, ratio), "velocity": row["velocity"], "exponent": row["dragExponent"],
                        "factor": row["dragFactor"], "height": row["height"],
                        "rows": round(row["height"] * bed["columns"] / bed["width"]), "endTime": end, **(changed or {})}
        name = f"grains-{kind}" + ("" if ratio == bed["ratio"] else f"-l{ratio:g}")
        super().__init__(out / name, name, env, {**self.changed, "fingerprint": mark},
                         (analyse, case_entries, foam_results), CASE, work=end * (bed["ratio"] / ratio)**4)

    def change(self):
        self.case.edit(analyse.BED, **{name: repr(value) for name, value in self.changed.items()})

    def figures(self):
        return analyse.figures(self.folder)


def seconds_per_second(result, end):
    """Of a processor, over those that were simulated."""
    return {"seconds_per_second": result["processor_seconds"] / end}


def fluids(out, bed, end):
    """[figures] of the first `end` seconds of the two fluids that run.py has left in the folder `out`; none without."""
    file = out / bed / RESULT
    if not file.exists():
        return []
    result = json.loads(file.read_text())
    simulated = result["settings"]["time"]
    if simulated < end:
        return []
    return [{**analyse.figures(out / bed, end), **seconds_per_second(result, simulated)}]


def main():
    args = arguments()
    expected.rows(EXPECTED)
    args.build = args.build.resolve()
    out = program.out_folder(args, "geldart-a-two-fluid").resolve()
    env = environment(args.build, ["lammps"])
    mark = fingerprint(CASE, args.build, env)
    jobs = [GrainBed(out, env, mark, bed, args.ratio, args.time) for bed in args.beds]
    require_ours(jobs, MARK, args.overwrite)
    results = [{**result, **seconds_per_second(result, args.time)} for result in carry_out(jobs, args.together)]
    kinds = study_table.by_kind(jobs, results)
    beside = {}
    for bed, job in zip(args.beds, jobs):
        beside |= {kind: found for kind, found in ((bed, fluids(out, bed, args.time)), (job.kind, kinds[job.kind])) if found}
    # What is expected is of whole runs alone.
    whole = args.time == case_entries.entries(CASE / analyse.BED)["endTime"]
    held = "\n\n" + expected.text(EXPECTED, study_table.means_of(kinds)) if whole else ""
    program.leave_table(out, study_table.side_by_side(beside, digits=3) + held, "grains.txt")
    picture.draw(out / "grains.png", [out / kind for kind in beside], args.time)
    print(f"ParaView: {out}/grains-*/case.foam")


if __name__ == "__main__":
    program.run(main, RunError, expected.ExpectationError)
