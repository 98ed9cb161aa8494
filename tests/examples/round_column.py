# SPDX-License-Identifier: BSD-3-Clause
"""round_column.py BUILD_FOLDER: a small version of examples/round-column, 3000 beads in each engine, on two ranks too;
the mesh of the wall."""

import math
import re
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np

import picture
import run
import wall
from cohesion_studies.foam_case import environment
from cohesion_studies.foam_results import written_times
from cohesion_studies.job_pool import carry_out
from cohesion_studies.powder_program import PowderProgram
from cohesion_tests.coupling.cases import exchange_lines

SOURCE = Path(__file__).resolve().parents[2]

BUILD = sys.argv.pop(1) if len(sys.argv) > 1 else str(SOURCE / "build")
SMALL = {"--column": 0.0091, "--height": 0.004}
COURSE = {"fastest": 0.35, "ramp": 0.06, "hold": 0.01}


class SmallColumn(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.keeper = tempfile.TemporaryDirectory(prefix="cohesion-")
        cls.addClassCleanup(cls.keeper.cleanup)
        env, powder = environment(BUILD, run.ENGINES), PowderProgram(BUILD)
        cls.jobs = [run.Column(Path(cls.keeper.name), env, powder, engine, 5, SMALL, COURSE) for engine in run.ENGINES]
        cls.results = carry_out(cls.jobs, 2)

    def test_gas_and_beads_balance(self):
        """Round-off of sums over some thousand beads."""
        for job in self.jobs:
            lines = exchange_lines((job.folder / "log.cohesiveBedFoam").read_text())
            self.assertLess(max(line["imbalance"] for line in lines), 1e-12)
            self.assertLess(max(line["volume"] for line in lines), 1e-12)

    def test_beads_stay_inside(self):
        """A bead is pressed into the wall by less than a hundredth of its diameter; the mesh's corners are a thousandth
        farther out than the cylinder."""
        radius = 0.0045
        for result in self.results:
            self.assertLess(result["farthest"] - 1, 0.01 * 5e-4 / radius + 1e-3)

    def test_the_resting_bed_has_the_drag_of_the_closure(self):
        """At the mean void fraction; beside the wall a layer of a quarter of a bead is empty, a ninth of the section, and
        the gas prefers it, by about U ~ eps^3/(1 - eps)^2 of it. Both engines have the same beads and gas: they differ
        by the packing's part alone."""
        for result in self.results:
            self.assertAlmostEqual(result["U_mf"] / result["U_mf_of_the_closure"], 1, delta=1.5 / 9)

    def test_picture(self):
        """Bright colours are of beads, up to their surface on the left, and of the gas on the right; the wall is grey."""
        for job in self.jobs:
            times = written_times(job.folder)
            section, (image,) = picture.views(job, {max(times): times[max(times)]})
            spread = image.max(axis=2).astype(int) - image.min(axis=2)
            up, across = spread.shape
            scale = up / (2 * 0.54 * section.height)  # pixels of a metre; the middle is that of the height shown
            row = lambda z, up=up, scale=scale, section=section: round(up / 2 - (z - section.height / 2) * scale)
            left, right = spread[:, across // 2 - 60:across // 2 - 10], spread[:, across // 2 + 10:across // 2 + 60]
            bed, above = row(0.4 * SMALL["--height"]), row(1.7 * SMALL["--height"])
            self.assertGreater(left[bed].mean(), 30)
            self.assertLess(left[above].mean(), 30)
            self.assertGreater(right[[bed, above]].mean(), 30)
        self.assertEqual(picture.draw(Path(self.keeper.name) / "result.png", self.jobs), None)

    def test_two_ranks(self):
        """The first gas steps; what both have of volume and momentum balances, and beads are as many."""
        for job in self.jobs:
            job.case.set("system/controlDict", "endTime", 0.005)
            log = job.case.solve(ranks=2)
            lines = exchange_lines(log)
            self.assertGreater(len(lines), 5)
            self.assertLess(max(line["imbalance"] for line in lines), 1e-12)
            self.assertIn(f"Particles: {run_number(job)}, ", log)


def run_number(job):
    return int(re.search(r"(\d+) atoms", (job.folder / "grains.data").read_text())[1])


class Wall(unittest.TestCase):
    def test_its_section_is_that_of_the_cylinder(self):
        """Shoelace formula, to round-off."""
        x, y = np.array(wall.corners(0.009)).T
        area = 0.5 * abs(np.dot(x, np.roll(y, -1)) - np.dot(y, np.roll(x, -1)))
        self.assertAlmostEqual(area / (math.pi * 0.009**2), 1, delta=1e-12)

    def test_its_triangles_close_it(self):
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "column.stl"
            wall.write_stl(file, 0.009, 0.03, 12)
            points = np.array(re.findall(r"vertex (\S+) (\S+) (\S+)", file.read_text()), dtype=float).reshape(-1, 3, 3)
        self.assertEqual(len(points), 24)
        a, b = points[:, 1] - points[:, 0], points[:, 2] - points[:, 0]
        area = 0.5 * np.linalg.norm(np.cross(a, b), axis=1).sum()
        side = math.dist(wall.corners(0.009, 12)[0], wall.corners(0.009, 12)[1])
        # Nine digits are written.
        self.assertAlmostEqual(area / (12 * side * 0.03), 1, delta=1e-8)

    def test_another_script_is_refused(self):
        with self.assertRaises(ValueError):
            wall.as_mesh("fix sides all wall/gran primitive")


if __name__ == "__main__":
    unittest.main()
