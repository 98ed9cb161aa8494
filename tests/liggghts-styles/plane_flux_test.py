# SPDX-License-Identifier: BSD-3-Clause
"""Momentum through planes across the gradient of a sheared box of LIGGGHTS, counted from the places of spheres and
contacts in each step, against the stress that compute shear/profile and the pairs' part of compute pressure give for
the volume."""
import math
import sys
import unittest

import numpy

from cohesion_tests import dumps
from cohesion_tests.liggghts_scenes import steady_spheres as spheres

SIDE, FRACTION, E = 6, 0.3, 0.9
LENGTH = spheres.length(SIDE, FRACTION)
STEPS, EVERY, BEFORE = 6000, 50, 3.0
PLANES = (numpy.arange(32) + 0.3) * LENGTH / 32
BLOCKS = 12


def through(low, high):
    """How often the ways from one height to another lead up through each plane and its images: a row for each."""
    return (numpy.floor((high[:, None] - PLANES) / LENGTH) - numpy.floor((low[:, None] - PLANES) / LENGTH))


def frames(done):
    """Columns y, vx, vy of all spheres in each step: array (steps, spheres, 3), sorted by id."""
    return numpy.array([snapshot.sorted() for snapshot in dumps.parse(done.files["out.txt"])])[:, :, 1:]


def by_flight(now, then, dt):
    """y- and x-momentum, of x that beyond the mean flow at the plane, that spheres carry up from one step to the
    next. Those that the engine has put back as their images between are taken back."""
    count = numpy.rint((then[:, 0] - now[:, 0]) / LENGTH)
    high = then[:, 0] - count * LENGTH
    vx = (now[:, 1] + then[:, 1] - count * LENGTH) / 2
    vy = (high - now[:, 0]) / dt
    times = through(now[:, 0], high)
    # The image of the plane that lies on the way.
    at = PLANES + LENGTH * numpy.floor((numpy.maximum(now[:, 0], high)[:, None] - PLANES) / LENGTH)
    return (times.sum(axis=1) * vy).sum(), (times * (vx[:, None] - (at - LENGTH / 2))).sum()


def by_contacts(touches, dt):
    """Momentum that each contact hands up in its step: force on the sphere above, by as many planes as lie
    between."""
    away = touches.places[:, 1] - touches.places[:, 0]
    images = numpy.rint(away[:, 1] / LENGTH)
    away[:, 0] -= images * LENGTH * touches.step * dt
    away[:, 1] -= images * LENGTH
    away -= numpy.array([1, 0, 1]) * LENGTH * numpy.rint(away / LENGTH)
    distance = numpy.linalg.norm(away, axis=1)
    low = touches.places[:, 0, 1]
    handed = through(low, low + away[:, 1]).sum(axis=1) * touches.force * dt
    return distance, handed * away[:, 1] / distance, handed * away[:, 0] / distance


class PlaneFlux(unittest.TestCase):
    def test_momentum_through_planes_is_the_stress(self):
        law, dt = spheres.hard_enough(FRACTION, E, 0.015)
        T = spheres.theory.steady(FRACTION, E).temperature
        table, done = spheres.run(SIDE, FRACTION, law, T, dt, STEPS, BEFORE, 1, EVERY, contacts=True,
                                  columns=("y", "vx", "vy"))
        touches, path = spheres.Touches(done, law, dt), frames(done)
        self.assertEqual(path.shape, (STEPS + 1, SIDE**3, 3))
        self.assertGreater(touches.count, 1000)

        # The places of pairs are theirs: as far apart as the overlap says.
        distance, *handed = by_contacts(touches, dt)
        self.assertLess(abs(distance - 1 + touches.overlap).max(), 1e-12)

        # Per window of the table, by the planes and by the volume. A contact counts in the step of its force; those
        # of the first dump, before the first step, are of no window.
        window = numpy.ceil((touches.step - (touches.step.max() - STEPS)) / EVERY).astype(int)
        volume = numpy.array([table["kinetic yy"] + table["contact yy"],
                              table["carried"] / LENGTH**3 + table["contact xy"]])[:, 1:]
        plane = numpy.array([numpy.bincount(window, part, len(table["T"]))[1:] for part in handed])
        flown = numpy.array([by_flight(now, then, dt) for now, then in zip(path, path[1:])])
        plane += flown.reshape(-1, EVERY, 2).sum(axis=1).T
        plane /= LENGTH**2 * len(PLANES) * EVERY * dt
        plane, volume = (a.reshape(2, BLOCKS, -1).mean(axis=2) for a in (plane, volume))

        stress = volume.mean(axis=1)
        self.assertGreater(stress[0], 0)
        self.assertLess(stress[1], 0)
        off = plane - volume
        error = off.std(axis=1, ddof=1) / math.sqrt(BLOCKS)
        print("yy, xy: by planes over by volume", plane.mean(axis=1) / stress, "+-", error / abs(stress),
              file=sys.stderr)
        # Student's t of eleven degrees: beyond 4.5 once in a thousand.
        self.assertLess(abs(off.mean(axis=1) / error).max(), 4.5)
        # Enough to see it if the contacts across the faces of the box were left out. Of what contacts carry they have a
        # share: of unit vectors k, mean of kx^2 |ky|^3 over mean of kx^2 ky^2 is 5/8 (3/4 for yy), times 1/LENGTH.
        contacts = numpy.array([table["contact yy"], table["contact xy"]])[:, 1:].mean(axis=1)
        self.assertLess((4.5 * error / abs(contacts)).max(), 5 / 8 / LENGTH)


if __name__ == "__main__":
    unittest.main()
