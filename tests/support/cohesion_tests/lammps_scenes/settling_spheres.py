# SPDX-License-Identifier: BSD-3-Clause
"""Spheres that settle under gravity on a layer of spheres that do not move."""
import numpy

from cohesion_tests import lammps as engine
from cohesion_tests.lammps_scenes import cohesive_gas as gas
from cohesion_tests.theory import hertzian_laws

GRAVITY, CUT = 9.81, 4e-10


def hamaker_constant(ratio):
    """A [J] of spheres whose adhesion is `ratio` times their weight: F_ad = A d/(24 H_cut^2)."""
    return ratio * gas.MASS * GRAVITY * 24 * CUT**2 / gas.DIAMETER


def write(folder, side, layers, seed):
    """A layer of side^2 fixed spheres (type 2) and above it `layers` of jittered ones with random
    velocities (type 1)."""
    random = numpy.random.default_rng(seed)
    step = 1.1 * gas.DIAMETER
    grid = (0.5 + numpy.arange(side)) * step
    atoms = []
    for layer in range(layers + 1):
        for x in grid:
            for y in grid:
                place = numpy.array([x, y, (0.6 + layer) * step])
                if layer > 0:
                    place += random.uniform(-0.04, 0.04, 3) * gas.DIAMETER
                atoms.append({"type": 1 if layer else 2, "diameter": gas.DIAMETER,
                              "density": gas.DENSITY, "x": place,
                              "v": random.uniform(-0.05, 0.05, 3) if layer else numpy.zeros(3)})
    engine.write_spheres(folder, atoms, [(0.0, side * step), (0.0, side * step),
                                         (0.0, (layers + 3) * step)], 2)


def follow(folder, steps_per_contact, duration, samples=50, ranks=1, law="linear", **options):
    """Thermo table (step, kinetic energy, largest speed, residual) and processor seconds. law: one of hertzian_laws, of
    which t_c is that at 0.1 m/s."""
    dt = (gas.CONTACT_TIME if law == "linear" else hertzian_laws.contact_time(law, 0.1)) / steps_per_contact
    every = max(1, round(duration / dt / samples))
    values = {"scheme": "exact", "K": gas.STIFFNESS, "e": 0.9, "mu": 0.3, "A": 0.0, "cut": CUT,
              "out": 1e-7, "skin": 0.2 * gas.DIAMETER, "D": gas.DIAMETER, "file": "end.txt",
              **gas.law_words(law), **options}
    return gas.table(engine.run("in.gran_hamaker_settling", folder, ranks=ranks, dt=dt,
                                steps=every * samples, every=every, **values))


def liveliest_share(end):
    """Of the kinetic energy in a dump of the end, what the one sphere has that has most of it."""
    energy = (end[:, 4:7]**2).sum(axis=1) + gas.DIAMETER**2 / 10 * (end[:, 7:10]**2).sum(axis=1)
    return energy.max() / energy.sum()
