# SPDX-License-Identifier: BSD-3-Clause
"""Each drag closure of src/drag: its values beside the formula of closure_formulas.py in 60 digits, and its rows of
docs/openfoam-coupling/drag_closures.md."""
import decimal
import os
import subprocess
import unittest
from decimal import Decimal

from cohesion_tests.theory import closure_page
from cohesion_tests.theory.closure_formulas import CLOSURES, PRECISE

decimal.getcontext().prec = 60
LINES = [line.split() for line in subprocess.run([os.environ["CLOSURE_VALUES"]], text=True, capture_output=True,
                                                 check=True).stdout.splitlines()]
TABLE = {name: cells for kind, name, *cells in LINES if kind == "closure"}
# Some forty roundings of 1.1e-16, those of a fitted denominator or numerator (Hill, Koch and Ladd's 0.66 is a sum of
# terms of 2.2) magnified by 3.3. Syamlal and O'Brien's V_t is half of A - 0.06 Re plus a root of nearly that size, at
# the largest Re some 0.06 Re/V_t = 400 times V_t at a void fraction of 0.38 (V_t >= 0.2), and enters squared.
TOLERANCE = {"syamlalOBrien": 2 * 3 * 400 * 1.1e-16}
# The formulas divide by the slip. At this one [m/s] the terms that vanish with it, the slowest of which goes with its
# square root, are below 1e-27.
NO_SLIP = Decimal("1e-60")


class Closures(unittest.TestCase):
    maxDiff = None

    def test_each_row_has_a_formula_and_rows_of_the_page(self):
        for where in (CLOSURES, closure_page.rows("Closures")):
            self.assertEqual(list(where), list(TABLE))

    def test_each_has_the_values_of_its_formula(self):
        points = [cells for kind, *cells in LINES if kind == "value"]
        self.assertEqual(len(points), 20 * len(CLOSURES))
        for name, *numbers in points:
            eps, slip, *gas, found = (Decimal(float(number)) for number in numbers)
            expected = CLOSURES[name](PRECISE, eps, slip or NO_SLIP, *gas)
            self.assertLess(abs(found / expected - 1), TOLERANCE.get(name, 1e-14), (name, *numbers))

    def test_the_page_states_range_and_exponent(self):
        for name, (lowest, highest, reynolds, exponent) in TABLE.items():
            stated = closure_page.Range(name)
            self.assertEqual((stated.lowest, stated.highest, stated.reynolds),
                             (float(lowest), float(highest), float(reynolds)), name)
            self.assertEqual(closure_page.rows("Closures")[name][5] != "none", exponent == "1", name)

    def test_the_page_states_the_drag_of_a_packed_bed(self):
        for name, cells in closure_page.rows("Closures").items():
            self.assertEqual(cells[6], closure_page.packed(name), name)


if __name__ == "__main__":
    unittest.main()
