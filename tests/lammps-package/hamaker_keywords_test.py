# SPDX-License-Identifier: BSD-3-Clause
"""Keywords of pair_style hamaker, its pair_coeff and fix wall/hamaker: what is refused, and how."""
import unittest

from cohesion_tests.lammps_scenes import two_at_rest as scene
from cohesion_tests.test_cases import ScriptTestCase

PAIR = scene.SPHERES + "pair_style hamaker 4e-10 1e-7 "
COEFF = PAIR + "form exact\npair_coeff 1 2 1e-19 "
WALL = scene.SPHERES + scene.PAIR + "fix wall all wall/hamaker 1e-19 4e-10 1e-7 "


class HamakerKeywords(ScriptTestCase):
    def test_the_right_input_is_accepted(self):
        self.goes(PAIR + "form small_gap\npair_coeff * * 1e-19 4e-10 1e-7 asperity 0\n"
                  "fix wall all wall/hamaker 1e-19 4e-10 1e-7 asperity 1e-8 xplane 0 NULL form exact\n"
                  + scene.TAIL)

    def test_unknown_form(self):
        self.stops(PAIR + "form full\n", "pair_style hamaker", "unknown form 'full'",
                   "valid names: small_gap, exact")
        self.stops(WALL + "form full xplane 0 NULL\n", "fix wall wall/hamaker",
                   "unknown form 'full'", "valid names: small_gap, exact")

    def test_unknown_keyword(self):
        self.stops(PAIR + "shape exact\n", "pair_style hamaker", "'shape'", "form")
        self.stops(WALL + "xplane 0 NULL shape exact\n", "'shape'",
                   "xplane, yplane, zplane, form, asperity")
        self.stops(COEFF + "4e-10 1e-7 asparity 1e-8\n", "pair_coeff of hamaker", "'asperity'")

    def test_missing_value(self):
        self.stops(PAIR + "form\n", "H_cut H_out", "'form' with a name")
        self.stops(COEFF + "asperity\n", "i j A H_cut H_out", "'asperity' with a radius")
        self.stops(COEFF + "4e-10 1e-7 asperity\n", "i j A H_cut H_out", "'asperity' with a radius")
        self.stops(WALL + "xplane 0 NULL form\n", "form takes a name")
        self.stops(WALL + "xplane 0 NULL asperity\n", "asperity takes a radius")
        self.stops(WALL + "form exact asperity 1e-8\n", "at least one plane")

    def test_asperity_radius(self):
        for value, words in (("-1e-8", ["asperity radius = -1e-08", "not below zero"]),
                             ("nan", ["nan"]), ("inf", ["inf"]), ("small", ["small"])):
            with self.subTest(value):
                self.stops(COEFF + f"asperity {value}\n", *words)
                self.stops(WALL + f"asperity {value} xplane 0 NULL\n", *words)

    def test_message_names_the_place(self):
        self.stops(COEFF + "asperity -1e-8\n", "pair_coeff 1 2 of hamaker")
        self.stops(WALL + "xplane 0 NULL asperity -1e-8\n", "fix wall wall/hamaker")


if __name__ == "__main__":
    unittest.main()
