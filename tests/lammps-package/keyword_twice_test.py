# SPDX-License-Identifier: BSD-3-Clause
"""A keyword that one command gives twice is refused with both of its values: of two the script means one."""
import unittest

from cohesion_tests.lammps_scenes.small_box import box, spheres
from cohesion_tests.test_cases import ScriptTestCase

HEAD = box() + spheres((1, 0.002, 0.005, 0.005))
CONTACT = "stiffness 200 restitution 0.9"
SOFT = "pair_style gran/hamaker\npair_coeff * * " + CONTACT + "\n"
HARD = "pair_style hard/squarewell\npair_coeff * * restitution 0.9\n"


class Twice(ScriptTestCase):
    def refuses(self, script, where, keyword, first, second):
        with self.subTest(where, keyword=keyword):
            self.stops(HEAD + script + "\n", where, f"keyword '{keyword}' is there twice",
                       f"with {first} and with {second}")

    def test_pair_coeff(self):
        for style in ("gran/hamaker", "gran/squarewell"):
            self.refuses(f"pair_style {style}\npair_coeff * * {CONTACT} stiffness 300",
                         f"pair_coeff * * of {style}", "stiffness", 200, 300)
        # The same value twice too: which of them a later change meets is left to chance.
        self.refuses(SOFT.rstrip() + " restitution 0.9", "gran/hamaker", "restitution", 0.9, 0.9)
        self.refuses("pair_style gran/hamaker\npair_coeff * * " + CONTACT +
                     " hamaker 1e-19 cutoff 4e-10 1e-7 cutoff 4e-10 2e-7", "gran/hamaker", "cutoff",
                     "4e-10 1e-7", "4e-10 2e-7")
        self.refuses(HARD.rstrip() + " restitution 0.8", "hard/squarewell", "restitution", 0.9, 0.8)

    def test_pair_style(self):
        self.refuses("pair_style gran/hamaker scheme exact scheme sampled", "pair_style gran/hamaker",
                     "scheme", "exact", "sampled")
        self.refuses("pair_style hard/squarewell limit 10 limit 20", "pair_style hard/squarewell",
                     "limit", 10, 20)

    def test_walls(self):
        wall = SOFT + "fix w all wall/gran/hamaker " + CONTACT
        self.refuses(wall + " stiffness 300 zplane 0 NULL", "fix w wall/gran/hamaker", "stiffness", 200, 300)
        self.refuses(wall + " form exact form small_gap zplane 0 NULL", "fix w wall/gran/hamaker", "form",
                     "exact", "small_gap")
        self.refuses(SOFT + "fix w all wall/hamaker hamaker 1e-19 cutoff 4e-10 1e-7 zplane 0 NULL form exact form small_gap",
                     "fix w wall/hamaker", "form", "exact", "small_gap")
        self.refuses(HARD + "fix w all wall/hard/squarewell restitution 0.9 well off well off zplane 0 NULL",
                     "fix w wall/hard/squarewell", "well", "off", "off")

    def test_other_fixes(self):
        self.refuses(SOFT + "fix s all agglomerates 1 sizes 5 sizes 6", "fix s agglomerates", "sizes", 5, 6)
        self.refuses("change_box all triclinic\n" + SOFT + "fix s all deform/shear rate 1 rate 2", "fix s deform/shear", "rate", 1, 2)
        self.refuses(SOFT + "fix s all stationary 1 start 5 start 6", "fix s stationary", "start", 5, 6)

    def test_planes_of_one_kind_may_be_many(self):
        self.goes(HEAD + SOFT + "fix w all wall/gran/hamaker " + CONTACT +
                  " zplane 0 NULL zplane NULL 0.01\nfix move all nve/sphere\ntimestep 1e-7\nrun 0\n")


if __name__ == "__main__":
    unittest.main()
