# SPDX-License-Identifier: BSD-3-Clause
"""Reads one finished bed: time means of void fraction and velocity of the spheres across the bed, compared with measured
profiles. Lengths in m, velocities in m/s."""

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
    """Entries of a finished case, and its time means."""

    case: Path

    def __post_init__(self):
        self.case = Path(self.case)
        self.size = entries(self.case / "constant/bed")
        self.times = written_times(self.case)
        start = self.size["averageFrom"]
        ends = sorted(time for time in self.times if time > start)
        if not ends:
            raise EntryError(f"{self.case}: no time after averageFrom, {start:g} s, is written: raise endTime in "
                             "constant/bed")
        self.span = start, ends[-1]
        self.blocks = list(zip([start, *ends], ends))  # begin and end of the times between those written

    def mean_void_fraction(self, span):
        """Means over a span between written times and over the thickness of the bed: an array (up, across). The written
        fields are means since averageFrom."""
        across, deep, up = (int(self.size[name]) for name in ("across", "deep", "up"))
        sums = []
        for time in span:
            length = time - self.span[0]
            values = read_cells(self.times[time] / "voidFractionMean", across * deep * up) if length > 0 else np.zeros(1)
            sums.append(length * values)
        return ((sums[1] - sums[0]) / (span[1] - span[0])).reshape(up, deep, across).mean(axis=1)

    def void_fraction(self, height, span):
        """x and means in the middles of the cells across the bed, at a height."""
        layers = self.mean_void_fraction(span)
        up, across = layers.shape
        # Between the layers of cells above and below the height
        layer = height / self.size["height"] * up - 0.5
        low = int(layer)
        above = layer - low
        x = (np.arange(across) + 0.5) / across * self.size["width"]
        return x, (1 - above) * layers[low] + above * layers[low + 1]

    def velocity(self, height, span):
        """x and upward velocity of the spheres in the layer of profiles.dat around a height."""
        steps = [time / particle_step(self.case) for time in span]
        return mean_velocity(chunk_rows(self.case / "profiles.dat", *steps), height)

    def profile(self, quantity, height, span=None):
        """x and mean values over a span of time, or all, of a quantity of measured() at a height [mm]."""
        of = {"void_fraction": self.void_fraction, "velocity": self.velocity}
        return of[quantity](1e-3 * float(height), span or self.span)

    def error(self, quantity, height):
        """Standard error of the mean of a profile, from its means over the blocks of time; nan with one block."""
        means = [self.profile(quantity, height, block)[1].mean() for block in self.blocks]
        return float(np.std(means, ddof=1) / np.sqrt(len(means))) if len(means) > 1 else float("nan")


def chunk_rows(file, begin, end):
    """Rows chunk, x, z, spheres, velocity of the means that fix ave/chunk wrote over times between the steps `begin` and
    `end`."""
    rows, inside = [], False
    for line in file.read_text().splitlines():
        words = line.split()
        if line.startswith("#"):
            continue
        if len(words) == 3:
            inside = begin + 0.5 < float(words[0]) < end + 0.5
        elif inside:
            rows.append(words)
    return np.array(rows, dtype=float)


def mean_velocity(rows, height):
    """Of chunk_rows(): x and velocity of the columns around a height, means over time and spheres. Columns without
    spheres are left out."""
    layer = rows[np.isclose(rows[:, 2], height, atol=1e-6) & (rows[:, 3] > 0)]
    x, column = np.unique(layer[:, 1], return_inverse=True)
    return x, np.bincount(column, layer[:, 3] * layer[:, 4]) / np.bincount(column, layer[:, 3])


def figures(case, table):
    """Of one bed, for each profile that the `table` has for its gas velocity: means over the measured points, measured
    and simulated, and the largest values; of the differences the root of the mean square and the mean, with the
    standard error of that mean."""
    bed, found = Bed(case), {}
    for (gas, quantity, height), (x, values) in measured(table).items():
        if float(gas) == bed.size["gasVelocity"]:
            simulated = np.interp(x, *bed.profile(quantity, height))
            difference = simulated - values
            name = f"{quantity}_{height}"
            for of, some in (("measured", values), ("simulated", simulated)):
                found[f"{name}_{of}"], found[f"{name}_{of}_largest"] = float(some.mean()), float(some.max())
            found[f"{name}_rms"] = float(np.sqrt((difference**2).mean()))
            found[f"{name}_mean"] = float(difference.mean())
            found[f"{name}_error"] = bed.error(quantity, height)
    return found
