# SPDX-License-Identifier: BSD-3-Clause
"""bubbling_hard_sphere.py BUILD_FOLDER: a small version of examples/bubbling-hard-sphere, 300 spheres above a jet
for 0.05 s with and without dissipation; the reading of pressure, void fraction and cavities where it is known."""

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
import first_second
import picture
import run
from cohesion_studies import expected
from cohesion_studies.case_entries import entries, gravity
from cohesion_studies.cavities import cavities, width_of
from cohesion_studies.foam_results import read_cloud, written_times
from cohesion_tests.coupling.cases import exchange_lines

SOURCE = Path(__file__).resolve().parents[2]

BUILD = sys.argv.pop(1) if len(sys.argv) > 1 else str(SOURCE / "build")
SMALL = {"width": 0.05, "height": 0.2, "jetFrom": 0.02, "jetTo": 0.03, "middle": 0.025, "sideCells": 2,
         "cellsUp": 10, "trace": 0.05, "count": 300, "settle": 0.1, "endTime": 0.05}
STARTED = {**SMALL, "begin": 0.02,
           "jetGas": "table ((0 (0 1.8 0)) (0.02 (0 1.8 0)) (0.021 (0 18 0)) (1 (0 18 0)))"}
STEPS = 100  # gas steps


class SmallBed(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.keeper = tempfile.TemporaryDirectory(prefix="cohesion-")
        cls.addClassCleanup(cls.keeper.cleanup)
        env = run.environment(BUILD)
        cls.jobs = [run.HardBed(Path(cls.keeper.name), env, "", "b", dissipation, 4711, SMALL)
                    for dissipation in ((1, 1), (0, 0))]
        cls.started = run.HardBed(Path(cls.keeper.name), env, "", "b-start", (0.5, 0), 4711, STARTED)
        cls.results = run.carry_out([*cls.jobs, cls.started], 2)
        cls.start_result = cls.results.pop()
        cls.beds = [analyse.Bed(job.folder) for job in cls.jobs]

    def test_gas_and_spheres_balance(self):
        """Round-off of sums over 300 spheres: 1e-13 of the force on them, some 0.3 N."""
        for bed in self.beds:
            lines = exchange_lines((bed.case / "log.cohesiveBedFoam").read_text())
            self.assertEqual(len(lines), STEPS)
            self.assertLess(max(line["imbalance"] for line in lines), 1e-13)
            self.assertLess(max(line["volume"] for line in lines), 1e-13)

    def test_collisions_take_energy_or_none(self):
        """Without dissipation what collisions have taken stays as it was when the gas began, but for the round-off of
        sums (1e-12 of what settling took); with it they take more."""
        taken = []
        for bed in self.beds:
            text = (bed.case / "log.lammps").read_text()
            after = [line.split() for line in text[text.index("fix          gas"):].splitlines()]
            rows = [[float(word) for word in words] for words in after if len(words) == 6 and words[0].isdigit()]
            self.assertGreater(len(rows), STEPS)
            taken.append((rows[0][5], rows[-1][5], rows[-1][3] - rows[0][3]))
        (start, end, collisions), (elastic_start, elastic_end, elastic_collisions) = taken
        self.assertGreater(start, 0)
        self.assertGreater(end, start * (1 + 1e-6))
        self.assertLess(abs(elastic_end - elastic_start), 1e-12 * start)
        self.assertGreater(min(collisions, elastic_collisions), 1000)

    def test_void_fraction_is_where_the_spheres_are(self):
        """All solid is in the cells (8 digits are written), in rows that are those of the spheres: they differ by what
        of a sphere is across a face, at most its radius of its volume's middle, and what it flies in a gas step."""
        for bed in self.beds:
            time, folder = max(written_times(bed.case).items())
            void = analyse.void_fraction(bed, folder)
            self.assertEqual(void.shape, (10, 5))
            cell = bed.width * bed.height / void.size * (bed.front - bed.back)
            sphere = math.pi / 6 * bed.diameter**3
            self.assertAlmostEqual((1 - void).sum() * cell / sphere, bed.count, delta=1e-6 * bed.count)
            places, velocities = read_cloud(folder)
            self.assertEqual(len(places), bed.count)
            flight = abs(velocities).max() * 5e-4
            for axis, size in ((0, bed.width), (1, bed.height)):
                share = (1 - void).sum(axis=axis)
                middles = (np.arange(len(share)) + 0.5) / len(share) * size
                half = middles[0]
                self.assertLess(abs((middles * share).sum() / share.sum() - places[:, axis].mean()), half + flight)
                for limit in middles[:-1] + half:
                    below = share[middles < limit].sum() / share.sum()
                    self.assertGreaterEqual(below + 1e-6, (places[:, axis] < limit - bed.diameter / 2 - flight).mean())
                    self.assertLessEqual(below - 1e-6, (places[:, axis] < limit + bed.diameter / 2 + flight).mean())

    def test_figures_and_picture(self):
        for result in self.results:
            self.assertTrue(all(math.isfinite(v) for v in result.values() if isinstance(v, float)), result)
            self.assertGreater(result["expansion"], 0.9)
        out = Path(self.keeper.name) / "result.png"
        picture.draw(out, [job.folder for job in self.jobs])
        self.assertGreater(out.stat().st_size, 10000)

    def test_bed_that_starts_at_minimum_fluidisation(self):
        """Shares of dissipation: the restitution and friction that LAMMPS gets. The gas at the jet changes at begin."""
        self.assertEqual(self.started.name, "b-start-0.5-0-seed-4711")
        log = (self.started.folder / "log.lammps").read_text()
        spheres = re.findall(r"^pair_coeff \* \* restitution ([\d.]+) friction ([\d.]+)$", log, re.M)[-1]
        np.testing.assert_allclose(np.array(spheres, float), (0.95, 0.15), rtol=1e-12)
        walls = re.findall(r"^fix +walls .* restitution ([\d.]+) +friction ([\d.]+) xplane", log, re.M)[-1]
        np.testing.assert_allclose(np.array(walls, float), (1, 0))
        bed = analyse.Bed(self.started.folder)
        speed = {}
        for time, folder in first_second.written_times(bed.case).items():
            if time == 0:
                continue
            text = (folder / "U").read_text()
            speed[time] = float(re.search(r"jet\s*\{[^}]*value\s+uniform \(\S+ (\S+) ", text)[1])
        self.assertAlmostEqual(speed[0.02], 1.8 / 0.4, delta=1e-6)
        self.assertAlmostEqual(speed[0.04], 18 / 0.4, delta=1e-6)
        self.assertEqual([round(time, 6) for time, _ in first_second.after(bed)], [0.02])
        self.assertGreater(self.start_result["collisions_per_s"], 1000)
        self.assertGreater(self.start_result["jet_void_excess"], 0)

    def test_expected_are_figures_of_its_beds(self):
        for row in expected.rows(run.HERE / "expected.csv"):
            self.assertIn(row["case"], {f"{bed}{kind}" for bed in run.BEDS for kind in ("", "-elastic")})
            of_start = row["case"].removesuffix("-elastic") not in ("b", "c", "d")
            self.assertIn(row["quantity"], self.start_result if of_start else self.results[0])

    def test_a_run_of_another_time_is_not_held_against_expectations(self):
        """The small bed's figures in the place of those of both beds, with and without dissipation."""
        rows = [row for row in expected.rows(run.HERE / "expected.csv") if row["case"].removesuffix("-elastic") in "bc"]
        for words, lines in ((), len(rows)), (("--time", "0.05"), 0):
            with tempfile.TemporaryDirectory(prefix="cohesion-") as out, \
                    mock.patch.object(run, "carry_out", lambda jobs, together: len(jobs) * self.results[:1]), \
                    mock.patch.object(run.picture, "draw"), contextlib.redirect_stdout(io.StringIO()) as printed, \
                    mock.patch.object(sys, "argv", ["run.py", "--seeds", "1", "--out", out, "--build", BUILD, *words]):
                run.main()
            self.assertEqual(len(re.findall(", expected [0-9.]+ to", printed.getvalue())), lines)
            self.assertIn("slug_share_of_time", printed.getvalue())

    def test_beds_of_other_settings_are_kept(self):
        env = run.environment(BUILD)
        other = run.HardBed(Path(self.keeper.name), env, "", "b", (1, 1), 4711, {**SMALL, "endTime": 0.1})
        self.assertEqual(other.folder, self.jobs[0].folder)
        run.require_ours(self.jobs, run.MARK)
        with self.assertRaisesRegex(run.RunError, "b-seed-4711.*--overwrite"):
            run.require_ours([other], run.MARK)


class Reading(unittest.TestCase):
    def test_cavities(self):
        """Two bubbles, one of them at a wall and three cells wide, and the space above the bed with a channel down."""
        empty = np.array([[c == "o" for c in row] for row in reversed([
            "oooooo",
            "xxoxxx",
            "xxoxxx",
            "xxxxxo",
            "xoxooo",
            "xxxxxx"])])
        found = sorted(cavities(empty), key=len)
        self.assertEqual([len(members) for members in found], [1, 4])
        self.assertAlmostEqual(width_of(found[1], 6), 0.5)
        self.assertEqual(cavities(np.zeros((3, 3), bool)), [])
        self.assertEqual(cavities(np.ones((3, 3), bool)), [])

    def test_first_cavities(self):
        """A bubble of two cells, then a slug from the left wall: seven of its eight cells have a mirror cell."""
        bubble = [np.array([[0, 4], [1, 4]])]
        slug = [np.array([[2, column] for column in range(8)])]
        figures = first_second.first_cavities([(0.1, bubble), (0.2, slug), (0.3, bubble)], 9, 0.02)
        self.assertEqual(figures["bubble_before_slug"], 1)
        self.assertEqual(figures["slug_time"], 0.2)
        self.assertAlmostEqual(figures["slug_height"], 0.05)
        self.assertAlmostEqual(figures["slug_mirrored"], 7 / 8)
        self.assertEqual(figures["largest_cavity_cells"], 8)
        self.assertEqual(first_second.satellites([(0.1, []), (0.2, bubble + slug), (0.3, bubble)]), 0)
        self.assertEqual(first_second.satellites([(0.1, slug + [np.array([[3, 1]]), np.array([[5, 1]])])]), 2)
        none = first_second.first_cavities([(0.1, [])], 9, 0.02)
        self.assertTrue(math.isnan(none["slug_time"]) and none["bubble_before_slug"] == 0)

    def test_shares(self):
        self.assertEqual([run.kind_of("b", run.shares(text)) for text in ("1", "0", "0.5", "0:1")],
                         ["b", "b-elastic", "b-0.5-0.5", "b-0-1"])
        for text in ("2", "0:-1", "x"):
            with self.assertRaisesRegex(Exception, "shares are 0 to 1"):
                run.shares(text)

    def test_peaks(self):
        self.assertEqual(analyse.peaks(np.array([1, 3, 3, 1, 2, 1, 3]), 2), 2)
        self.assertEqual(analyse.peaks(np.array([3, 1, 1]), 2), 0)

    def test_minimum_fluidisation_is_that_of_the_source(self):
        """1.77 m/s, three digits, at the void fraction that the depth of the slab is made for; the bed (d) to what
        its entries say of it, 0.56 m/s."""
        case = SOURCE / "examples/bubbling-hard-sphere/case"
        for name, velocity in (("b", 1.77), ("c", 1.77), ("d", 0.56)):
            bed = object.__new__(analyse.Bed)
            bed.size = entries(case / f"constant/bed.{name}")
            bed.gas = entries(case / "constant/transportProperties")
            bed.gravity = gravity(case)
            self.assertAlmostEqual(bed.minimum_fluidisation(0.41), velocity, delta=0.005)
            depth = bed.front - bed.back
            self.assertAlmostEqual(1 - 0.83 * 2 / 3 * bed.diameter / depth, 0.41, delta=0.001)


if __name__ == "__main__":
    unittest.main()
