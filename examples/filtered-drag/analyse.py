# SPDX-License-Identifier: BSD-3-Clause
"""Reads finished boxes: the slip between gas and grains, and how even the grains are. SI units."""

import math
import re
from pathlib import Path

import numpy as np

from cohesion_studies.case_entries import entries, gravity
from cohesion_studies.foam_results import function_table, read_cloud, written_times

FROM = 0.3  # share of the time in which clusters come about
BLOCKS = 5  # of the rest, for the error
WINDOWS = 4, 8  # across and up: parts of the box whose solid fractions say how even the grains are


class Box:
    """What a case is of, and what it has written."""

    def __init__(self, case):
        self.case = Path(case)
        self.is_of = entries(self.case / "constant/box")
        self.rho = entries(self.case / "constant/transportProperties")["rho"]

    @property
    def solid(self):
        """Mean solid fraction."""
        of = self.is_of
        grains = of["across"] * of["up"] * of["layers"]
        return grains * math.pi / 6 * of["diameter"]**3 / (of["width"] * of["height"] * of["depth"])

    @property
    def drive(self):
        """Weight of gas and grains, over the volume and the density of the gas, in form B [m/s2]: that of the grains in
        the gas, and of gas in the whole box."""
        return gravity(self.case) * (self.solid * (self.is_of["density"] - self.rho) / self.rho + 1)

    def velocities(self):
        """Times, and along y the mean velocities of gas, by its volume, and of grains, at these."""
        text = function_table(self.case, "gas", "volFieldValue.dat").read_text()
        gas = np.array(re.findall(r"^\s*(\S+)\s+\(\S+ (\S+) \S+\)", text, re.M), dtype=float)
        steps, grains = np.loadtxt(self.case / "grains.dat").T
        return gas[:, 0], gas[:, 1], np.interp(gas[:, 0], steps * self.is_of["dt"], grains)

    def places(self):
        """Times and places (n, 3) of the grains, of the written ones."""
        found = sorted(written_times(self.case).items())
        return [(time, read_cloud(folder)[0]) for time, folder in found if (folder / "lagrangian").exists()]

    def unevenness(self, places):
        """Standard deviation of the solid fractions of WINDOWS, over their mean, and over that of grains at random: 1
        when they are, above it in clusters."""
        size = self.is_of["width"], self.is_of["height"]
        counts = np.histogram2d(*(places[:, :2].T % np.array(size)[:, None]), WINDOWS, [(0, s) for s in size])[0]
        return counts.std() / math.sqrt(counts.mean())


def mean_and_error(times, values, end):
    """Mean from FROM of the time on, and its standard error by the means of BLOCKS equal times."""
    edges = np.linspace(FROM * end, end, BLOCKS + 1)
    means = np.array([values[(times > low) & (times <= high)].mean() for low, high in zip(edges, edges[1:])])
    return means.mean(), means.std(ddof=1) / math.sqrt(BLOCKS)


def figures(case):
    box = Box(case)
    times, gas, grains = box.velocities()
    end = box.is_of["endTime"]
    slip, error = mean_and_error(times, gas - grains, end)
    uneven = [box.unevenness(places) for time, places in box.places() if time > FROM * end]
    # Momentum of both, over that of the grains at the slip: 0 when drive and weight are the same
    drift = box.solid * box.is_of["density"] * grains[-1] + (1 - box.solid) * box.rho * gas[-1]
    return {"slip": float(slip), "slip_error": float(error), "first_slip": float((gas - grains)[times > 0.01][0]),
            "unevenness": float(np.mean(uneven)), "drift": float(drift / (box.solid * box.is_of["density"] * slip))}


def slip_of(results):
    """Mean over seeds, and its error: by those of the runs, or between them where that is more."""
    slips = np.array([result["slip"] for result in results])
    within = math.sqrt(sum(result["slip_error"]**2 for result in results)) / len(slips)
    between = slips.std(ddof=1) / math.sqrt(len(slips)) if len(slips) > 1 else 0.0
    return slips.mean(), max(within, between)


def differences(kinds):
    """{"4 times": {...}} of the kinds of run.py, those that have all three: slip in coarse cells less that in fine ones,
    without and with the filter, over that in fine ones; `left`: the second over the first, sizes, and its error."""
    found = {}
    for times in (4, 8):
        names = "fine", f"coarse-{times}", f"filtered-{times}"
        if not all(name in kinds for name in names):
            continue
        (fine, e_fine), (coarse, e_coarse), (filtered, e_filtered) = (slip_of(kinds[name]) for name in names)
        off, with_filter = coarse - fine, filtered - fine
        left = abs(with_filter / off)
        error = math.sqrt(e_filtered**2 + (left * e_coarse)**2 + ((1 - with_filter / off) * e_fine)**2) / abs(off)
        found[f"{times} times"] = {"unfiltered": off / fine, "unfiltered_error": math.hypot(e_coarse, e_fine) / fine,
                                   "filtered": with_filter / fine,
                                   "filtered_error": math.hypot(e_filtered, e_fine) / fine,
                                   "left": left, "left_error": error}
    return found


def table(differences_found):
    """Text."""
    return "\n".join(f"cells of {name}: slip over that in fine cells, less 1: {of['unfiltered']:+.3f} +- "
                     f"{of['unfiltered_error']:.3f}, with the filter {of['filtered']:+.3f} +- {of['filtered_error']:.3f};"
                     f" left of it {of['left']:.2f} +- {of['left_error']:.2f}" for name, of in differences_found.items())
