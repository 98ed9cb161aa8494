# SPDX-License-Identifier: BSD-3-Clause
"""What pair_style gran/squarewell and its wall refuse, and what their advice says, in LAMMPS."""
import math
import unittest

from cohesion_tests import lammps as engine
from cohesion_tests.lammps_scenes.one_sphere import HEAD, MOVE
from cohesion_tests.lammps_scenes.square_well_scene import Scene, escape_velocity, words
from cohesion_tests.refusals import assert_refused
from cohesion_tests.theory.pair_motion import DAMPING, DIAMETER, MASS, STIFFNESS


class Input(Scene):
    def test_wrong_words_and_values(self):
        style = "pair_style gran/squarewell\npair_coeff * * "
        wall = style + "stiffness 800\nfix w all wall/gran/squarewell "
        for text, expected in (
                ("pair_style gran/squarewell form exact", ("form", "valid ones: scheme")),
                (style + "stiffness 800 hamaker 1e-19", ("hamaker", "well")),
                (style + "stiffness 800 well 1e-11", ("needs 'well D ratio': ratio is missing",)),
                (style + "well 1e-11 stiffness 800", ("'stiffness' stands in the place of ratio",)),
                (style + "stiffness 800 well -1e-11 1.1", ("depth D", "-1e-11")),
                (style + "stiffness 800 well 1e-11 0.9", ("ratio r_out/r", "0.9", "below 1")),
                (style + "stiffness 800 well nan 1.1", ("nan",)),
                (style + "well 1e-11 1.1", ("stiffness",)),
                (wall + "stiffness 800 well 1e-11 zplane 0 NULL", ("fix w", "well")),
                (wall + "stiffness 800 well 1e-11 0.5 zplane 0 NULL", ("fix w", "0.5")),
                (wall + "stiffness 800 form exact zplane 0 NULL", ("form", "well"))):
            with self.subTest(text):
                code, output = engine.run_text(HEAD + text + MOVE, self.folder)
                assert_refused(self, code, output, *expected)

    def test_advice_has_the_escape_velocity(self):
        code, output = engine.run_text(
            HEAD + "pair_style gran/squarewell\npair_coeff * * " + words(5e-11, 1.01) +
            "\nfix w all wall/gran/squarewell " + words(1e-10, 1.01) + " zplane 0 NULL" + MOVE,
            self.folder)
        self.assertEqual(code, 0, output)
        row = next(l for l in output.splitlines() if l.strip().startswith("1 - 1")).split()
        self.assertAlmostEqual(float(row[-2]) / escape_velocity(5e-11), 1, delta=5e-3)  # printed
        alpha = DAMPING / (2 * MASS)
        e = math.exp(-math.pi * alpha / math.sqrt(STIFFNESS / MASS - alpha**2))
        row = next(l for l in output.splitlines() if l.strip().startswith("1 - wall")).split()
        self.assertAlmostEqual(float(row[-2]) / escape_velocity(1e-10, MASS, e), 1, delta=5e-3)

    def test_a_pair_that_its_turning_presses_to_the_edge_goes_round_on_it(self):
        """Captured just below the edge of its well: a chord of the circle that is the edge takes 2 sqrt(2 part) of a
        radian, and a step of 0.002 radian 3500 of them. That is rest at the edge; the speed along it stays."""
        part, ratio, dt = 4e-14, 1.1, 5e-6
        edge = ratio * DIAMETER
        v = 0.002 * edge / dt
        end = self.follow([self.sphere((5e-3 + side * edge * (1 - part) / 2, 5e-3, 5e-3), (0.0, side * v / 2, 0.0))
                           for side in (-1, 1)], [f"* * {words(5e-11, ratio)}"], dt, 20)
        self.assertNotIn("turned round", self.output)
        apart, rate = end[1, 1:4] - end[0, 1:4], end[1, 4:7] - end[0, 4:7]
        # Velocities that the engine prints lie between two steps: less than at their ends by a square of the turn.
        self.assertAlmostEqual(math.hypot(*apart) / edge, 1, delta=1e-9)
        self.assertAlmostEqual(math.hypot(*rate) / v, 1, delta=0.002**2)


if __name__ == "__main__":
    unittest.main()
