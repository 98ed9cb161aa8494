# SPDX-License-Identifier: BSD-3-Clause
"""What a case of cohesiveBedFoam has written, ASCII: times, particles, fields, mesh."""

import re
from pathlib import Path

import numpy as np


def written_times(case):
    """Time folders of a case, by time."""
    return {float(d.name): d for d in Path(case).iterdir() if re.fullmatch(r"[\d.]+", d.name)}


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
