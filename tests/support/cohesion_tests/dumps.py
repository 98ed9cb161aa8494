# SPDX-License-Identifier: BSD-3-Clause
"""Reads dump files of LAMMPS and LIGGGHTS: of atoms, or of what is local, as contacts are."""
import re
from pathlib import Path

import numpy


class Snapshot:
    """step; names of the columns; table: numbers, in the order of the file."""

    def __init__(self, text):
        self.step = int(text.split(None, 1)[0])
        head = re.search(r"ITEM: (?:ATOMS|ENTRIES) ?(.*)\n?", text)
        self.names = head[1].split()
        rows = text[head.end():].split("\n")
        self.table = numpy.array([row.split() for row in rows if row], dtype=float)

    def sorted(self):
        """The table, its rows by the first column."""
        return self.table[self.table[:, 0].argsort()] if self.table.size else self.table

    def by_number(self):
        """{id: list of the numbers after it}, of a dump whose first column is the id."""
        return {int(row[0]): row[1:] for row in self.table.tolist()}


def parse(text):
    """Snapshots of the text of a dump, in order."""
    return [Snapshot(part) for part in text.split("ITEM: TIMESTEP")[1:]]


def read(file):
    """Snapshots of a dump file."""
    return parse(Path(file).read_text())
