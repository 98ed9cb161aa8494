# SPDX-License-Identifier: BSD-3-Clause
"""array-drag: what it prints, spheres of files, random arrays, closures beside it, and what it refuses."""
import csv
import math
import statistics
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
        # To what is left of the transient, 1e-5 of the velocity
        self.assertLess(found["error_of_balance"], 1e-5)

    def test_closures_stand_beside_it(self):
        """F* = beta d^2/(18 mu (1 - eps) eps), of the formulas written out again."""
        found = program.values("--array", "sc", "--phi", 0.45, "--diameter", 8, "--re", 5, "--tolerance", 1e-3)
        self.assertAlmostEqual(found["Re"], 5, delta=0.01)
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

    def test_a_dump_is_the_rows_in_its_box(self):
        """Of its last frame, with the box where the dump has it, and radii in place of diameters."""
        with tempfile.TemporaryDirectory() as folder:
            rows, dump = Path(folder) / "rows", Path(folder) / "dump"
            rows.write_text("0.5 0.5 0.5 0.8\n1.4 1.2 1.6 0.6\n")
            frame = ("ITEM: TIMESTEP\n{}\nITEM: NUMBER OF ATOMS\n{}\nITEM: BOX BOUNDS pp pp pp\n-1 1\n-1 1\n-1 1\n"
                     "ITEM: ATOMS id type x y z radius\n{}")
            dump.write_text(frame.format(0, 1, "1 1 0 0 0 0.3\n")
                            + frame.format(10, 2, "2 1 -0.5 -0.5 -0.5 0.4\n1 1 0.4 0.2 0.6 0.3\n"))
            read = program.values("--spheres", rows, "--box", 2, 2, 2, "--diameter", 8)
            dumped = program.values("--spheres", dump, "--diameter", 8)
        self.assertEqual(dumped["spheres"], 2)
        self.assertAlmostEqual(dumped["F"] / read["F"], 1, delta=1e-9)

    def test_random_arrays(self):
        """Each has its own seed, and the numbers of several are those of each: mean and standard error."""
        def of(*words):
            return program.values("--array", "random", "--phi", 0.4, "--counts", 12, "--diameter", 6, *words)
        one, two, both = of("--seed", 5), of("--seed", 6), of("--seed", 5, "--arrays", 2)
        self.assertNotEqual(one["F"], two["F"])
        self.assertAlmostEqual(both["F"] / ((one["F"] + two["F"]) / 2), 1, delta=1e-12)
        self.assertAlmostEqual(both["F_error"] / (abs(one["F"] - two["F"]) / 2), 1, delta=1e-9)
        self.assertEqual(both["steps"], one["steps"] + two["steps"])

    def test_threads_change_no_digit(self):
        words = "--array", "random", "--phi", 0.4, "--counts", 12, "--diameter", 6
        one, two = program.values(*words, "--threads", 1), program.values(*words, "--threads", 2)
        for name in ("F", "K", "error_of_balance", "scatter_1", "steps"):
            self.assertEqual(one[name], two[name], name)

    def test_each_sphere_of_a_mixture(self):
        """The drag of a size is the mean over its spheres in --each, and all of it is what drives the fluid."""
        with tempfile.TemporaryDirectory() as folder:
            each = Path(folder) / "each"
            found = program.values("--array", "random", "--phi", 0.4, "--counts", 32, 4, "--sizes", 1, 2, "--diameter", 8,
                                   "--each", each)
            with open(each, newline="") as lines:
                rows = [{name: float(x) for name, x in row.items()} for row in csv.DictReader(lines)]
        self.assertEqual(len(rows), 36)
        small, large = found["diameter_1"], found["diameter_2"]
        self.assertAlmostEqual(large / small, 2, delta=1e-9)
        for size, name in ((small, "F_1"), (large, "F_2")):
            drags = [row["Fx"] for row in rows if abs(row["diameter"] / size - 1) < 1e-4]
            self.assertAlmostEqual(statistics.mean(drags) / found[name], 1, delta=1e-4)  # digits of --each
        # Fractions of nodes and of spheres in the box differ by less than a shell of a tenth of a spacing.
        total = (32 * found["F_1"] * small + 4 * found["F_2"] * large) / (36 * found["diameter"])
        self.assertAlmostEqual(total / found["F"], 1, delta=0.03)

    def test_mixture_laws_stand_beside_it(self):
        """y_i of Carman and Kozeny times beetstra's F, and 0.064 (y^3 - phi M y^2) of it besides, by hand."""
        found = program.values("--array", "random", "--phi", 0.4, "--counts", 32, 4, "--sizes", 1, 2, "--diameter", 8)
        sauter = (32 + 4 * 8) / (32 + 4 * 4)
        spread = (32 + 4 * 16) / ((32 + 4 * 4) * sauter**2)
        for n, d in ((1, 1), (2, 2)):
            y = d / sauter
            self.assertAlmostEqual(found[f"F_carmanKozeny_{n}"] / (y * found["F_beetstra"]), 1, delta=1e-9)
            cubic = y + 0.064 * (y**3 - 0.4 * spread * y**2)
            self.assertAlmostEqual(found[f"F_vanDerHoef_{n}"] / (cubic * found["F_beetstra"]), 1, delta=1e-9)

    def test_tensor_of_a_cube_is_a_number(self):
        """To where the nodes lie among the walls, 1 %; what is beside the diagonal is zero by symmetry."""
        found = program.values("--array", "sc", "--phi", 0.3, "--diameter", 10, "--tensor")
        for axes in ("xx", "yy", "zz"):
            self.assertAlmostEqual(found["F_" + axes] / found["F"], 1, delta=0.01)
        for axes in ("xy", "xz", "yz"):
            self.assertLess(abs(found["F_" + axes] / found["F"]), 0.01)

    def test_slice(self):
        """The mean over the box is U: over one plane of a cube, which the flow crosses nowhere, within a factor of 2."""
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "slice"
            program.values("--array", "sc", "--phi", 0.2, "--diameter", 8, "--slice", file)
            with open(file, newline="") as lines:
                rows = list(csv.DictReader(lines))
        speeds = [float(row["speed"]) for row in rows]
        self.assertEqual(len(rows), 11**2)
        self.assertTrue(0.5 < statistics.mean(speeds) < 2, statistics.mean(speeds))

    def refused(self, words, *parts):
        code, output, error = program.call(*words)
        self.assertNotEqual(code, 0, output)
        for part in parts:
            self.assertIn(part, error + output)

    def test_refusals(self):
        self.refused((), "--array with --phi, or --spheres")
        self.refused(("--array", "sc", "--phi", 0.6), "fraction of solid = 0.6", "spheres that touch")
        self.refused(("--array", "hcp", "--phi", 0.3), "--array", "hcp")
        self.refused(("--array", "sc", "--phi", 0.3, "--phi", 0.4), "--phi")
        self.refused(("--array", "sc"), "--phi")
        self.refused(("--phi", 0.3), "--array")
        self.refused(("--array", "random", "--phi", 0.7), "fraction of solid = 0.7", "0.62")
        self.refused(("--array", "random", "--phi", 0.6, "--counts", 16, "--diameter", 6), "jammed", "another seed")
        self.refused(("--array", "random", "--phi", 0.5, "--counts", 2), "edge of the box", "more spheres")
        self.refused(("--array", "random", "--phi", 0.3, "--counts", 8, 8), "--counts", "--sizes")
        self.refused(("--array", "sc", "--phi", 0.3, "--tensor", "--re", 5), "--tensor")
        self.refused(("--array", "sc", "--phi", 0.3, "--each", "/nowhere/file"), "--each /nowhere/file")
        self.refused(("--array", "sc", "--phi", 0.3, "--arrays", 2), "--arrays", "random")
        self.refused(("--spheres", "nowhere", "--box", 1, 1, 1), "--spheres nowhere: cannot be read")
        self.refused(("--spheres", "nowhere"), "--spheres nowhere: cannot be read")
        self.refused(("--array", "sc", "--phi", 0.3, "--direction", 0, 0, 0), "direction")
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "spheres"
            file.write_text("0 0 0 1\n0 0 word 1\n")
            self.refused(("--spheres", file, "--box", 2, 2, 2), "row 2 is not x y z diameter")
            file.write_text("0 0 0 1\n")
            self.refused(("--spheres", file, "--box", 2, 2, 2.05), "edge of the box")
            self.refused(("--spheres", file), "--box LX LY LZ")
            file.write_text("ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS pp pp pp\n0 1\n0 1\n0 1\n"
                            "ITEM: ATOMS id x y z\n1 0 0 0\n")
            self.refused(("--spheres", file), "no column", "radius or diameter")


if __name__ == "__main__":
    unittest.main()
