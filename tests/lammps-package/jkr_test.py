# SPDX-License-Identifier: BSD-3-Clause
"""pair_style gran/jkr and its walls: sticking speed, strength, and the force against the overlap, against JKR's formulas."""
import math
import sys
import unittest

from cohesion_tests.lammps_scenes import pull_off
from cohesion_tests.lammps_scenes.oblique_pairs import limits
from cohesion_tests.lammps_scenes.one_sphere import HEAD, MOVE
from cohesion_tests.test_cases import ScriptTestCase
from cohesion_tests.theory.jkr_contact import JkrPair
from cohesion_tests.theory.slow_ramp import JkrGrain

DIAMETER, MODULUS, GAMMA = 1e-3, 1e7, 0.05


def report(text):
    print(text, file=sys.stderr)


class Jkr(unittest.TestCase):
    def test_sticking(self):
        # Within 1e-3 of the sticking speed at t_c/20, and 2e-3 at t_c/10 for a restitution above 0.7.
        for restitution, division, grade in ((0.5, 20, 1e-3), (0.9, 20, 1e-3), (0.9, 10, 2e-3), (0.99, 20, 1e-3)):
            pair = JkrPair(MODULUS, GAMMA, restitution, DIAMETER)
            speeds = {angle: pair.sticking_speed(math.radians(angle)) for angle in (0, 40, 80)}
            dt = pair.contact_time(speeds[0]) / division
            for angle, slowest, fastest in limits(pair.words(), "gran/jkr", speeds, grade, dt, 30 * division,
                                                  0.0, 2 * pair.tearing, 1.5 * pair.tearing):
                report(f"e {restitution}, {angle} degrees, t_c/{division}: slowest parted {slowest}, captured {fastest}")
                self.assertEqual((slowest, fastest), (1 + grade, 1 - grade))

    def test_strength(self):
        # 1.5 pi w R; by the lag of the ramp up to 0.3 %.
        for partner in pull_off.PARTNERS:
            for division in (10, 20):
                found = pull_off.load_at_parting(JkrGrain(5e6, 0.005, 0.9, partner=partner), division)
                report(f"{partner}, t_c/{division}: {found:.4f} of the pull-off force")
                self.assertAlmostEqual(found, 1.0, delta=5e-3)


class Words(ScriptTestCase):
    def test_what_stops_a_run(self):
        for words, settings, message in (
                ("normal hertz 5e6 0.25", "", "needs 'normal hertz E nu' and 'surface_energy gamma'"),
                ("stiffness 800 surface_energy 0.05", "", "needs 'normal hertz E nu' and 'surface_energy gamma'"),
                ("normal hertz 5e6 0.25 surface_energy -1", "", "surface energy gamma"),
                ("normal hertz 5e6 0.25 surface_energy 0.05", "scheme sampled", "scheme sampled has linear springs only")):
            with self.subTest(words=words):
                self.stops(f"{HEAD}pair_style gran/jkr {settings}\npair_coeff * * {words}{MOVE}", message)


if __name__ == "__main__":
    unittest.main()
