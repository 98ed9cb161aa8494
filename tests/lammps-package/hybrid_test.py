# SPDX-License-Identifier: BSD-3-Clause
"""The styles as parts of pair_style hybrid: pairs of types that belong to another style, or to none, are not theirs."""
import unittest

import numpy

from cohesion_tests import lammps as engine
from cohesion_tests.lammps_scenes.small_box import box, spheres
from cohesion_tests.test_cases import ScriptTestCase

HEAD = box(types=3, size=(0.02, 0.02, 0.02)) + spheres(
    (1, 0.002, 0.005, 0.005), (2, 0.0035, 0.005, 0.005), (3, 0.005, 0.005, 0.005)) + """velocity all set 0.01 0 0
neighbor 1e-4 bin
"""
CONTACT = "stiffness 800 restitution 0.9"
STYLES = {
    "gran/hamaker": f"{CONTACT} hamaker 5e-19 cutoff 4e-10 1e-7",
    "gran/hamaker scheme sampled": f"{CONTACT} hamaker 5e-19 cutoff 4e-10 1e-7",
    "gran/squarewell": f"{CONTACT} well 1e-12 1.1",
    "gran/squarewell scheme sampled": f"{CONTACT} well 1e-12 1.1",
    "hamaker cutoff 4e-10 1e-7": "hamaker 5e-19",
    "squarewell": "well 1e-12 1.1",
    "hard/squarewell": "restitution 0.9 well 1e-12 1.1",
}
OTHER = "gran/hooke/history 800 NULL 0.001 NULL 0.3 0"


class Hybrid(ScriptTestCase):
    def output(self, style, pairs):
        name = style.split()[0]
        words = "".join(f"pair_coeff {types} {f'{name} {STYLES[style]}' if mine else which}\n"
                        for types, mine, which in pairs)
        move = "" if name.startswith("hard") else "fix move all nve/sphere\n"
        return self.goes(f"{HEAD}pair_style hybrid {style} {OTHER}\n{words}{move}timestep 1e-6\nrun 5\n")

    @staticmethod
    def advised(output):
        return [" ".join(line.split()[:3]) for line in output.splitlines() if line.split()[1:2] == ["-"]]

    def test_pairs_of_the_other_style_are_left_to_it(self):
        pairs = [("1 1", True, ""), ("1 2*3", False, "gran/hooke/history"), ("2 2*3", False, "gran/hooke/history"),
                 ("3 3", False, "none")]
        for style in STYLES:
            with self.subTest(style):
                advised = self.advised(self.output(style, pairs))
                self.assertEqual(advised, [] if style.split()[0] in ("squarewell", "hard/squarewell") else ["1 - 1"])

    def test_types_of_one_style_are_mixed(self):
        pairs = [("1 1", True, ""), ("2 2", True, ""), ("1*2 3", False, "gran/hooke/history"),
                 ("3 3", False, "gran/hooke/history")]
        for style in STYLES:
            if style.startswith(("gran", "hamaker")):
                with self.subTest(style):
                    self.assertEqual(self.advised(self.output(style, pairs)), ["1 - 1", "1 - 2", "2 - 2"])

    def test_sampled_contacts_beside_those_of_the_exact_scheme_are_contacts_whether_anybody_looks_or_not(self):
        """Weight and drag are external forces on contacts of the exact scheme; forces of sampled contacts are not."""
        row = spheres((1, 0.002, 0.005, 0.005), (1, 0.00301, 0.005, 0.005), (2, 0.00399, 0.005, 0.005))
        ends = []
        for looks in ("", "compute tally all gran/energy\nthermo_style custom step c_tally[1]\n"):
            self.goes(f"""{box(types=2, size=(0.02, 0.02, 0.02))}{row}neighbor 1e-4 bin
pair_style hybrid gran/hamaker gran/squarewell scheme sampled
pair_coeff 1 1 gran/hamaker {STYLES["gran/hamaker"]}
pair_coeff * 2 gran/squarewell {STYLES["gran/squarewell scheme sampled"]}
set atom 1 vx 0.02
fix down all gravity 9.81 vector 0 0 -1
fix move all nve/sphere
timestep 5e-6
{looks}run 40
write_dump all custom end.txt id vx vy vz modify sort id format float %.17g
""")
            ends.append(engine.dump(self.folder, "end.txt"))
        self.assertGreater(abs(ends[0][:, 1]).min(), 1e-4)
        numpy.testing.assert_array_equal(*ends)

    def test_contacts_of_two_styles_that_overlay_adds_are_named_once(self):
        words = "between types 1 and 1 the contact springs of "
        for overlaid, warned in (("gran/hamaker", True), ("gran/squarewell", True), ("squarewell", False),
                                 ("hamaker cutoff 4e-10 1e-7", False)):
            with self.subTest(overlaid):
                name = overlaid.split()[0]
                output = self.goes(f"""{HEAD}pair_style hybrid/overlay {overlaid} gran/liquidbridge {OTHER}
pair_coeff 1 1 gran/liquidbridge {CONTACT}
pair_coeff 1 1 {name} {STYLES[overlaid]}
pair_coeff * 2*3 gran/hooke/history
fix move all nve/sphere
timestep 1e-6
run 1
run 1
""")
                self.assertEqual(output.count(f"{words}gran/liquidbridge and {name}"), warned, output)
                self.assertEqual(output.count("add up"), warned, output)


if __name__ == "__main__":
    unittest.main()
