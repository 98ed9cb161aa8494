# SPDX-License-Identifier: BSD-3-Clause
"""spouted_bed.py BUILD_FOLDER: a small version of examples/spouted-bed, 800 spheres that a jet blows through for
0.02 s, dry and wet, on 1 and 2 ranks; the reading of walls, heights and openings where they are known."""

import contextlib
import io
import math
import re
import sys
import tempfile
import types
import unittest
from pathlib import Path
from unittest import mock

import numpy as np

import analyse
import geometry
import picture
import run
from cohesion_studies import expected, vtk_screen
from cohesion_studies.foam_results import vector_list
from cohesion_tests.coupling.cases import exchange_lines

SOURCE = Path(__file__).resolve().parents[2]

BUILD = sys.argv.pop(1) if len(sys.argv) > 1 else str(SOURCE / "build")
COUNT, STEPS = 800, 50  # spheres, gas steps
SMALL = {"constant/couplingProperties": {"liggghtsCoeffs/variables/count": COUNT,
                                         "liggghtsCoeffs/variables/settle": 0.1},
         "constant/vessel": {"coneLayers": 8, "upperLayers": 3},  # twice as high as those of the example, and more
         "constant/schedule": {"superficialVelocity": "table ((0 (0 6 0)) (0.01 (0 12 0)) (0.015 (0 12 0)))",
                               "endTime": 0.02},
         "system/controlDict": {"writeInterval": 0.002}}


class SmallBeds(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.keeper = tempfile.TemporaryDirectory(prefix="cohesion-")
        cls.addClassCleanup(cls.keeper.cleanup)
        env = run.environment(BUILD, ["liggghts"])
        cls.beds = {}
        for name, kind, ranks in (("dry", "dry", 1), ("two ranks", "dry", 2), ("wet", "wet", 1)):
            job = run.SpoutedBed(Path(cls.keeper.name) / name.replace(" ", "-"), env, "", kind, 15485863, SMALL)
            job.prepare()
            job.case.solve(ranks=ranks)
            if ranks > 1:
                job.case.run("reconstructPar")
            cls.beds[name] = analyse.Bed(job.folder)
        cls.results = {name: analyse.figures(bed.case) for name, bed in cls.beds.items()}

    def test_gas_and_spheres_balance(self):
        """Sums over the spheres round by 1.1e-16 of themselves for each: 9e-14. The smoothing's equations are solved to
        1e-15 in each of 1056 cells."""
        for name, bed in self.beds.items():
            lines = exchange_lines((bed.case / "log.cohesiveBedFoam").read_text())
            self.assertEqual(len(lines), STEPS, name)
            self.assertLess(max(line["imbalance"] for line in lines), 1.2e-12, name)
            self.assertLess(max(line["volume"] for line in lines), 1.2e-12, name)

    def test_spheres_stay_inside_the_mesh(self):
        """One that flies at the wall alone is pressed in by v sqrt(m/K), 0.18 of its radius at 2 m/s."""
        for name, found in self.results.items():
            self.assertEqual(found["spheres_missing"], 0, name)
            self.assertEqual(found["spheres_outside"], 0, name)
            self.assertLess(found["deepest_overlap_at_wall"], 0.18, name)
            self.assertGreater(found["deepest_overlap_at_wall"], 0, name)

    def test_both_see_one_wall(self):
        """All points of the gas's mesh are within the planes of the spheres' wall, those of its sides on one: by the 8
        digits of the STL file, some 1e-9 of points and 1e-6 of normals, to 1e-6 of half a metre."""
        bed = self.beds["dry"]
        walls = analyse.planes(bed)
        # Plate, cone and cylinder
        self.assertEqual(len(walls), 1 + 2 * geometry.SIDES)
        points = vector_list(bed.case / "constant/polyMesh/points")
        depths = analyse.depth(walls, points)
        self.assertGreater(depths.min(), -1e-6)
        radius = np.hypot(points[:, 0], points[:, 2])
        outer = radius > 0.99 * geometry.CORNER * bed.wall(points[:, 1])
        self.assertGreater(np.count_nonzero(outer), geometry.SIDES)
        self.assertLess(depths[outer].max(), 1e-6)

    def test_figures_and_picture(self):
        for name, found in self.results.items():
            finite = {key: value for key, value in found.items() if "velocity" not in key and "closing" not in key}
            self.assertTrue(all(math.isfinite(value) for value in finite.values()), (name, found))
        out = Path(self.keeper.name) / "result.png"
        with contextlib.redirect_stdout(io.StringIO()):
            picture.draw(out, [self.beds["dry"].case, self.beds["wet"].case])
        self.assertGreater(out.stat().st_size, 30000)

    def test_expected_are_figures_of_its_beds(self):
        for row in expected.rows(run.HERE / "expected.csv"):
            self.assertIn(row["case"], run.BEDS)
            self.assertIn(row["quantity"], self.results["dry"])

    def test_a_run_of_another_time_is_not_held_against_expectations(self):
        rows = [row for row in expected.rows(run.HERE / "expected.csv") if row["case"] == "dry"]
        for words, lines in ((), len(rows)), (("--time", "0.02"), 0):
            with tempfile.TemporaryDirectory(prefix="cohesion-") as out, \
                    mock.patch.object(run, "carry_out", lambda jobs, together: [self.results["dry"]]), \
                    mock.patch.object(run.picture, "draw"), contextlib.redirect_stdout(io.StringIO()) as printed, \
                    mock.patch.object(sys, "argv", ["run.py", "--out", out, "--build", BUILD, *words]):
                run.main()
            self.assertEqual(len(re.findall(", expected [-0-9.]+ to", printed.getvalue())), lines)
            self.assertIn("spheres_outside", printed.getvalue())


class Reading(unittest.TestCase):
    def bed(self):
        """Without a run."""
        bed = object.__new__(analyse.Bed)
        bed.vessel = {"baseDiameter": 0.06, "slope": 0.4142135624, "shoulder": 0.16, "inletDiameter": 0.04}
        bed.spheres = {"d": 4e-3, "density": 2420}
        bed.gas, bed.gravity = {"rho": 1.205, "nu": 1.452282e-5}, 9.81
        bed.schedule = np.array([[0, 1, 2, 4], [0, 10, 10, 0]], dtype=float)
        return bed

    def test_vessel_is_that_of_its_numbers(self):
        self.assertEqual(geometry.FILE.read_text(), geometry.text())

    def test_polygons_have_the_area_of_circles(self):
        corners = geometry.CORNER * np.exp(2j * np.pi * np.arange(geometry.SIDES) / geometry.SIDES)
        area = np.sum(np.imag(np.conj(corners) * np.roll(corners, -1))) / 2
        self.assertAlmostEqual(area, math.pi, delta=1e-12)

    def test_correlation(self):
        """By hand: Ar = 9.81 (4e-3)^3 2418.795/(1.205 (1.452282e-5)^2) = 5.9753e6, D_b = 0.06 + 0.2 tan 22.5 =
        0.142843, Re = 0.126 sqrt(Ar) (3.571068)^1.68 (0.414214)^-0.57 = 4319.5."""
        archimedes = 9.81 * 64e-9 * 2418.795 / (1.205 * 1.452282e-5**2)
        self.assertAlmostEqual(archimedes, 5.9753e6, delta=50)
        velocity = analyse.olazar(self.bed(), 0.1)
        self.assertAlmostEqual(velocity * 4e-3 / 1.452282e-5, 4319.5, delta=1)

    def test_volume_of_the_cone(self):
        bed, slices = self.bed(), np.linspace(0, 0.1, 20001)
        middles = (slices[1:] + slices[:-1]) / 2
        self.assertAlmostEqual(bed.volume(0.1), (math.pi * bed.wall(middles)**2).mean() * 0.1, delta=1e-11)

    def test_depth(self):
        """A cube of edge 2 around the origin."""
        walls = np.array([[*(sign * np.eye(3)[axis]), 1] for axis in range(3) for sign in (1, -1)])
        found = analyse.depth(walls, np.array([[0, 0, 0], [0.5, 0, -0.75], [0, 1.5, 0]]))
        np.testing.assert_allclose(found, [1, 0.25, -0.5], atol=1e-15)

    def test_closing(self):
        """Open from 0.5 to 3 s but for a moment, shorter than half of the window: closed at 5 m/s on the way down."""
        bed, time = self.bed(), np.arange(0, 4, 2e-3)
        is_open = (time > 0.5) & (time < 3) & ~((time > 1.5) & (time < 1.54))

        def closing(is_open):
            values = np.where(is_open[:, None], 0.9, 0.4) * np.ones(3)
            with mock.patch.object(analyse, "axis", lambda bed: (time, np.array([0.01, 0.05, 0.2]), values)):
                return analyse.closing_velocity(bed, 0.1)
        # Half of the window is open where it is centred on the change, within two rows
        self.assertAlmostEqual(closing(is_open), 5, delta=5 * 4e-3)
        self.assertTrue(math.isnan(closing(np.zeros_like(is_open))))
        self.assertTrue(math.isnan(closing(time > 0.5)))

    def test_dilute_height(self):
        heights = np.array([0.005, 0.015, 0.025])
        for profile, height in ((0.9, 0.85, 0.7), 2 / 3), ((0.9, 0.85, 0.81), 1), ((0.5, 0.9, 0.9), 0):
            self.assertAlmostEqual(analyse.dilute_height(heights, np.array(profile), 0.03), height, delta=1e-12)

    def test_missing_programs_are_said_at_once(self):
        with mock.patch.object(vtk_screen, "shutil", types.SimpleNamespace(which=lambda name: None)):
            with self.assertRaisesRegex(run.RunError, "package xvfb"):
                vtk_screen.require()


if __name__ == "__main__":
    unittest.main()
