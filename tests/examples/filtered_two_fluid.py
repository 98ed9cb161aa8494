# SPDX-License-Identifier: BSD-3-Clause
"""filtered_two_fluid.py BUILD_FOLDER: a small version of examples/filtered-two-fluid, 16 x 16 cells for some tenths of a
second, end to end; the drag of squares of made-up fields where it is known by hand."""

import contextlib
import io
import json
import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

import numpy as np

import analyse
import run
from cohesion_studies import expected

SOURCE = Path(__file__).resolve().parents[2]
BUILD = sys.argv.pop(1) if len(sys.argv) > 1 else str(SOURCE / "build")
CELLS, END, START = 16, 0.3, 0.2


def start(out, *words):
    """What run.py prints."""
    said = io.StringIO()
    with mock.patch.object(sys, "argv", ["run.py", "--build", BUILD, "--out", str(out), *map(str, words)]), \
            contextlib.redirect_stdout(said):
        run.main()
    return said.getvalue()


def field(kind, values):
    rows = values if kind == "scalar" else [f"({row[0]!r} {row[1]!r} {row[2]!r})" for row in values.tolist()]
    return f"internalField   nonuniform List<{kind}> \n{len(values)}\n(\n" + "\n".join(map(str, rows)) + "\n)\n;\n"


class MadeUp(unittest.TestCase):
    """4 x 4 cells of 1 m. By Wen and Yu beta ~ phi eps^-2.65 f(Re), f = 1 + 0.15 Re^0.687, Re = 5 s/m eps slip."""

    def of(self, *times):
        """Drag over the law's of squares of 1 and 2 cells; each time: solid fraction, vertical velocities of particles
        and gas, of columns that alternate between two values."""
        with tempfile.TemporaryDirectory(prefix="cohesion-") as folder:
            (Path(folder) / "system").mkdir()
            (Path(folder) / "system/blockMeshDict").write_text("height 4;\nrows 4;\n")
            for k, columns in enumerate(times):
                solid, particles, gas = (np.tile(pair, (4, 2)).ravel() for pair in columns)
                place = Path(folder) / f"{k + 1}"
                place.mkdir()
                (place / "alpha.particles").write_text(field("scalar", solid))
                for name, values in (("U.particles", particles), ("U.air", gas)):
                    (place / name).write_text(field("vector", np.stack([0 * values, values, 0 * values], axis=1)))
            return analyse.by_size(folder, 0.5)

    def test_slips_that_differ(self):
        """f(0.4) = 1.07993, f(1.2) = 1.17002, f(0.8) = 1.12868: (0.1 f(0.4) + 0.3 f(1.2))/(2 * 0.2 f(0.8))"""
        (one, ratio_of_one, _), (two, ratio_of_two, _) = self.of(((0.2, 0.2), (0, 0), (0.1, 0.3)))
        self.assertEqual((one, two), (1, 2))
        self.assertAlmostEqual(ratio_of_one, 1, delta=1e-12)
        self.assertAlmostEqual(ratio_of_two, 1.01667, delta=2e-5)

    def test_fractions_that_differ(self):
        """Half of the cells empty, one slip: (0.6/0.8)^-2.65 f(0.3)/f(0.4) = 2.14334 * 1.06560/1.07993"""
        self.assertAlmostEqual(self.of(((0.4, 0), (0, 0), (0.1, 0.1)))[1][1], 2.1149, delta=2e-4)

    def test_times_that_are_alike_have_no_error(self):
        (_, _, alone), (_, ratio, error) = self.of(*[((0.4, 0), (0, 0), (0.1, 0.1))] * 3)
        self.assertAlmostEqual(ratio, 2.1149, delta=2e-4)
        self.assertLess(max(alone, error), 1e-12)

    def test_mean_slip_is_that_of_the_momentum(self):
        solid = np.tile([0.1, 0.4], (2, 1))
        still = np.zeros((2, 2, 3))

        def upwards(left, right):
            found = still.copy()
            found[..., 1] = [left, right]
            return found

        # Particles at 0.4 * (-1)/(0.1 + 0.4); gas at 0.9 * 1/(0.9 + 0.6)
        self.assertAlmostEqual(analyse.squares(solid, upwards(0, -1), still, 2)[2][0], 0.8, delta=1e-14)
        self.assertAlmostEqual(analyse.squares(solid, still, upwards(1, 0), 2)[2][0], 0.6, delta=1e-14)


class SmallBoxes(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        keeper = tempfile.TemporaryDirectory(prefix="cohesion-")
        cls.addClassCleanup(keeper.cleanup)
        cls.out = Path(keeper.name)
        cls.words = ("--fractions", 0.05, 0.15, "--cells", CELLS, "--time", END, "--from", START, "--together", 1)
        cls.said = start(cls.out, *cls.words)

    def test_table_and_picture(self):
        self.assertIn((self.out / "result.txt").read_text(), self.said)
        self.assertIn("as expected: box-0.05, one_cell: 1,", self.said)
        self.assertIn("as expected: box-0.15, filtered_0.02", self.said.lower())
        self.assertGreater((self.out / "result.png").stat().st_size, 10000)
        self.assertEqual({row["case"] for row in expected.rows(run.EXPECTED)}, {"box-0.05", "box-0.15", "box-0.40"})

    def test_one_cell_has_the_law_itself(self):
        for kind in ("box-0.05", "box-0.15"):
            found = json.loads((self.out / kind / "result.json").read_text())
            sizes = [name for name in found if name.startswith("filtered_")]
            self.assertEqual(sizes, ["filtered_0.01", "filtered_0.02", "filtered_0.04", "filtered_0.08"])
            self.assertAlmostEqual(found["one_cell"], 1, delta=1e-12)

    def test_no_particle_is_lost(self):
        """Written with 8 digits; the solver's fractions lose some 1e-5 of what flows through a face."""
        means = [solid.mean() for solid, _, _ in analyse.snapshots(self.out / "box-0.05", 0)]
        self.assertEqual(len(means), 1 + round(END / run.WRITTEN))
        self.assertLess(np.abs(np.array(means) / means[0] - 1).max(), 1e-3)

    def test_columns_of_cells_do_not_alternate(self):
        """Cells of 2.5 mm at 0.40, columns that alternate by a tenth and noise: after 0.5 s fractions side by side are
        alike, if at all. With the momentum of cells, `faceMomentum no`, what alternates grows instead."""
        class Small(run.Box):
            def change(self):
                super().change()
                self.case.edit("system/blockMeshDict", width=0.04, height=0.04)

            def solid(self):
                return self.phi * (1 + 0.1 * np.random.default_rng(1).uniform(-1, 1, (CELLS, CELLS))
                                   + 0.1 * (-1.0)**np.arange(CELLS))

        job = Small(self.out / "small", run.environment(BUILD), BUILD, 0.4, CELLS, 1e-3, 0.5, 0.4)
        run.carry_out([job], 1)
        first, *_, last = [solid - solid.mean() for solid, _, _ in analyse.snapshots(job.folder, 0)]

        def side_by_side(off):
            return (off * np.roll(off, 1, axis=1)).mean() / off.var()

        self.assertLess(side_by_side(first), -0.5)
        self.assertGreater(side_by_side(last), 0)
        self.assertLess(last.std(), first.std())

    def test_finished_runs_are_not_made_again(self):
        with mock.patch.object(run.Box, "start", side_effect=AssertionError):
            self.assertIn("box-0.15", start(self.out, *self.words))

    def test_words_that_cannot_be(self):
        for words, said in ((("--cells", 12), "power of 2"), (("--time", 0.1), "take an earlier one"),
                            (("--fractions", 0.6), "below 0.48")):
            with self.subTest(words), contextlib.redirect_stderr(io.StringIO()) as errors:
                self.assertRaises(SystemExit, start, self.out, *words)
                self.assertIn(said, errors.getvalue())


if __name__ == "__main__":
    unittest.main()
