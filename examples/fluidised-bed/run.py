# SPDX-License-Identifier: BSD-3-Clause
"""Runs the fluidised bed without and with cohesion, both at once on one core each, and ends in a
table of the characteristic velocities and a picture.

    run.py [--engine liggghts] [--schedule brief|thesis] [--hamaker A] [--seed N] [--beside FOLDER]
           [--out FOLDER] [--overwrite] [--build FOLDER] [--case FOLDER]

Without --schedule the cycle is `short`; --hamaker is the Hamaker constant of the cohesive case [J].
"""

import argparse
from math import isnan
from pathlib import Path

import picture
from cohesion_studies import program
from cohesion_studies.bed import bed_case
from cohesion_studies.bed.bed_case import ENGINES, MARK, SCHEDULES, BedRun, fingerprint
from cohesion_studies.bed.figures import evaluate
from cohesion_studies.foam_case import CaseError, environment
from cohesion_studies.job_pool import RunError, carry_out, require_ours
from cohesion_studies.study_table import TableError, aligned
from study import seeds_of


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--engine", choices=ENGINES, default=ENGINES[0],
                        help="particle engine (%(default)s)")
    parser.add_argument("--seed", type=int, default=None, metavar="N",
                        help="another realisation of the bed; for LIGGGHTS a prime above 10000")
    parser.add_argument("--beside", type=Path, default=None, metavar="FOLDER",
                        help="earlier results, of the other engine for instance, to stand beside "
                             "these in the table")
    parser.add_argument("--schedule", choices=SCHEDULES, default="short",
                        help="gas velocity against time: short, of 4 s; brief, of 1.94 s, from 1 m/s on; thesis, the "
                             "thesis's, of 9 s (%(default)s)")
    parser.add_argument("--hamaker", type=float, default=7.49e-19, metavar="A",
                        help="Hamaker constant of the cohesive case [J] (%(default)s)")
    program.folder_words(parser, "BUILD/fluidised-bed, for LIGGGHTS BUILD/fluidised-bed-liggghts", "cases and results")
    bed_case.case_word(parser)
    parser.add_argument("--overwrite", action="store_true",
                        help="replace the results of an earlier run")
    return parser.parse_args()


def table(results):
    rows = [("", *results)]

    def with_error(value, sign=""):
        return "none" if isnan(value[0]) else f"{value[0]:{sign}.3f} +- {value[1]:.3f}"

    rows.append(("U_mf,df  falling branch [m/s]",
                 *(with_error(r["velocities"].falling) for r in results.values())))
    rows.append(("U_mf,th  rising branch [m/s]",
                 *(with_error(r["velocities"].rising) for r in results.values())))
    rows.append(("U_mf,in  pressure maximum [m/s]",
                 *(with_error(r["velocities"].opening) for r in results.values())))
    rows.append(("overshoot of the pressure drop",
                 *(with_error(r["velocities"].overshoot, "+") for r in results.values())))
    rows.append(("pressure drop / weight, fluidised",
                 *(with_error(r["plateau"]) for r in results.values())))
    rows.append(("same with plate and walls added",
                 *(with_error(r["balance"]) for r in results.values())))
    rows.append(("void fraction of the resting bed",
                 *(with_error(r["void_fraction"]) for r in results.values())))
    rows.append(("Ergun's U_mf for it [m/s]",
                 *("{:.3f} to {:.3f}".format(*r["ergun"]) for r in results.values())))
    rows.append(("seconds, of these in the particle engine",
                 *("{:.0f}, {:.0f}".format(*r["seconds"]) for r in results.values())))
    return aligned(rows)


def earlier(folder, kinds):
    """Of the cases `kinds` in a folder of results; raises CaseError."""
    try:
        return {f"{name}, {folder.name}": evaluate(folder / name) for name in kinds}
    except (OSError, LookupError, ValueError) as error:
        raise CaseError(f"--beside '{folder}' holds no results of this program: {error!r}") from None


def main():
    args = arguments()
    bed_case.use(args.case)
    args.build = args.build.resolve()
    out = program.out_folder(args, "fluidised-bed" if args.engine == "lammps" else f"fluidised-bed-{args.engine}")
    common = {"engine": args.engine, "schedule": args.schedule}
    if args.seed is not None:
        common["seed"], = seeds_of(common, [args.seed])
    env = environment(args.build, [args.engine])
    mark = fingerprint(args.build, env)
    # Where nothing sticks the engine's own contacts do as well, and take less.
    kinds = {"non-cohesive": {"A": 0.0, "scheme": "sampled"}, "Hamaker": {"A": args.hamaker}}
    # The longest that the exact scheme allows with these springs, t_c/6.2 in a plane (README.md, Particle step and
    # scheme); that of LIGGGHTS takes t_c/8.2 as the case has it.
    if args.engine == "lammps":
        kinds["Hamaker"]["dt"] = 1.5e-5
    beside = {} if args.beside is None else earlier(args.beside, kinds)
    jobs = [BedRun(out / name, {**common, **given}, env, mark) for name, given in kinds.items()]
    require_ours(jobs, MARK, args.overwrite)
    if args.overwrite:
        for job in jobs:
            job.discard()
    carry_out(jobs, together=len(jobs))

    results = {name: evaluate(out / name) for name in kinds}
    program.leave_table(out, table({**results, **beside}))
    picture.draw(out, results)
    print(f"ParaView: {out}/*/case.foam, gas and particles together")


if __name__ == "__main__":
    program.run(main, RunError, TableError)
