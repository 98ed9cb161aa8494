# SPDX-License-Identifier: BSD-3-Clause
"""A wall judges the particles of its group alone, those to come included."""
import unittest

from cohesion_tests.lammps_scenes.small_box import box
from cohesion_tests.test_cases import ScriptTestCase

HEAD = box(types=2, size=(0.01, 0.01, 0.02), ghosts="vel yes cutoff 2e-3") + """
create_atoms 1 single 0.002 0.005 0.005 units box
create_atoms 2 single 0.007 0.005 0.005 units box
set type 1 diameter 1e-3 density 2650
set type 2 diameter 1e-7 density 2650
group big type 1
group dust type 2
pair_style none
timestep 1e-5
"""
CONTACT = "stiffness 800 restitution 0.9"
HAMAKER = "hamaker 5e-19 cutoff 4e-10 1e-7"
TAIL = "\nfix move all nve/sphere\nrun 1\n"
POUR = """
region top block 0.002 0.004 0.002 0.004 0.01 0.018 units box
fix g all gravity 9.81 vector 0 0 -1
fix ins {} pour 5 2 4711 region top vol 0.1 50 diam one 1e-4 dens 2650 2650
"""


class WallOfAGroup(ScriptTestCase):
    def test_cutoffs_beside_dust(self):
        for wall in (f"wall/gran/hamaker {CONTACT} {HAMAKER} xplane 0 NULL",
                     "wall/hamaker hamaker 5e-19 cutoff 4e-10 1e-7 xplane 0 NULL"):
            with self.subTest(wall):
                self.goes(f"{HEAD}fix w big {wall}{TAIL}")
                self.stops(f"{HEAD}fix w all {wall}{TAIL}", "H_out = 1e-07: must not be above 5e-08")

    def test_contacts_of_dust(self):
        wall = f"wall/gran/hamaker {CONTACT} xplane 0 NULL"
        for ranks in (1, 2):
            output = self.goes(f"{HEAD}fix w big {wall}{TAIL}", ranks=ranks)
            self.assertIn("1 - wall", output)
            self.assertNotIn("2 - wall", output)
        self.stops(f"{HEAD}fix w all {wall}{TAIL}", "2 - wall: a contact takes")

    def test_its_speed_is_that_of_the_group(self):
        wall = f"fix w big wall/gran/hamaker {CONTACT} xplane 0 NULL\nset type 1 vx 0.01\nset type 2 vx 5"
        self.assertRegex(self.goes(f"{HEAD}{wall}{TAIL}"), r"1 - wall +0\.01 ")

    def test_dust_to_come(self):
        wall = f"fix w big wall/gran/hamaker {CONTACT} hamaker 5e-19 cutoff 4e-10 1e-4 xplane 0 NULL"
        alone = HEAD.replace("create_atoms 2", "#").replace("set type 2", "#")
        self.goes(alone + wall + POUR.format("dust") + TAIL)
        self.stops(alone + wall + POUR.format("big") + TAIL, "H_out = 0.0001: must not be above 5e-05")


if __name__ == "__main__":
    unittest.main()
