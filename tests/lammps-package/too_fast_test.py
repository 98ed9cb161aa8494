# SPDX-License-Identifier: BSD-3-Clause
"""Where particles fly too far in a step the message names who, where and how fast, and into whom it was put when that
is why."""
import unittest

from cohesion_tests.lammps_scenes.small_box import box, spheres
from cohesion_tests.test_cases import ScriptTestCase

HEAD = box(boundary="p p f") + spheres((1, 0.002, 0.002, 0.005), (1, 0.007, 0.002, 0.005),
                                       (1, "%s", 0.002, 0.005)) + """%s
neighbor %s bin
neigh_modify delay 0
timestep %s
"""
GRAN = "pair_style gran/hamaker\npair_coeff * * stiffness 8000 restitution 0.9\n"
HARD = "pair_style hard/square_well\npair_coeff * * restitution 0.9\n"
TAIL = "fix move all nve/sphere\nrun 50\n"
APART = "place them apart from each other"


class TooFast(ScriptTestCase):
    def test_spheres_within_each_other(self):
        """0.2 mm apart: they overlap by 0.8 of the diameter."""
        for ranks in (1, 2):
            output = self.stops(HEAD % (0.0072, "", 1e-4, 2e-6) + GRAN + TAIL, "particles fly up to",
                                  "The fastest: particle ", "has the speed ", "of the smaller diameter",
                                APART, ranks=ranks)
            self.assertRegex(output, r"particle (2 at \(0.0069.* overlaps particle 3|"
                                     r"3 at \(0.0072.* overlaps particle 2) by 0.7")

    def test_spheres_a_little_within_each_other(self):
        """0.87 mm apart: of an overlap of 0.13 of the diameter half is left where they are too fast."""
        for ranks in (1, 2):
            self.stops(HEAD % (0.00787, "", 1.2e-4, 2e-6) + GRAN + TAIL, "particles fly up to", "overlap",
                       "of the smaller diameter", APART, ranks=ranks)

    def test_the_fastest_is_not_the_one_that_overlaps(self):
        fast = HEAD % (0.00787, "set atom 1 vz 10", 1e-5, 2e-6)
        output = self.stops(fast + GRAN + TAIL, "The fastest: particle 1 at (0.002", APART, ranks=1)
        self.assertRegex(output, r"has the speed 10; particles 2 and 3 overlap by 0\.1[23]")

    def test_a_sphere_that_is_only_fast(self):
        """Hard spheres on one process have no list of the engine to fly out of."""
        for pair, ranks in ((GRAN, 1), (GRAN, 2), (HARD, 2)):
            fast = HEAD % (0.005, "set atom 1 vx 10", 1e-5, 2e-6)
            output = self.stops(fast + pair + TAIL, "The fastest: particle 1 at (0.002",
                                " 0.002 0.005) has the speed 10", ranks=ranks)
            self.assertNotIn("overlaps", output)

    def test_at_a_wall(self):
        wall = "fix w all wall/gran/hamaker stiffness 8000 restitution 0.9 zplane 0 NULL\n"
        quiet = "pair_style square_well\npair_coeff * * well 0 1\n"
        self.stops(HEAD % (0.005, "set atom 2 vz -36", 1e-4, 1.5e-5) + quiet + wall + TAIL, "fix w wall/gran/hamaker",
                     "could miss the wall", "particle 2 at (0.007", "has the speed 36", ranks=1)


if __name__ == "__main__":
    unittest.main()
