# SPDX-License-Identifier: BSD-3-Clause
"""Agglomerates of spheres of diameter 1 in a tilted box: places that are hard to get right, and a search
over all pairs that says what is right."""

import numpy

BOX = numpy.array([10.0, 8.0, 6.0])
RANGE = 0.2  # gap up to which two spheres are bound


def places_in_chain(start, steps):
    return numpy.array([start + 1.1 * numpy.array(s) for s in steps])


class Search:
    """Sets of spheres of diameter 1 in the tilted box, found by walking from partner to partner."""

    def __init__(self, x, tilt):
        self.edges = numpy.array([[BOX[0], 0, 0], [tilt, BOX[1], 0], [0, 0, BOX[2]]])
        self.x = x
        n = len(x)
        self.set_of, self.unfolded, self.wraps = -numpy.ones(n, int), x.copy(), set()
        for first in range(n):
            if self.set_of[first] < 0:
                self.walk(first)
        self.sizes = numpy.bincount(self.set_of, minlength=n)

    def walk(self, first):
        self.set_of[first], waiting = first, [first]
        while waiting:
            i = waiting.pop()
            for k in range(-1, 2):
                for l in range(-1, 2):
                    for m in range(-1, 2):
                        d = self.x + numpy.array([k, l, m]) @ self.edges - self.x[i]
                        r = numpy.sqrt((d**2).sum(axis=1))
                        for j in numpy.nonzero((r < 1.0 + RANGE) & (r > 0))[0]:
                            place = self.unfolded[i] + d[j]
                            if self.set_of[j] < 0:
                                self.set_of[j], self.unfolded[j] = first, place
                                waiting.append(j)
                            elif numpy.abs(place - self.unfolded[j]).max() > 1.0:
                                self.wraps.add(first)

    def vector(self):
        sets = [s for s in range(len(self.x)) if self.sizes[s] > 1]
        gyration = [numpy.sqrt(self.unfolded[self.set_of == s].var(axis=0).sum()) for s in sets
                    if s not in self.wraps]
        number = len(sets)
        mean = sum(self.sizes[s] for s in sets) / number
        return [number, number, mean, 0.0, max(self.sizes) / len(self.x), 0.0, 0.0,
                numpy.mean(gyration) if gyration else 0.0, len(self.wraps)]

    def gyration_of_each(self):
        """Radius of gyration of the set of each: 0 for a single sphere, -1 where it is bound to its own image."""
        of_set = {s: -1.0 if s in self.wraps else numpy.sqrt(self.unfolded[self.set_of == s].var(axis=0).sum())
                  for s in set(self.set_of)}
        return numpy.array([of_set[s] for s in self.set_of])

    def sizes_up_to(self, most):
        """Number of sets of each size, of `most` and more in the last."""
        sizes = self.sizes[self.sizes > 0]
        return [*((sizes == s).sum() for s in range(1, most)), (sizes >= most).sum()]

    def of_each(self):
        """Set, named by its smallest ID, 0 for a single sphere; its size."""
        size = self.sizes[self.set_of]
        return numpy.array([numpy.where(size == 1, 0, self.set_of + 1), size]).T


def in_box(x, tilt):
    lattice = numpy.array([[BOX[0], 0, 0], [tilt, BOX[1], 0], [0, 0, BOX[2]]])
    return x - numpy.floor(x @ numpy.linalg.inv(lattice)) @ lattice


def constructed():
    """A chain through all three faces, a ring around a corner, one bound to its own image along the
    flow, a pair, a single one."""
    chain = places_in_chain([9.2, 7.3, 5.4], [(0, 0, 0), (1, 0, 0), (1, 1, 0), (1, 1, 1),
                                              (2, 1, 1)])
    angle = numpy.arange(6) * numpy.pi / 3
    ring = numpy.array([5.0, 0.0, 3.0]) + 1.1 * numpy.array([numpy.cos(angle),
                                                            numpy.sin(angle), 0 * angle]).T
    along = numpy.array([[1.0 * k, 3.0, 3.0] for k in range(10)])
    pair = numpy.array([[8.0, 4.9, 0.5], [8.0, 4.9, 5.4]])
    single = numpy.array([[4.0, 5.0, 0.5]])
    return numpy.concatenate([chain, ring, along, pair, single])


def passing():
    """A particle at rest; one passes above it, and before that one has left its range another passes
    below. Gives places, velocities and when the ranges are entered and left."""
    across = 1.1  # of the paths from the middle; never in contact
    half = numpy.sqrt((1.0 + RANGE)**2 - across**2)
    x = numpy.array([[5.0, 4.0, 3.0], [3.5 - half, 4.0 + across, 3.0],
                     [2.95 - half, 4.0 - across, 3.0]])
    v = numpy.array([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 0.0, 0.0]])
    first, second = (1.5, 1.5 + 2 * half), (2.05, 2.05 + 2 * half)
    assert second[0] < first[1]
    return x, v, first, second
