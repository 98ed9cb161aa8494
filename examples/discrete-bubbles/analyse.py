# SPDX-License-Identifier: BSD-3-Clause
"""Reads one finished reactor: hold-up, sizes, the mean circulation, and whether what came in is inside or has left.
Lengths in m, velocities in m/s."""

import re
from pathlib import Path

import numpy as np

from cohesion_studies.case_entries import entries
from cohesion_studies.foam_results import read_cells, vector_list, written_times

RISE = 0.711  # v/sqrt(g d) of one bubble
G = 9.81
# Columns of bubbles.dat
COLUMNS = ("step", "injected", "injected_volume", "removed", "removed_volume", "merged", "broken", "pending", "inside",
           "inside_volume")


class Reactor:
    """What a case is of, and what it has written."""

    def __init__(self, case):
        self.case = Path(case)
        self.is_of = entries(self.case / "constant/reactor")
        table = np.loadtxt(self.case / "bubbles.dat", ndmin=2)
        self.course = dict(zip(COLUMNS, table.T))
        self.across, self.up = int(self.is_of["cells"]), int(self.is_of["rows"]) + 1
        self.last = max(written_times(self.case).items())[1]

    @property
    def superficial(self):
        """Velocity of the gas."""
        return self.is_of["flow"] / self.is_of["width"] ** 2

    def means(self):
        """Of U, an array (up, y, x, 3), and of the share of bubbles, (up, y, x), over the time from meanFrom on."""
        shape = self.up, self.across, self.across
        text = (self.last / "UMean").read_text()
        vectors = vector_list(self.last / "UMean")[: np.prod(shape)]
        assert "nonuniform" in text
        return vectors.reshape(*shape, 3), 1 - read_cells(self.last / "voidFractionMean", np.prod(shape)).reshape(shape)

    def bubbles(self):
        """Places and radii at the last written time."""
        folder = self.last / "lagrangian/particles"
        text = re.search(r"\n\d+\s*\((.*)\)", (folder / "radius").read_text(), re.S)
        places = vector_list(folder / "positions")
        if text:
            return places, np.array(text[1].split(), float)
        same = re.search(r"\{(\S+)\}", (folder / "radius").read_text())
        return places, np.full(len(places), float(same[1]))


def figures(case):
    reactor = Reactor(case)
    course, is_of = reactor.course, reactor.is_of
    steps = course["step"]
    held = steps >= steps[-1] * is_of["meanFrom"] / is_of["endTime"]
    volume = is_of["width"] ** 2 * is_of["height"]
    first = course["inside"][0]  # the one that is there
    one = np.pi / 6 * is_of["diameter"] ** 3
    velocity, _ = reactor.means()
    middle = reactor.across // 2
    half = velocity[reactor.up // 4: 3 * reactor.up // 4, :, :, 2]
    inside, inside_volume = (course[name][held].mean() for name in ("inside", "inside_volume"))
    mean_diameter = (6 / np.pi * inside_volume / inside) ** (1 / 3)
    rise = RISE * np.sqrt(G * mean_diameter)
    ends = {name: course[name][-1] for name in COLUMNS}
    return {
        "holdup": inside_volume / volume,
        "without_circulation": reactor.superficial / (reactor.superficial + rise),
        "bubbles": inside,
        "mean_diameter": mean_diameter,
        "merged": ends["merged"],
        "in_the_middle": half[:, middle - 1: middle + 1, middle - 1: middle + 1].mean(),
        "at_the_walls": np.mean([half[:, 0].mean(), half[:, -1].mean(), half[:, :, 0].mean(), half[:, :, -1].mean()]),
        "count_missing": first + ends["injected"] - ends["merged"] + ends["broken"] - ends["removed"] - ends["inside"],
        "volume_missing": abs(first * one + ends["injected_volume"] - ends["removed_volume"] - ends["inside_volume"])
        / ends["injected_volume"],
        "flow_kept": ends["injected_volume"] / (is_of["flow"] * is_of["endTime"]),
    }
