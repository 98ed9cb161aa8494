# SPDX-License-Identifier: BSD-3-Clause
"""Adhesion in a mixture of sizes of one type with cohesion hamaker: each pair has the reduced radius of its own two
spheres, each sphere at a wall its own radius. The force is read from what it presses a spring: a pair that nothing else
moves comes to rest at the overlap F_ad/K."""
import math
import unittest

from cohesion_tests.liggghts import EPSILON
from cohesion_tests.liggghts_scenes.scene import DENSITY, STIFFNESS, contact, frames, hamaker, part, sphere

SMALL, LARGE = 0.15e-3, 0.6e-3  # radii
A, CUT, OUT = 7.49e-19, 4e-10, 1e-7
COUPLES = ((SMALL, SMALL), (SMALL, LARGE), (LARGE, LARGE))
DAMPING = 1e4  # dashpot over reduced mass, [1/s]: amplitudes fall by exp(-DAMPING t/2)
TIME = 2 * 28 / DAMPING  # to 7e-13
SIZE = 0.01


def spheres():
    """Couples that touch, along y, then one of each size that touches the wall z = -SIZE."""
    made = []
    for column, (one, other) in enumerate(COUPLES):
        x = -4e-3 + 3e-3 * column
        made += [sphere((x, 0.0, 0.0), radius=one), sphere((x, one + other, 0.0), radius=other)]
    return made + [sphere((-4e-3 + 3e-3 * column, 5e-3, -SIZE + radius), radius=radius)
                   for column, radius in enumerate((SMALL, LARGE))]


def mass(radius):
    return 4 / 3 * math.pi * DENSITY * radius**3


def reduced(one, other):
    return one * other / (one + other)


class Rest(unittest.TestCase):
    def test_each_pair_and_each_sphere_at_the_wall_has_its_own_force(self):
        dt = math.pi * math.sqrt(mass(SMALL) / 2 / STIFFNESS) / 16
        steps = math.ceil(TIME / dt)
        for scheme in ("exact", "sampled"):
            models = "model hooke/stiffness tangential off cohesion hamaker"
            settings = f" tangential_damping off scheme {scheme}"
            end = frames(spheres(), models + settings, hamaker(A, cut=CUT, out=OUT),
                         [f"fix plane all wall/gran {models} primitive type 2 zplane {-SIZE}{settings}"], dt=dt,
                         steps=steps, every=steps, contacts=contact(gamman=DAMPING))[-1]
            place = {number: part(row, "x") for number, row in end.items()}
            measured = [(reduced(one, other), reduced(mass(one), mass(other)),
                         one + other - math.dist(place[2 * k + 1], place[2 * k + 2]))
                        for k, (one, other) in enumerate(COUPLES)]
            measured += [(radius, mass(radius), radius - SIZE - place[number][2])
                         for radius, number in ((SMALL, 7), (LARGE, 8))]
            for radius, moved, overlap in measured:
                with self.subTest(scheme, radius=radius):
                    force = A * radius / (6 * CUT**2)
                    # What is left of the first overlap; the rounding of places; and that motion ends where its way in
                    # a step, K x/eta dt of a distance x from the balance, is lost in it.
                    rounding = (4 + DAMPING * moved / (STIFFNESS * dt)) * EPSILON * SIZE
                    tolerance = math.exp(-DAMPING * TIME / 2) + rounding * STIFFNESS / force
                    self.assertLess(tolerance, 1e-6)
                    self.assertLessEqual(abs(STIFFNESS * overlap / force - 1), tolerance)


if __name__ == "__main__":
    unittest.main()
