# SPDX-License-Identifier: BSD-3-Clause
"""A run in which no fix moves or holds any sphere gets a warning, once, before its first step; all others none."""
import unittest

from cohesion_tests.lammps_scenes.small_box import box, spheres
from cohesion_tests.test_cases import ScriptTestCase

BOX = box(boundary="p p f")
SPHERES = spheres((1, 0.002, 0.002, 0.005), (1, 0.005, 0.002, 0.005))
CONTACT = "stiffness 800 restitution 0.9 "
STYLES = ("gran/hamaker", "gran/hamaker scheme sampled", "gran/squarewell", "gran/squarewell scheme sampled",
          "gran/liquidbridge", "gran/liquidbridge scheme sampled")
SAID = "no fix integrates the motion of any particle"
SETTINGS = "neighbor 1e-4 bin\ntimestep 1e-6\n"
POUR = ("region top block 0.001 0.009 0.001 0.009 0.005 0.009 units box\nfix fall all gravity 9.81 vector 0 0 -1\n"
        "fix more all pour 2 1 4711 region top diam one 1e-3 dens 2650 2650\n")


class Unmoved(ScriptTestCase):
    def said(self, script, style=STYLES[0], made=SPHERES, run="run 1\nrun 1\n", **options):
        pairs = f"pair_style {style}\npair_coeff * * {CONTACT}\n"
        return self.goes(BOX + made + SETTINGS + pairs + script + run, **options)

    def test_warned(self):
        for style in STYLES:
            for ranks in (1, 2) if style == STYLES[0] else (1,):
                with self.subTest(style, ranks=ranks):
                    output = self.said("", style, ranks=ranks)
                    self.assertEqual(output.count(f"WARNING: {SAID}"), 1, output)
                    self.assertRegex(output, f"{SAID}: all stay in their places .*add 'fix ID all nve/sphere'")
                    self.assertLess(output.index(SAID), output.index("Step"), output)

    def test_spheres_of_a_wall_alone(self):
        wall = f"fix w all wall/gran/hamaker {CONTACT} zplane 0 NULL\nrun 1\n"
        output = self.goes(BOX + SPHERES + SETTINGS + "comm_modify cutoff 2e-3\n" + wall)
        self.assertIn(SAID, output)

    def test_fix_that_moves_others(self):
        self.assertIn(SAID, self.said("group nobody empty\nfix move nobody nve/sphere\n"))

    def test_spheres_that_are_to_come(self):
        for move, run, warned in (("", "run 10\n", True), ("", "run 1\n", False),
                                  ("fix move all nve/sphere\n", "run 10\n", False)):
            with self.subTest(move=move, run=run):
                output = self.said(POUR + move, made="", run=run)
                self.assertEqual(SAID in output, warned, output)

    def test_right_ones(self):
        for script in ("fix move all nve/sphere\n", "fix move all nve\n", "fix move all move linear 0 0 1\n",
                       "fix move all nve/noforce\n", "fix hold all freeze\n", "fix hold all setforce 0 0 0\n",
                       "group one id 1\nfix move one nve/sphere\n", "fix squeeze all deform 1 x scale 0.99 remap x\n"):
            with self.subTest(script):
                self.assertNotIn(SAID, self.said(script))
        self.assertNotIn(SAID, self.said("", run="run 0\n"))
        self.assertNotIn(SAID, self.said("", made="", run="run 10\n"))


if __name__ == "__main__":
    unittest.main()
