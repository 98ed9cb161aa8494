# SPDX-License-Identifier: BSD-3-Clause
"""Particles that fly far in a step have their list of neighbours made anew in each, and their contacts are as those of
others. Where they fly too far for that the message names who, where and how fast, and into whom it was put when that is
why."""
import unittest

from cohesion_tests.lammps_scenes.small_box import box, spheres
from cohesion_tests.test_cases import ScriptTestCase
from cohesion_tests.thermo import thermo_end

HEAD = box(boundary="p p f") + spheres((1, 0.002, 0.002, 0.005), (1, 0.007, 0.002, 0.005),
                                       (1, "%s", 0.002, 0.005)) + """%s
neighbor %s bin
neigh_modify delay 0
timestep %s
"""
GRAN = "pair_style gran/hamaker\npair_coeff * * stiffness 8000 restitution 0.9\n"
HARD = "pair_style hard/squarewell\npair_coeff * * restitution 0.9\n"
TAIL = "fix move all nve/sphere\nrun 50\n"
APART = "place them apart from each other"


# Two spheres of equal speed that meet head-on
MEET = box(boundary="f f f") + spheres((1, 0.0035, 0.005, 0.005), (1, 0.0065, 0.005, 0.005)) + """
set atom 1 vx %(speed)g
set atom 2 vx -%(speed)g
neighbor 1e-4 bin
neigh_modify delay 0
timestep 1e-6
compute v all reduce max vx
thermo_style custom step c_v
pair_style gran/hamaker%(scheme)s
pair_coeff * * stiffness 2e5 restitution 0.9
fix move all nve/sphere
run %(steps)d
"""


def meet(speed, steps, scheme=""):
    return MEET % {"speed": speed, "steps": steps, "scheme": scheme}


class FarFlights(ScriptTestCase):
    def test_fast_spheres_rebound(self):
        """In a step each flies up to 0.55 of the skin; a list that is not new allows for a tenth of it. They part with
        the restitution's share of their speed: in closed form for the exact scheme, whose contact takes t_c = 5.85
        steps; sampled to (pi dt/t_c)^2/2 = 0.144: a contact that is first seen at the end of a step, v dt deep, has the
        energy of the spring there too much."""
        for scheme, share, ranks in (("", 1e-9, 1), ("", 1e-9, 2), (" scheme sampled", 0.144, 1)):
            for speed in (5, 20, 40, 55):
                # 1 mm to fly for each, the contact, and a little of the way back
                script = meet(speed, int(1e-3 / speed / 1e-6) + 30, scheme)
                output = self.goes(script, ranks=ranks)
                last = thermo_end(output)["c_v"]
                self.assertAlmostEqual(last / (0.9 * speed), 1.0, delta=share, msg=f"{speed} m/s{scheme}")
                warned = output.count("above 70 % of the")
                self.assertEqual(warned, 1 if speed > 0.7 * 60 else 0, f"{speed} m/s")

    def test_limit(self):
        """1.2 skins for the flights of both in a step, forth and back: 0.3 of 0.1 mm in half a step of 1 us."""
        self.stops(meet(65, 50), "particles fly up to 3.25", "the neighbour list allows for 3", "a smaller time step or a skin")

    def test_a_fast_collision_is_no_sphere_that_was_put_there(self):
        """They overlap by 0.03 of the diameter and approach by 0.13 of it in a step."""
        inside = meet(65, 50).replace("neighbor", "set atom 1 x 0.004515\nset atom 2 x 0.005485\nneighbor", 1)
        for ranks in (1, 2):
            output = self.stops(inside, "The fastest: particle ", "in a fast collision with particle ", ranks=ranks)
            self.assertNotIn(APART, output)


class TooFast(ScriptTestCase):
    def test_spheres_within_each_other(self):
        """0.2 mm apart: they overlap by 0.8 of the diameter."""
        for ranks in (1, 2):
            output = self.stops(HEAD % (0.0072, "", 1.7e-5, 2e-6) + GRAN + TAIL, "particles fly up to",
                                  "The fastest: particle ", "has the speed ", "of the smaller diameter",
                                APART, ranks=ranks)
            self.assertRegex(output, r"particle (2 at \(0.0069.* overlaps particle 3|"
                                     r"3 at \(0.0072.* overlaps particle 2) by 0.7")

    def test_spheres_a_little_within_each_other(self):
        """0.87 mm apart: of an overlap of 0.13 of the diameter half is left where they are too fast."""
        for ranks in (1, 2):
            self.stops(HEAD % (0.00787, "", 2e-5, 2e-6) + GRAN + TAIL, "particles fly up to", "overlap",
                       "of the smaller diameter", APART, ranks=ranks)

    def test_the_fastest_is_not_the_one_that_overlaps(self):
        fast = HEAD % (0.00787, "set atom 1 vz 10", 1.7e-6, 2e-6)
        output = self.stops(fast + GRAN + TAIL, "The fastest: particle 1 at (0.002", APART, ranks=1)
        self.assertRegex(output, r"has the speed 10; particles 2 and 3 overlap by 0\.1[23]")

    def test_a_sphere_that_is_only_fast(self):
        """Hard spheres on one process have no list of the engine to fly out of."""
        for pair, ranks in ((GRAN, 1), (GRAN, 2), (HARD, 2)):
            fast = HEAD % (0.005, "set atom 1 vx 10", 1e-6, 2e-6)
            output = self.stops(fast + pair + TAIL, "The fastest: particle 1 at (0.002",
                                " 0.002 0.005) has the speed 10", ranks=ranks)
            self.assertNotIn("overlaps", output)

    def test_at_a_wall(self):
        wall = "fix w all wall/gran/hamaker stiffness 8000 restitution 0.9 zplane 0 NULL\n"
        quiet = "pair_style squarewell\npair_coeff * * well 0 1\n"
        self.stops(HEAD % (0.005, "set atom 2 vz -36", 1e-4, 1.5e-5) + quiet + wall + TAIL, "fix w wall/gran/hamaker",
                     "could miss the wall", "particle 2 at (0.007", "has the speed 36", ranks=1)


if __name__ == "__main__":
    unittest.main()
