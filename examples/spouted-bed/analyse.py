# SPDX-License-Identifier: BSD-3-Clause
"""Reads one finished bed: pressure drop, spout, fountain and annulus, the gas velocity at which the spout closes, and
whether all spheres are inside the mesh. Lengths in m, pressures in Pa, velocities in m/s; gas velocities are
superficial, in the inlet."""

import re
from dataclasses import dataclass
from functools import cached_property
from math import pi, sqrt
from pathlib import Path

import numpy as np

from cohesion_studies.case_entries import entries, gravity, particle_variables
from cohesion_studies.foam_results import function_table, read_cloud, written_times

OPEN = 0.6  # void fraction: halfway between a resting bed's and a dilute spout's, above which the axis is open
DILUTE = 0.8  # void fraction of a spout
WINDOW = 0.1  # s over which the share of time with an open axis is taken
ANNULUS = 0.6  # of the wall's radius: where it begins
WITHIN = 0.8  # of the resting bed's height: spheres below are of the annulus


@dataclass
class Bed:
    """What a case is of, from its dictionaries."""

    case: Path

    def __post_init__(self):
        self.vessel = entries(self.case / "constant/vessel")
        self.gas = entries(self.case / "constant/transportProperties")
        self.spheres = particle_variables(self.case)
        self.gravity = gravity(self.case)
        text = (self.case / "constant/schedule").read_text()
        rows = re.findall(r"\(\s*([^\s()]+)\s+\(\s*\S+\s+(\S+)\s+\S+\s*\)\s*\)", text)
        self.schedule = np.array(rows, dtype=float).T

    def velocity(self, time):
        return np.interp(time, *self.schedule)

    @property
    def steady(self):
        """Begin and end of the fastest gas."""
        times, velocities = self.schedule
        fastest = times[velocities == velocities.max()]
        return fastest[0], fastest[-1]

    @property
    def spouting(self):
        """Of the fastest gas, begin and end of the second half."""
        begin, end = self.steady
        return (begin + end) / 2, end

    @cached_property
    def times(self):
        """Folders by time."""
        return {time: folder for time, folder in sorted(written_times(self.case).items()) if time > 0}

    def wall(self, height):
        """Radius of the circle that has the area of the vessel there."""
        return self.vessel["baseDiameter"] / 2 + self.vessel["slope"] * np.minimum(height, self.vessel["shoulder"])

    def volume(self, height):
        """Of the cone below a height."""
        low, high = self.wall(0), self.wall(height)
        return pi / 3 * height * (low**2 + low * high + high**2)


def mean(values):
    """nan without values."""
    return float(np.mean(values)) if len(values) else float("nan")


def resting(bed):
    """Height and void fraction of the resting bed: that of a layer between a tenth and a half of the highest sphere's
    height, and the height of the cone that all spheres fill with it."""
    places, _ = read_cloud(next(iter(bed.times.values())))
    height, sphere = places[:, 1], pi / 6 * bed.spheres["d"]**3
    low, high = np.array([0.1, 0.5]) * height.max()
    inside = np.count_nonzero((low < height) & (height < high))
    solid = inside * sphere / (bed.volume(high) - bed.volume(low))
    # The cone's radius rises by the slope: its volume is a difference of cubes.
    first, slope = bed.wall(0), bed.vessel["slope"]
    last = (first**3 + 3 * slope / pi * len(places) * sphere / solid)**(1 / 3)
    return float((last - first) / slope), 1 - solid


def olazar(bed, height):
    """Minimum spouting velocity in the inlet, of Olazar et al. (1992), for a conical bed of this height."""
    d, rho, nu = bed.spheres["d"], bed.gas["rho"], bed.gas["nu"]
    archimedes = bed.gravity * d**3 * (bed.spheres["density"] - rho) / (rho * nu**2)
    widening = 2 * bed.wall(height) / bed.vessel["inletDiameter"]
    return 0.126 * sqrt(archimedes) * widening**1.68 * bed.vessel["slope"]**-0.57 * nu / d


def column(bed, height, void):
    """What a column of the resting bed weighs in the gas [Pa]."""
    return (1 - void) * (bed.spheres["density"] - bed.gas["rho"]) * bed.gravity * height


def pressure_drop(bed):
    """Times and pressure in the inlet, without the gas's own weight."""
    time, p = np.loadtxt(function_table(bed.case, "inlet", "surfaceFieldValue.dat"), comments="#", ndmin=2).T
    return time, bed.gas["rho"] * (p - bed.gravity * bed.vessel["height"])


def axis(bed):
    """Times, heights of the probes and void fractions (times, heights)."""
    file = function_table(bed.case, "axis", "voidFraction")
    heights = [float(y) for y in re.findall(r"^# Probe \d+ \(\S+ (\S+) \S+\)", file.read_text(), re.M)]
    table = np.loadtxt(file, comments="#", ndmin=2)
    return table[:, 0], np.array(heights), table[:, 1:]


def share_open(bed, height):
    """Times, and the share of the WINDOW around them in which the axis is open up to the resting bed's surface."""
    time, heights, values = axis(bed)
    is_open = values[:, heights < height].min(axis=1) > OPEN
    wide = max(1, round(WINDOW / (time[1] - time[0])))
    # Of a window that is cut short at an end, what there is of it
    kernel = np.ones(wide)
    return time, np.convolve(is_open, kernel, "same") / np.convolve(np.ones_like(time), kernel, "same")


def closing_velocity(bed, height):
    """Of the gas where the share with an open axis falls through half for the last time; nan without a spout, or with
    one that is open at the end."""
    time, share = share_open(bed, height)
    above = np.flatnonzero(share >= 0.5)
    return float(bed.velocity(time[above[-1]])) if len(above) and above[-1] < len(time) - 1 else float("nan")


def planes(bed):
    """Of the mesh that is the spheres' wall, which is convex: outward normals, distances from the origin."""
    text = (bed.case / "wall.stl").read_text()
    number = r"([-+.\deE]+)"
    rows = re.findall(rf"normal {number} {number} {number}\s+outer loop\s+vertex {number} {number} {number}", text)
    rows = np.array(rows, dtype=float)
    offset = (rows[:, :3] * rows[:, 3:]).sum(axis=1)
    # One triangle of each plane
    _, first = np.unique(rows[:, :3].round(3), axis=0, return_index=True)
    return np.column_stack([rows[:, :3], offset])[first]


def depth(walls, places):
    """Of places, how far inside the nearest plane of a convex vessel they are; negative outside."""
    return (walls[:, 3] - places @ walls[:, :3].T).min(axis=1)


def inside(bed):
    """Over all written times: spheres missing, centres outside the mesh, and the deepest overlap with it over the
    radius."""
    walls, radius = planes(bed), bed.spheres["d"] / 2
    missing = outside = 0
    deepest = -np.inf
    for folder in bed.times.values():
        places, _ = read_cloud(folder)
        depths = depth(walls, places)
        missing = max(missing, int(bed.spheres["count"]) - len(places))
        outside = max(outside, np.count_nonzero((depths < 0) | (places[:, 1] > bed.vessel["height"])))
        deepest = max(deepest, 1 - depths.min() / radius)
    return {"spheres_missing": missing, "spheres_outside": int(outside), "deepest_overlap_at_wall": float(deepest)}


def motion(bed, height):
    """Over the written times with steady gas: mean height of the highest sphere above the resting surface over that of
    the bed, share of spheres above the surface, mean upward velocity in the annulus and on the axis, nan without
    spheres there."""
    begin, end = bed.spouting
    highest, above, annulus, middle = [], [], [], []
    for time, folder in bed.times.items():
        if begin <= time <= end:
            places, velocities = read_cloud(folder)
            radius, low = np.hypot(places[:, 0], places[:, 2]), places[:, 1] < WITHIN * height
            highest.append(places[:, 1].max() / height - 1)
            above.append((places[:, 1] > height + bed.spheres["d"]).mean())
            annulus += list(velocities[low & (radius > ANNULUS * bed.wall(places[:, 1])), 1])
            middle += list(velocities[low & (radius < bed.vessel["inletDiameter"] / 4), 1])
    found = {"fountain_height": highest, "share_in_fountain": above, "annulus_velocity": annulus,
             "spout_velocity": middle}
    return {name: mean(values) for name, values in found.items()}


def dilute_height(heights, profile, height):
    """Height up to which void fractions on the axis are above DILUTE, half a probe's distance beyond the last of these,
    over that of the bed."""
    if np.isnan(profile).any():
        return float("nan")
    dilute = len(profile) if profile.min() > DILUTE else int(np.argmax(profile <= DILUTE))
    return float(min(1, dilute * (heights[1] - heights[0]) / height))


def exchange(bed):
    """Over all gas steps, the largest of what gas and spheres do not balance by, of momentum and solid."""
    found = re.findall(r"imbalance (\S+), solid volume error (\S+)", (bed.case / "log.cohesiveBedFoam").read_text())
    return dict(zip(("momentum_imbalance", "solid_imbalance"), map(float, np.array(found, dtype=float).max(axis=0))))


def figures(case):
    """Those of one bed; pressure drops over column()."""
    bed = Bed(Path(case))
    height, void = resting(bed)
    begin, end = bed.spouting
    time, drop = pressure_drop(bed)
    drop = drop / column(bed, height, void)
    when, heights, values = axis(bed)
    steady = (begin <= when) & (when <= end)
    profile = np.array([mean(probe) for probe in values[steady][:, heights < height].T])
    closing, correlation = closing_velocity(bed, height), olazar(bed, height)
    before = time < bed.steady[0]
    return {"resting_height": height, "resting_void_fraction": float(void), "olazar_u_ms": float(correlation),
            "closing_velocity": closing, "closing_over_olazar": closing / correlation,
            "peak_drop": float(drop[before].max()),
            "peak_velocity": float(bed.velocity(time[before][drop[before].argmax()])),
            "spouting_drop": mean(drop[(begin <= time) & (time <= end)]),
            "axis_void_fraction": float(profile.min()), "dilute_height": dilute_height(heights, profile, height),
            **motion(bed, height), **inside(bed), **exchange(bed)}
