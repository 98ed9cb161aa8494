# SPDX-License-Identifier: BSD-3-Clause
"""Sheared soft spheres in LIGGGHTS over very many steps (in.shear_long): what shear-long.py and its test share.

Spheres at solid fraction 0.3, rate 1, on one rank, on two, and continued from the middle by two ranks and by one
(long_shear.py of the LAMMPS package). Paths of many colliding spheres part after some ten collisions, whatever rounds
differently: what must come out is that no sphere is lost, that only rounding moves the momentum, that the profile is
straight, and that temperature and shear stress are the same within their statistical errors."""
import math

import numpy

from cohesion_tests import lammps as engine
from cohesion_tests.lammps_scenes import long_shear
from cohesion_tests.liggghts_scenes.steady_spheres import Contact, length, theory

FRACTION, RESTITUTION, BLOCKS = 0.3, 0.9, 10
COLUMNS = ("temperature", "kinetic stress", "contact stress")


def write_start(folder, side):
    """On a lattice, with the profile, the speeds that kinetic theory has."""
    random = numpy.random.default_rng(11)
    box = length(side, FRACTION)
    places = (numpy.array(numpy.meshgrid(*3 * [range(side)])).reshape(3, -1).T + 0.5) * box / side
    v = random.normal(0, math.sqrt(theory.steady(FRACTION, RESTITUTION).temperature), places.shape)
    v[:, 0] += places[:, 1] - box / 2
    atoms = [{"type": 1, "diameter": 1.0, "density": 6 / math.pi, "x": x, "v": w}
             for x, w in zip(places, v - v.mean(axis=0))]
    engine.write_spheres(folder, atoms, 3 * [(0.0, box)], 1, tilt=(0.0, 0.0, 0.0))


def law(steps, strain):
    """A contact that lasts 0.003 of the strain, or fifteen steps if those are longer."""
    return Contact(max(0.003, 15 * strain / steps), RESTITUTION)


def all_runs(folder, side, steps, strain, samples, step_done):
    contact = law(steps, strain)
    return long_shear.all_runs(folder, side, steps, strain, samples, step_done, write_start,
                               stiffness=f"{contact.spring:.17g}", gamman=f"{2 * contact.damping:.17g}")


def momentum_room(steps, strain, side):
    """Largest momentum per component that rounding leaves, at five standard deviations: in each step each sphere's
    velocity, of no more than the box's own, is rounded twice, and the force of a contact across a face, spring times
    overlap, is worked out on either side from two places of which one is that of an image, off by 2^-53 of the box."""
    contact, spheres, box = law(steps, strain), side**3, length(side, FRACTION)
    # Of a step: collisions of the gas (Enskog) as long as a contact lasts, and of a unit vector 1/2 along each axis.
    T = theory.steady(FRACTION, RESTITUTION).temperature
    frequency = 4 * theory.density(FRACTION) * theory.contact_value(FRACTION) * math.sqrt(math.pi * T)
    across = spheres * frequency * contact.duration / 2 * 3 / (2 * box)
    velocities = box * math.sqrt(2 * spheres)
    forces = strain / steps * contact.spring * box * math.sqrt(2 * across)
    return 5 * math.sqrt(steps) * 2.0**-53 * math.hypot(velocities, forces)


class Result:
    """Of one run: fewest spheres, strain, largest momentum, by how many standard errors the worst layer is off the
    line and that error, means of COLUMNS with theirs."""

    def __init__(self, done, side, strain):
        # The means of the first line are of no samples.
        _, atoms, strained, *momentum, T, kinetic, contact = numpy.array(list(done.table.values()))[:, 1:]
        self.name, self.seconds = done.name, done.seconds
        self.atoms, self.strain, self.momentum = atoms.min(), strained[-1], numpy.abs(momentum).max()
        self.crooked, self.layer_error = long_shear.crooked(done.profile, length(side, FRACTION))
        kept = numpy.array([T, kinetic, contact])[:, strained > min(10, strain / 4)]
        blocks = kept[:, len(kept[0]) % BLOCKS:].reshape(len(COLUMNS), BLOCKS, -1).mean(axis=2)
        self.means, self.errors = blocks.mean(axis=1), blocks.std(axis=1, ddof=1) / math.sqrt(BLOCKS)


def apart(one, other):
    """Largest difference of means, in standard errors of it."""
    return (abs(one.means - other.means) / numpy.hypot(one.errors, other.errors)).max()
