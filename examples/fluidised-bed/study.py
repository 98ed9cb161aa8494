# SPDX-License-Identifier: BSD-3-Clause
"""Runs a table of beds, each with several seeds, on the cores there are, and ends in a table of the
characteristic velocities, of mixing and movement with their standard deviations, and of the differences
between the engines where two rows are the same bed in both; then come the figures that expected.csv beside the
table has for its rows. Runs that are finished are not made again: after an interruption the same command goes on
with the others.

    study.py TABLE.csv [--seeds N ...] [--together N] [--out FOLDER] [--overwrite] [--build FOLDER]
             [--case FOLDER]
"""

import argparse
from math import isnan, isqrt, sqrt

from cohesion_studies import expected, package_tree, program
from cohesion_studies.bed import bed_case
from cohesion_studies.bed.bed_case import ENGINES, MARK, SCHEDULES, BedRun, fingerprint, geometry_of, parameters
from cohesion_studies.bed.geometry import GeometryError
from cohesion_studies.foam_case import environment
from cohesion_studies.job_pool import RunError, carry_out, require_ours
from cohesion_studies.mapping_program import MappingError
from cohesion_studies.study_table import TableError, aligned, over_seeds, read_table, with_deviation, write_summary
from escape import PLACES, bond_number, escape_velocities

# Primes above 10000, which LIGGGHTS asks for
SEEDS = {"lammps": [4711, 4712, 4713], "liggghts": [15485863, 32452843, 49979687]}
# What is printed, with its digits; of both engines, COLUMNS are compared
COLUMNS = {"U_mf_df": ".3f", "U_mf_th": ".3f", "U_mf_in": ".3f", "overshoot": ".3f", "mixing": ".3f",
           "movement": ".2e"}
PRINTED = {**COLUMNS, "processor_seconds": ".0f"}


def rows(file):
    """{name: parameters} of the table `file`; what a row leaves empty is as in the case of its engine. Raises
    TableError."""
    known = dict.fromkeys(name for engine in ENGINES for name in parameters(engine))
    table = {}
    for name, row in read_table(file, known).items():
        given = {column: value for column, value in row.items() if value is not None}
        engine = given.get("engine", ENGINES[0])
        if engine not in ENGINES:
            raise TableError(f"{file}: row '{name}' has engine '{engine}'; there are " + ", ".join(ENGINES))
        for column in given:
            if column not in parameters(engine):
                raise TableError(f"{file}: row '{name}': '{column}' does not apply to engine '{engine}'; it has "
                                 + ", ".join(parameters(engine)))
        table[name] = {**parameters(engine), **given}
        if table[name]["schedule"] not in SCHEDULES:
            raise TableError(f"{file}: row '{name}' has schedule '{table[name]['schedule']}'; there are "
                             + ", ".join(SCHEDULES))
        try:
            geometry_of(table[name])
        except GeometryError as error:
            raise TableError(f"{file}: row '{name}': {error}") from None
    return table


def seeds_of(row, given):
    """Those `given` on the command line, or SEEDS. Raises TableError for one that the engine would not take."""
    for seed in given or ():
        if row["engine"] == "liggghts" and (seed < 10000 or any(seed % k == 0 for k in range(2, isqrt(seed) + 1))):
            raise TableError(f"seeds: LIGGGHTS takes primes above 10000, and {seed} is none")
    return given or SEEDS[row["engine"]]


def known_speeds(build, name, row):
    """escape_velocities() of the row called `name`, and "bond", with six digits; None each when they are not known, and
    why."""
    try:
        found = {**escape_velocities(build, row), "bond": bond_number(build, row)}
        return {place: float(f"{speed:.6g}") for place, speed in found.items()}
    except (MappingError, ValueError) as error:
        print(f"study.py: no escape velocities of row '{name}': {error}")
        return dict.fromkeys([*PLACES, "bond"])


def text(table, results, failed, speeds):
    """Escape velocity between particles, and mean and standard deviation of PRINTED, a line per row, and for each
    bed that is there with both engines the difference; `failed`: {row name: seeds without a result}, `speeds`: {row
    name: known_speeds()}."""
    lines = [("", "v_esc", *PRINTED, "seeds")]
    for name in table:
        figures, speed = over_seeds(results[name]), speeds[name]["v_esc"]
        lines.append((name, "unknown" if speed is None else f"{speed:.5f}",
                      *(with_deviation(*figures[column], PRINTED[column]) if column in figures else "none"
                        for column in PRINTED),
                      f"{len(results[name])}" + (f", {failed[name]} failed" if failed[name] else "")))
    lines = [aligned(lines)]
    pairs = [(one, other) for one in table for other in table if same_bed(table[one], table[other])]
    if pairs:
        differences = [(other, *(difference(results[one], results[other], column) for column in COLUMNS))
                       for one, other in pairs]
        lines += ["", aligned([("LIGGGHTS - LAMMPS (over its standard error)", *COLUMNS), *differences])]
    return "\n".join(lines)


def against_expected(file, table, results, speeds):
    """What expected.csv beside the table `file` says of its rows, as text; empty without such."""
    found = {name: {**speeds[name], **{figure: mean for figure, (mean, _) in over_seeds(results[name]).items()}}
             for name in table if results[name]}
    return expected.text(file.parent / "expected.csv", found)


def same_bed(one, other):
    """Whether the rows `one`, of LAMMPS, and `other`, of LIGGGHTS, are the same bed: a variable that one of the
    scripts only has must be as in the case."""
    in_case = {**parameters("liggghts"), **parameters("lammps"), "engine": None}
    alike = {**in_case, **one, "engine": None} == {**in_case, **other, "engine": None}
    return (one["engine"], other["engine"]) == ("lammps", "liggghts") and alike


def difference(one, other, figure):
    """Of the means over the seeds, other - one, with how many of its standard errors that is, as text; "none" with
    fewer than two seeds of either, or one of no such figure."""
    if min(len(one), len(other)) < 2:
        return "none"
    (first, spread), (second, other_spread) = (over_seeds(results)[figure] for results in (one, other))
    if isnan(second - first):
        return "none"
    error = sqrt(spread**2 / len(one) + other_spread**2 / len(other))
    return f"{second - first:+{COLUMNS[figure]}} ({f'{(second - first) / error:.1f}' if error else 'no spread'})"


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("table", type=package_tree.example,
                        help="CSV: name, and columns of " + ", ".join(parameters("lammps")))
    parser.add_argument("--seeds", type=int, nargs="+", metavar="N",
                        help="of the beds of each row ("
                             + "; ".join(f"{engine}: {' '.join(map(str, seeds))}" for engine, seeds in SEEDS.items())
                             + ")")
    program.together_words(parser)
    program.folder_words(parser, "BUILD/TABLE")
    bed_case.case_word(parser)
    parser.add_argument("--overwrite", action="store_true", help="replace the runs of other settings")
    args = parser.parse_args()
    bed_case.use(args.case)
    if args.seeds and len(set(args.seeds)) < len(args.seeds):
        parser.error("--seeds: one stands twice, and both runs would be made in the same folder")
    build = args.build.resolve()
    out = program.out_folder(args, args.table.stem).resolve()
    table = rows(args.table)
    expected.rows(args.table.parent / "expected.csv")
    seeds = {name: seeds_of(row, args.seeds) for name, row in table.items()}
    env = environment(build, {row["engine"] for row in table.values()})
    mark = fingerprint(build, env)
    jobs = {name: [BedRun(out / "runs" / f"{name}-{seed}", {**row, "seed": seed}, env, mark)
                   for seed in seeds[name]] for name, row in table.items()}
    every = [job for row in jobs.values() for job in row]
    require_ours(every, MARK, args.overwrite)
    failure = None
    try:
        carry_out(every, args.together)
    except RunError as error:  # the table is of those that are done
        failure = error
    results = {name: [without_settings(job.result()) for job in row if job.result()] for name, row in jobs.items()}
    failed = {name: len(row) - len(results[name]) for name, row in jobs.items()}
    speeds = {name: known_speeds(build, name, row) for name, row in table.items()}
    write_summary(out / "summary.csv", {name: {**row, **speeds[name]} for name, row in table.items()}, results, failed)
    print(text(table, results, failed, speeds))
    if said := against_expected(args.table, table, results, speeds):
        print("\n" + said)
    print(f"\ntable: {out / 'summary.csv'}; the runs: {out / 'runs'}")
    if failure:
        raise failure


def without_settings(result):
    return {figure: value for figure, value in result.items() if figure not in ("settings", "readers")}


if __name__ == "__main__":
    program.run(main, RunError, TableError, expected.ExpectationError)
