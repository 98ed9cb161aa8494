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

    def test_a_softer_modulus_sticks_as_the_material_does(self):
        # The scaling is exact head-on; the grade is that of the step, as above.
        grade, division = 1e-3, 20
        real = JkrPair(1e3 * MODULUS, GAMMA, 0.9, DIAMETER)
        soft = JkrPair(MODULUS, GAMMA * 1e-3**0.4, 0.9, DIAMETER)
        speed = real.sticking_speed()
        self.assertGreater(JkrPair(MODULUS, GAMMA, 0.9, DIAMETER).sticking_speed(), 3 * speed)
        words = (f"normal hertz {MODULUS} {real.poisson} surface_energy {GAMMA} restitution 0.9 "
                 f"material_modulus {real.modulus} {real.poisson}")
        dt = soft.contact_time(speed) / division
        (_, slowest, fastest), = limits(words, "gran/jkr", {0: speed}, grade, dt, 30 * division, 0.0, 2 * soft.tearing,
                                        1.5 * soft.tearing)
        report(f"E over the material's 1e-3: slowest parted {slowest}, captured {fastest}")
        self.assertEqual((slowest, fastest), (1 + grade, 1 - grade))

    def test_strength(self):
        # 1.5 pi w R; by the lag of the ramp up to 0.3 %.
        for partner in pull_off.PARTNERS:
            for division in (10, 20):
                found = pull_off.load_at_parting(JkrGrain(5e6, 0.005, 0.9, partner=partner), division)
                report(f"{partner}, t_c/{division}: {found:.4f} of the pull-off force")
                self.assertAlmostEqual(found, 1.0, delta=5e-3)


class Words(ScriptTestCase):
    def test_the_run_prints_the_scaled_work_of_adhesion_and_what_it_keeps(self):
        for keep, note, ratios in (
                ("", "adhesion scaled from modulus E* 2.66667e+09 to 2.66667e+06, which keeps the escape velocity: work of "
                     "adhesion 0.1 -> 0.00630957", "escape velocity 1, pull-off force 0.0631"),
                # v_esc of JKR's contact goes with E^(-1/3) where the dashpot takes nothing.
                (" material_keep force", "adhesion not scaled from modulus E* 2.66667e+09 to 2.66667e+06, which keeps "
                                         "the pull-off force", "escape velocity 10, pull-off force 1")):
            words = f"normal hertz 5e6 0.25 surface_energy 0.05 material_modulus 5e9 0.25{keep}"
            output = self.goes(f"{HEAD}pair_style gran/jkr\npair_coeff * * {words}\n"
                               f"fix plate all wall/gran/jkr {words} zplane 0 NULL{MOVE}")
            self.assertEqual(output.count(note), 4)  # three pairs of types and a wall
            for names in ("1 - 1", "1 - wall"):
                self.assertIn(f"modulus E* 2.66667e+06 for 2.66667e+09 of the material: {ratios} times the material's "
                              f"({names})", output)

    def test_what_stops_a_run(self):
        for words, settings, message in (
                ("normal hertz 5e6 0.25", "", "needs 'normal hertz E nu' and 'surface_energy gamma'"),
                ("normal hertz 5e6 0.25 surface_energy 0.05 material_keep force", "",
                 "'material_keep' needs 'material_modulus E_m nu_m'"),
                ("stiffness 800 surface_energy 0.05", "", "needs 'normal hertz E nu' and 'surface_energy gamma'"),
                ("normal hertz 5e6 0.25 surface_energy -1", "", "surface energy gamma"),
                ("normal hertz 5e6 0.25 surface_energy 0.05", "scheme sampled", "scheme sampled does not follow the neck")):
            with self.subTest(words=words):
                self.stops(f"{HEAD}pair_style gran/jkr {settings}\npair_coeff * * {words}{MOVE}", message)


if __name__ == "__main__":
    unittest.main()
