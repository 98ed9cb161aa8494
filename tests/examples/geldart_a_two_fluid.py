# SPDX-License-Identifier: BSD-3-Clause
"""geldart_a_two_fluid.py BUILD_FOLDER: a small version of examples/geldart-a-two-fluid, coarse cells for some tenths of
a second; the reading of expansion and pressure where it is known."""

import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

import numpy as np

import analyse
import picture
import run
from cohesion_studies import expected

SOURCE = Path(__file__).resolve().parents[2]
BUILD = sys.argv.pop(1) if len(sys.argv) > 1 else str(SOURCE / "build")
CELL, STEP, END = 0.015, 5e-4, 0.4


class SmallBeds(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.keeper = tempfile.TemporaryDirectory(prefix="cohesion-")
        cls.addClassCleanup(cls.keeper.cleanup)
        env = run.environment(BUILD)
        cls.jobs = [run.Bed(Path(cls.keeper.name), env, BUILD, kind, STEP, END, CELL)
                    for kind in ("slow-n9.6", "fast-n4.65")]
        cls.results = run.carry_out(cls.jobs, 1)

    def test_no_grain_is_lost(self):
        """Written with 8 digits; the solver's bounded fractions lose some 1e-5 of what flows through a face."""
        for job in self.jobs:
            solid = analyse.fractions(job.folder)[1].sum(axis=(1, 2))
            self.assertLess(np.abs(solid / solid[0] - 1).max(), 1e-3, job.name)

    def test_it_starts_at_rest(self):
        for job in self.jobs:
            times, expanded = analyse.expansion(job.folder)
            self.assertEqual((times[0], expanded[0]), (0, 0))
            self.assertEqual(len(times), 1 + round(END / 0.05))

    def test_fast_gas_lifts_the_bed_and_slow_gas_less(self):
        """At 0.2 m/s, nearly the speed at which single grains fall, the bed is pushed up; at 0.009 m/s with the drag of
        the exponent 9.6 no more than (0.707 of void, of the balance of one grain among its like) in all time."""
        slow, fast = (analyse.expansion(job.folder)[1][-1] for job in self.jobs)
        self.assertGreater(fast, slow)
        self.assertLess(slow, 1.05)

    def test_figures_of_known_fields(self):
        times = np.arange(100) / 10 + 0.05
        mean, error = analyse.mean_and_error(times, np.where(times > 3, 2.0, 9.0), 10.0)
        self.assertEqual((mean, error), (2.0, 0.0))
        # From 3 s on five blocks of 1.4 s, each with its number
        steps = np.floor((times - 3) / 1.4)
        mean, error = analyse.mean_and_error(times, steps, 10.0)
        self.assertAlmostEqual(mean, 2.0, delta=1e-12)
        self.assertAlmostEqual(error, np.sqrt(2.5 / 5), delta=1e-12)

    def test_picture_and_expectations(self):
        file = Path(self.keeper.name) / "result.png"
        picture.draw(file, [job.folder for job in self.jobs])
        self.assertGreater(file.stat().st_size, 10000)
        self.assertTrue(all(row["case"] in run.BEDS for row in expected.rows(run.EXPECTED)))

    def test_finished_runs_are_not_made_again(self):
        with mock.patch.object(run.Bed, "start", side_effect=AssertionError):
            self.assertEqual(run.carry_out(self.jobs, 1), self.results)


if __name__ == "__main__":
    unittest.main()
