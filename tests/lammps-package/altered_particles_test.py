# SPDX-License-Identifier: BSD-3-Clause
"""What a script changes between two runs and what leaves contacts as they are: particles that are all shifted, types with
the same law. Bridges remain, and energy is kept."""
import re
import unittest

from cohesion_tests.lammps_scenes import small_box
from cohesion_tests.lammps_scenes.small_box import spheres
from cohesion_tests.test_cases import ScriptTestCase

CONTACT = "stiffness 800 restitution {} "
D = 1e-3
BRIDGE = CONTACT.format(0.9) + "bridge 1e-4 5e-5"
STRONGER = CONTACT.format(0.9) + "bridge 2e-4 5e-5"
# It touches its partner and flies back into the gap of the bridge.
END = "\nrun 1000\nprint \"FOUND {}\"\n"


def box(**options):
    """Variables name particles."""
    return small_box.box(**options).replace("atom_style sphere\n", "atom_style sphere\natom_modify map array\n")


class AlteredParticles(ScriptTestCase):
    def found(self, script, wanted, change, steps=25):
        output = self.goes(script + f"fix move all nve/sphere\nrun {steps}\n{change}" + END.format(wanted))
        return float(re.search(r"^FOUND (\S+)", output, re.M)[1])

    def check(self, script, wanted, changes, steps=25):
        """The result after each change is that without one, to the rounding of some hundred steps."""
        expected = self.found(script, wanted, "", steps)
        for change in changes:
            with self.subTest(change):
                # A contact has its distance with a rounding of eps of the box, and 1000 steps.
                self.assertAlmostEqual(self.found(script, wanted, change, steps), expected, delta=1e-9 * D)
        return expected

    def test_a_bridge_to_a_wall_when_all_are_shifted_along_it(self):
        script = (box(types=2, boundary="p p f") + spheres((1, 0.004, 0.005, 0.000502), (1, 0.004, 0.008, 0.000502)) +
                  "set group all vz -0.1\nneighbor 2e-4 bin\ntimestep 1e-5\npair_style gran/liquidbridge\n"
                  f"pair_coeff * * {BRIDGE}\nfix wall all wall/gran/liquidbridge {STRONGER} zplane 0 NULL\n")
        gap = self.check(script, "$(z[1]-5e-4)", ("displace_atoms all move 1e-4 0 0 units box\n",
                                                  "displace_atoms all move 8e-3 -6e-3 0 units box\n",
                                                  "set group all type 2\n", "change_box all x scale 1.02 remap units box\n"))
        self.assertLess(gap, 5e-5)

    def test_a_bridge_between_grains_of_another_type(self):
        script = (box(types=2) + spheres((1, 0.004, 0.005, 0.005), (1, 0.005002, 0.005, 0.005)) +
                  "set atom 2 vx -0.1\nneighbor 2e-4 bin\ntimestep 1e-5\npair_style gran/liquidbridge\n"
                  f"pair_coeff * * {BRIDGE}\n")
        gap = self.check(script, "$(x[2]-x[1]-1e-3)", ("set group all type 2\n", "set atom 1 type 2\n"))
        self.assertLess(gap, 5e-5)

    def test_an_elastic_impact_of_another_type(self):
        script = (box(types=2) + spheres((1, 0.004, 0.005, 0.005), (1, 0.00501, 0.005, 0.005)) +
                  "set atom 2 vx -0.1\nneighbor 2e-4 bin\ntimestep 9e-6\nthermo_modify norm no\n"
                  f"pair_style gran/hamaker\npair_coeff * * {CONTACT.format(1)}\n")
        kept = self.check(script, "$(ke/(mass(all)*0.0025))", ("set group all type 2\n",), steps=14)
        self.assertAlmostEqual(kept, 1, delta=1e-12)

    def test_a_wider_law_of_the_other_type_acts_where_the_grains_are(self):
        script = (box(types=2) + spheres((1, 0.004, 0.005, 0.005), (1, 0.005002, 0.005, 0.005)) +
                  "set atom 2 vx -0.1\nneighbor 2e-4 bin\ntimestep 1e-5\npair_style gran/liquidbridge\n"
                  f"pair_coeff * * {BRIDGE}\npair_coeff 2 2 {CONTACT.format(0.9)} bridge 0 0\n")
        self.assertGreater(self.found(script, "$(x[2]-x[1]-1e-3)", "set group all type 2\n"), 2e-5)


class TwoOfOneStyle(ScriptTestCase):
    def test_a_hybrid_has_a_style_once(self):
        self.stops(box(types=2) + spheres((1, 0.004, 0.005, 0.005)) +
                   "pair_style hybrid gran/hamaker gran/hamaker\n", "gran/hamaker", "once", "pair_coeff")


if __name__ == "__main__":
    unittest.main()
