# SPDX-License-Identifier: BSD-3-Clause
"""Keywords of pair_style hamaker, its pair_coeff and fix wall/hamaker: what is refused, and how."""
import unittest

from cohesion_tests.lammps_scenes import two_at_rest as scene
from cohesion_tests.test_cases import ScriptTestCase

PAIR = scene.SPHERES + "pair_style hamaker cutoff 4e-10 1e-7 "
COEFF = PAIR + "form exact\npair_coeff 1 2 hamaker 1e-19 "
WALL = scene.SPHERES + scene.PAIR + "fix wall all wall/hamaker hamaker 1e-19 cutoff 4e-10 1e-7 "


class HamakerKeywords(ScriptTestCase):
    def test_the_right_input_is_accepted(self):
        self.goes(PAIR + "form small_gap\npair_coeff * * hamaker 1e-19 cutoff 4e-10 1e-7 asperity 0\n"
                  "fix wall all wall/hamaker hamaker 1e-19 cutoff 4e-10 1e-7 asperity 1e-8 xplane 0 NULL form exact\n"
                  + scene.TAIL)

    def test_numbers_without_keywords_are_taken_with_a_warning(self):
        right = scene.SPHERES + ("pair_style hamaker cutoff 4e-10 1e-7 form small_gap\n"
                                 "pair_coeff * * hamaker 1e-19 cutoff 4e-10 2e-7 asperity 0\n")
        wall = "fix wall all wall/hamaker hamaker 1e-19 cutoff 4e-10 1e-7 xplane 0 NULL\n"
        self.assertNotIn("without keywords", self.goes(right + wall + scene.TAIL))
        for text, instead in (
                (right.replace("cutoff 4e-10 1e-7", "4e-10 1e-7") + wall,
                 "pair_style hamaker: numbers without keywords; write 'cutoff 4e-10 1e-7'"),
                (right.replace("hamaker 1e-19 cutoff", "1e-19") + wall,
                 "pair_coeff * * of hamaker: numbers without keywords; write 'hamaker 1e-19 cutoff 4e-10 2e-7'"),
                (right.replace("hamaker 1e-19 cutoff 4e-10 2e-7", "1e-19") + wall, "write 'hamaker 1e-19'"),
                (right + wall.replace("hamaker 1e-19 cutoff", "1e-19"),
                 "fix wall wall/hamaker: numbers without keywords; write 'hamaker 1e-19 cutoff 4e-10 1e-7'"),
                (scene.SPHERES.replace("newton off", "newton off\ncomm_modify vel yes")
                 + "pair_style squarewell\npair_coeff * * 1e-11 1.1\n",
                 "of squarewell: numbers without keywords; write 'well 1e-11 1.1'")):
            output = self.goes(text + scene.TAIL)
            self.assertEqual(output.count("without keywords"), 1, output)
            self.assertIn(instead, " ".join(output.split()))

    def test_unknown_form(self):
        self.stops(PAIR + "form full\n", "pair_style hamaker", "unknown form 'full'",
                   "valid names: small_gap, exact")
        self.stops(WALL + "form full xplane 0 NULL\n", "fix wall wall/hamaker",
                   "unknown form 'full'", "valid names: small_gap, exact")

    def test_unknown_keyword(self):
        self.stops(PAIR + "shape exact\n", "pair_style hamaker", "'shape'", "form")
        self.stops(WALL + "xplane 0 NULL shape exact\n", "'shape'",
                   "hamaker, cutoff, xplane, yplane, zplane, form, asperity, roughness")
        self.stops(COEFF + "cutoff 4e-10 1e-7 asparity 1e-8\n", "pair_coeff 1 2 of hamaker", "'asparity'",
                   "hamaker, cutoff, asperity, roughness")

    def test_missing_value(self):
        self.stops(PAIR + "form\n", "pair_style hamaker", "needs 'form name': name is missing")
        self.stops(COEFF + "asperity\n", "pair_coeff 1 2 of hamaker", "needs 'asperity r_a': r_a is missing")
        self.stops(COEFF + "cutoff 4e-10\n", "pair_coeff 1 2 of hamaker", "needs 'cutoff H_cut H_out': H_out is missing")
        self.stops(scene.SPHERES + "pair_style hamaker\npair_coeff 1 2 hamaker 1e-19\n", "cutoff H_cut H_out",
                   "or in pair_style")
        self.stops(COEFF.replace("hamaker 1e-19", "asperity 0"), "needs 'hamaker A'")
        self.stops(WALL + "xplane 0 NULL form\n", "form takes a name")
        self.stops(WALL + "xplane 0 NULL asperity\n", "needs 'asperity r_a': r_a is missing")
        self.stops(WALL + "form exact asperity 1e-8\n", "at least one plane")

    def test_asperity_radius(self):
        for value, words in (("-1e-8", ["asperity radius = -1e-08", "not below zero"]),
                             ("nan", ["nan"]), ("inf", ["inf"]), ("small", ["small"])):
            with self.subTest(value):
                self.stops(COEFF + f"asperity {value}\n", *words)
                self.stops(WALL + f"asperity {value} xplane 0 NULL\n", *words)

    def test_roughness(self):
        right = PAIR + "\npair_coeff * * hamaker 1e-19 roughness 5e-9 5e-7\n"
        self.goes(right + "fix wall all wall/hamaker hamaker 1e-19 cutoff 4e-10 1e-7 roughness 0 5e-7 xplane 0 NULL\n"
                  + scene.TAIL)
        for values, words in (
                ("-1e-9 5e-7", ("rms roughness = -1e-09", "not below zero")),
                ("1e-9 0", ("wavelength of the roughness = 0", "greater than zero")),
                ("1e-9 1e-8", ("wavelength of the roughness = 1e-08", "at least 10.2785 times the rms of 1e-09")),
                ("1e-9", ("needs 'roughness rms lambda': lambda is missing",)),
                ("5e-9 5e-7 asperity 1e-8", ("'asperity'", "'roughness'", "not both"))):
            with self.subTest(values):
                self.stops(COEFF + f"roughness {values}\n", "pair_coeff 1 2 of hamaker", *words)
                self.stops(WALL + f"xplane 0 NULL roughness {values}\n", "fix wall wall/hamaker", *words)

    def test_flat_caps_are_refused_beside_the_particles(self):
        # 1/(1 + R*/r_a) + 1/(1 + h_a/H_cut)^2 with r_a = 17.2 mm, h_a = 0.1817 nm: 0.986 + 0.473 of the pair.
        flat = "hamaker 1e-19 cutoff 4e-10 1e-7 roughness 1e-10 1e-5"
        self.stops(PAIR + f"\npair_coeff * * {flat}\n" + scene.TAIL, "types 1 and 1",
                   "asperity height = 1.817e-10", "would be 1.4", "smooth surfaces")
        self.stops(scene.SPHERES + scene.PAIR + f"fix wall all wall/hamaker {flat} xplane 0 NULL\n" + scene.TAIL,
                   "fix wall wall/hamaker", "asperity height = 1.817e-10")

    def test_message_names_the_place(self):
        self.stops(COEFF + "asperity -1e-8\n", "pair_coeff 1 2 of hamaker")
        self.stops(WALL + "xplane 0 NULL asperity -1e-8\n", "fix wall wall/hamaker")


if __name__ == "__main__":
    unittest.main()
