# SPDX-License-Identifier: BSD-3-Clause
"""What a case of cohesiveBedFoam has written, ASCII: times, particles, fields."""

import re
from pathlib import Path

import numpy as np


def written_times(case):
    """Time folders of a case, by time."""
    return {float(d.name): d for d in Path(case).iterdir() if re.fullmatch(r"[\d.]+", d.name)}


def read_cloud(folder):
    """Positions and velocities of the particles in a written time: two arrays (n, 3)."""
    def vectors(file):
        text = (folder / "lagrangian/particles" / file).read_text()
        rows = re.findall(r"\(([-+.\deE]+) ([-+.\deE]+) ([-+.\deE]+)\)", text)
        return np.array(rows, dtype=float)

    return vectors("positions"), vectors("U")


def read_cells(file):
    """Values of a scalar field in the cells, in their order; a uniform one is one number."""
    text = Path(file).read_text()
    uniform = re.search(r"^internalField\s+uniform\s+(\S+);", text, re.M)
    if uniform:
        return np.array([float(uniform[1])])
    return np.array(re.search(r"^internalField[^(]*\(([^)]*)\)", text, re.M)[1].split(), dtype=float)
