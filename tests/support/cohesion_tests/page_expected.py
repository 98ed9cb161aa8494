# SPDX-License-Identifier: BSD-3-Clause
"""Results that a page says its scripts print, `name = value`: rows of its table that begins with the columns printed,
from and to. Rules: docs/contributing.md, Code blocks of pages."""
import re

from cohesion_tests import SOURCE

ROW = re.compile(r"^\| `([^`|]+)` \| ([^\s|]+) \| ([^\s|]+) \|", re.MULTILINE)


def expected(page):
    """Bounds by name. page: relative to the repository."""
    text = (SOURCE / page).read_text()
    tables = re.findall(r"^\| printed \| from \| to \|.*\n(?:\|.*\n)+", text, re.MULTILINE)
    return {name: (float(low), float(high)) for table in tables for name, low, high in ROW.findall(table)}


def faults(bounds, output):
    """Names that the output does not print last with a value between their bounds."""
    found = []
    for name, (low, high) in bounds.items():
        values = re.findall(rf"^{re.escape(name)} = (\S+)", output, re.MULTILINE)
        if not values:
            found.append(f"{name}: not printed")
        elif not low <= float(values[-1]) <= high:
            found.append(f"{name} = {values[-1]}, not from {low:g} to {high:g}")
    return found


def printed_by(script, bounds):
    """Those of the bounds whose names the script prints."""
    return {name: pair for name, pair in bounds.items() if f"{name} = " in script}
