# SPDX-License-Identifier: BSD-3-Clause
"""The first printed table becomes rows and a CSV file."""
import tempfile
import unittest
from pathlib import Path

import printed_table

LINES = ["Words.", "", "| a | b |", "|---|---|", "| *x* | 1 |", "| y |  |", "", "| c |", "|---|", "| 3 |"]


class Table(unittest.TestCase):
    def test_is_written_and_read(self):
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "table.csv"
            printed_table.write_csv(file, printed_table.read(LINES))
            self.assertEqual(file.read_text(), "a,b\nx,1\ny,\n")
            self.assertEqual(printed_table.read_csv(file), [{"a": "x", "b": "1"}, {"a": "y", "b": ""}])


if __name__ == "__main__":
    unittest.main()
