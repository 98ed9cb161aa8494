# SPDX-License-Identifier: BSD-3-Clause
"""Pull-off under a slow load: contacts of scheme exact part at F_ad whatever the step, stiffness, restitution, size,
partner and load. benchmarks/liggghts-styles/pull-off-campaign.py prints the whole campaign."""

import sys
import unittest

from cohesion_tests.liggghts_scenes.pull_off import Grain

# The lag of the ramp is 1.5e-3 of F_ad, the load is read to 3e-4. A contact that carries a load has the overlap
# (F_ad - L)/K when it is to part; where it had F_ad/K - L/K' before, it swings by the difference, of which half a
# hundredth of F_ad may be left (contact_solver.h).
WITHIN = 0.01


class PullOff(unittest.TestCase):
    def check(self, division, *grain, scheme="exact", pulled_by="addforce", **partner):
        with self.subTest(division=division, grain=grain, scheme=scheme, pulled_by=pulled_by, **partner):
            found = Grain(*grain, **partner).load_at_parting(division, scheme, pulled_by)
            print(f"t_c/{division}, K and e {grain}, {partner}, {scheme}, {pulled_by}: {found:.4f} F_ad", file=sys.stderr)
            self.assertAlmostEqual(found, 1.0, delta=WITHIN)

    def test_at_any_step(self):
        for stiffness, restitution, divisions in ((10.0, 0.99, (4, 10, 20)), (10.0, 0.9, (4, 10, 20)), (50.0, 0.9, (4, 10, 50)),
                                                  (50.0, 0.5, (4, 10, 50)), (500.0, 0.3, (4, 10))):
            for division in divisions:
                self.check(division, stiffness, restitution)

    def test_any_partner_and_load(self):
        for partner in ("plane", "cylinder", "pair", "mesh"):
            for pulled_by in ("addforce",) if partner == "pair" else ("addforce", "gravity"):
                self.check(10, 50.0, 0.5, partner=partner, pulled_by=pulled_by)

    def test_pulled_by_a_wall(self):
        for restitution, division in ((0.9, 4), (0.5, 4), (0.3, 10), (0.5, 20)):
            self.check(division, 50.0, restitution, pulled_by="wall")

    def test_load_that_grows_fast_on_a_deep_contact(self):
        for division in (4, 5):
            self.check(division, 10.0, 0.3, 1e-3)

    def test_sampled(self):
        self.check(50, 50.0, 0.5, scheme="sampled")


if __name__ == "__main__":
    unittest.main()
