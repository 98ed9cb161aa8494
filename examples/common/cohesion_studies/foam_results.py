# SPDX-License-Identifier: BSD-3-Clause
"""What a case of cohesiveBedFoam has written, ASCII: times, particles, fields, mesh."""

import re
from pathlib import Path

import numpy as np

from cohesion_studies.case_entries import EntryError

NUMBER = r"[-+.\deE]+"


def written_times(case):
    """Time folders of a case, by time."""
    return {float(d.name): d for d in Path(case).iterdir() if re.fullmatch(r"[\d.]+", d.name)}


def function_table(case, name, file):
    """The table `file` of the function object `name`, of one run from 0. OpenFOAM keeps the tables that it finds: a
    case that is run again has <type>_<start>.dat beside them, one that is continued a folder of its later start. Raises
    EntryError then, and without the table."""
    folder = Path(case) / "postProcessing" / name
    starts = sorted(d.name for d in folder.glob("*") if re.fullmatch(NUMBER, d.name))
    if starts and starts != ["0"]:
        raise EntryError(f"{folder}: tables from the starts {', '.join(starts)}; what is read is one run from 0, not "
                         "continued: clean the case and run it from 0")
    table = folder / "0" / file
    again = rf"{re.escape(table.stem)}_{NUMBER}{re.escape(table.suffix)}"
    others = sorted(f.name for f in table.parent.glob("*") if re.fullmatch(again, f.name))
    if others:
        raise EntryError(f"{table.parent}: {', '.join(others)} beside {file}: tables of more than one run; clean the "
                         "case and run it again")
    if not table.is_file():
        raise EntryError(f"{table}: no such table; it is there once the case has run with the function object '{name}'")
    return table


def vector_list(file):
    """Of a list of vectors, an array (n, 3)."""
    rows = re.findall(r"\(([-+.\deE]+) ([-+.\deE]+) ([-+.\deE]+)\)", Path(file).read_text())
    return np.array(rows, dtype=float)


def read_cloud(folder):
    """Positions and velocities of the particles in a written time: two arrays (n, 3)."""
    return tuple(vector_list(folder / "lagrangian/particles" / file) for file in ("positions", "U"))


def read_cells(file, count):
    """Values of a scalar field in the `count` cells, in their order; a uniform one has the same in all."""
    text = Path(file).read_text()
    uniform = re.search(r"^internalField\s+uniform\s+(\S+);", text, re.M)
    if uniform:
        return np.full(count, float(uniform[1]))
    return np.array(re.search(r"^internalField[^(]*\(([^)]*)\)", text, re.M)[1].split(), dtype=float)


def mesh_size(case):
    """Of the box around the mesh, which blockMesh has made: x, y, z [m]."""
    return np.ptp(vector_list(Path(case) / "constant/polyMesh/points"), axis=0)
