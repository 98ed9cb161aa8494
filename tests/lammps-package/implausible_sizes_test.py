# SPDX-License-Identifier: BSD-3-Clause
"""Ranges that are not far below the radii, and sizes that no box of the script could hold, are refused before the
engine makes lists with them: mostly they are lengths in other units, or spheres that no `set` reached."""
import unittest

from cohesion_tests.test_cases import ScriptTestCase

HEAD = """
plugin load ${plugin}
units si
atom_style sphere
boundary %(boundary)s
newton off
comm_modify vel yes
region box block 0 0.01 0 0.01 0 0.01 units box
create_box 1 box
create_atoms 1 single 0.002 0.005 0.005 units box
create_atoms 1 single 0.008 0.005 0.005 units box
set group all diameter %(diameter)s density 2650
%(then)s
neighbor 1e-3 bin
timestep 1e-8
"""
CONTACT = "stiffness 800 restitution 0.9"
TAIL = "\nfix move all nve/sphere\nrun 1\n"
UNITS = "lengths are those of 'units si', m"


def script(pair, boundary="p p p", diameter="75e-6", then=""):
    return HEAD % dict(boundary=boundary, diameter=diameter, then=then) + pair + TAIL


def gran(cut, out, form=""):
    return f"pair_style gran/hamaker {form}\npair_coeff * * {CONTACT} hamaker 5e-19 cutoff {cut} {out}"


def overlay(cut, out, form=""):
    return f"pair_style hamaker cutoff {cut} {out} {form}\npair_coeff * * hamaker 5e-19"


NONE = f"pair_style gran/hamaker\npair_coeff * * {CONTACT}\n"
WALLS = (lambda cut, out, form="": NONE + f"fix w all wall/gran/hamaker {form} {CONTACT} hamaker 5e-19 "
         f"cutoff {cut} {out} zplane 0 NULL",
         lambda cut, out, form="": NONE + f"fix w all wall/hamaker hamaker 5e-19 cutoff {cut} {out} zplane 0 NULL {form}")


class Sizes(ScriptTestCase):
    def refuses(self, *words, ranks=(1,), without=None, **changes):
        for number in ranks:
            with self.subTest(words, ranks=number, **changes):
                text = script(**changes)
                self.stops(text.replace(without, "") if without else text, *words, timeout=20, ranks=number)

    def test_cutoffs_in_nanometres(self):
        for law, where in ((gran, "pair_style gran/hamaker, types 1 and 1"),
                           (overlay, "pair_style hamaker, types 1 and 1")):
            self.refuses(where, "surface cut-off H_cut = 0.4: must not be above 1.875e-06", UNITS,
                         pair=law("0.4", "100"), ranks=(1, 2) if law is gran else (1,))
            self.refuses(where, "H_cut = 0.4", "form exact", pair=law("0.4", "100", "form exact"))
        for law in WALLS:
            self.refuses("fix w wall/", "H_cut = 0.4: must not be above 3.75e-06", UNITS, pair=law("0.4", "100"),
                         boundary="p p f")

    def test_range_that_is_not_far_below_the_radius(self):
        for law in (gran, overlay):
            self.refuses("outer cut-off H_out = 4e-05: must not be above 1.875e-05", "(form small_gap)",
                         UNITS, pair=law("4e-10", "4e-5"))
            self.goes(script(law("4e-10", "1.8e-5")))
            self.goes(script(law("4e-10", "1.5e-5"), diameter="60e-6"))
            self.goes(script(law("4e-10", "4e-5", "form exact")))
            self.refuses("H_out = 0.0004", "form exact", pair=law("4e-10", "4e-4", "form exact"))
        for law in WALLS:
            self.refuses("fix w wall/", "H_out = 4e-05: must not be above 3.75e-05", pair=law("4e-10", "4e-5"),
                         boundary="p p f")
            self.goes(script(law("4e-10", "3.7e-5"), boundary="p p f"))

    def test_range_in_which_pairs_would_turn_wrongly(self):
        """A thirtieth of the distance of two of 75 um at touch is 2.5e-6 m; beside a wall nothing turns."""
        wide = "surface cut-off H_cut of the contact = 2.6e-06: must not be above 2.5e-06"
        self.refuses("pair_style gran/hamaker, types 1 and 1", wide, "use 'scheme sampled'",
                     pair=gran("2.6e-6", "1e-5", "form exact"))
        self.goes(script(gran("2.4e-6", "1e-5", "form exact")))
        self.goes(script(gran("2.6e-6", "1e-5", "form exact scheme sampled")))
        self.goes(script(WALLS[0]("2.6e-6", "1e-5", "form exact"), boundary="p p f"))
        # H_cut of the soft contact, from 3.7e-7 m of a material 64 times as stiff.
        self.refuses("surface cut-off H_cut of the contact = ", "where it was scaled for a soft spring",
                     pair=gran("3.7e-7", "1.5e-5") + " material_stiffness 51200")
        self.goes(script(gran("3.7e-8", "1.5e-5") + " material_stiffness 51200"))

    def test_the_smallest_of_a_mixture_counts(self):
        self.refuses("H_out = 1e-05: must not be above 5e-06", pair=gran("4e-10", "1e-5"),
                     then="set atom 2 diameter 20e-6", ranks=(1, 2))

    def test_wells_are_ratios(self):
        for style, contact in (("gran/squarewell", CONTACT + " well 1e-12"), ("squarewell", "1e-12"),
                               ("hard/squarewell", "restitution 0.9 well 1e-12")):
            self.refuses("pair_coeff * * of " + style, "ratio r_out/r of the well = 3.5: must not be above 3",
                         pair=f"pair_style {style}\npair_coeff * * {contact} 3.5")
        self.refuses("fix w wall/gran/squarewell", "= 40: must not be above 3", boundary="p p f",
                     pair=NONE + f"fix w all wall/gran/squarewell {CONTACT} well 1e-12 40 zplane 0 NULL")

    def test_spheres_of_the_size_they_were_created_with(self):
        for pair, style in ((gran("4e-10", "1e-7"), "gran/hamaker"), (overlay("4e-10", "1e-7"), "hamaker"),
                            ("pair_style hard/squarewell\npair_coeff * * restitution 0.9", "hard/squarewell")):
            self.refuses("pair_style " + style, "particle 3 has the diameter 1, others as little as 7.5e-05", UNITS,
                         "until 'set ... diameter'", pair=pair, ranks=(1, 2) if "hard" in style else (1,),
                         then="create_atoms 1 single 0.005 0.005 0.005 units box")
            self.refuses("radius of a particle = 0.5: must not be above the longest side of the box, 0.01",
                         "until 'set ... diameter'", pair=pair, then="set group all diameter 1 density 1")

    def test_spheres_of_diameter_1_may_be_meant_in_other_units(self):
        for units in ("lj", "cgs"):
            text = script(NONE, then="create_atoms 1 single 5 5 5 units box") + "run 1\n"
            output = self.goes(text.replace("units si", f"units {units}").replace("0 0.01", "0 10"))
            self.assertEqual(output.count("WARNING: pair_style gran/hamaker: particle 3 has the diameter 1"), 1, output)

    def test_density_before_the_diameter(self):
        """What is set first keeps its mass: 1500 kg/m^3 of 1 m in 75 um are 3.56e15 kg/m^3."""
        says = ("particle 1 (one of 2) has the mass of a sphere of diameter 1 and density 1500",
                "a density of 3.56e+15 kg/m^3", "set the diameter first, then the density", UNITS)
        wall = "\nfix w all wall/gran/hamaker " + CONTACT + " zplane 0 NULL"
        for pair, style in ((gran("4e-10", "1e-7"), "pair_style gran/hamaker"),
                            (overlay("4e-10", "1e-7"), "pair_style hamaker"),
                            ("pair_style hard/squarewell\npair_coeff * * restitution 0.9", "pair_style hard/squarewell"),
                            ("pair_style none" + wall, "fix w wall/gran/hamaker"),
                            ("pair_style none\nfix w all wall/hamaker hamaker 5e-19 cutoff 4e-10 1e-7 zplane 0 NULL",
                             "fix w wall/hamaker")):
            with self.subTest(style):
                text = script(pair, boundary="p p f").replace("diameter 75e-6 density 2650",
                                                              "density 1500\nset group all diameter 75e-6")
                self.stops(text, style, *says, ranks=2 if "hard" in style else 1)
        self.goes(script(gran("4e-10", "1e-7")).replace("diameter 75e-6 density 2650",
                                                        "diameter 75e-6\nset group all density 1500"))

    def test_no_density(self):
        """The mass pi/6 of create_atoms in 75 um is 2.37e12 kg/m^3."""
        says = ("particle 1 (one of 2) has the mass of a sphere of diameter 1 and density 1,",
                "a density of 2.37e+12 kg/m^3", "set the density after the diameter", UNITS)
        hard = "pair_style hard/squarewell\npair_coeff * * restitution 0.9"
        for pair in (gran("4e-10", "1e-7"), overlay("4e-10", "1e-7"), hard):
            self.refuses(*says, pair=pair, ranks=(1, 2) if pair == hard else (1,), without=" density 2650")
        self.stops(script(hard).replace(" density 2650", "").replace("units si", "units si\ndimension 2").replace(
            "0.005 units", "0 units").replace("0 0.01 units", "-0.01 0.01 units"), "density 1,", "2.37e+12 kg/m^3")
        # One of two; heavy on purpose; and a sphere of 50 mm, of 8000 kg/m^3.
        self.stops(script(hard, then="set atom 1 diameter 80e-6\nset atom 2 diameter 75e-6").replace(
            "density 2650", "").replace("set atom 2", "set atom 1 density 2650\nset atom 2"), "particle 2 (one of 1)")
        self.goes(script(hard).replace("density 2650", "density 1e12"))
        self.goes(script(hard, diameter="0.05", boundary="p p p").replace(" density 2650", "").replace("0.01", "1").replace(
            "0.008 0", "0.8 0"))

    def test_density_before_the_diameter_in_other_units(self):
        """In micrometres a sphere of diameter 1 is the smaller one: the density falls by 75^3."""
        text = script("pair_style hard/squarewell\npair_coeff * * restitution 0.9").replace("units si", "units micro")
        text = text.replace("0 0.01", "0 1000").replace("0.002 0.005 0.005", "200 500 500").replace(
            "0.008 0.005 0.005", "800 500 500").replace("1e-3 bin", "10 bin")
        self.stops(text.replace("diameter 75e-6 density 2650", "density 1.5\nset group all diameter 75"),
                   "a density of 0.00356 kg/m^3", "diameter 1 and density 1.5")
        self.goes(text.replace("diameter 75e-6 density 2650", "diameter 75 density 1.5"))

    def test_hamaker_constant_that_no_material_has(self):
        """F_ad = A R*/(6 H_cut^2) of 2e-4 N needs 50 N/m to give way by 5 % of the diameter."""
        strong = "stiffness 50 restitution 0.5 hamaker 1e-17 cutoff 4e-10 1e-7"
        says = ("the Hamaker constant A = 1e-17 J is above that of any material (1e-21 to 1e-18 J): check its value and "
                "its unit; the overlap of a resting pair is")
        none = strong.replace("1e-17", "0")
        for pair in (f"pair_style gran/hamaker\npair_coeff * * {strong}",
                     f"pair_style gran/hamaker\npair_coeff * * {none}\nfix w all wall/gran/hamaker {strong} zplane 0 NULL"):
            output = self.goes(script(pair, boundary="p p f"))
            self.assertIn(says, " ".join(output.split()))
        usual = self.goes(script(f"pair_style gran/hamaker\npair_coeff * * {strong}".replace("1e-17", "1e-18").replace(
            "stiffness 50", "stiffness 5")))
        self.assertIn("the overlap of a resting pair is", usual)
        self.assertNotIn("Hamaker constant", usual)

    def test_two_in_one_place(self):
        again = "create_atoms 1 single 0.002 0.005 0.005 units box\nset group all diameter 75e-6 density 2650"
        for pair, style in ((gran("4e-10", "1e-7"), "gran/hamaker"),
                            (gran("4e-10", "1e-7", "scheme sampled"), "gran/hamaker"),
                            (overlay("4e-10", "1e-7"), "hamaker"),
                            ("pair_style hard/squarewell\npair_coeff * * restitution 0.9 well 1e-12 1.1",
                             "hard/squarewell")):
            self.refuses(f"pair_style {style}: particles", "are in one place, (0.002, 0.005, "
                         "0.005)", "'delete_atoms overlap'", pair=pair, then=again, ranks=(1, 2))
        # Nothing happens between two that are excluded, or that nothing moves.
        for pair in (gran("4e-10", "1e-7"), "pair_style hard/squarewell\npair_coeff * * restitution 0.9"):
            self.goes(script(pair + "\nneigh_modify exclude type 1 1", then=again))
            self.goes(script(pair, then=again).replace("fix move all nve/sphere", ""))

    def test_shrink_wrapped_boxes_follow_the_centres(self):
        alone = "group other id 2\ndelete_atoms group other"
        text = script(NONE, boundary="s s s", diameter="1e-3", then=alone).replace("1e-3 bin", "1e-3 nsq")
        self.goes(text + "run 1\n")

    def test_particles_larger_than_the_box(self):
        self.refuses("radius of a particle = 0.0375: must not be above the longest side of the box, 0.01", UNITS,
                     pair=gran("4e-10", "1e-7"), diameter="75e-3", boundary="f f f")

    def test_range_of_very_many_images(self):
        self.refuses("range of radii and attraction = 0.051", "would find 2197 images of each particle", UNITS,
                     pair=gran("4e-10", "0.036", "form exact scheme sampled"), diameter="15e-3")

    def test_thin_boxes_are_right(self):
        thin = script(gran("4e-10", "1e-7"), diameter="8e-4").replace("0 0.01 units", "0 8e-4 units").replace(
            "0.005 units", "0.0004 units")
        self.goes(thin)


if __name__ == "__main__":
    unittest.main()
