# SPDX-License-Identifier: BSD-3-Clause
"""Agglomerates by the thesis's definition, and orientations of collisions, from the record of a run's events.

A pair is an agglomerate from its capture to its escape (thesis, section 4.2.2)."""

import math
from collections import Counter, defaultdict

import numpy as np

PARTS = 8  # of the time that is evaluated, for the errors


def read_events(file):
    """(time in steps, kind, i, j) of each event, in order."""
    with open(file) as lines:
        for line in lines:
            step, fraction, kind, i, j = line.split()
            yield int(step) - 1 + float(fraction), kind, int(i), int(j)


def blocks(file):
    """Lines of each step of a dump."""
    with open(file) as lines:
        next(lines)
        block = []
        for line in lines:
            if line.startswith("ITEM: TIMESTEP"):
                yield block
                block = []
            else:
                block.append(line)
        yield block


def read_positions(file, first):
    """From the step `first` on, by step: side of the box, its tilt, and x and y by ID."""
    found = {}
    for lines in blocks(file):
        if int(lines[0]) < first:
            continue
        (_, _, tilt), (low, high, _) = (map(float, line.split()) for line in lines[4:6])
        table = np.array(" ".join(lines[8:]).split(), float).reshape(-1, 3)
        at = np.empty((len(table) + 1, 2))
        at[table[:, 0].astype(int)] = table[:, 1:]
        found[int(lines[0])] = high - low, tilt, at
    return found


def separation(positions, i, j):
    """From i to j, of the nearest images."""
    side, tilt, at = positions
    x, y = at[j] - at[i]
    rows = round(y / side)
    x, y = x - rows * tilt, y - rows * side
    return np.array([x - side * round(x / side), y])


def along_shear(positions, time, i, j):
    """Whether the line of centres is in the compressive quadrants of the shear, x y < 0 from i to j; None without the
    positions of both steps."""
    step = math.floor(time)
    if step not in positions or step + 1 not in positions:
        return None
    before, after = (separation(positions[k], i, j) for k in (step, step + 1))
    x, y = before + (time - step) * (after - before)
    return x * y < 0


def size(partners):
    """Mean number of discs of the agglomerates."""
    left, agglomerates, total = set(partners), 0, len(partners)
    while left:
        agglomerates += 1
        edge = [left.pop()]
        while edge:
            near = partners[edge.pop()] & left
            left -= near
            edge += near
    return total / agglomerates


class Parts:
    """Sums of values and their numbers in equal parts of the time."""

    def __init__(self, begin, end):
        self.begin, self.width = begin, (end - begin) / PARTS
        self.sums, self.numbers = np.zeros(PARTS), np.zeros(PARTS)

    def add(self, time, value):
        part = int((time - self.begin) / self.width)
        if 0 <= part < PARTS:
            self.sums[part] += value
            self.numbers[part] += 1

    def mean(self):
        """[mean, standard error]"""
        if not all(self.numbers):
            return [math.nan, math.nan]
        parts = self.sums / self.numbers
        return [self.sums.sum() / self.numbers.sum(), parts.std(ddof=1) / math.sqrt(PARTS)]


def evaluate(folder, dt, start):
    """After the share `start` of the run: durations and sizes by capture and escape, share of collisions along the
    shear of free discs and of captured pairs. Removes the record."""
    last = max(int(lines[0]) for lines in blocks(folder / "positions.txt"))
    first = math.ceil(start * last)
    positions = read_positions(folder / "positions.txt", first)
    durations, sizes, free, captured = (Parts(first, last) for _ in range(4))
    partners, since, kinds, seen = defaultdict(set), {}, Counter(), first
    for time, kind, i, j in read_events(folder / "events.txt"):
        kinds[kind] += 1
        while seen < time:
            if partners:
                sizes.add(seen, size(partners))
            seen += (last - first) / 200
        if kind == "capture" and j not in partners[i]:
            for a, b in ((i, j), (j, i)):
                if not partners[a]:
                    since[a] = time
                partners[a].add(b)
        elif kind == "escape" and j in partners[i]:
            for a, b in ((i, j), (j, i)):
                partners[a].discard(b)
                if not partners[a]:
                    durations.add(time, (time - since[a]) * dt)
        elif kind in ("collision", "elastic"):
            share = captured if j in partners[i] else None if partners[i] or partners[j] else free
            along = along_shear(positions, time, i, j) if share else None
            if along is not None:
                share.add(time, along)
        for a in (i, j):
            if a in partners and not partners[a]:
                del partners[a]
    for name in ("events.txt", "positions.txt"):
        (folder / name).unlink()
    return {"captured_duration": durations.mean(), "captured_size": sizes.mean(), "free_along_shear": free.mean(),
            "captured_along_shear": captured.mean(), "recorded": dict(kinds)}
