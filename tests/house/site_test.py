# SPDX-License-Identifier: BSD-3-Clause
"""The site's index of warnings (docs/site/message_index.py) has the rows of all tables of messages, and no others; each
chart of a page (docs/site/charts.py) has points."""
import sqlite3
import tempfile
import unittest
from pathlib import Path
from types import SimpleNamespace

import charts
import message_index

SOURCE = Path(__file__).resolve().parents[2]
PAGE = """# Page
| keyword | meaning | unit |
|---|---|---|
| `a` | b | c |

## Warnings

| Message | Meaning | Remedy |
|---|---|---|
| a step \\| of N | too long | [shorter](other.md#steps) |

text

| message | remedy |
|---|---|
| d | e |

```
| message | meaning | remedy |
| in | a | block |
```
"""


class MessageIndex(unittest.TestCase):
    def test_rows_of_tables_with_the_header_alone(self):
        self.assertEqual(list(message_index.rows_of(PAGE)),
                         [("a step \\| of N", "too long", "[shorter](other.md#steps)")])

    def test_order_is_by_words_without_article_and_marks(self):
        rows = [("the step",), ("*a wall*",), ("... cells",), ("Particles",)]
        self.assertEqual(sorted(rows, key=message_index.key),
                         [("... cells",), ("Particles",), ("the step",), ("*a wall*",)])

    def test_every_row_of_the_repository_is_there_once(self):
        pages = [page.relative_to(SOURCE) for page in sorted((SOURCE / "docs").rglob("*.md"))]
        found = {row for page in pages for row in message_index.rows_of((SOURCE / page).read_text())}
        self.assertGreater(len(found), 50)
        site = SimpleNamespace(source=SOURCE, pages=pages, text_of=lambda page, text, place: text)
        text = message_index.warnings(site)
        lines = [line for line in text.splitlines() if line]
        self.assertEqual(len(lines), len(set(lines)))
        self.assertEqual([row for row in found if f"| {row[0]} | " not in text], [])
        self.assertNotIn("](#", text)


class Charts(unittest.TestCase):
    def test_each_chart_of_a_page_is_drawn(self):
        base, found = charts.database(SOURCE), 0
        for page in sorted((SOURCE / "docs").rglob("*.md")):
            text = page.read_text()
            drawn = charts.charts(base, text)
            found += len(drawn)
            self.assertEqual(len(drawn), text.count("\n<!-- chart"), page)
            for match, _, series in drawn:
                self.assertGreaterEqual(sum(map(len, series.values())), 4, (page, match["caption"]))
                self.assertLessEqual(len(series), 8, (page, match["caption"]))
        self.assertGreater(found, 15)

    def test_numbers_with_errors(self):
        self.assertEqual(charts.number("1.5 +- 0.5"), (1.0, 1.5, 2.0))
        self.assertEqual(charts.number("2 (1 to 4)"), (1.0, 2.0, 4.0))
        self.assertEqual(charts.number("-1e-3"), (-1e-3,) * 3)
        self.assertEqual(charts.number("20,400"), (20400.0,) * 3)
        self.assertIsNone(charts.number("7.0, 8"))

    def test_what_is_no_number(self):
        base = sqlite3.connect(":memory:")
        _, series = charts.points(base, "select 1 as x, 'stops' as y union select 2, null union select 3, '4'")
        self.assertEqual(series, {"": [(3, (4.0,) * 3)]})
        with self.assertRaisesRegex(ValueError, "'7.0, 8' is no number"):
            charts.points(base, "select 1 as x, '7.0, 8' as y")
        with self.assertRaisesRegex(ValueError, "a zero on a logarithmic axis"):
            charts.logarithmic([0.0, 1e-3, 1.0])
        self.assertEqual([charts.logarithmic([0.0, 1.0]), charts.logarithmic([-1.0, 1e-3, 1.0])], [False, False])

    def test_lines_bars_and_points(self):
        line = charts.draw(["step", "scheme", "error"], {"a": [("10", (1.0,) * 3), ("20", (1e-3,) * 3)]}).axes[0]
        self.assertEqual((line.get_xscale(), line.get_yscale(), line.get_ylabel()), ("linear", "log", "error"))
        bars = charts.draw(["law", "cost"], {"": [("hertz", (1.0,) * 3), ("jkr", (2.0,) * 3)]}).axes[0]
        self.assertEqual([bar.get_width() for bar in bars.patches], [1.0, 2.0])
        points = charts.draw(["law", "cost"], {"": [("hertz", (1.0, 1.5, 2.0)), ("jkr", (2.0,) * 3)]}).axes[0]
        self.assertEqual((len(points.patches), len(points.containers)), (0, 1))
        charts.pyplot.close("all")

    def test_comment_becomes_a_picture(self):
        base = sqlite3.connect(":memory:")
        text = "a\n\n<!-- chart Of two\nselect 1 as x, 2 as y union select 2, 3\n-->\n\nb\n"
        with tempfile.TemporaryDirectory() as folder:
            self.assertEqual(charts.drawn(base, Path("docs/page.md"), text, folder),
                             "a\n\n![Of two](charts/page-1.png)\n\nb\n")
            self.assertTrue((Path(folder) / "charts/page-1.png").exists())


if __name__ == "__main__":
    unittest.main()
