# SPDX-License-Identifier: BSD-3-Clause
"""Tables that the benchmarks print, as rows, and their CSV files."""
import csv
import itertools


def cells(line):
    return [cell.strip().replace("*", "") for cell in line.strip().strip("|").split("|")]


def read(lines):
    """The first table of `lines`: a dictionary for each row."""
    table = itertools.takewhile(lambda line: line.startswith("|"),
                                itertools.dropwhile(lambda line: not line.startswith("|"), lines))
    rows = [cells(line) for line in table]
    return [dict(zip(rows[0], row)) for row in rows[2:]]


def read_csv(file):
    with open(file, newline="") as opened:
        return list(csv.DictReader(opened))


def write_csv(file, rows):
    with open(file, "w", newline="") as opened:
        writer = csv.DictWriter(opened, list(rows[0]), restval="", lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)
