# SPDX-License-Identifier: BSD-3-Clause
"""Bonded spheres to which special_bonds gives the factor 0 pass through each other, in soft contacts and hard spheres
alike; with the factor 1 they collide. Factors between are refused."""
import unittest

import numpy

from cohesion_tests import lammps as engine
from cohesion_tests.test_cases import ScriptTestCase

# Four of 1 mm in a row along x, in a chain of bonds; the first flies at the second, and the last at the third, in
# the other direction, a little later.
DATA = """spheres in a chain

4 atoms
3 bonds
1 atom types
1 bond types
2 extra bond per atom
6 extra special per atom

0 0.02 xlo xhi
0 0.02 ylo yhi
0 0.02 zlo zhi

Atoms # hybrid

1 1 0.004 0.01 0.01 1e-3 2650 1
2 1 0.006 0.01 0.01 1e-3 2650 1
3 1 0.012 0.01 0.01 1e-3 2650 1
4 1 0.0141 0.01 0.01 1e-3 2650 1

Velocities

1 1 0 0 0 0 0
2 0 0 0 0 0 0
3 0 0 0 0 0 0
4 -1 0 0 0 0 0

Bonds

1 1 {first}
2 1 {second}
3 1 {third}
"""
CHAIN = dict(first="1 2", second="2 3", third="3 4")
# 1-3 neighbours meet: the chain goes 1, 3, 2, 4.
CROSSED = dict(first="1 3", second="3 2", third="2 4")
SCRIPT = """
plugin load ${{plugin}}
units si
newton off
atom_style hybrid sphere bond
comm_modify vel yes cutoff 0.02
boundary f f f
timestep 1e-6
bond_style zero nocoeff
special_bonds {special}
read_data data.chain
bond_coeff *
pair_style {style}
pair_coeff * * {contact}
{extra}neighbor 2e-3 bin
neigh_modify delay 0 every 1 check yes
fix move all nve/sphere
run 3000
write_dump all custom end.txt id vx modify sort id format float %.17g
"""
STYLES = {"gran/hamaker": "stiffness 3000 restitution 1", "gran/hamaker scheme sampled": "stiffness 3000 restitution 1",
          "hard/squarewell": "restitution 1"}
COLLIDED, PASSED = [0, 1, -1, 0], [1, 0, 0, -1]


class SpecialBonds(ScriptTestCase):
    def setUp(self):
        super().setUp()
        if "MOLECULE package" in engine.run_text("atom_style bond\n", self.folder)[1]:
            self.skipTest("this LAMMPS has no bonds")

    def text(self, style, special, bonds=CHAIN, extra="", contact=None):
        (engine.Path(self.folder) / "data.chain").write_text(DATA.format(**bonds))
        return SCRIPT.format(style=style, contact=contact or STYLES[style], special=special, extra=extra)

    def speeds(self, style, special, bonds=CHAIN, **options):
        self.goes(self.text(style, special, bonds), **options)
        return engine.dump(self.folder, "end.txt")[:, 1]

    def assert_ends(self, speeds, expected):
        # A sampled elastic contact keeps the speed to (w0 dt)^2/8, 5e-4 with w0 = sqrt(3000/6.9e-7).
        numpy.testing.assert_allclose(speeds, expected, atol=2e-3)

    def test_factor_0_and_1(self):
        for style in STYLES:
            for special, expected in (("lj 0 1 1 coul 0 1 1", PASSED), ("lj/coul 0 0 0", PASSED),
                                      ("lj/coul 1 1 1", COLLIDED), ("lj 1 1 1", COLLIDED), ("lj 0 1 1", PASSED)):
                with self.subTest(style, special=special):
                    self.assert_ends(self.speeds(style, special), expected)

    def test_two_bonds_apart(self):
        for style in STYLES:
            for special, expected in (("lj/coul 0 1 1", COLLIDED), ("lj/coul 1 0 1", PASSED), ("lj/coul 0 0 1", PASSED)):
                with self.subTest(style, special=special):
                    self.assert_ends(self.speeds(style, special, CROSSED), expected)

    def test_on_ranks(self):
        for ranks in (2, 3):
            for special, expected in (("lj/coul 0 1 1", PASSED), ("lj/coul 1 1 1", COLLIDED)):
                text = self.text("hard/squarewell", special).replace("1e-6", "1e-4").replace("run 3000", "run 30")
                self.goes(text, ranks=ranks)
                self.assert_ends(engine.dump(self.folder, "end.txt")[:, 1], expected)

    def test_other_factors_are_refused(self):
        overlay = "hamaker 1e-19 cutoff 4e-10 1e-7"
        for style in (*STYLES, "hamaker"):
            name = f"pair_style {style.split()[0]}"
            contact = overlay if style == "hamaker" else None
            with self.subTest(style):
                self.stops(self.text(style, "lj/coul 0.5 1 1", contact=contact), name,
                           "gives 1-2 neighbours the factor 0.5", "it must be 0 or 1")
                self.stops(self.text(style, "lj/coul 0 1 0.2", contact=contact), "1-4 neighbours the factor 0.2")
        # The list has them for the sake of another kind of force.
        self.stops(self.text("gran/hamaker", "lj 0 1 1 coul 1 1 1"), "gives 1-2 neighbours the factor 0",
                   "'special_bonds lj/coul'")


if __name__ == "__main__":
    unittest.main()
