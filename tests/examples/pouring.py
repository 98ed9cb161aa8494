# SPDX-License-Identifier: BSD-3-Clause
"""pouring.py BUILD_FOLDER: a small version of examples/pouring, 96 spheres in a box 12 diameters wide: energy within
its bound, a bed at rest without overlaps; the area fraction where it is known; what the example expects and reads."""

import math
import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

import numpy as np

import analyse
import run
from cohesion_studies import expected
from cohesion_studies.job_pool import carry_out, require_ours
from cohesion_studies.lammps_run import MARK, tables

SOURCE = Path(__file__).resolve().parents[2]

BUILD = sys.argv.pop(1) if len(sys.argv) > 1 else str(SOURCE / "build")
SMALL = {"count": 96, "columns": 8, "height": 24, "time": 0.3}
HEXAGONAL = math.pi / (2 * math.sqrt(3))
# Points of a square raster in a circle with a radius of 25 of them: 1963 to some 20 (Gauss's circle problem).
RASTER = 0.01


class SmallBed(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.keeper = tempfile.TemporaryDirectory(prefix="cohesion-")
        cls.addClassCleanup(cls.keeper.cleanup)
        engine = run.launcher(BUILD)
        cls.jobs = [run.Pouring(Path(cls.keeper.name), engine, 1, dt, **SMALL)
                    for dt in (run.STEP, run.STEP / 4)]
        cls.results = carry_out(cls.jobs, 2)

    def test_energy_is_kept_but_for_the_bound(self):
        """What the step leaves is at most g dt/2 times the impulse of the walls; digits: 15, summed over some
        1e6 collisions. At the smaller step collisions that took 1 % more or less than they say would be seen."""
        for job, result in zip(self.jobs, self.results):
            found = analyse.energy(job.log(), job.dt)
            self.assertTrue((abs(found["error"]) <= found["bound"] + 1e-9).all())
            self.assertGreater(found["lost"][-1], 0.3)
            self.assertGreater(result["collisions"], 1000)
        self.assertLess(found["bound"][-1], 0.01 * found["lost"][-1])

    def test_at_rest_on_the_floor_without_overlap(self):
        """At rest the walls give M g dt in a step; speeds that a step of gravity makes, g dt, are the scale of what
        is left: less than ten of them each."""
        for job, result in zip(self.jobs, self.results):
            dt = job.dt
            start = tables(job.log())[0]["f_down"][0]
            mass = SMALL["count"] * 2700 * math.pi / 6 * analyse.DIAMETER**3
            self.assertLess(result["motion_end"] * start, mass / 2 * (10 * analyse.GRAVITY * dt)**2)
            # The same formula for distances in another order of operations, places with 10 digits.
            self.assertLess(result["overlap_diameters"], 1e-7)
            places = analyse.spheres(job.folder)
            self.assertEqual(len(places), SMALL["count"])
            self.assertGreater(places.min(), analyse.DIAMETER / 2 * (1 - 1e-7))
            self.assertLess(places[:, 0].max(), job.width - analyse.DIAMETER / 2 * (1 - 1e-7))

    def test_packed(self):
        """Denser than a square lattice, which gravity breaks, and no denser than can be; the whole bed has loose
        rows at floor and walls."""
        for result in self.results:
            self.assertGreater(result["area_fraction"], math.pi / 4)
            self.assertLess(result["area_fraction"], HEXAGONAL + RASTER)
            self.assertLess(result["whole_bed"], HEXAGONAL)

    def test_expected_are_figures_of_the_first_kind_of_run(self):
        kind = run.Pouring(Path(), run.launcher(BUILD), 1, run.STEPS[0]).kind
        for row in expected.rows(run.HERE / "expected.csv"):
            self.assertEqual(row["case"], kind)
            self.assertIn(row["quantity"], self.results[0])

    def test_finished_runs_are_taken_over(self):
        before = [(job.folder / "log").stat().st_mtime_ns for job in self.jobs]
        self.assertEqual(carry_out(self.jobs, 2), self.results)
        self.assertEqual([(job.folder / "log").stat().st_mtime_ns for job in self.jobs], before)

    def test_runs_of_other_settings_and_what_is_no_run_are_kept(self):
        first = self.jobs[0]
        require_ours(self.jobs, MARK)
        other = run.Pouring(Path(self.keeper.name), first.engine, 1, run.STEP, **{**SMALL, "time": 0.2})
        self.assertEqual(other.folder, first.folder)
        with self.assertRaisesRegex(run.RunError, "--overwrite"):
            require_ours([other], MARK)
        with tempfile.TemporaryDirectory(prefix="cohesion-") as out:
            folder = Path(out) / first.folder.name
            folder.mkdir()
            (folder / "letter.txt").write_text("mine")
            with mock.patch.object(sys, "argv", ["run.py", "--out", out, "--build", BUILD, "--overwrite"]), \
                    self.assertRaisesRegex(run.RunError, f"{folder.name}.*would be lost"):
                run.main()


class Reading(unittest.TestCase):
    def test_area_fraction_of_lattices(self):
        d = analyse.DIAMETER
        i, j = (a.ravel() for a in np.meshgrid(np.arange(40), np.arange(40)))
        square = np.stack([i, j], axis=1) * d
        hexagonal = np.stack([i + 0.5 * (j % 2), j * math.sqrt(3) / 2], axis=1) * d
        # Whole cells of the lattices: 20 diameters, 20 rows.
        for places, up, known in ((square, 20, math.pi / 4), (hexagonal, 10 * math.sqrt(3), HEXAGONAL)):
            found = analyse.area_fraction(places, (5.3 * d, 25.3 * d, 5.3 * d, (5.3 + up) * d))
            self.assertAlmostEqual(found, known, delta=RASTER)

    def test_surface_is_that_of_the_tops(self):
        d, columns = analyse.DIAMETER, analyse.COLUMNS
        x = (np.arange(2 * columns) + 0.5) * d
        flat = np.concatenate([np.stack([x, np.full_like(x, height)], axis=1) for height in (0.5 * d, 1.5 * d)])
        self.assertAlmostEqual(analyse.surface(flat, 2 * columns * d), 2 * d)
        self.assertAlmostEqual(analyse.whole_bed(flat, 2 * columns * d), math.pi / 4)


if __name__ == "__main__":
    unittest.main()
