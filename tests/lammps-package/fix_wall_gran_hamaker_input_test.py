# SPDX-License-Identifier: BSD-3-Clause
"""What fix wall/gran/hamaker takes and refuses, in LAMMPS."""
import unittest

from cohesion_tests import lammps as engine
from cohesion_tests.test_cases import ScriptTestCase


class BadInput(ScriptTestCase):
    HEAD = """
plugin load ${plugin}
units si
atom_style %s
boundary f f p
newton off
comm_modify vel yes cutoff 2e-3
region box block 0 0.01 0 0.01 0 0.01 units box
create_box 1 box
create_atoms 1 single 0.002 0.005 0.005 units box
%s
timestep 1e-7
"""
    SPHERES = HEAD % ("sphere", "set group all diameter 1e-3 density 2650")
    TAIL = "\nfix move all nve/sphere\nrun 1\n"
    FIX = "fix wall all wall/gran/hamaker "

    def refused(self, words, *message):
        with self.subTest(words):
            self.stops(self.SPHERES + self.FIX + words + self.TAIL, *message)

    def test_right_input(self):
        for words in ("stiffness 800 xplane 0 NULL", "xplane NULL 0.01 stiffness 800 yplane 0 0.01",
                      "stiffness 800 zcylinder 0.02 wiggle z 1e-6 1e-3",
                      "stiffness 800 hamaker 1e-19 cutoff 4e-10 1e-7 form exact asperity 1e-8 "
                      "xplane 0 0.01"):
            with self.subTest(words):
                code, output = engine.run_text(self.SPHERES + self.FIX + words + self.TAIL, self.folder)
                self.assertEqual(code, 0, output)

    def test_keywords(self):
        self.refused("stiffness 800 plane 0 1", "fix wall wall/gran/hamaker", "'plane'", "stiffness",
                     "hamaker", "xplane", "zcylinder", "translate")
        self.refused("stiffness 800", "no wall", "xplane lo hi", "zcylinder radius")
        self.refused("stiffness 800 region drum", "region drum does not exist")
        self.refused("stiffness 800 rolling_friction -0.1 xplane 0 NULL", "rolling friction")
        self.refused("", "no wall")
        self.refused("xplane 0 NULL", "stiffness K = 0")
        self.refused("stiffness -1 xplane 0 NULL", "stiffness K = -1")
        self.refused("stiffness 800 restitution 1.1 xplane 0 NULL", "restitution e = 1.1")
        self.refused("stiffness 800 hamaker 1e-19 xplane 0 NULL", "cutoff H_cut H_out")
        self.refused("stiffness 800 xplane 0 NULL form flat", "unknown form 'flat'", "exact")
        self.refused("stiffness 800 xplane 0 NULL form", "form takes a name")
        self.refused("xplane 0 NULL stiffness", "keyword 'stiffness' needs 'stiffness K': K is missing")

    def test_walls(self):
        self.refused("stiffness 800 xplane 0.01 0", "xplane 0.01 0", "below")
        self.refused("stiffness 800 xplane 0.01 0.01", "below")
        self.refused("stiffness 800 xplane NULL NULL", "xplane NULL NULL is no wall")
        self.refused("stiffness 800 xplane 0", "xplane takes two positions")
        self.refused("stiffness 800 xplane nan NULL", "nan")
        self.refused("stiffness 800 zplane 0 NULL", "no zplane in a periodic direction", "boundary f")
        self.refused("stiffness 800 zcylinder -1", "radius -1", "greater than zero")
        self.refused("stiffness 800 zcylinder", "zcylinder takes a radius")
        with self.subTest("periodic"):
            self.stops((self.SPHERES + self.FIX).replace("boundary f f p", "boundary p f f") +
                       "stiffness 800 zcylinder 1", "no zcylinder in a periodic direction")

    def test_motion(self):
        wall = "stiffness 800 xplane 0 NULL "
        self.refused(wall + "wiggle x 1e-6", "wiggle takes a dimension, an amplitude and a period")
        self.refused(wall + "wiggle x 1e-6 0", "period of the wall = 0")
        self.refused(wall + "wiggle u 1e-6 1", "x, y or z, not 'u'")
        self.refused(wall + "shear x 1", "across a xplane", "translate")
        self.refused(wall + "shear y inf", "inf")
        self.refused(wall + "shear y 1 wiggle x 1 1", "one of wiggle, shear and translate")
        self.refused("stiffness 800 zcylinder 1 wiggle x 1 1", "zcylinder moves along z only")
        self.refused("stiffness 800 zcylinder 1 xplane 0 NULL shear x 1", "fix of their own")
        turning = "stiffness 800 friction 0.3 rolling_friction {} zcylinder 1 shear {} 1"
        for axis in "xy":
            self.refused(turning.format(0.1, axis), "rolling_friction does not know how fast a cylinder turns")
        for words in (turning.format(0, "x"), turning.format(0.1, "z")):
            with self.subTest(words):
                self.goes(self.SPHERES + self.FIX + words + self.TAIL)

    def test_particles(self):
        points = self.HEAD % ("atomic", "mass * 1e-6\npair_style none")
        self.stops(points + self.FIX + "stiffness 800 xplane 0 NULL\nfix move all nve\nrun 1\n",
                   "atom_style sphere")
        wall = self.SPHERES + self.FIX + "stiffness 1e-6 xplane 0.001 NULL"
        self.stops(wall + "\nset group all vx -10\ntimestep 1e-6\nfix move all nve/sphere\nrun 1000",
                   "pass through walls", "raise the stiffness")
        stiff = wall.replace("1e-6", "1300")  # just stiff enough for that step and speed
        self.stops(stiff + "\nset group all vx -10\ntimestep 1e-4\nfix move all nve/sphere\nrun 1000",
                   "2.000000 radii in one step")
        self.stops(wall + "\nminimize 0 1e-8 10 10", "cannot be minimized")

    def test_order_of_fixes(self):
        self.stops(self.SPHERES + "fix move all nve/sphere\n" + self.FIX +
                   "stiffness 800 xplane 0 NULL\nrun 1\n", "fix move", "behind the pair_style and wall")


if __name__ == "__main__":
    unittest.main()
