# SPDX-License-Identifier: BSD-3-Clause
"""A dense gas under pair_style gran/hamaker, on several ranks and restarted."""
import math
import unittest

import numpy

from cohesion_tests import lammps as engine
from cohesion_tests.lammps_scenes import cohesive_gas as gas

D, T_C = gas.DIAMETER, gas.CONTACT_TIME


class RanksAndRestart(unittest.TestCase):
    """216 spheres at solid fraction 0.5 with damping, friction and adhesion, 360 steps of t_c/10: two
    to seven collisions each, while a third of the energy is left.

    Restarts and divided runs order no sum differently on one rank: the same numbers, all digits. Ranks
    order sums differently and hold other images: 2^-53 of the box, 1e-18 m, a step. Velocities follow
    from places: in the ten steps of a contact that adds up to sqrt(10) 1e-18 m/dt by chance, and in the
    flight of 100 dt to the next collision to 3e-16 m. A collision makes a difference 1 + 2 l/d times
    larger in place, twice that in direction; the mean path l is d/20: 2.4^6 = 190 in six more: 6e-14 m.
    Speeds: times w0 = 3.4e4 1/s."""
    TOLERANCE = 6e-14  # [m]

    @classmethod
    def setUpClass(cls):
        keeper = engine.temporary_folder()
        cls.addClassCleanup(keeper.cleanup)
        cls.folder = keeper.name
        gas.write(cls.folder, 6, 0.5, 0.05, seed=3)
        cls.whole, cls.table = cls.end()

    @classmethod
    def end(cls, **options):
        table, _ = gas.follow(cls.folder, 10, 36 * T_C, 1, e=0.9, mu=0.3, A=2e-18, **options)
        return engine.dump(cls.folder, "end.txt"), table

    def near(self, end):
        difference = numpy.abs(end - self.whole).max(axis=0)
        w0 = math.pi / T_C
        self.assertEqual(difference[0], 0.0)
        self.assertLessEqual(difference[1:4].max(), self.TOLERANCE)
        self.assertLessEqual(difference[4:7].max(), self.TOLERANCE * w0)
        self.assertLessEqual(difference[7:].max() * D / 2, self.TOLERANCE * w0)

    def test_contacts_are_there(self):
        self.assertLess(self.table[-1, 3], 0.5 * self.table[0, 3])
        self.assertGreater(self.table[-1, 3], 0.01 * self.table[0, 3])

    def test_ranks(self):
        for ranks in (2, 4):
            with self.subTest(ranks=ranks):
                self.near(self.end(ranks=ranks)[0])

    def test_two_runs(self):
        numpy.testing.assert_array_equal(self.end(mode="halves")[0], self.whole)

    def test_restart(self):
        numpy.testing.assert_array_equal(self.end(mode="restart_file")[0], self.whole)
        numpy.testing.assert_array_equal(self.end(mode="restart")[0], self.whole)
        self.near(self.end(mode="restart", ranks=2)[0])


if __name__ == "__main__":
    unittest.main()
