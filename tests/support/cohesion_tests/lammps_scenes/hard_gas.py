# SPDX-License-Identifier: BSD-3-Clause
"""Gases of hard particles with square wells in a periodic box, for LAMMPS and for the event-driven
reference."""
import math

import numpy

from cohesion_tests import lammps as engine
from cohesion_tests.lammps_scenes import hard_spheres as hard
from cohesion_tests.theory.event_driven_reference import Reference


class Gas:
    """`count` particles at a fraction of the volume (area) on a lattice that melts at once, speeds of
    standard deviation 1 per component, no momentum; radii: taken in turn at random, mass 1 at
    radius 0.5 and as radius^3."""

    def __init__(self, count, fraction, dimension=3, radii=(0.5,), seed=1):
        random = numpy.random.default_rng(seed)
        self.dimension = dimension
        self.radius = random.choice(radii, count)
        self.mass = (self.radius / 0.5)**3
        size = math.pi * self.radius**2 if dimension == 2 else 4 / 3 * math.pi * self.radius**3
        self.length = (size.sum() / fraction)**(1 / dimension)
        side = math.ceil(count**(1 / dimension) - 1e-9)
        grid = (numpy.arange(side) + 0.5) * self.length / side
        places = numpy.array(numpy.meshgrid(*dimension * [grid])).reshape(dimension, -1).T
        self.x, self.v = numpy.zeros((count, 3)), numpy.zeros((count, 3))
        self.x[:, :dimension] = places[random.permutation(len(places))[:count]]
        self.v[:, :dimension] = random.normal(size=(count, dimension))
        self.v -= self.mass @ self.v / self.mass.sum()
        self.v /= math.sqrt((self.v**2).sum() / count / dimension)
        self.box = numpy.full(3, self.length)
        if dimension == 2:
            self.box[2] = math.inf

    def spin(self, seed=2):
        spin = 2 * numpy.random.default_rng(seed).normal(size=self.x.shape)
        return spin * [0, 0, 1] if self.dimension == 2 else spin

    def write(self, folder, spin=None):
        spin = numpy.zeros_like(self.x) if spin is None else spin
        edge = (0.0, self.length)
        engine.write_spheres(folder, [hard.atom(x, v, radius, mass, 1, w) for x, v, radius, mass, w in
                                      zip(self.x, self.v, self.radius, self.mass, spin)],
                             [edge, edge, (-0.5, 0.5) if self.dimension == 2 else edge], 1)

    def reference(self, moved=0.0, **law):
        """moved: by up to so much at random, to see how fast paths part [m]."""
        away = moved * numpy.random.default_rng(9).uniform(-1, 1, self.x.shape)
        away[:, self.dimension:] = 0.0
        return Reference(self.x + away, self.v, self.radius, self.mass, self.box,
                         inertia=0.5 if self.dimension == 2 else 0.4, **law)

    def run(self, folder, pair, dt, steps, **options):
        return hard.run(folder, pair, dt, steps, dimension=self.dimension, **options)


class RowThatJustFits(Gas):
    """Discs of diameter 1 at rest in a box `count` wide and high: a row that fills the width when it lies flat on the
    floor, each second one raised, and over it `rows` with one less, apart from each other."""

    def __init__(self, count, rows, raised=0.05):
        super().__init__(count + rows * (count - 1), 0.5, 2)
        self.length = float(count)
        self.v[:] = 0.0
        step = math.sqrt(1 - raised**2)
        places = [(count / 2 + (n - (count - 1) / 2) * step, 0.5 + n % 2 * raised) for n in range(count)]
        for row in range(1, rows + 1):
            places += [(0.6 + row % 2 / 2 + 1.04 * n, 0.5 + raised + 1.01 * row) for n in range(count - 1)]
        self.x[:, :2] = places
