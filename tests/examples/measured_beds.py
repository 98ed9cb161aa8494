# SPDX-License-Identifier: BSD-3-Clause
"""measured_beds.py BUILD_FOLDER: a small version of examples/measured-beds, 1100 spheres for 0.06 s; its reading of
profiles where they are known."""

import math
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np

import analyse
import picture
import run
from cohesion_studies import expected
from cohesion_studies.case_entries import EntryError
from cohesion_studies.foam_results import read_cells

SOURCE = Path(__file__).resolve().parents[2]

BUILD = sys.argv.pop(1) if len(sys.argv) > 1 else str(SOURCE / "build")
SMALL = {"width": 0.012, "thickness": 0.006, "height": 0.06, "across": 5, "deep": 2, "up": 24, "count": 1100,
         "averageFrom": 0.02, "writeEvery": 0.02, "endTime": 0.06}

# Of fix ave/chunk: two layers of two columns, one of them without spheres, over two times
PROFILES = """# Chunk-averaged data for fix profiles and group all
# Timestep Number-of-chunks Total-count
# Chunk Coord1 Coord2 Ncount vz
80 4 100
  1 0.001 0.015 10 9
  2 0.003 0.015 10 9
  3 0.001 0.02 40 9
  4 0.003 0.02 40 9
160 4 100
  1 0.001 0.015 10 0.1
  2 0.003 0.015 0 0
  3 0.001 0.02 40 0.3
  4 0.003 0.02 50 0.4
240 4 100
  1 0.001 0.015 30 0.2
  2 0.003 0.015 0 0
  3 0.001 0.02 20 -0.3
  4 0.003 0.02 50 0.2
"""


class SmallBed(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.keeper = tempfile.TemporaryDirectory(prefix="cohesion-")
        cls.addClassCleanup(cls.keeper.cleanup)
        job = run.MeasuredBed(Path(cls.keeper.name), run.environment(BUILD), "", "0.6", 4711, SMALL)
        cls.results = run.carry_out([job], 1)
        cls.bed = analyse.Bed(job.folder)

    def test_void_fraction_holds_all_spheres(self):
        """Round-off: 1100 spheres and 240 cells at 1e-15 each."""
        size = self.bed.size
        void = read_cells(self.bed.times[max(self.bed.times)] / "voidFractionMean", 240)
        solid = (1 - void).mean() * size["width"] * size["thickness"] * size["height"]
        spheres = size["count"] * math.pi / 6 * size["diameter"]**3
        self.assertAlmostEqual(solid / spheres, 1, delta=1e-11)

    def test_profile_between_layers(self):
        """In the middle of a layer of cells it is that of the cells; on the face between two it is their mean."""
        void = read_cells(self.bed.times[max(self.bed.times)] / "voidFractionMean", 240).reshape(24, 2, 5)
        _, middle = self.bed.void_fraction(2.5 * 2.5e-3, self.bed.span)
        np.testing.assert_allclose(middle, void[2].mean(axis=0), rtol=1e-12)
        _, face = self.bed.void_fraction(3 * 2.5e-3, self.bed.span)
        np.testing.assert_allclose(face, void[2:4].mean(axis=(0, 1)), rtol=1e-12)

    def test_blocks_of_time_make_the_whole(self):
        """Two blocks of equal length: their mean is the whole, which is written to 17 digits."""
        self.assertEqual(self.bed.blocks, [(0.02, 0.04), (0.04, 0.06)])
        halves = [self.bed.mean_void_fraction(block) for block in self.bed.blocks]
        self.assertGreater(abs(halves[0] - halves[1]).max(), 1e-6)
        np.testing.assert_allclose(np.mean(halves, axis=0), self.bed.mean_void_fraction(self.bed.span), rtol=1e-13)

    def test_all_spheres_are_in_the_profiles(self):
        """Each time of profiles.dat has all spheres, and the times from averageFrom on are read. Counts below 100 have
        four decimals: the rounding of some 100 of them adds up to 3e-4, of which the limit is seven times."""
        chunks = analyse.chunk_rows(self.bed.case / "profiles.dat", 1600, 4800)
        self.assertAlmostEqual(chunks[:, 3].sum(), 2 * 1100, delta=2e-3)

    def test_figures_and_picture(self):
        for name, value in self.results[0].items():
            self.assertTrue(not isinstance(value, float) or math.isfinite(value), name)
        for row in expected.rows(run.HERE / "expected.csv"):
            if row["case"] == "0.6":
                self.assertIn(row["quantity"], self.results[0])
        out = Path(self.keeper.name) / "result.png"
        picture.draw(out, run.MEASURED, {"0.6": [self.bed.case]})
        self.assertGreater(out.stat().st_size, 10000)

    def test_a_run_without_averages_is_named(self):
        with tempfile.TemporaryDirectory(prefix="cohesion-") as name:
            (Path(name) / "constant").mkdir()
            (Path(name) / "constant/bed").write_text("averageFrom 1;\n")
            (Path(name) / "0.06").mkdir()
            with self.assertRaisesRegex(EntryError, "no time after averageFrom"):
                analyse.Bed(name)


class Reading(unittest.TestCase):
    def test_velocity_is_the_mean_over_spheres_and_time(self):
        """By hand: (10 0.1 + 30 0.2)/40; a column without spheres is left out; (40 0.3 - 20 0.3)/60, (0.4 + 0.2)/2."""
        with tempfile.TemporaryDirectory(prefix="cohesion-") as name:
            file = Path(name) / "profiles.dat"
            file.write_text(PROFILES)
            rows = analyse.chunk_rows(file, 80, 240)
        for height, x, velocities in ((0.015, [0.001], [0.175]), (0.02, [0.001, 0.003], [0.1, 0.3])):
            found = analyse.mean_velocity(rows, height)
            np.testing.assert_allclose(found[0], x)
            np.testing.assert_allclose(found[1], velocities)

    def test_measured_profiles(self):
        """All that expected.csv speaks of are in the table, each across most of the bed."""
        profiles = analyse.measured(run.MEASURED)
        self.assertEqual({f"{gas} {quantity}_{height}" for gas, quantity, height in profiles},
                         {f"{row['case']} {row['quantity'].rpartition('_')[0]}"
                          for row in expected.rows(run.HERE / "expected.csv")})
        for x, values in profiles.values():
            self.assertGreater(np.ptp(x), 0.038)
            self.assertTrue(((0 < x) & (x < 0.044)).all())
            self.assertTrue((np.diff(x) > 0).all())
            self.assertGreater(len(values), 20)


if __name__ == "__main__":
    unittest.main()
