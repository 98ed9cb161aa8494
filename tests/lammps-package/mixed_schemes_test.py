# SPDX-License-Identifier: BSD-3-Clause
"""A wall whose scheme is not that of the pair style gets a warning that names both, once; walls of the same scheme,
and walls beside pairs that have no contacts of their own, none."""
import re
import unittest

from cohesion_tests.lammps_scenes.small_box import box, spheres
from cohesion_tests.test_cases import ScriptTestCase

HEAD = (box(types=2, boundary="p p f") + spheres((1, 0.002, 0.002, 0.005), (2, 0.005, 0.002, 0.005)) +
        "neighbor 1e-4 bin\ntimestep 1e-6\n")
CONTACT = "stiffness 800 restitution 0.9 "
LAWS = ("hamaker", "square_well", "liquid_bridge")
SAID = "give both the same scheme (exact where the keyword is missing)"


def wall(law, scheme, name="w"):
    return f"fix {name} all wall/gran/{law} {CONTACT} {scheme} zplane 0 NULL\n"


class MixedSchemes(ScriptTestCase):
    def printed(self, pairs, walls, ranks=1):
        return self.goes(HEAD + pairs + walls + "fix move all nve/sphere\nrun 1\nrun 1\n", ranks=ranks)

    def pairs(self, law, scheme):
        return f"pair_style gran/{law} {scheme}\npair_coeff * * {CONTACT}\n"

    def test_warned(self):
        for law in LAWS:
            for of_wall, of_pairs in (("exact", "sampled"), ("sampled", "exact")):
                for ranks in (1, 2) if law == LAWS[0] else (1,):
                    with self.subTest(law, of_wall=of_wall, ranks=ranks):
                        output = self.printed(self.pairs(law, f"scheme {of_pairs}"), wall(law, f"scheme {of_wall}"),
                                              ranks)
                        self.assertEqual(output.count(SAID), 1, output)
                        self.assertIn(f"WARNING: fix w wall/gran/{law} has 'scheme {of_wall}', and pair_style "
                                      f"gran/{law} has 'scheme {of_pairs}'", output)
                        self.assertLess(output.index(SAID), output.index("Step"), output)

    def test_keyword_that_is_missing(self):
        self.assertIn("has 'scheme exact', and", self.printed(self.pairs("hamaker", "scheme sampled"), wall("hamaker", "")))
        self.assertIn("has 'scheme sampled', and", self.printed(self.pairs("hamaker", ""),
                                                                wall("square_well", "scheme sampled")))

    def test_the_wall_that_differs_is_named(self):
        output = self.printed(self.pairs("hamaker", ""), wall("hamaker", "", "same") +
                              wall("hamaker", "scheme sampled", "other"))
        self.assertEqual(re.findall(r"WARNING: fix (\w+) wall/gran/hamaker has", output), ["other"])

    def test_right_ones(self):
        for law in LAWS:
            for scheme in ("", "scheme exact", "scheme sampled"):
                with self.subTest(law, scheme=scheme):
                    self.assertNotIn(SAID, self.printed(self.pairs(law, scheme), wall(law, scheme)))
        hybrid = (f"pair_style hybrid gran/hamaker gran/square_well scheme sampled\npair_coeff 1 1 gran/hamaker {CONTACT}\n"
                  f"pair_coeff 2 2 gran/square_well {CONTACT}\npair_coeff 1 2 gran/hamaker {CONTACT}\n")
        self.assertNotIn(SAID, self.printed(hybrid, wall("hamaker", "") + wall("square_well", "scheme sampled", "v")))
        attraction = "pair_style square_well\npair_coeff * * well 1e-12 1.1\n"
        self.assertNotIn(SAID, self.printed(attraction, wall("hamaker", "scheme sampled")))
        self.assertNotIn(SAID, self.printed("pair_style zero 3e-3\npair_coeff * *\n", wall("hamaker", "scheme sampled")))


if __name__ == "__main__":
    unittest.main()
