# SPDX-License-Identifier: BSD-3-Clause
"""Forces of the cohesion model hamaker on particles at rest against the closed form."""

import itertools
import math
import unittest

from cohesion_tests.liggghts import EPSILON, Run

A, CUT, OUT = 1e-18, 4e-10, 1e-7
STIFFNESS = 800.0  # kn of the scripts
GAPS = [-1e-8, -1e-10, 0.5 * CUT, 1.5 * CUT, 2e-9, 3e-8, 0.99 * OUT, 1.01 * OUT, 10 * OUT]


def attraction(a, reduced_radius, gap):
    if gap >= OUT:
        return 0.0
    return a * reduced_radius / (6 * max(gap, CUT) ** 2)


def error_of_gap(force, gap, size):
    """What rounding of positions of `size` does to a force at `gap`: F goes as H^-2 beyond CUT."""
    return force * (4 * EPSILON * size / max(gap, CUT) + 16 * EPSILON)


class TwoSpheres(unittest.TestCase):
    def pair(self, gap, radii=(0.5e-3, 0.2e-3), types=(1, 2), a=A, how="launcher"):
        """Repulsion of the two, and the gap as the engine had it, after all rounding."""
        run = Run("in.two_spheres", how, radius1=radii[0], radius2=radii[1], type1=types[0],
                  type2=types[1], gap=gap, A=a, cut=CUT, out=OUT, model="hooke/stiffness",
                  tangential="history")
        one, two = (run.frames("forces.txt")[0][i] for i in (1, 2))
        force = two[3:]
        self.assertEqual([-f for f in one[3:]], force, "action is not minus reaction")
        r = math.dist(one[:3], two[:3])
        normal = [(q - p) / r for p, q in zip(one[:3], two[:3])]
        along = sum(n * f for n, f in zip(normal, force))
        across = math.dist(force, [n * along for n in normal])
        self.assertLessEqual(across, 16 * EPSILON * abs(along), "force is not central")
        return along, r - sum(radii)

    def check(self, gap, a, radii=(0.5e-3, 0.2e-3), **options):
        force, real_gap = self.pair(gap, radii=radii, **options)
        reduced = radii[0] * radii[1] / sum(radii)
        cohesion = attraction(a, reduced, real_gap)
        spring = STIFFNESS * max(-real_gap, 0.0)
        # The spring's overlap is rounded at the size of the distance.
        tolerance = (error_of_gap(cohesion, real_gap, sum(radii))
                     + 4 * EPSILON * (spring + STIFFNESS * sum(radii) * (real_gap < 0)))
        self.assertAlmostEqual(force, spring - cohesion, delta=tolerance)

    def test_force_is_the_closed_form_at_overlap_and_gap(self):
        for gap in GAPS:
            with self.subTest(gap=gap):
                self.check(gap, 2 * A)

    def test_preloaded_into_the_stock_program_it_is_the_same(self):
        for gap in (-1e-8, 2e-9, 1.01 * OUT):
            with self.subTest(gap=gap):
                self.check(gap, 2 * A, how="preload")
                self.assertEqual(self.pair(gap, how="preload"), self.pair(gap))

    def test_constant_is_that_of_the_pair_of_types(self):
        for types, factor in {(1, 1): 1, (1, 2): 2, (2, 1): 2, (2, 2): 3}.items():
            with self.subTest(types=types):
                self.check(2e-9, factor * A, types=types)

    def test_small_and_large_spheres_feel_it_up_to_the_outer_cutoff(self):
        for radii in itertools.product((2e-6, 1e-3), repeat=2):
            with self.subTest(radii=radii):
                self.check(0.999 * OUT, 2 * A, radii=radii)


class SphereAndWall(unittest.TestCase):
    def wall(self, gap, radius=0.5e-3, how="launcher"):
        run = Run("in.sphere_and_wall", how, radius=radius, gap=gap, A=A, cut=CUT, out=OUT,
                  model="hooke/stiffness", tangential="history", skin=1e-4,
                  wall="primitive type 2 zplane 0")
        x, y, z, fx, fy, fz = run.frames("forces.txt")[0][1]
        self.assertEqual((fx, fy), (0.0, 0.0))
        return fz, z - radius

    def check(self, gap, how="launcher", radius=0.5e-3):
        force, real_gap = self.wall(gap, how=how, radius=radius)
        cohesion = attraction(2 * A, radius, real_gap)
        spring = STIFFNESS * max(-real_gap, 0.0)
        tolerance = (error_of_gap(cohesion, real_gap, radius)
                     + 4 * EPSILON * (spring + STIFFNESS * radius * (real_gap < 0)))
        self.assertAlmostEqual(force, spring - cohesion, delta=tolerance)

    def test_force_is_the_closed_form_at_overlap_and_gap(self):
        for gap in GAPS:
            with self.subTest(gap=gap):
                self.check(gap)

    def test_preloaded_into_the_stock_program_it_is_the_same(self):
        for gap in (-1e-8, 2e-9, 1.01 * OUT):
            with self.subTest(gap=gap):
                self.check(gap, how="preload")

    def test_small_and_large_spheres_feel_it_up_to_the_outer_cutoff(self):
        for radius in (2e-6, 3e-3):
            with self.subTest(radius=radius):
                self.check(0.999 * OUT, radius=radius)


if __name__ == "__main__":
    unittest.main()
