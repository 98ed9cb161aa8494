# SPDX-License-Identifier: BSD-3-Clause
"""array_drag.py BUILD_FOLDER: examples/array-drag with a small table: its figures, its picture, and that rows which are
done are not done again."""

import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

import run
from cohesion_studies import expected, study_table

SOURCE = Path(__file__).resolve().parents[2]
EXAMPLE = SOURCE / "examples/array-drag"

BUILD = sys.argv.pop(1) if len(sys.argv) > 1 else str(SOURCE / "build")

TABLE = """name, array, phi, counts, sizes, diameter, re, speed, arrays
sc-0.45, sc, 0.45, , , 12, , , 1
few-0.4, , 0.4, 16, , 8, , , 4
few-0.4-re-10, , 0.4, 12, , 8, 10, , 2
mixture-2-0.4, , 0.4, 32 4, 1 2, 8, , , 2
"""


class ArrayDragExample(unittest.TestCase):
    def start(self, out):
        table = out / "table.csv"
        table.write_text(TABLE)
        with mock.patch.object(sys, "argv", ["run.py", "--build", BUILD, "--out", str(out / "runs"), "--table",
                                             str(table)]), \
                mock.patch.object(run, "PAIR_BOX", 8.0), mock.patch.object(run, "PAIR_DIAMETER", 8):
            run.main()

    def test_whole_run(self):
        with tempfile.TemporaryDirectory(prefix="cohesion-") as folder:
            out = Path(folder)
            self.start(out)
            text = (out / "runs/result.txt").read_text()
            rows = {line.split()[0]: line.split() for line in text.split("\n\n")[0].splitlines()}
            found = {name: dict(zip(words[1::2], map(float, words[2::2]))) for name, words in rows.items()}
            self.assertEqual(set(found), {"sc-0.45", "few-0.4", "few-0.4-re-10", "mixture-2-0.4", *run.PAIRS})
            held = expected.held(EXAMPLE / "expected.csv", found)
            self.assertEqual(len(held), 3)
            for line, holds in held:
                self.assertTrue(holds, line)
            # Three standard errors of four arrays of 16 spheres, some 8 % each, and 3 % of the law
            self.assertAlmostEqual(found["few-0.4"]["over_beetstra"], 1, delta=0.15)
            self.assertAlmostEqual(found["few-0.4-re-10"]["Re"], 10, delta=0.1)
            self.assertIn("over_tang", found["few-0.4-re-10"])
            self.assertIn("over_vanDerHoef_2", found["mixture-2-0.4"])
            self.assertGreater((out / "runs/result.png").stat().st_size, 20000)
            with mock.patch.object(run.DragRun, "start", side_effect=AssertionError("done again")):
                self.start(out)
            self.assertEqual((out / "runs/result.txt").read_text(), text)

    def test_every_row_that_is_expected_is_in_the_table(self):
        table = study_table.read_table(EXAMPLE / "arrays.csv", run.KNOWN)
        for row in expected.rows(EXAMPLE / "expected.csv"):
            self.assertIn(row["case"], {**table, **run.PAIRS})

    def test_says_what_is_missing(self):
        with self.assertRaisesRegex(run.ToolError, "build the package"):
            run.ArrayDrag("/nowhere")


if __name__ == "__main__":
    unittest.main()
