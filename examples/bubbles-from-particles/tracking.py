# SPDX-License-Identifier: BSD-3-Clause
"""Bubbles in beds of one layer of spheres, tracked from picture to picture. Lengths in m, times in s."""

from dataclasses import dataclass

import numpy as np
from scipy.spatial import cKDTree

from cohesion_studies.cavities import cavities

AROUND = 1.5  # diameters: radius of the circle that a share of solids is of
EMPTY = 0.4  # share of the area below which a bubble is: about half of that of a packed bed
SMALLEST = 4  # diameters: smaller cavities come and go within the emulsion
SHORTEST = 0.04  # s that a bubble has to be tracked for
ALIKE = 1.5  # areas of a bubble in two pictures differ by no more than this factor


def solid_share(places, diameter, width, height):
    """Share of the area that is spheres, in circles around the middles of square cells of about a diameter: an array
    (up, across). `places`: (n, 2), x from 0 to width and y from 0. Spheres are mirrored at side walls and plate, so that
    a circle across them is a whole one."""
    reach = AROUND * diameter
    x, y = places.T
    mirrored = [np.column_stack([a, b]) for b in (y, -y) for a in (x, -x, 2 * width - x)]
    near = [images[np.all((images > -reach) & (images < [width + reach, height + reach]), axis=1)] for images in mirrored]
    middles = [(np.arange(n) + 0.5) * size / n for n, size in ((round(height / diameter), height),
                                                               (round(width / diameter), width))]
    grid = np.stack(np.meshgrid(*middles, indexing="ij")[::-1], axis=-1)
    inside = cKDTree(np.concatenate(near)).query_ball_point(grid.reshape(-1, 2), reach, return_length=True)
    return inside.reshape(grid.shape[:2]) * (diameter / 2 / reach)**2


@dataclass
class Bubble:
    """In one picture."""

    cells: set  # numbers of its cells
    area: float
    x: float
    y: float
    free: bool  # it touches no wall, and not the plate

    @property
    def diameter(self):
        """Of the circle of its area."""
        return float(np.sqrt(4 / np.pi * self.area))


def bubbles(share, cell, diameter):
    """Those of one picture, `share` as of solid_share() and cells of the sizes `cell`, x and y."""
    found = []
    for members in cavities(share < EMPTY):
        rows, columns = members.T
        one = Bubble(set(rows * share.shape[1] + columns), len(members) * cell[0] * cell[1],
                     (columns.mean() + 0.5) * cell[0], (rows.mean() + 0.5) * cell[1],
                     bool(rows.min() > 0 and columns.min() > 0 and columns.max() < share.shape[1] - 1))
        if one.diameter >= SMALLEST * diameter:
            found.append(one)
    return found


def successors(now, then):
    """{number of a bubble now: number of it then}: pairs that overlap each other and no third, so that none has split or
    merged, and are alike in area."""
    over = np.array([[bool(a.cells & b.cells) for b in then] for a in now]).reshape(len(now), len(then))
    return {i: int(j) for i in range(len(now)) for j in np.flatnonzero(over[i])
            if over[i].sum() == 1 and over[:, j].sum() == 1
            and max(now[i].area, then[j].area) <= ALIKE * min(now[i].area, then[j].area)}


def follow(pictures):
    """Lives of bubbles, each a list of (number of the picture, Bubble), while they are free; `pictures`: bubbles() of
    each."""
    done, open_lives = [], {}
    for k, now in enumerate(pictures):
        before = successors(pictures[k - 1], now) if k else {}
        came_from = {then: first for first, then in before.items()}
        lives = {}
        for number, bubble in enumerate(now):
            if bubble.free:
                life = open_lives.pop(came_from.get(number), [])
                lives[number] = life + [(k, bubble)]
        done += open_lives.values()
        open_lives = lives
    return done + list(open_lives.values())


def measured(life, times):
    """(mean diameter, mean height, rise velocity, when, mean place across) of a life that is long enough; None of one that
    is not. The velocity is the slope of a straight line through the heights."""
    when = np.array([times[k] for k, _ in life])
    if when[-1] - when[0] < SHORTEST * (1 - 1e-9):
        return None
    heights = np.array([bubble.y for _, bubble in life])
    return (float(np.mean([bubble.diameter for _, bubble in life])), float(heights.mean()),
            float(np.polyfit(when - when[0], heights, 1)[0]), float(when.mean()),
            float(np.mean([bubble.x for _, bubble in life])))
