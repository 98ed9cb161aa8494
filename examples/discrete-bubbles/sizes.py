# SPDX-License-Identifier: BSD-3-Clause
"""How much gas the reactor of run.py holds by the size of its bubbles: bubbles of three sizes from the nozzles, that do
not merge, or merge up to two sizes, slowly and fast; 17 reactors, and a table.

    sizes.py [--flows 0.1 0.3] [--time SECONDS] [--out FOLDER] [--overwrite] [--build FOLDER] [--together N]
"""

import argparse

import run
from cohesion_studies import program
from cohesion_studies.case_job import MARK, fingerprint
from cohesion_studies.foam_case import environment
from cohesion_studies.job_pool import RunError, carry_out, require_ours
from cohesion_studies.study_table import aligned

# Diameter of the bubbles of nozzles: how many of them along x and y, how far apart and what waiting bubbles grow to, at
# most to the walls [m], and the step of the bubbles [s], a tenth of a contact of theirs at most: pi sqrt(M/(2 K)) = 14, 26
# and 40 ms, with M the mass and the added mass.
NOZZLES = {0.08: (11, 0.085, 0.14, 1.25e-3), 0.12: (7, 0.12, 0.19, 2.5e-3), 0.16: (5, 0.17, 0.19, 2.5e-3)}
NONE = 1e-3  # no bubble is that small: none merge
LARGEST = (NONE, 0.3, 0.5)  # to which bubbles merge [m]
# Springs of 1500 N/m lost a bubble out of the box there.
LEFT_OUT = {(0.3, 0.08, 0.5)}
GAS_STEP = 0.025


class Sized(run.Reactor):
    """A reactor with a flow of gas [m3/s] of bubbles of a size from its nozzles that merge up to another [m]."""

    def __init__(self, out, env, mark, flow, diameter, largest, changed=None):
        count, spacing, grown, step = NOZZLES[diameter]
        name = f"{flow:g}-{1e3 * diameter:g}-" + ("none" if largest == NONE else f"{1e3 * largest:g}")
        self.flow, self.diameter, self.largest = flow, diameter, largest
        reactor = {"flow": flow, "diameter": diameter, "nozzles": count, "spacing": spacing,
                   "grow": grown, **(changed or {})}
        prefix = "lammpsCoeffs/variables/"
        self.changed = {run.REACTOR: reactor, run.MERGE[0]: {run.MERGE[1]: largest, prefix + "dt": step,
                                                             prefix + "every": round(GAS_STEP / step)}}
        super(run.Reactor, self).__init__(out / name, name, env, {"changed": self.changed, "fingerprint": mark},
                                          run.READERS, run.CASE, work=flow / diameter**3 / step)


def table(jobs, results):
    """Hold-up with its ratio to that without merging, beside the same of Davidson and Harrison's for the mean sizes."""
    alone = {(job.flow, job.diameter): found for job, found in zip(jobs, results) if job.largest == NONE}
    rows = [("gas [m/s]", "from nozzles [mm]", "merge to [mm]", "mean [mm]", "hold-up", "of that without", "by the sizes",
             "flow kept")]
    for job, found in zip(jobs, results):
        first = alone[job.flow, job.diameter]
        rows.append((f"{job.flow:g}", f"{1e3 * job.diameter:g}",
                     "none" if job.largest == NONE else f"{1e3 * job.largest:g}", f"{1e3 * found['mean_diameter']:.0f}",
                     f"{found['holdup']:.4f}", f"{found['holdup'] / first['holdup']:.2f}",
                     f"{found['without_circulation'] / first['without_circulation']:.2f}", f"{found['flow_kept']:.4f}"))
    return aligned(rows)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--flows", nargs="+", type=float, default=[0.1, 0.3], metavar="Q", help="of gas [m3/s] (0.1 0.3)")
    parser.add_argument("--time", type=float, default=None, metavar="SECONDS", help="to simulate (that of the case)")
    parser.add_argument("--overwrite", action="store_true", help="replace reactors of other settings")
    program.folder_words(parser, "BUILD/discrete-bubbles-sizes", "cases and results")
    program.together_words(parser)
    args = parser.parse_args()
    args.build = args.build.resolve()
    out = program.out_folder(args, "discrete-bubbles-sizes").resolve()
    env = environment(args.build, ["lammps"])
    mark = fingerprint(run.CASE, args.build, env)
    changed = {} if args.time is None else {"endTime": args.time, "meanFrom": args.time / 3}
    jobs = [Sized(out, env, mark, flow, diameter, largest, changed)
            for flow in args.flows for diameter in NOZZLES for largest in LARGEST
            if (flow, diameter, largest) not in LEFT_OUT]
    require_ours(jobs, MARK, args.overwrite)
    program.leave_table(out, table(jobs, carry_out(jobs, args.together)))


if __name__ == "__main__":
    program.run(main, RunError)
