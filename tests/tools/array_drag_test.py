# SPDX-License-Identifier: BSD-3-Clause
"""array-drag: what it prints, spheres from a file, closures beside it, and what it refuses."""
import math
import tempfile
import unittest
from pathlib import Path

from cohesion_tests.csv_program import CsvProgram
from cohesion_tests.theory.closure_formulas import CLOSURES, DOUBLE

program = CsvProgram("ARRAY_DRAG")


class ArrayDrag(unittest.TestCase):
    def test_simple_cubic(self):
        """Zick and Homsy: K 28.1 at 0.45. 1 % is asked."""
        found = program.values("--array", "sc", "--phi", 0.45, "--diameter", 12)
        self.assertAlmostEqual(found["K"] / 28.1, 1, delta=0.01)
        self.assertAlmostEqual(found["F"] / (0.55 * found["K"]), 1, delta=1e-12)
        self.assertAlmostEqual(found["phi"], 0.45, delta=1e-12)
        # To what is left of the transient, 1e-6 of the velocity
        self.assertLess(found["error_of_balance"], 1e-5)

    def test_closures_stand_beside_it(self):
        """F* = beta d^2/(18 mu (1 - eps) eps), of the formulas written out again."""
        found = program.values("--array", "sc", "--phi", 0.45, "--diameter", 8, "--re", 10)
        self.assertAlmostEqual(found["Re"], 10, delta=0.11)
        eps, mu = 0.55, 1 / found["Re"]
        for name, closure in CLOSURES.items():
            expected = closure(DOUBLE, eps, 1 / eps, 1.0, 1.0, mu) / (18 * mu * eps)
            self.assertAlmostEqual(found["F_" + name] / expected, 1, delta=1e-9)

    def test_spheres_of_a_file_are_the_array(self):
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "spheres"
            edge = 2.0
            d = edge * (6 * 0.45 / math.pi)**(1 / 3)
            file.write_text(f"{0.31 / 13 * edge} {0.17 / 13 * edge} {0.43 / 13 * edge} {d}\n")
            array = program.values("--array", "sc", "--phi", 0.45, "--diameter", 12.36)
            read = program.values("--spheres", file, "--box", edge, edge, edge, "--diameter", 12.36)
        self.assertAlmostEqual(read["K"] / array["K"], 1, delta=1e-6)
        self.assertEqual(read["steps"], array["steps"])

    def refused(self, words, *parts):
        code, output, error = program.call(*words)
        self.assertNotEqual(code, 0, output)
        for part in parts:
            self.assertIn(part, error + output)

    def test_refusals(self):
        self.refused((), "--phi, or --spheres")
        self.refused(("--array", "sc", "--phi", 0.6), "fraction of solid = 0.6", "spheres that touch")
        self.refused(("--array", "hcp", "--phi", 0.3), "--array", "hcp")
        self.refused(("--phi", 0.3, "--phi", 0.4), "--phi")
        self.refused(("--spheres", "nowhere", "--box", 1, 1, 1), "--spheres nowhere: cannot be read")
        self.refused(("--spheres", "nowhere"), "--box")
        self.refused(("--phi", 0.3, "--direction", 0, 0, 0), "direction")
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "spheres"
            file.write_text("0 0 0 1\n0 0 word 1\n")
            self.refused(("--spheres", file, "--box", 2, 2, 2), "row 2 is not x y z diameter")
            file.write_text("0 0 0 1\n")
            self.refused(("--spheres", file, "--box", 2, 2, 2.05), "edge of the box")


if __name__ == "__main__":
    unittest.main()
