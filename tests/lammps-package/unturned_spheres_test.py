# SPDX-License-Identifier: BSD-3-Clause
"""Spheres with friction that a fix moves and does not turn get a warning, once; all others none. What no force
moves is as heavy as a wall."""
import unittest

import numpy

from cohesion_tests import lammps as engine

from cohesion_tests.lammps_scenes.small_box import box, spheres
from cohesion_tests.test_cases import ScriptTestCase

HEAD = box(types=2, boundary="p p f") + spheres((1, 0.002, 0.002, 0.005), (1, 0.005, 0.002, 0.005),
                                                (2, 0.007, 0.002, 0.005)) + """group first type 1
group second type 2
neighbor 1e-4 bin
timestep 1e-6
"""
CONTACT = "stiffness 800 restitution 0.9 "
RUBBING_SECOND = f"pair_coeff 2 2 {CONTACT}friction 0.3\npair_coeff 1 2 {CONTACT}\n"
RUN = "\nrun 1\nrun 1\n"


def pairs(friction, style="gran/hamaker"):
    return f"pair_style {style}\npair_coeff * * {CONTACT}{friction}\n"


class Unturned(ScriptTestCase):
    def warns(self, script, number, fix, ranks=1):
        output = self.goes(HEAD + script + RUN, ranks=ranks)
        self.assertEqual(output.count("does not turn"), 1, output)
        self.assertRegex(output, f"WARNING: friction acts on {number} particles that fix {fix} moves and does not "
                                 "turn.*use 'fix nve/sphere'")

    def passes(self, script):
        self.assertNotIn("does not turn", self.goes(HEAD + script + RUN))

    def test_warned(self):
        for ranks in (1, 2):
            self.warns(pairs("friction 0.3") + "fix move all nve", 3, "move nve", ranks)
        self.warns(pairs("rolling_friction 0.1", "gran/squarewell scheme sampled") + "fix move all nve/limit 1", 3,
                   "move nve/limit")
        self.warns(pairs("friction 0.3") + "fix a first nve/sphere\nfix b second nve", 1, "b nve")
        self.warns(pairs("") + f"fix w all wall/gran/hamaker {CONTACT} friction 0.3 zplane 0 NULL\n"
                   "fix move all nve", 3, "move nve")
        self.warns(pairs("") + RUBBING_SECOND + "fix a first nve\nfix b second nve", 1, "b nve", ranks=2)
        self.warns(pairs("friction 0.3", "gran/liquidbridge") + "fix move all nve", 3, "move nve")

    def test_right_ones(self):
        for friction, move in (("", "fix move all nve"), ("friction 0.3", "fix move all nve/sphere"),
                               ("friction 0.3", "fix move all nve\nfix still all freeze"),
                               ("friction 0.3", "fix a first nve/sphere\nfix b second move linear 0 0 1"),
                               ("friction 0.3", "fix a first nve/sphere\nfix b second nve/noforce"),
                               ("", RUBBING_SECOND + "fix a first nve\nfix b second nve/sphere")):
            with self.subTest(friction=friction, move=move):
                self.passes(pairs(friction) + move)

    def test_one_that_is_led_is_as_heavy_as_a_wall(self):
        # The third comes at -1, strikes the second, and is led on.
        script = (pairs("").replace("restitution 0.9", "restitution 1") + "fix a first nve/sphere\nfix b second "
                  "nve/noforce\nvelocity second set -1 0 0\nrun 2000\nwrite_dump all custom end.txt id x y z vx vy vz "
                  "omegax omegay omegaz modify format float %.17g sort id\n")
        self.goes(HEAD + script)
        velocities = engine.dump(self.folder, "end.txt")[:, 4]
        numpy.testing.assert_allclose(velocities[1:], [-2.0, -1.0], rtol=1e-9)

    def test_discs_that_friction_would_take_for_spheres(self):
        flat = box(boundary="p f p").replace("0 0.01 units", "-0.005 0.005 units")
        flat = (flat.replace("atom_style", "dimension 2\natom_style") + spheres((1, 0.002, 0.002, 0)) +
                "neighbor 1e-4 bin\ntimestep 1e-6\nfix flat all enforce2d\n")
        discs = "fix move all nve/sphere disc"
        for script in (pairs("friction 0.3"), pairs("") + f"fix w all wall/gran/hamaker {CONTACT} friction 0.3 "
                       "yplane 0 NULL\n", pairs("", "gran/hamaker scheme sampled") + "compute tally all gran/energy\n"):
            with self.subTest(script):
                self.stops(flat + script + discs + RUN, "fix move nve/sphere disc", "leave out 'disc'")
        self.stops(flat + pairs("friction 0.3") + "fix move all nvt/sphere temp 1 1 1 disc" + RUN,
                   "fix move nvt/sphere disc")
        for script in (pairs(""), pairs("friction 0.3", "gran/hamaker scheme sampled")):
            with self.subTest(script):
                self.goes(flat + script + discs + RUN)


if __name__ == "__main__":
    unittest.main()
