# SPDX-License-Identifier: BSD-3-Clause
"""Sheared smooth inelastic discs: balance of power, and kinetic theory (sheared_discs.py)."""
import unittest

from cohesion_tests.lammps_scenes.steady_shear import SteadyShear
from cohesion_tests.theory import sheared_discs as theory


class Theory(unittest.TestCase):
    def test_nearly_elastic_limit(self):
        """The viscosity of a dilute gas falls by (1 + c)^-2, c = cooling rate/rate of the decay of
        stress = (1 - e^2)/2, of a denser one by less."""
        for fraction in (0.01, 0.2, 0.4):
            ratio = theory.steady(fraction, 0.9999).temperature / theory.nearly_elastic(fraction, 0.9999)
            self.assertLess(ratio, 1)
            self.assertGreater(ratio, 1 - 1.01 * (1 - 0.9999**2))

    def test_power(self):
        for restitution in (0.5, 0.9):
            state = theory.steady(0.2, restitution)
            work = -(state.kinetic + state.impulsive)[0, 1]
            self.assertLess(abs(work / state.dissipation - 1), 1e-9)


class Discs(SteadyShear, unittest.TestCase):
    def test_damping(self):
        self.sheared(16, 0.2, 0.9, 0.03, 20000)

    def test_little_damping(self):
        self.sheared(16, 0.2, 0.97, 0.02, 20000)

    def test_little_damping_dilute(self):
        self.sheared(16, 0.05, 0.97, 0.012, 27000, skin=5.0)

    def test_elastic_discs_heat_as_they_are_sheared(self):
        """Without a steady state: nothing is lost, and all the work becomes energy of their own."""
        table, area = self.run_discs(16, 0.2, 1.0, 1.0, 0.001, 2000, before=0)
        self.assertEqual(table["c_events[5]"][-1], 0)
        gained = table["c_sums[2]"][-1] - table["c_sums[2]"][0]
        self.assertGreater(gained, 0.5 * table["c_sums[2]"][0])
        self.power(table, area, 0.001, 16**2, gained)


if __name__ == "__main__":
    unittest.main()
