# SPDX-License-Identifier: BSD-3-Clause
"""Tables of what is expected, expected.csv of each example: case, quantity, low, high, origin; # begins a comment."""

import csv

COLUMNS = ["case", "quantity", "low", "high", "origin"]


class ExpectationError(RuntimeError):
    """The table cannot be right."""


def rows(file):
    """Rows of the table as dicts, low and high as they stand there; none without such a file. Raises ExpectationError.
    Programs call it before their runs: a mistake in the table is then said at once."""
    if not file.exists():
        return []
    with open(file, newline="") as lines:
        reader = csv.DictReader(line for line in lines if not line.startswith("#"))
        found = list(reader)
    if reader.fieldnames != COLUMNS:
        raise ExpectationError(f"{file}: its columns must be {', '.join(COLUMNS)}")
    for row in found:
        name = f"{file}: row '{row['case']}, {row['quantity']}'"
        try:
            if not float(row["low"]) <= float(row["high"]):
                raise ExpectationError(f"{name}: {row['low']} is above {row['high']}")
        except (TypeError, ValueError):
            raise ExpectationError(f"{name}: low and high must be numbers") from None
        if not row["origin"] or None in row:
            raise ExpectationError(f"{name}: it needs an origin, in quotes if it has a comma")
    return found


def held(file, found):
    """For each row of the table whose case is in `found`, {case: {quantity: number}}, a text, and whether it holds:
    [(text, bool)]."""
    checked = []
    for row in rows(file):
        if row["case"] in found:
            value = found[row["case"]].get(row["quantity"])
            holds = value is not None and float(row["low"]) <= value <= float(row["high"])
            checked.append((f"{row['case']}, {row['quantity']}: {'none' if value is None else f'{value:.5g}'}, "
                            f"expected {row['low']} to {row['high']} ({row['origin']})", holds))
    return checked


def text(file, found):
    """Of held(), a line each; empty without such a table."""
    return "\n".join(f"{'as expected' if holds else 'NOT AS EXPECTED'}: {line}"
                     for line, holds in held(file, found))
