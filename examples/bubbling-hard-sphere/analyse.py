# SPDX-License-Identifier: BSD-3-Clause
"""Reads one finished bed: pressure trace, height, and the cavities in it, bubbles and slugs. Lengths in m, pressures
in Pa, velocities in m/s."""

import math
import re
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from cohesion_studies import ergun
from cohesion_studies.case_entries import entries, gravity
from cohesion_studies.cavities import cavities, width_of
from cohesion_studies.foam_results import function_table, read_cells, written_times

START_UP = 0.8  # s left out: gas that begins at once lifts the resting bed as one plug, which falls back by then
PEAK = 1.5  # times its mean: where the pressure has a peak
EMPTY = 0.8  # void fraction above which a cell belongs to a cavity
SLUG = 0.7  # a cavity this wide, of the bed's width, is a slug


@dataclass
class Bed:
    """What a case is of, from its dictionaries."""

    case: Path

    def __post_init__(self):
        self.size = entries(self.case / "constant/bed")
        self.gas = entries(self.case / "constant/transportProperties")
        self.gravity = gravity(self.case)

    def __getattr__(self, name):
        return self.size[name]

    @property
    def cells(self):
        """Across and up."""
        return int(2 * self.sideCells + self.jetCells), int(self.cellsUp)

    @property
    def weight(self):
        """Per area of the plate [Pa]."""
        mass = self.count * self.density * math.pi / 6 * self.diameter**3
        return mass * self.gravity / (self.width * (self.front - self.back))

    def minimum_fluidisation(self, void_fraction):
        """By Ergun's equation."""
        rho = self.gas["rho"]
        return ergun.minimum_fluidisation(void_fraction, self.diameter, self.density, rho, rho * self.gas["nu"],
                                          self.gravity)

    def terminal_velocity(self):
        """Of a single sphere in the gas, with the drag coefficient of Rowe and Henwood: eq. 38 of the source."""
        rho, mu = self.gas["rho"], self.gas["rho"] * self.gas["nu"]
        weight = (self.density - rho) * self.gravity * math.pi / 6 * self.diameter**3

        def drag(velocity):
            reynolds = rho * velocity * self.diameter / mu
            coefficient = 0.44 if reynolds >= 1000 else 24 / reynolds * (1 + 0.15 * reynolds**0.687)
            return coefficient * math.pi / 8 * self.diameter**2 * rho * velocity**2

        low, high = 1e-6, 1e3
        while high - low > 1e-9 * high:
            middle = (low + high) / 2
            low, high = (middle, high) if drag(middle) < weight else (low, middle)
        return high


def pressure_trace(bed):
    """Times and pressures in the middle, at the height of the trace, without the gas's own weight."""
    time, p = np.loadtxt(function_table(bed.case, "trace", "p"), comments="#", ndmin=2).T
    return time, bed.gas["rho"] * (p - bed.gravity * (bed.height - bed.trace))


def heights(bed):
    """Times and twice the mean height of the spheres; the first is at rest."""
    return np.loadtxt(function_table(bed.case, "height", "bedHeight.dat"), comments="#", ndmin=2).T[:2]


def void_fraction(bed, folder):
    """Of the cells in a written time, (up, across); the mesh has a block left of the jet, one above it and one
    right of it."""
    values = read_cells(folder / "voidFraction", math.prod(bed.cells))
    up, blocks, start = bed.cells[1], [], 0
    for across in (bed.sideCells, bed.jetCells, bed.sideCells):
        end = start + int(across) * up
        blocks.append(values[start:end].reshape(up, int(across)))
        start = end
    return np.hstack(blocks)


def cavity_history(bed):
    """For each written time: time, area of all cavities over that of the bed at rest, width of the widest over
    that of the bed."""
    across, up = bed.cells
    cell = bed.width * bed.height / across / up
    rest = heights(bed)[1][0] * bed.width
    rows = []
    for time, folder in sorted(written_times(bed.case).items()):
        if time > 0:
            found = cavities(void_fraction(bed, folder) > EMPTY)
            rows.append((time, sum(map(len, found)) * cell / rest,
                         max((width_of(members, across) for members in found), default=0.0)))
    return np.array(rows).T


def resting_void_fraction(bed):
    """Mean at the start, of the cells below two thirds of the bed's height that are not next to a wall."""
    file = min((t, f) for t, f in written_times(bed.case).items() if t > 0)[1]
    rows = int(heights(bed)[1][0] * 2 / 3 / bed.height * bed.cells[1])
    return float(void_fraction(bed, file)[1:rows, 1:-1].mean())


def seconds_per_second(bed):
    """By the clock, of one simulated second."""
    log = (bed.case / "log.cohesiveBedFoam").read_text()
    time, seconds = re.findall(r"^Time = (\S+)  \(\S+ %, (\S+) s elapsed", log, re.M)[-1]
    return float(seconds) / float(time)


def peaks(values, level):
    """How often a series rises through a level."""
    above = values > level
    return int(np.count_nonzero(above[1:] & ~above[:-1]))


def figures(case):
    """Those of one bed that are one number. Pressures over the weight per area of the plate, heights over that at
    rest; means, deviations and peaks after the entry `begin` of the bed, without it after START_UP, in runs of less
    than twice that after their first quarter."""
    bed = Bed(Path(case))
    when, pressure = pressure_trace(bed)
    start = bed.size.get("begin", START_UP if when[-1] >= 2 * START_UP else when[-1] / 4)
    pressure = pressure[when > start] / bed.weight
    moment, height = heights(bed)
    height = height[moment > start] / height[0]
    times, area, widest = cavity_history(bed)
    area, widest = area[times > start], widest[times > start]
    void = resting_void_fraction(bed)
    return {"pressure_mean": float(pressure.mean()), "pressure_deviation": float(pressure.std()),
            "pressure_peaks_per_s": peaks(pressure, PEAK * pressure.mean()) / float(when[-1] - start),
            "expansion": float(height.mean()), "expansion_deviation": float(height.std()),
            "cavities": float(area.mean()), "widest_cavity": float(widest.max()),
            "slug_share_of_time": float((widest >= SLUG).mean()),
            "resting_void_fraction": void, "ergun_U_mf": bed.minimum_fluidisation(void),
            "terminal_velocity": bed.terminal_velocity(),
            "seconds_per_second": seconds_per_second(bed)}
