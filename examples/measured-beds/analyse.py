# SPDX-License-Identifier: BSD-3-Clause
"""Reads one finished bed: time means of void fraction and velocity of the spheres across the bed, and how far they are
from the measured profiles. Lengths in m, velocities in m/s."""

import csv
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from cohesion_studies.case_entries import EntryError, entries, particle_step
from cohesion_studies.foam_results import read_cells, written_times


def measured(file):
    """{(gas, quantity, height [mm]): (x, values)}, the first three as they stand in the table."""
    with open(file, newline="") as lines:
        _, *rows = csv.reader(line for line in lines if not line.startswith("#"))
    found = {}
    for gas, quantity, height, x, value in rows:
        found.setdefault((gas, quantity, height), []).append((1e-3 * float(x), float(value)))
    return {key: tuple(np.array(points).T) for key, points in found.items()}


@dataclass
class Bed:
    """What a case is of, from its dictionaries, and its time means."""

    case: Path

    def __post_init__(self):
        self.case = Path(self.case)
        self.size = entries(self.case / "constant/bed")
        self.times = written_times(self.case)
        if max(self.times) <= self.size["averageFrom"]:
            raise EntryError(f"{self.case}: no time after averageFrom, {self.size['averageFrom']:g} s, is written: raise "
                             "endTime in constant/bed")

    def void_fraction(self, height):
        """x and time means in the middles of the cells across the bed, at a height, averaged over its thickness."""
        across, deep, up = (int(self.size[name]) for name in ("across", "deep", "up"))
        values = read_cells(self.times[max(self.times)] / "voidFractionMean", across * deep * up)
        layers = values.reshape(up, deep, across).mean(axis=1)
        # Between the layers of cells above and below the height
        layer = height / self.size["height"] * up - 0.5
        low = int(layer)
        above = layer - low
        x = (np.arange(across) + 0.5) / across * self.size["width"]
        return x, (1 - above) * layers[low] + above * layers[low + 1]

    def velocity(self, height):
        """x and upward velocity of the spheres in the layer of profiles.dat around a height."""
        begin = self.size["averageFrom"] / particle_step(self.case)
        return mean_velocity(chunk_rows(self.case / "profiles.dat", begin), height)

    def profile(self, quantity, height):
        """x and values of a quantity of measured() at a height [mm]."""
        of = {"void_fraction": self.void_fraction, "velocity": self.velocity}
        return of[quantity](1e-3 * float(height))


def chunk_rows(file, begin):
    """Rows chunk, x, z, spheres, velocity of all means that fix ave/chunk wrote over times after the step `begin`."""
    rows, after = [], False
    for line in file.read_text().splitlines():
        words = line.split()
        if line.startswith("#"):
            continue
        if len(words) == 3:
            after = float(words[0]) > begin + 0.5
        elif after:
            rows.append(words)
    return np.array(rows, dtype=float)


def mean_velocity(rows, height):
    """Of chunk_rows(): x and velocity of the columns around a height, means over time and spheres. Columns without
    spheres are left out."""
    layer = rows[np.isclose(rows[:, 2], height, atol=1e-6) & (rows[:, 3] > 0)]
    x, column = np.unique(layer[:, 1], return_inverse=True)
    return x, np.bincount(column, layer[:, 3] * layer[:, 4]) / np.bincount(column, layer[:, 3])


def figures(case, table):
    """Of one bed, differences from each profile that the `table` has for its gas velocity."""
    bed, found = Bed(case), {}
    for (gas, quantity, height), (x, values) in measured(table).items():
        if float(gas) == bed.size["gasVelocity"]:
            difference = np.interp(x, *bed.profile(quantity, height)) - values
            name = f"{quantity}_{height}"
            found[f"{name}_rms"] = float(np.sqrt((difference**2).mean()))
            found[f"{name}_mean"] = float(difference.mean())
    return found
