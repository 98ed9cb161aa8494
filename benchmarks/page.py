# SPDX-License-Identifier: BSD-3-Clause
"""Puts tables into a page of the documentation, or beside it."""
import csv
import itertools
import os
import re
import shlex

SOURCE = re.compile(r"^From `benchmarks\.py BUILD [^`]*`.*\n", re.M)
TABLE = re.compile(r"^\|.*\n(?:\|.*\n)*", re.M)


def source(words):
    """Line that says where a table is from; `words`: of the command line, behind the build folder."""
    return (f"From `benchmarks.py BUILD {shlex.join(words)}`, the load of the machine before it "
            f"{os.getloadavg()[0]:.1f} on {len(os.sched_getaffinity(0))} processors.")


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


def write_csv(file, lines):
    """The rows of the first table of `lines`, which the .csv file `file` gets."""
    rows = read(lines)
    with open(file, "w", newline="") as opened:
        writer = csv.DictWriter(opened, list(rows[0]), restval="", lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)
    return rows


def beside(file, lines, brief):
    """The lines with brief(rows) in the place of the first table, all rows of which go to a .csv file beside `file`."""
    rows = write_csv(file.with_suffix(".csv"), lines)
    first = next(n for n, line in enumerate(lines) if line.startswith("|"))
    return [*lines[:first], *brief(rows), *lines[first + 2 + len(rows):]]


def put(section, pattern, number, text):
    """The section with `text` in the place of what matches `pattern` for the time `number`, from 0 on; where nothing
    does, a source comes first, and a table behind the one before it or last."""
    found = list(pattern.finditer(section))
    if number < len(found):
        return section[:found[number].start()] + text + section[found[number].end():]
    if pattern is SOURCE:
        return f"\n{text}{section}"
    at = found[-1].end() if found else len(section.rstrip()) + 1
    return f"{section[:at].rstrip()}\n\n{text}" + (section[at:] or "\n")


def replace_section(file, title, lines):
    """The tables of the section `## title` in `file` become those of `lines`, in their order, parted by empty lines,
    and its line that a source() is that of `lines`, if there is one; what else the section says stays. A section that
    is not there is added at the end."""
    text = file.read_text() if file.exists() else ""
    heading = re.search(rf"^## {re.escape(title)}\n", text, re.M)
    if not heading:
        file.write_text(f"{text.rstrip()}\n\n## {title}\n\n".lstrip() + "\n".join(lines) + "\n")
        return
    end = re.compile(r"^## ", re.M).search(text, heading.end())
    end = end.start() if end else len(text)
    section, tables = text[heading.end():end], 0
    for block in re.split(r"\n\n+", "\n".join(lines)):
        if block.startswith("|"):
            section = put(section, TABLE, tables, block + "\n")
            tables += 1
        else:
            section = put(section, SOURCE, 0, block + "\n")
    file.write_text(text[:heading.end()] + section + text[end:])
