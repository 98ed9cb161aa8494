# SPDX-License-Identifier: BSD-3-Clause
"""Former names: 'scheme event' of 'scheme exact', and the names of styles. A run warns of each in one line and is
otherwise the same; exact is the default."""
import unittest
from pathlib import Path

from cohesion_tests.lammps_scenes.small_box import box, spheres
from cohesion_tests.test_cases import ScriptTestCase

# A pair that approaches, and a sphere that presses on a floor.
HEAD = (box(boundary="p p f") +
        spheres((1, 0.002, 0.002, 0.005), (1, 0.00299, 0.002, 0.005), (1, 0.007, 0.002, 0.00049)) +
        "set atom 1 vx 0.1\nset atom 3 vz -0.1\nneighbor 1e-4 bin\ntimestep 1e-6\n")
TAIL = """fix move all nve/sphere
dump out all custom 5 {file} id fx fy fz vx vy vz
dump_modify out sort id format float %.17g
run 10
run 10
"""
CONTACT = "stiffness 800 restitution 0.9 "
LAWS = {"hamaker": "hamaker 1e-18 cutoff 4e-10 1e-7", "squarewell": "well 1e-11 1.01",
        "liquidbridge": "bridge 1e-4 1e-5"}
LINE = "scheme 'event' is now called 'exact'; write 'exact', since from version 0.4.0 on the old word stops the run"


class SchemeEvent(ScriptTestCase):
    def end(self, law, of_pairs, of_walls, ranks=1):
        """What was printed, and the forces and velocities."""
        words = CONTACT + LAWS[law]
        file = Path(self.folder) / "out.txt"
        output = self.goes(HEAD + f"pair_style gran/{law} {of_pairs}\npair_coeff * * {words}\n" +
                           "".join(f"fix {name} all wall/gran/{law} {words} {of_walls} {plane}\n"
                                   for name, plane in (("floor", "zplane 0 NULL"), ("lid", "zplane NULL 0.01"))) +
                           TAIL.format(file=file), ranks=ranks)
        return " ".join(output.split()), file.read_text()

    def test_taken_with_one_line(self):
        for law in LAWS:
            for ranks in (1, 2) if law == "hamaker" else (1,):
                with self.subTest(law, ranks=ranks):
                    right, expected = self.end(law, "scheme exact", "scheme exact", ranks)
                    self.assertNotIn("is now called", right)
                    output, found = self.end(law, "scheme event", "scheme event", ranks)
                    self.assertEqual(output.count("is now called"), 1, output)
                    self.assertIn(f"WARNING: pair_style gran/{law}: {LINE}", output)
                    self.assertEqual(found, expected)

    def test_of_a_wall_alone(self):
        output, _ = self.end("hamaker", "", "scheme event")
        self.assertEqual(output.count("is now called"), 1, output)
        self.assertIn(f"WARNING: fix floor wall/gran/hamaker: {LINE}", output)

    def test_the_default(self):
        for law in LAWS:
            with self.subTest(law):
                (default, found), (_, expected) = self.end(law, "", ""), self.end(law, "scheme exact", "scheme exact")
                self.assertIn(f"pair_style gran/{law}, scheme exact: what to expect", default)
                self.assertNotIn("is now called", default)
                self.assertEqual(found, expected)
        self.assertNotEqual(found, self.end(law, "scheme sampled", "scheme sampled")[1])

    def test_an_unknown_scheme_gets_the_valid_names_alone(self):
        self.stops(HEAD + "pair_style gran/hamaker scheme events\n",
                   "unknown scheme 'events'; valid names: exact, sampled")


class NamesOfStyles(ScriptTestCase):
    """Styles under their names with an underscore: one line each, and the same run."""
    STYLES = {("gran/squarewell", "gran/square_well"): CONTACT + LAWS["squarewell"],
              ("gran/liquidbridge", "gran/liquid_bridge"): CONTACT + LAWS["liquidbridge"],
              ("hard/squarewell", "hard/square_well"): "well 1e-11 1.01 restitution 0.9"}

    def end(self, name, words):
        file = Path(self.folder) / "out.txt"
        output = self.goes(HEAD + f"pair_style {name}\npair_coeff * * {words}\n"
                           f"fix floor all wall/{name} {words} zplane 0 NULL\n" + TAIL.format(file=file))
        return " ".join(output.split()), file.read_text()

    def test_taken_with_one_line_each(self):
        for (now, former), words in self.STYLES.items():
            with self.subTest(now):
                right, expected = self.end(now, words)
                self.assertNotIn("is now called", right)
                output, found = self.end(former, words)
                for prefix in ("", "wall/"):
                    self.assertEqual(output.count(f"style '{prefix}{former}' is now called '{prefix}{now}'"), 1, output)
                self.assertEqual(found, expected)

    def test_an_overlay(self):
        output = self.goes(HEAD + "pair_style hybrid/overlay gran/hooke/history 800 NULL 0 NULL 0 0 square_well\n"
                           "pair_coeff * * gran/hooke/history\npair_coeff * * square_well well 1e-11 1.01\n"
                           "fix move all nve/sphere\nrun 10\n")
        self.assertEqual(output.count("style 'square_well' is now called 'squarewell'"), 1, output)


if __name__ == "__main__":
    unittest.main()
