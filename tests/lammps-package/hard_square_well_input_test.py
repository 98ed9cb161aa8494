# SPDX-License-Identifier: BSD-3-Clause
"""Input of pair_style hard/squarewell, fix wall/hard/squarewell and compute hard/events: what is
refused and why, and what is warned of."""
import unittest

from cohesion_tests.test_cases import ScriptTestCase

HEAD = """
plugin load ${plugin}
units lj
atom_style sphere
boundary f f f
newton %(newton)s
%(velocities)s
region box block -5 5 -5 5 -5 5 units box
create_box 2 box
create_atoms 1 single -1 0 0 units box
create_atoms 2 single %(second)s 0 0 units box
set group all diameter 1 density 1.9
velocity all set %(speed)s 0 0
neighbor 0.5 bin
neigh_modify delay 0 every 1 check yes
timestep %(dt)s
"""
USUAL = {"newton": "off", "velocities": "comm_modify vel yes", "dt": "0.01", "second": "1",
         "speed": "1"}
PAIR = "pair_style hard/squarewell\npair_coeff * * restitution 0.9 friction 0.3 well 0.5 1.2\n"
MOVE = "fix move all nve/sphere\nrun 2\n"


def script(middle=PAIR, tail=MOVE, **changes):
    return HEAD % {**USUAL, **changes} + middle + "\n" + tail


class Input(ScriptTestCase):
    def test_wrong_words_and_values_of_a_pair(self):
        style = "pair_style hard/squarewell\npair_coeff * * "
        for words, expected in (
                ("restitutoin 0.9", ("restitutoin", "restitution", "well")),
                ("restitution 1.1", ("restitution e = 1.1", "between 0 and 1")),
                ("restitution nan", ("nan",)),
                ("friction 0.3", ("give 'restitution e'",)),
                ("restitution 1 friction -1", ("friction mu = -1",)),
                ("restitution 1 well 1", ("needs 'well D ratio': ratio is missing",)),
                ("restitution 1 well -1 1.1", ("depth D of the well = -1",)),
                ("restitution 1 well 1 0.9", ("= 0.9", "not below 1")),
                ("restitution 1 well 1 1", ("above 1", "infinitely many events"))):
            with self.subTest(words):
                self.stops(script(style + words), *expected)

    def test_a_well_of_no_depth_may_have_no_width(self):
        self.goes(script("pair_style hard/squarewell\npair_coeff * * restitution 1 well 0 1\n"))

    def test_wrong_settings(self):
        for words, expected in (("colapse off", ("colapse", "rest, collapse, contact_time, limit")),
                                ("collapse 0", ("at least 1", "off")),
                                ("limit 0", ("at least 1",)),
                                ("contact_time -1", ("contact_time -1", "not below zero")),
                                ("rest -0.1", ("rest -0.1", "not below zero")),
                                ("rest no", ("instead of 'no'",)),
                                ("record", ("takes a file name",)),
                                ("record no/such/folder/f", ("cannot open", "no/such/folder/f"))):
            with self.subTest(words):
                self.stops(script(PAIR.replace("squarewell", "squarewell " + words, 1)),
                           *expected)

    def test_missing_types(self):
        self.stops(script("pair_style hard/squarewell\npair_coeff 1 1 restitution 1\n"),
                   "pair coeffs are not set")

    def test_what_the_engine_must_provide(self):
        self.stops(script(newton="on"), "newton off")
        self.stops(script(velocities=""), "comm_modify vel yes")
        self.stops(script(tail="run_style respa 2 2\n" + MOVE), "run_style verlet")
        self.stops(script(tail="minimize 0 0 1 1\n"), "minimized")

    def test_walls(self):
        wall = "fix w all wall/hard/squarewell "
        for words, expected in (
                ("restitution 1", ("no wall",)),
                ("xplane -5 5", ("give 'restitution e'",)),
                ("restitution 1 xplan -5 5", ("xplan", "xplane", "well")),
                ("restitution 1 well 1 1 xplane -5 5", ("above 1",)),
                ("restitution 1 zcylinder 0.55", ("0.55", "must be above 0.6"))):
            with self.subTest(words):
                self.stops(script(tail=wall + words + "\n" + MOVE), *expected)
        self.stops(HEAD % USUAL + wall + "restitution 1 xplane -5 5\npair_style zero 2\n"
                   "pair_coeff * *\n" + MOVE, "pair_style hard/squarewell")

    def test_compute_needs_the_pair_style(self):
        self.stops(HEAD % USUAL + "pair_style zero 2\npair_coeff * *\ncompute h all hard/events\n" +
                   MOVE, "pair_style hard/squarewell")
        self.stops(script(tail="group one type 1\ncompute h one hard/events\n"), "must be 'all'")

    def test_a_step_too_long_for_the_list_names_the_skin(self):
        """On several processes: one alone has no border beyond which it knows nothing."""
        self.stops(script(speed="100"), "in step 1", "skin above", ranks=2)
        self.goes(script(speed="100"))

    def test_a_flight_longer_than_the_box_is_refused(self):
        self.stops(script(speed="2000").replace("boundary f f f", "boundary p p p"), "box is 10")

    def test_overlapping_cores_are_told_of(self):
        self.assertRegex(self.goes(script(second="-0.5")), "WARNING.*1 pairs of hard cores.*0.5")
        self.assertNotIn("WARNING: pair_style", self.goes(script()))


if __name__ == "__main__":
    unittest.main()
