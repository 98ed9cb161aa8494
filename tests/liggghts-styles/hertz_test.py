# SPDX-License-Identifier: BSD-3-Clause
"""model hertz with scheme exact: capture of pairs and at walls, restitution, strength and tangential springs, against an
integration that knows nothing of the engine."""
import math
import sys
import unittest

from cohesion_tests.liggghts_scenes import pull_off
from cohesion_tests.liggghts_scenes.impacts import DIAMETER, WALLS, left_after_sticking, limits
from cohesion_tests.liggghts_scenes.scene import hamaker
from cohesion_tests.theory.hertz_contact import CUT, OUT, HertzPair

A = 7.49e-19
START = 1.001 * OUT
MODELS = "model hertz tangential off cohesion hamaker"
EXACT = "tangential_damping off scheme exact"


class Hertz(unittest.TestCase):
    def test_capture(self):
        # Within 1e-3 of the escape velocity at t_c/20, 2e-3 at t_c/10 for a restitution above 0.7.
        for restitution, division, grade in ((0.5, 20, 1e-3), (0.9, 20, 1e-3), (0.9, 10, 2e-3)):
            for name, wall in WALLS.items():
                pair = HertzPair(5e6, restitution, DIAMETER, A, poisson=0.3, plane=bool(wall))
                dt = pair.contact_time(pair.touching_speed(pair.escape_velocity(0.0, START))) / division
                for degrees in (0, 80) if wall else (0, 40, 80):
                    speed = pair.escape_velocity(math.radians(degrees), START)
                    slowest, fastest = limits(MODELS, EXACT, hamaker(A, cut=CUT, out=OUT), restitution, speed, degrees,
                                              grade, dt, 30 * division, START, 0.0, START, wall)
                    print(f"e {restitution}, t_c/{division}, {name}, {degrees} degrees: slowest parted {slowest}, fastest "
                          f"captured {fastest}", file=sys.stderr)
                    self.assertEqual((slowest, fastest), (1 + grade, 1 - grade))

    def test_strength(self):
        # The lag of the ramp and how it is read: slow_ramp.py, pull_off.py.
        for partner in pull_off.PARTNERS:
            for division in (10, 20):
                found = pull_off.HertzGrain(5e6, 0.9, partner=partner).load_at_parting(division)
                print(f"{partner}, t_c/{division}: {found:.4f} F_ad", file=sys.stderr)
                self.assertAlmostEqual(found, 1.0, delta=0.01)

    def test_a_tangential_spring_that_stiffens_gives_no_energy(self):
        # Elastic impacts that stick: the engine alone (sampled), and its tangential model under scheme exact.
        time = HertzPair(5e6, 1 - 1e-12, DIAMETER, poisson=0.3).contact_time(0.1)
        for scheme in ("sampled", "exact"):
            for degrees in (5, 20, 45, 70, 85):
                left = left_after_sticking("model hertz tangential history cohesion hamaker",
                                           f"tangential_damping off scheme {scheme}", hamaker(0, cut=CUT, out=OUT), degrees,
                                           time)
                print(f"{scheme}, {degrees} degrees: {left - 1:.2e}", file=sys.stderr)
                if scheme == "exact":
                    self.assertLess(left, 1 + 1e-3)


if __name__ == "__main__":
    unittest.main()
