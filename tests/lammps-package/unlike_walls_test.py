# SPDX-License-Identifier: BSD-3-Clause
"""A wall whose scheme, adhesion or softening is not that of the pair style gets a warning that names both, once; walls
like the pairs, walls that the script declares without adhesion, and walls beside pairs that have no contacts of their
own, none."""
import re
import unittest

from cohesion_tests.lammps_scenes.small_box import box, spheres
from cohesion_tests.test_cases import ScriptTestCase

HEAD = (box(types=2, boundary="p p f") + spheres((1, 0.002, 0.002, 0.005), (2, 0.005, 0.002, 0.005)) +
        "neighbor 1e-4 bin\ntimestep 1e-6\n")
CONTACT = "stiffness 800 restitution 0.9 "
LAWS = ("hamaker", "squarewell", "liquidbridge")
SAID = "give both the same scheme (exact where the keyword is missing)"


def wall(law, scheme, name="w"):
    return f"fix {name} all wall/gran/{law} {CONTACT} {scheme} zplane 0 NULL\n"


# A contact with adhesion; and what declares a wall without one.
ADHESIVE = {"hamaker": "hamaker 1e-19 cutoff 4e-10 1e-7", "squarewell": "well 1e-14 1.01", "liquidbridge": "bridge 1e-5 1e-5"}
WITHOUT = {"hamaker": "hamaker 0", "squarewell": "well 0 1", "liquidbridge": "bridge 0 0"}


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
                                                                wall("squarewell", "scheme sampled")))

    def test_the_wall_that_differs_is_named(self):
        output = self.printed(self.pairs("hamaker", ""), wall("hamaker", "", "same") +
                              wall("hamaker", "scheme sampled", "other"))
        self.assertEqual(re.findall(r"WARNING: fix (\w+) wall/gran/hamaker has", output), ["other"])

    def test_right_ones(self):
        for law in LAWS:
            for scheme in ("", "scheme exact", "scheme sampled"):
                with self.subTest(law, scheme=scheme):
                    self.assertNotIn(SAID, self.printed(self.pairs(law, scheme), wall(law, scheme)))
        hybrid = (f"pair_style hybrid gran/hamaker gran/squarewell scheme sampled\npair_coeff 1 1 gran/hamaker {CONTACT}\n"
                  f"pair_coeff 2 2 gran/squarewell {CONTACT}\npair_coeff 1 2 gran/hamaker {CONTACT}\n")
        self.assertNotIn(SAID, self.printed(hybrid, wall("hamaker", "") + wall("squarewell", "scheme sampled", "v")))
        attraction = "pair_style squarewell\npair_coeff * * well 1e-12 1.1\n"
        self.assertNotIn(SAID, self.printed(attraction, wall("hamaker", "scheme sampled")))
        self.assertNotIn(SAID, self.printed("pair_style zero 3e-3\npair_coeff * *\n", wall("hamaker", "scheme sampled")))


class Unlike(ScriptTestCase):
    """Runs of pairs and a wall that are given whole."""
    def printed(self, pairs, wall):
        style, _, coefficients = pairs.partition(" ")
        return self.goes(f"{HEAD}pair_style gran/{style}\npair_coeff * * {coefficients}\n"
                         f"fix w all wall/gran/{wall} zplane 0 NULL\nfix move all nve/sphere\nrun 1\nrun 1\n")

    def warned(self, said, pairs, wall):
        output = self.printed(pairs, wall)
        self.assertEqual(output.count(f"WARNING: {said}"), 1, output)
        self.assertLess(output.index(said), output.index("Step"), output)

    def silent(self, pairs, wall):
        output = self.printed(pairs, wall)
        for word in ("for the wall", "times the", "for both"):
            self.assertFalse([line for line in output.split("\n") if "WARNING" in line and word in line], output)


class Adhesion(Unlike):
    def test_missing(self):
        for law, adhesion in ADHESIVE.items():
            with self.subTest(law):
                self.warned(f"fix w wall/gran/{law} has no adhesion, and pair_style gran/{law} has that of gran/{law}: "
                            "particles stick to each other, but not to the wall; use fix wall/gran/"
                            f"{law} with '{WITHOUT[law].split()[0]}' for the wall, or '{WITHOUT[law]}' if nothing shall "
                            "stick to it", f"{law} {CONTACT} {adhesion}", f"{law} {CONTACT}")

    def test_another_law(self):
        jkr = "normal hertz 1e7 0.3 restitution 0.9 surface_energy 0.05"
        self.warned("fix w wall/gran/hamaker has the adhesion of gran/hamaker, and pair_style gran/jkr that of gran/jkr: "
                    "a particle sticks to the wall and to another particle by different criteria; use fix "
                    "wall/gran/jkr with 'surface_energy' for the wall", f"jkr {jkr}",
                    f"hamaker {CONTACT} {ADHESIVE['hamaker']}")
        self.warned("fix w wall/gran/jkr has the adhesion of gran/jkr, and pair_style gran/hamaker",
                    f"hamaker {CONTACT} {ADHESIVE['hamaker']}", f"jkr {jkr}")

    def test_right_ones(self):
        """Also a wall that attracts beside pairs that do not: a plate that catches grains."""
        for law, adhesion in ADHESIVE.items():
            with self.subTest(law):
                self.silent(f"{law} {CONTACT} {adhesion}", f"{law} {CONTACT} {adhesion}")
                self.silent(f"{law} {CONTACT} {adhesion}", f"{law} {CONTACT} {WITHOUT[law]}")
                self.silent(f"{law} {CONTACT}", f"{law} {CONTACT} {adhesion}")
                self.silent(f"{law} {CONTACT}", f"{law} {CONTACT}")


class Softening(Unlike):
    """f = (E*/E*_m)^(2/5) and (K/K_m)^(1/2); the cure is the stiffness of the wall times (f_pairs/f_wall)^(p + 1)."""
    JKR = "normal hertz {} 0.3 restitution 0.9 surface_energy 0.05 "
    HERTZ = "normal hertz {} 0.3 restitution 0.9 hamaker 1e-19 cutoff 4e-10 1e-7 "
    LINEAR = "stiffness {} restitution 0.9 hamaker 1e-19 cutoff 4e-10 1e-7 "
    MODULUS = "material_modulus 7e10 0.3"

    def test_another_modulus(self):
        for law, contact in (("jkr", self.JKR), ("hamaker", self.HERTZ)):
            with self.subTest(law):
                self.warned(f"fix w wall/gran/{law} has 0.001 times the modulus E* of the material (f = 0.0631), and "
                            f"pair_style gran/{law} has 0.01 times the modulus E* of the material (f = 0.158): what soft "
                            "contacts do not keep of their materials (the pull-off force, or with 'material_keep "
                            "force' the escape velocity) differs; give both the same f: multiply Young's modulus of the wall by 10",
                            f"{law} {contact.format(7e8)} {self.MODULUS}", f"{law} {contact.format(7e7)} {self.MODULUS}")

    def test_another_stiffness(self):
        self.warned("fix w wall/gran/hamaker has 0.0004 times the stiffness of the material (f = 0.02), and pair_style "
                    "gran/hamaker has 0.0001 times the stiffness of the material (f = 0.01)",
                    f"hamaker {self.LINEAR.format(80)} material_stiffness 8e5",
                    f"hamaker {self.LINEAR.format(80)} material_stiffness 2e5")

    def test_one_without_material(self):
        self.warned("pair_style gran/jkr has 0.01 times the modulus E* of the material (f = 0.158), by which its "
                    "adhesion is scaled, and fix w wall/gran/jkr has no material: a particle sticks to the wall and to "
                    "another particle by different criteria; give 'material_modulus E_m nu_m' for both",
                    f"jkr {self.JKR.format(7e8)} {self.MODULUS}", f"jkr {self.JKR.format(7e8)}")

    def test_right_ones(self):
        """Also what is kept of the materials may differ."""
        soft = f"jkr {self.JKR.format(7e8)} "
        self.silent(soft + self.MODULUS, soft + self.MODULUS)
        self.silent(soft + self.MODULUS, f"jkr {self.JKR.format(1e7)} material_modulus 1e9 0.3")
        self.silent(soft, f"jkr {self.JKR.format(1e7)}")
        self.silent(soft + self.MODULUS + " material_keep force", soft)
        self.silent(soft + self.MODULUS + " material_keep force", soft + self.MODULUS)
        # 1e-4 of K and 1e-5 of E*: both f = 0.01.
        self.silent(f"hamaker {self.LINEAR.format(80)} material_stiffness 8e5",
                    f"hamaker {self.HERTZ.format(7e5)} {self.MODULUS}")


if __name__ == "__main__":
    unittest.main()
