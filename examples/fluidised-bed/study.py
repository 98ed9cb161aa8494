# SPDX-License-Identifier: BSD-3-Clause
"""Runs a table of beds, each with several seeds, on the cores there are, and ends in a table of the
characteristic velocities with their standard deviations. Runs that are finished are not made again: after
an interruption the same command goes on with the others.

    study.py TABLE.csv [--seeds N ...] [--together N] [--out FOLDER] [--overwrite] [--build FOLDER]
"""

import argparse
import re
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "common"))

import run  # noqa: E402
from foam_case import environment  # noqa: E402
from job_pool import RunError, carry_out, cores  # noqa: E402
from study_table import TableError, number, over_seeds, read_table, write_summary  # noqa: E402

NOT_IN_TABLES = ("plugin", "seed")


def parameters():
    """Those of a row, with what they are in the case: the schedule, the void fraction and the variables of its
    script."""
    text = (HERE / "case/constant/couplingProperties").read_text()
    block = re.search(r"^lammpsCoeffs\s*\{.*?variables\s*\{(.*?)\}", text, re.M | re.S)[1]
    variables = dict(re.findall(r"^\s*(\w+)\s+([^;\s]+);", block, re.M))
    kernel = re.search(r"^voidFraction\s+(\w+);", text, re.M)[1]
    return {"schedule": "short", "voidFraction": kernel, "smoothingWidth": 0, **{name: number(value) for name, value in variables.items()
                                    if name not in NOT_IN_TABLES}}


def text(table, results, failed):
    """Mean and standard deviation of what the velocities and the overshoot are, a line per row; `failed`:
    {row name: seeds without a result}."""
    columns = ("U_mf_df", "U_mf_th", "U_mf_in", "overshoot")
    lines = [f"{'':20}" + "".join(f"{column:<20}" for column in columns) + "seeds"]
    for name in table:
        figures = over_seeds(results[name])
        lines.append(f"{name:20}" + "".join("{:<20}".format("{:.3f} +- {:.3f}".format(*figures[column])
                                                            if column in figures else "none")
                                            for column in columns) + str(len(results[name]))
                     + (f", {failed[name]} failed" if failed[name] else ""))
    return "\n".join(lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("table", type=Path, help="CSV: name, and columns of " + ", ".join(parameters()))
    parser.add_argument("--seeds", type=int, nargs="+", default=[4711, 4712, 4713], metavar="N",
                        help="of the beds of each row (%(default)s)")
    parser.add_argument("--together", type=int, default=cores(), metavar="N",
                        help="runs at a time (the cores there are: %(default)s)")
    parser.add_argument("--build", type=Path, default=HERE.parents[1] / "build",
                        help="build folder of the package")
    parser.add_argument("--out", type=Path, default=None, help="folder for runs and results (BUILD/TABLE)")
    parser.add_argument("--overwrite", action="store_true", help="replace the runs of other settings")
    args = parser.parse_args()
    if len(set(args.seeds)) < len(args.seeds):
        parser.error("--seeds: one stands twice, and both runs would be made in the same folder")
    if args.together < 1:
        parser.error(f"--together {args.together}: it must be 1 or more")
    build = args.build.resolve()
    out = (args.out or build / args.table.stem).resolve()
    table = read_table(args.table, parameters())
    for name, row in table.items():
        if row["schedule"] not in run.SCHEDULES:
            raise TableError(f"{args.table}: row '{name}' has schedule '{row['schedule']}'; there are "
                             + ", ".join(run.SCHEDULES))
    env = environment(build)
    mark = run.fingerprint(build, env)
    jobs = {name: [run.BedRun(out / "runs" / f"{name}-{seed}", {"engine": "lammps", **row, "seed": seed}, env, mark)
                   for seed in args.seeds] for name, row in table.items()}
    every = [job for row in jobs.values() for job in row]
    if not args.overwrite:
        run.require_ours(every)
    failure = None
    try:
        carry_out(every, args.together)
    except RunError as error:  # the table is of those that are done
        failure = error
    results = {name: [without_settings(job.result()) for job in row if job.result()] for name, row in jobs.items()}
    failed = {name: len(row) - len(results[name]) for name, row in jobs.items()}
    write_summary(out / "summary.csv", table, results, failed)
    print(text(table, results, failed))
    print(f"\ntable: {out / 'summary.csv'}; the runs: {out / 'runs'}")
    if failure:
        raise failure


def without_settings(result):
    return {figure: value for figure, value in result.items() if figure != "settings"}


if __name__ == "__main__":
    try:
        main()
    except (RunError, TableError) as error:
        sys.exit(f"study.py: {error}")
