# SPDX-License-Identifier: BSD-3-Clause
"""A study: a table of parameters (a CSV file with a line of names), each row run with several seeds, and
the figures of the runs with mean and standard deviation over the seeds."""

import csv
import math
import statistics


class TableError(RuntimeError):
    """The table of a study cannot be right."""


def number(text):
    """What JSON keeps: int or float where it is one, the text otherwise."""
    for kind in (int, float):
        try:
            return kind(text)
        except ValueError:
            pass
    return text


def read_table(file, known):
    """Rows of the table `file` as dicts, lines that begin with # left out. The first column, `name`, names
    the row, and so the folders of its runs; the others must be in `known` (name: default). What a row leaves
    empty is the default. Raises TableError."""
    try:
        with open(file, newline="") as lines:
            rows = list(csv.reader((line for line in lines if not line.startswith("#")),
                                   skipinitialspace=True))
    except OSError as error:
        raise TableError(f"{file}: {error.strerror}") from None
    rows = [[cell.strip() for cell in row] for row in rows if any(cell.strip() for cell in row)]
    if len(rows) < 2 or rows[0][0] != "name":
        raise TableError(f"{file}: needs a line of column names, the first of them 'name', and rows")
    columns = rows[0][1:]
    for column in columns:
        if column not in known:
            raise TableError(f"{file}: no parameter '{column}'; there are {', '.join(known)}")
    if len(set(columns)) < len(columns):
        raise TableError(f"{file}: a column stands twice")
    table = {}
    for row in rows[1:]:
        name = row[0]
        if len(row) != len(rows[0]):
            raise TableError(f"{file}: row '{name}' has {len(row)} cells for {len(rows[0])} columns")
        if not name or "/" in name or name in table:
            raise TableError(f"{file}: row name '{name}' is empty, holds a '/' or stands twice")
        given = {column: number(cell) for column, cell in zip(columns, row[1:]) if cell}
        table[name] = {**known, **given}
    return table


def over_seeds(results):
    """Mean and standard deviation (of one run, n - 1; nan for one seed) of every figure that is a number;
    {figure: (mean, deviation)}, empty without results. Both are nan when a seed has no such figure, nan.
    `results`: dicts of the same figures."""
    found = {}
    for figure, first in (results[0] if results else {}).items():
        values = [result[figure] for result in results]
        if isinstance(first, (int, float)) and not isinstance(first, bool):
            known = not any(math.isnan(value) for value in values)
            spread = statistics.stdev(values) if known and len(values) > 1 else math.nan
            found[figure] = (statistics.fmean(values), spread)
    return found


def by_kind(jobs, results):
    """{kind: results}, of jobs that have a kind, in their order."""
    found = {}
    for job, result in zip(jobs, results):
        found.setdefault(job.kind, []).append(result)
    return found


def means_of(kinds):
    """{kind: {figure: mean over the seeds}}, of by_kind()."""
    return {kind: {figure: mean for figure, (mean, _) in over_seeds(results).items()}
            for kind, results in kinds.items()}


def side_by_side(kinds, digits=4):
    """Text: a line for each figure, a column for each kind of by_kind(), means over the seeds of so many digits with
    the deviation of one run, which one seed has not. Without `seconds`, by the clock: it says more of the machine's
    other work."""
    found = {kind: over_seeds(results) for kind, results in kinds.items()}
    figures = [figure for figure in next(iter(found.values())) if figure != "seconds"]
    return aligned([("", *found), *((figure, *(with_deviation(*mean[figure], f".{digits}g", ".1g")
                                              for mean in found.values()))
                                    for figure in figures)])


def with_deviation(mean, deviation, digits, of_deviation=None):
    """Text of a mean with the deviation of one run, which one seed has not; "none" without a mean, nan. `digits`: a
    format, that of the deviation too when it has none of its own."""
    if math.isnan(mean):
        return "none"
    return f"{mean:{digits}}" + ("" if math.isnan(deviation) else f" +- {deviation:{of_deviation or digits}}")


def aligned(rows):
    """Text of a table: rows of cells, columns as wide as their widest."""
    widths = [max(map(len, column)) for column in zip(*rows)]
    return "\n".join("  ".join(cell.ljust(width) for cell, width in zip(row, widths)).rstrip() for row in rows)


def in_order(lines):
    """The columns of `lines` (dicts), name, parameters and figures each in the order in which they come."""
    before = [list(line)[:list(line).index("seeds")] for line in lines]
    after = [list(line)[list(line).index("seeds"):] for line in lines]
    return list(dict.fromkeys(column for part in (before, after) for line in part for column in line))


def write_summary(file, table, results, failed=None):
    """CSV: a line per row of `table`, with its parameters, how many seeds, and for each figure its mean and,
    as <figure>_sd, standard deviation. `results`: {row name: [dict of figures per seed]}; `failed`: {row name:
    seeds without a result}, a column of its own when given."""
    lines = []
    for name, parameters in table.items():
        figures = over_seeds(results[name])
        line = {"name": name, **parameters, "seeds": len(results[name])}
        if failed is not None:
            line["failed"] = failed[name]
        for figure, (mean, deviation) in figures.items():
            line[figure], line[f"{figure}_sd"] = f"{mean:.6g}", f"{deviation:.3g}"
        lines.append(line)
    with open(file, "w", newline="") as out:
        # Rows of different programs have other parameters, and those without results no figures.
        columns = in_order(lines)
        writer = csv.DictWriter(out, columns, restval="")
        writer.writeheader()
        writer.writerows(lines)
