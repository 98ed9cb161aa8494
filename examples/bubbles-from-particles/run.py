# SPDX-License-Identifier: BSD-3-Clause
"""Measures bubbles, their size and how fast they rise, in beds of particles: hard spheres, soft ones, cohesive ones. Ends
in a table beside the correlations that examples/discrete-bubbles takes, and a picture. Beds that are finished are not run
again.

    run.py [--kinds hard non-cohesive Hamaker] [--seeds N ...] [--out FOLDER] [--overwrite] [--build FOLDER] [--together N]
"""

import argparse
from math import isnan
from pathlib import Path

import analyse
import picture
from beds import HARD_CASE, KINDS, HardBubbles, SoftBubbles
from cohesion_studies import expected, program
from cohesion_studies.bed import bed_case
from cohesion_studies.case_job import MARK, fingerprint
from cohesion_studies.foam_case import environment
from cohesion_studies.job_pool import RunError, carry_out, require_ours
from cohesion_studies.study_table import aligned

HERE = Path(__file__).resolve().parent


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--kinds", nargs="+", choices=KINDS, default=list(KINDS), help="of beds (all)")
    parser.add_argument("--seeds", type=int, nargs="+", default=[1, 2], metavar="N",
                        help="of the places from which the spheres are poured (%(default)s)")
    parser.add_argument("--overwrite", action="store_true", help="replace beds of other settings")
    program.folder_words(parser, "BUILD/bubbles-from-particles", "cases and results")
    program.together_words(parser)
    return parser.parse_args()


def pooled(jobs, results):
    """{kind: lives of the bubbles of all its beds}."""
    found = {}
    for job, result in zip(jobs, results):
        found.setdefault(job.kind, []).extend(result["lives"])
    return found


def table(found):
    """`found`: {kind: analyse.figures()}."""
    names = list(dict.fromkeys(name for figures in found.values() for name in figures))

    def cell(pair):
        mean, error = pair or ("none", float("nan"))
        return mean if mean == "none" else f"{mean:.4g}" + ("" if isnan(error) else f" +- {error:.1g}")

    return aligned([("", *found), *((name, *(cell(figures.get(name)) for figures in found.values())) for name in names)])


def main():
    args = arguments()
    expected.rows(HERE / "expected.csv")
    args.build = args.build.resolve()
    out = program.out_folder(args, "bubbles-from-particles").resolve()
    env = environment(args.build, ["lammps"])
    marks = fingerprint(HARD_CASE, args.build, env), bed_case.fingerprint(args.build, env)
    jobs = [HardBubbles(out, env, marks[0], seed) if kind == "hard" else SoftBubbles(out, env, marks[1], kind, seed)
            for seed in args.seeds for kind in args.kinds]
    require_ours(jobs, MARK, args.overwrite)
    lives = pooled(jobs, carry_out(jobs, args.together))
    found = {kind: analyse.figures(of, *KINDS[kind]) for kind, of in lives.items()}
    means = {kind: {name: mean for name, (mean, _) in figures.items()} for kind, figures in found.items()}
    program.leave_table(out, table(found) + "\n\n" + expected.text(HERE / "expected.csv", means))
    picture.draw(out / "result.png", jobs[:len(args.kinds)], lives)
    print(f"ParaView: {out}/*/case.foam, gas and particles together")


if __name__ == "__main__":
    program.run(main, RunError, expected.ExpectationError)
