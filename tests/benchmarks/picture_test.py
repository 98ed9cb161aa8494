# SPDX-License-Identifier: BSD-3-Clause
"""Pictures show the numbers of tables; tables of docs/ can be drawn: picture_test.py SOURCE."""
import re
import sys
import tempfile
import unittest
from pathlib import Path

import picture
import printed_table

DOCS = Path(sys.argv[1]) / "docs"
DENSE = """From elsewhere

| engine | scene | style | instructions | over stock | ns | over stock, same turn: median (least to most) |
|---|---|---|---|---|---|---|
| A | gas, 4 | x (stock) | 100 | 1.00 | 10 | 1.00 (1.00 to 1.00) |
| A | gas, 4 | y (stock, cohesive) | 200 | 2.00 | 18 | 1.80 (1.50 to 1.90) |
| B | gas, 4 | x *exact* (cohesive) | 300 | 1.00 |  |  |

| another | table |
|---|---|
| A | B |
""".splitlines()
GROWTH = """| style | particles | ns per particle and step | over 10: median (least to most) |
|---|---|---|---|
| *a* | 10 | 5.0 | 1.00 (1.00 to 1.00) |
| *a* | 100 | 6.0 | 1.20 (1.10 to 1.30) |
| b | 10 | 7.0 | 1.00 (1.00 to 1.00) |
| b | 100 | 9.8 | 1.40 (1.40 to 1.40) |
""".splitlines()
STEPS = """law,t_c/dt,2 to 3,3 to 4
law,correct/judged,3/6,0/0
law,unwarned,2,0
law,stopped/all,1/4,4/4
"""


class Pictures(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.file = Path(folder.name) / "steps.csv"
        self.file.write_text(STEPS)

    def tearDown(self):
        picture.pyplot.close("all")

    def test_dense_has_a_panel_of_each_engine_with_bars_and_times(self):
        panels = picture.draw_dense(printed_table.read(DENSE)).axes
        self.assertEqual([[bar.get_width() for bar in panel.patches] for panel in panels], [[1.0, 2.0], [1.0]])
        limits = [next(line for line in panel.lines if line.get_linestyle() == ":").get_xdata()[0] for panel in panels]
        self.assertEqual(limits, [1.15 * 2.0, 1.15])
        times = panels[0].containers[-1]
        self.assertEqual(list(times.lines[0].get_xdata()), [1.8])
        ends = [line.get_xdata()[0] for line in times.lines[1]]
        self.assertAlmostEqual(ends[0], 1.5)
        self.assertAlmostEqual(ends[1], 1.9)

    def test_of_one_turn_there_is_no_range(self):
        one = [re.sub(r" \([\d.]+ to [\d.]+\)|: median \(least to most\)", "", line) for line in DENSE + GROWTH]
        dense, growth = one[:len(DENSE)], one[len(DENSE):]
        panel = picture.draw_dense(printed_table.read(dense)).axes[0]
        ends = panel.containers[-1].lines[1]
        self.assertEqual([line.get_xdata()[0] for line in ends], [1.8, 1.8])
        right = picture.draw_growth(printed_table.read(growth)).axes[1]
        self.assertEqual([list(part.lines[0].get_ydata()) for part in right.containers], [[1.0, 1.2], [1.0, 1.4]])
        self.assertEqual(right.get_ylabel(), "over 10 spheres, one turn")

    def test_growth_has_a_line_of_each_style(self):
        left, right = picture.draw_growth(printed_table.read(GROWTH)).axes
        self.assertEqual([list(line.get_ydata()) for line in left.lines], [[5.0, 6.0], [7.0, 9.8]])
        self.assertEqual([line.get_label() for line in left.lines], ["a", "b"])
        middles = [list(part.lines[0].get_ydata()) for part in right.containers]
        self.assertEqual(middles, [[1.0, 1.2], [1.0, 1.4]])

    def test_steps_have_the_share_of_correct_cases(self):
        tables = picture.data_of("steps", self.file)
        self.assertEqual(list(tables), ["law"])
        shares = picture.draw_steps(tables).axes[0].images[0].get_array()
        self.assertEqual(shares[0, 0], 3 / 6)
        self.assertEqual([label.get_text() for label in picture.draw_steps(tables).axes[0].texts],
                         ["3 of 6\n2 unwarned\n1 of 4 stop", "0 of 0\n4 of 4 stop"])

    def test_tables_of_the_documentation_can_be_drawn(self):
        for name, table in (("dense", "step_costs"), ("growth", "growth"), ("steps", "stability")):
            with self.subTest(name):
                self.assertTrue(picture.DRAWN[name](picture.data_of(name, DOCS / f"verification/{table}.csv")).axes)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
