# SPDX-License-Identifier: BSD-3-Clause
"""mapping_example.py BUILD_FOLDER: the table of examples/cohesion-mapping against expected.csv there; its
picture and curves, from fewer steps and constants."""

import csv
import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

import run
from cohesion_studies import expected

SOURCE = Path(__file__).resolve().parents[2]
EXAMPLE = SOURCE / "examples/cohesion-mapping"

BUILD = sys.argv.pop(1) if len(sys.argv) > 1 else str(SOURCE / "build")


class MappingExample(unittest.TestCase):
    def test_expected_figures(self):
        exact_rows, same, _ = run.thesis_table(run.Program(BUILD))
        found = {}
        for exact, sampled in zip(exact_rows, same):
            found[f"{exact['depth']:g}"] = {"hamaker_constant": exact["hamaker_constant"],
                                            "hamaker_mean": sampled["hamaker_mean"] / exact["hamaker_mean"]}
        checked = expected.held(EXAMPLE / "expected.csv", found)
        self.assertEqual(len(checked), 7)
        for line, holds in checked:
            self.assertTrue(holds, line)

    def test_whole_run(self):
        with tempfile.TemporaryDirectory(prefix="cohesion-") as folder, \
                mock.patch.object(sys, "argv", ["run.py", "--build", BUILD, "--out", folder]), \
                mock.patch.object(run, "STEPS", run.STEPS[::10]), \
                mock.patch.object(run, "CONSTANTS", run.CONSTANTS[::8]):
            run.main()
            out = Path(folder)
            self.assertEqual(len((out / "result.txt").read_text().splitlines()), 5)
            self.assertGreater((out / "result.png").stat().st_size, 10000)
            with open(out / "depth.csv") as file:
                rows = list(csv.DictReader(file))
        self.assertEqual(len(rows), 12 * len(run.CONSTANTS[::8]))
        step = run.CONSTANTS[8] / run.CONSTANTS[0]
        for family in run.FAMILIES:
            for value in {row["value"] for row in rows if row["family"] == family}:
                depths = [float(row["depth"]) for row in rows
                          if (row["family"], row["value"]) == (family, value)]
                # Between D ~ A (attraction in the gap) and D ~ A^2 (that in the contact)
                for a, b in zip(depths, depths[1:]):
                    self.assertTrue(step <= b / a <= step**2, (family, value))

    def test_says_what_is_missing(self):
        with self.assertRaisesRegex(run.MappingError, "build the package"):
            run.Program("/nowhere")


if __name__ == "__main__":
    unittest.main()
