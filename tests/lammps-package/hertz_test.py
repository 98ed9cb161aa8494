# SPDX-License-Identifier: BSD-3-Clause
"""`normal hertz E nu`: restitution, capture and strength of Hertz contacts with a Hamaker attraction, against an
integration that knows nothing of the package."""
import math
import sys
import unittest

import numpy

from cohesion_tests.lammps_scenes import couples, pull_off
from cohesion_tests.lammps_scenes.oblique_pairs import PHASES, limits
from cohesion_tests.lammps_scenes.one_sphere import HEAD, MOVE
from cohesion_tests.test_cases import ScriptTestCase
from cohesion_tests.theory.hertz_contact import OUT, HertzPair
from cohesion_tests.theory.slow_ramp import HertzGrain

DIAMETER, DENSITY, MODULUS, HAMAKER = 1e-3, 2650.0, 5e6, 7.49e-19
START = 1.001 * OUT


def report(text):
    print(text, file=sys.stderr)


class Hertz(unittest.TestCase):
    def test_restitution(self):
        # The discrete orbit is of second order in the step, and loses a part of what the dashpot takes: at t_c/20 2e-4
        # for e 0.5 and 1e-5 for e 0.9, at t_c/10 four times that (IntegratedContact.RestitutionIsTheSameAtEverySpeed).
        for restitution, division, within in ((0.5, 20, 1e-3), (0.9, 20, 1e-4), (0.9, 10, 1e-3)):
            for speed in (1e-3, 0.1):
                pair = HertzPair(MODULUS, restitution, DIAMETER)
                dt = pair.contact_time(speed) / division
                atoms = []
                for phase in range(PHASES):
                    atoms += couples.couple(len(atoms) // 2, 1e-5 * DIAMETER + speed * dt * phase / PHASES,
                                            (0.0, speed, 0.0))
                steps = math.ceil(1e-5 * DIAMETER / speed / dt) + 3 * division
                end = couples.run(atoms, [f"1 1 {pair.words()}"], dt, steps)[0][-1]
                left = -(end[:, 0, 4] - end[:, 1, 4]) / speed / restitution
                report(f"e {restitution}, t_c/{division}, {speed} m/s: {left.min() - 1:.1e} {left.max() - 1:.1e}")
                self.assertLess(numpy.abs(left - 1).max(), within)

    def test_capture(self):
        # Within 1e-3 of the escape velocity at t_c/20, and 2e-3 at t_c/10 for a restitution of 0.7 or more.
        for restitution, division, grade in ((0.5, 20, 1e-3), *((e, *step) for e in (0.7, 0.9, 0.99)
                                                                for step in ((10, 2e-3), (20, 1e-3)))):
            pair = HertzPair(MODULUS, restitution, DIAMETER, HAMAKER)
            speeds = {angle: pair.escape_velocity(math.radians(angle), START) for angle in (0, 40, 80)}
            dt = pair.contact_time(pair.touching_speed(speeds[0])) / division
            for angle, slowest, fastest in limits(pair.words(), "gran/hamaker", speeds, grade, dt, 30 * division,
                                                  START, 0.0, START):
                report(f"e {restitution}, {angle} degrees, t_c/{division}: slowest parted {slowest}, captured {fastest}")
                self.assertEqual((slowest, fastest), (1 + grade, 1 - grade))

    def test_strength(self):
        for partner in pull_off.PARTNERS:
            for division in (10, 20, 50):
                grain = HertzGrain(5e6, 0.9, partner=partner)
                found = pull_off.load_at_parting(grain, division)
                report(f"{partner}, t_c/{division}: {found:.4f} F_ad")
                self.assertAlmostEqual(found, 1.0, delta=0.01)


class Words(ScriptTestCase):
    def test_what_stops_a_run(self):
        for words, settings, message in (
                ("normal hertz 5e6 0.25", "scheme sampled", "scheme sampled has linear springs only"),
                ("normal hertz 5e6 0.25 stiffness 100", "", "stiffness K = 100: is of a linear spring"),
                ("normal hertz 5e6 0.7", "", "Poisson's ratio nu = 0.7"),
                ("normal hertz -5e6 0.2", "", "Young's modulus E"),
                ("normal hooke 5e6 0.2", "", "normal"),
                ("normal hertz 5e6 0.2 damping 1e-3", "", "damping eta"),
                ("normal hertz 5e6 0.2 material_stiffness 1e5 hamaker 1e-19 cutoff 4e-10 1e-7", "", "material_stiffness")):
            with self.subTest(words=words):
                self.stops(f"{HEAD}pair_style gran/hamaker {settings}\npair_coeff * * {words}{MOVE}", message)


if __name__ == "__main__":
    unittest.main()
