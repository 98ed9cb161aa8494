# SPDX-License-Identifier: BSD-3-Clause
"""How extremes.py judges: triples at two times alike, and what it tells of warnings."""
import os
import unittest
from pathlib import Path

import numpy

from cohesion_tests.liggghts_scenes import extremes, extremes_page
from cohesion_tests.liggghts_scenes.extremes_points import LAWS, RADIUS, Partners

LAUNCHER = os.environ["COHESION_LAUNCHER"]
SPEED, DENSITY = 0.05, extremes.DENSITY


def pair():
    mass = 4 / 3 * numpy.pi * RADIUS**3 * DENSITY
    return Partners("square_well", dict(LAWS["square_well"], steps=8.0), 2 * [RADIUS], 2 * [mass], 0.5)


class Times(unittest.TestCase):
    def test_wrong_is_what_is_so_at_both(self):
        for right, found in (((True, True), ("right", 0.01)), ((True, False), ("right, later not", 0.01)),
                             ((False, True), ("right, later alone", 0.02)), ((False, False), ("wrong, silent", 0.01))):
            self.assertEqual(extremes.of_times("", [0.01, 0.02], right), (*found, ""))

    def test_second_time_is_that_of_a_longer_run(self):
        one = pair()
        spheres = [(1, RADIUS, DENSITY, (one.reach + one.gap, 0, 0), (-SPEED, 0, 0)),
                   (2, RADIUS, DENSITY, (0, 0, 0), (0, 0, 0))]
        _, _, both = extremes.run(LAUNCHER, "square_well", "sampled", one, 3 * [one.gamman], spheres, times=(0.0, 0.5))
        for n, time in enumerate((0.0, 0.5)):
            _, _, alone = extremes.run(LAUNCHER, "square_well", "sampled", one, 3 * [one.gamman], spheres,
                                       times=(time,))
            self.assertTrue(numpy.array_equal(both[n], alone[0]))
        self.assertFalse(numpy.array_equal(*both))


class Fast(unittest.TestCase):
    def test_sphere_that_leaves_a_well_at_a_wall(self):
        """It moves 0.07 of its radius in a step, and its contact is seen until the energy account closes."""
        found, error, _ = extremes.judge_two(LAUNCHER, "square_well", "exact", dict(LAWS["square_well"], speed=10.0),
                                             1.036, True)
        self.assertEqual(found, "right")
        self.assertLess(error, 1e-12)


class Warned(unittest.TestCase):
    def test_of_contacts_that_occur(self):
        """Two such spheres, of half the reduced mass, would have 14/sqrt(2) = 9.9 steps."""
        values = dict(LAWS["square_well"], steps=14.0, e=1.0)
        found, _, said = extremes.judge_two(LAUNCHER, "square_well", "sampled", values, 0.5, True)
        self.assertEqual(found, "right")
        self.assertEqual(said, "14 steps per contact; 9.9 steps per contact (1 - 1)")

    def test_verdicts(self):
        for said, found in (("14 steps per contact", "wrong, warned"), ("impact overlap 2 %", "wrong, silent"),
                            ("9.9 steps per contact (1 - 1)", "wrong, other types warned")):
            self.assertEqual(extremes.verdict(said, False), found)
            self.assertEqual(extremes.verdict(said, True), "right")

    def test_shown_is_what_was_said_of_contacts_that_occur(self):
        both = "14 steps per contact; 9.9 steps per contact (1 - 1)"
        results = [("right", 0.0, both), ("wrong, other types warned", 0.2, "9.9 steps per contact (1 - 1)"),
                   ("not set up", None, "")]
        self.assertEqual(extremes.said_of(results),
                         "pair: 14 steps per contact. wall: 9.9 steps per contact (1 - 1)")
        self.assertEqual(extremes.said_of([("right", 0.0, both)] * 3), "14 steps per contact")


class Report(unittest.TestCase):
    VALUES = LAWS["hamaker"]
    ROWS = [("hamaker", VALUES, False, [("right", 0.0, ""), ("wrong, silent", 0.3, ""),
                                        ("right, later alone", 0.0, "")]),
            ("hamaker", VALUES, False, [("refused", None, ""), ("right", 0.0, ""), ("no reference", None, "")]),
            ("hamaker", VALUES, False, [("right", 0.0, ""), ("right", 0.0, ""), ("reference crashed", None, "")])]

    def test_counts(self):
        counts = extremes_page.outcomes(self.ROWS)
        self.assertEqual([[row[name] for name in ("case", "points", "correct", "incorrect, no warning", "stops",
                                                  "no reference")] for row in counts],
                         [["pair", "3", "2", "0", "1", "0"], ["wall", "3", "2", "1", "0", "0"],
                          ["three spheres", "3", "1", "0", "0", "2"]])
        points = extremes_page.listed(self.ROWS)
        self.assertEqual([point["points"] for point in points], ["random", "random"])
        page = extremes_page.page(counts, points, "name")
        for line in ("| hamaker | 3, 3, 3 | 2, 2, 1 | 0, 1, 0 | 1, 0, 0 | 0, 0, 2 |",
                     "| hamaker | " + "; ".join(
                         f"random: {extremes_page.name_of(self.VALUES)} (pair correct, 0.0e+00; {others})"
                         for others in (
                             "wall incorrect, no warning, 3.0e-01; three spheres correct, later only, 0.0e+00",
                             "wall correct, 0.0e+00; three spheres reference crashed")) + " |"):
            self.assertIn(line, page.splitlines())
        self.assertIn("incorrect, no warning 1, crashed 0, hangs 0.", page.replace("\n", " "))

    def test_committed_page_is_that_of_the_tables(self):
        file = Path(__file__).resolve().parents[2] / "docs/verification/liggghts_extremes.md"
        counts, points = map(extremes_page.read_table, extremes_page.tables(file))
        self.assertEqual(file.read_text(), extremes_page.page(counts, points, file.stem))


if __name__ == "__main__":
    unittest.main()
