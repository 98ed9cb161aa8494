# SPDX-License-Identifier: BSD-3-Clause
"""binary_mixture.py BUILD_FOLDER: a small version of examples/binary-mixture, 400 spheres of two sizes for 0.1 s on one
process and on two, and a packed bed of one size; the reading of halves, segregation, Lacey's index and the closure where
they are known."""

import contextlib
import io
import math
import re
import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

import numpy as np

import analyse
import picture
import run
from cohesion_studies import ergun, expected
from cohesion_studies.foam_results import written_times
from cohesion_tests.coupling.cases import exchange_lines

BUILD = sys.argv.pop(1) if len(sys.argv) > 1 else str(Path(__file__).resolve().parents[2] / "build")
SMALL = {"width": 0.02, "across": 4, "height": 0.09, "up": 18, "small": 330, "large": 70, "settle": 0.2,
         "endTime": 0.1}
STEPS = 200  # gas steps


class SmallBed(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.keeper = tempfile.TemporaryDirectory(prefix="cohesion-")
        cls.addClassCleanup(cls.keeper.cleanup)
        env, out = run.environment(BUILD), Path(cls.keeper.name)
        cls.job = run.MixedBed(out, env, "", "above", 1, SMALL)
        cls.packed = run.MixedBed(out, env, "", "large", 1, {**SMALL, "small": 0, "large": 150})
        cls.result, cls.of_packed = run.carry_out([cls.job, cls.packed], 2)
        cls.parallel = run.MixedBed(out / "two", env, "", "above", 1, SMALL)
        cls.parallel.prepare()
        cls.parallel.case.solve(ranks=2)
        cls.parallel.case.run("reconstructPar", "-withZero")
        cls.beds = [analyse.Bed(job.folder) for job in (cls.job, cls.parallel)]

    def test_gas_and_spheres_balance(self):
        """Round-off of sums over 400 spheres: 1e-13 of the forces on them."""
        for bed in self.beds:
            lines = exchange_lines((bed.case / "log.cohesiveBedFoam").read_text())
            self.assertEqual(len(lines), STEPS)
            self.assertLess(max(line["imbalance"] for line in lines), 1e-13)
            self.assertLess(max(line["volume"] for line in lines), 1e-13)

    def test_each_size_keeps_its_number(self):
        for bed in self.beds:
            times, spheres = analyse.history(bed)
            self.assertGreater(len(times), 1)
            for now in spheres:
                self.assertEqual((np.count_nonzero(~now.large), np.count_nonzero(now.large)), (330, 70))
                self.assertTrue((now.places > 0).all() and (now.places < (bed.width, bed.height, bed.thickness)).all())

    def test_halves_hold_half_of_the_solid(self):
        """The shares of both sizes in the lower half, by their volumes, are half of it, to round-off of 400 terms; and
        each is what the upper half lacks."""
        for bed in self.beds:
            _, (_, small, large, _) = analyse.mixing_history(bed)
            held = small * bed.solid[0] + large * bed.solid[1]
            np.testing.assert_allclose(held, bed.solid.sum() / 2, rtol=1e-13)
            now = analyse.Spheres.read(max(written_times(bed.case).items())[1])
            volumes = bed.solid / bed.numbers
            lower = analyse.shares_below(now.places[:, 1], now.large, volumes)
            upper = analyse.shares_below(-now.places[:, 1], now.large, volumes)
            np.testing.assert_allclose(np.add(lower, upper), 1, rtol=1e-13)

    def test_void_fraction_is_that_of_both_sizes(self):
        """All solid is in the cells, of which 8 digits are written."""
        for bed in self.beds:
            void = analyse.void_fraction(bed, max(written_times(bed.case).items())[1])
            cell = bed.area * bed.height / void.size
            self.assertAlmostEqual((1 - void).sum() * cell / bed.solid.sum(), 1, delta=1e-6)

    def test_gas_and_walls_carry_the_spheres(self):
        """What the gas puts on the spheres, and walls and plate, is their weight and what their momentum gains: others
        are what is left of these, so this is the table's own sum, of which 9 digits are written."""
        for bed in self.beds:
            _, (gas, walls, gain) = analyse.force_history(bed)
            np.testing.assert_allclose(gas + walls - gain, 1, atol=1e-6)

    def test_packed_bed_is_between_the_limits_of_its_closure(self):
        """But for what the void fraction at a sphere, the mean of its cells, has not of the cells' scatter: 2 %, that of
        docs/verification/void_fraction.md for a random packing in such cells twice over, as half of these are at
        walls."""
        self.assertLess(self.of_packed["drop_over_straight_flow"], 1)
        self.assertGreater(self.of_packed["drop_over_free_flow"], 0.98)

    def test_pressure_drop_is_what_the_gas_puts_on_the_spheres(self):
        """Less the momentum that it brings. Of a packed bed, at rest, in each row: friction of the gas on the walls,
        mu U/(half a cell) times their area, is 2e-4 of the weight; buoyancy, which is in one of the two, 5e-4."""
        bed = analyse.Bed(self.packed.folder)
        _, drop = analyse.drop_history(bed)
        _, (gas, _, _) = analyse.force_history(bed)
        brought = analyse.momentum(bed, max(written_times(bed.case).items())[1]) / bed.weight
        self.assertLess(abs(drop[-1] - gas[-1] + brought), 1e-3)

    def test_figures_and_picture(self):
        self.assertTrue(all(math.isfinite(v) for v in self.result.values() if isinstance(v, float)), self.result)
        out = Path(self.keeper.name) / "result.png"
        picture.draw(out, [self.job])
        self.assertGreater(out.stat().st_size, 10000)

    def test_expected_are_figures_of_its_beds(self):
        for row in expected.rows(run.HERE / "expected.csv"):
            self.assertIn(row["case"], run.KINDS)
            self.assertIn(row["quantity"], self.of_packed if row["case"] in ("small", "large") else self.result)

    def test_a_run_of_another_time_is_not_held_against_expectations(self):
        """The small beds' figures in the place of those of all kinds."""
        def found(jobs, together):
            return [self.of_packed if job.packed else self.result for job in jobs]
        for words, lines in ((), len(expected.rows(run.HERE / "expected.csv"))), (("--time", "0.1"), 0):
            with tempfile.TemporaryDirectory(prefix="cohesion-") as out, mock.patch.object(run, "carry_out", found), \
                    mock.patch.object(run.picture, "draw"), contextlib.redirect_stdout(io.StringIO()) as printed, \
                    mock.patch.object(sys, "argv", ["run.py", "--seeds", "1", "--out", out, "--build", BUILD, *words]):
                run.main()
            self.assertEqual(len(re.findall(", expected [-0-9.]+ to", printed.getvalue())), lines)
            self.assertIn("large_in_lower_half", printed.getvalue())


class Reading(unittest.TestCase):
    def test_segregated_layers(self):
        """Heights of a bed of one density, small spheres on large ones: 1, to the half of a sphere's distance from the
        next, 1/1000 of the bed. Upside down 0 is passed: the large lie on the small."""
        large = np.arange(1000) < 500
        heights = np.arange(1000) + 0.5
        self.assertAlmostEqual(analyse.segregation(heights, large, 0.5), 1, delta=1e-3)
        self.assertEqual(analyse.shares_below(heights, large, (1.0, 1.0)), (0.0, 1.0))
        self.assertLess(analyse.segregation(1000 - heights, large, 0.5), 0)
        self.assertEqual(analyse.shares_below(1000 - heights, large, (1.0, 1.0)), (1.0, 0.0))

    def test_even_layers(self):
        """By turns: 0 to a sphere's distance from the next; half of each in the lower half, where a sphere of either
        size is cut."""
        large = np.arange(1001) % 2 == 0
        heights = np.arange(1001) + 0.5
        self.assertAlmostEqual(analyse.segregation(heights, large, 0.3), 0, delta=2e-3)
        for share in analyse.shares_below(heights, large, (1.0, 4.0)):
            self.assertAlmostEqual(share, 0.5, delta=2e-3)

    def test_lacey_index(self):
        """0 for cells of one kind each; 1 in the mean over dealings: 200 of them, each off by some
        1/sqrt(cells) of S_R^2/S_0^2, a thousandth here."""
        cells = np.repeat(np.arange(10), 50)
        self.assertAlmostEqual(analyse.lacey_index(cells, cells < 5), 0, delta=1e-12)
        random = np.random.default_rng(1)
        dealt = [analyse.lacey_index(cells, random.permutation(cells < 5)) for _ in range(200)]
        self.assertAlmostEqual(np.mean(dealt), 1, delta=3 * np.std(dealt) / math.sqrt(len(dealt)))

    def bed(self, **size):
        bed = object.__new__(analyse.Bed)
        bed.size = {"small": 0, "large": 100, "smallDiameter": 1.5e-3, "largeDiameter": 2.5e-3, "density": 2524,
                    "height": 0.1, "up": 4, **size}
        bed.gas, bed.gravity, bed.mixture = {"rho": 1.2, "nu": 1.5e-5}, 9.81, "none"
        return bed

    def test_minimum_fluidisation_is_ergun_s(self):
        """Of one size without a law for mixtures; with vanDerHoef 1 + 0.064 eps times the drag, so less."""
        bed = self.bed()
        alone = ergun.minimum_fluidisation(0.41, 2.5e-3, 2524, 1.2, 1.8e-5, 9.81)
        self.assertAlmostEqual(bed.minimum_fluidisation(0.41), alone, delta=1e-12)
        bed.mixture = "vanDerHoef"
        self.assertLess(bed.minimum_fluidisation(0.41), alone)
        self.assertAlmostEqual(bed.gradient(0.41, 1.0), (1 + 0.064 * 0.41) * self.bed().gradient(0.41, 1.0), delta=1e-9)

    def test_sauter_mean(self):
        """Of half of the volume each: the harmonic mean of the diameters."""
        bed = self.bed(small=125 * 100, large=27 * 100)
        self.assertAlmostEqual(bed.sauter, 2 / (1 / 1.5e-3 + 1 / 2.5e-3), delta=1e-12)

    def test_limits_of_the_closure(self):
        """The same in even cells, the closure's own; apart where cells of a layer differ, and the free flow's is less."""
        bed = self.bed()
        even = np.full((2, 4, 3), 0.4)
        free, straight = analyse.closure_drops(bed, even, 0.5)
        self.assertAlmostEqual(straight / (0.1 * bed.gradient(0.4, 0.5)), 1, delta=1e-12)
        self.assertAlmostEqual(free / straight, 1, delta=1e-9)
        even[0] = 0.5
        free, straight = analyse.closure_drops(bed, even, 0.5)
        self.assertLess(free, 0.99 * straight)


if __name__ == "__main__":
    unittest.main()
