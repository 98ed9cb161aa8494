# SPDX-License-Identifier: BSD-3-Clause
"""bubbles_from_particles.py BUILD_FOLDER: bubbles of examples/bubbles-from-particles where their size and rise are known,
in pictures that are made up; and 400 hard spheres for 0.1 s from start to table."""

import math
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np

import analyse
import beds
import picture
import run
import tracking
from cohesion_studies import expected
from cohesion_studies.foam_case import environment
from cohesion_studies.job_pool import carry_out

BUILD = sys.argv.pop(1) if len(sys.argv) > 1 else str(Path(__file__).resolve().parents[2] / "build")
D, ACROSS, FILLED, UP = 0.002, 40, 50, 60  # a diameter, which is a cell; the bed's cells, and those of the box
SMALL = {"width": 0.11, "height": 0.3, "jetFrom": 0.05, "jetTo": 0.06, "middle": 0.055, "sideCells": 5, "cellsUp": 15,
         "count": 400, "settle": 0.05, "endTime": 0.1}


def picture_of(*holes):
    """Bubbles of a square lattice of spheres, one in the middle of each cell, without those in the circles `holes`: x, y,
    radius in cells."""
    rows, columns = np.mgrid[0:FILLED, 0:ACROSS] + 0.5
    kept = np.ones(rows.shape, bool)
    for x, y, radius in holes:
        kept &= (columns - x)**2 + (rows - y)**2 > radius**2
    places = D * np.column_stack([columns[kept], rows[kept]])
    share = tracking.solid_share(places, D, ACROSS * D, UP * D)
    return tracking.bubbles(share, (D, D), D)


class MadeUp(unittest.TestCase):
    def test_share_of_a_whole_lattice(self):
        """Nine spheres of nine quarters of their square in each circle, at the walls too: (D/2)^2 9/(1.5 D)^2 = 1."""
        share = tracking.solid_share(D * np.argwhere(np.ones((ACROSS, FILLED))) + D / 2, D, ACROSS * D, UP * D)
        self.assertEqual(share.shape, (UP, ACROSS))
        np.testing.assert_allclose(share[:FILLED - 1], 1, atol=1e-14)
        np.testing.assert_array_equal(share[FILLED + 1:], 0)

    def test_size_and_place(self):
        """The border is where half of the circle is solid, within half a cell of the circle's: d to a cell, and the
        place by symmetry."""
        for radius in (6, 9):
            found, = picture_of((20, 25, radius))
            self.assertLess(abs(found.diameter - 2 * radius * D), D)
            self.assertAlmostEqual(found.x / D, 20, delta=1e-12)
            self.assertAlmostEqual(found.y / D, 25, delta=1e-12)
            self.assertTrue(found.free)

    def test_rise_is_that_of_the_hole(self):
        """A cell in 0.01 s, two that do so at other heights, and one that sinks: rounding of a line through ten points."""
        def at(k):
            return picture_of((10, 10 + k, 5), (29, 36 - k, 6))
        lives = tracking.follow([at(k) for k in range(10)])
        self.assertEqual(sorted(map(len, lives)), [10, 10])
        for life in lives:
            d, height, v, when, x = tracking.measured(life, 0.01 * np.arange(10))
            sign = 1 if x < 20 * D else -1
            self.assertAlmostEqual(v, sign * D / 0.01, delta=1e-12)
            self.assertAlmostEqual(height, (14.5 if sign == 1 else 31.5) * D, delta=1e-12)
            self.assertAlmostEqual(when, 0.045, delta=1e-12)

    def test_what_no_life_is(self):
        """At a wall, at the plate, open to the space above, too small; and the shorter ones that end with a merger."""
        self.assertFalse(picture_of((3, 25, 6))[0].free)
        self.assertFalse(picture_of((20, 3, 6))[0].free)
        self.assertEqual(picture_of((20, 48, 6)), [])
        self.assertEqual(picture_of((20, 25, 1.5)), [])
        # The two are one from the fifth picture on.
        pictures = [picture_of((14, 15 + k, 5), (26, 15 + k, 5)) for k in range(4)]
        pictures += [picture_of((20, 19 + k, 8)) for k in range(3)]
        lives = tracking.follow(pictures)
        self.assertEqual(sorted(map(len, lives)), [3, 4, 4])
        self.assertIsNone(tracking.measured(lives[0], 0.001 * np.arange(7)))

    def test_one_that_doubles_is_another(self):
        lives = tracking.follow([picture_of((20, 25, 5)), picture_of((20, 25, 8))])
        self.assertEqual(list(map(len, lives)), [1, 1])

    def test_correlations(self):
        """Bubbles that rise with 0.48 sqrt(g d) are alone in two dimensions; Darton's size by hand, 0.54 x 1 x 1/g^0.2."""
        lives = [(d, 0.1, 0.48 * math.sqrt(9.81 * d), 0, 0) for d in (0.02, 0.08)]
        found = analyse.figures(lives, 1.5, 0.5, 0.03, 4e-3)
        self.assertAlmostEqual(found["over_isolated"][0], 1, delta=1e-14)
        self.assertAlmostEqual(found["over_3d"][0], 0.48 / 0.711, delta=1e-14)
        self.assertAlmostEqual(found["diameter"][0], 0.05, delta=1e-15)
        self.assertAlmostEqual(found["diameter"][1], 0.03, delta=1e-15)  # half of their distance
        self.assertEqual((found["bubbles"][0], found["large_bubbles"][0]), (2, 1))
        self.assertAlmostEqual(analyse.darton(1, 0.97, 0.03), 0.342033, delta=1e-5)


class SmallBed(unittest.TestCase):
    def test_from_start_to_table(self):
        with tempfile.TemporaryDirectory(prefix="cohesion-") as folder:
            job = beds.HardBubbles(Path(folder), environment(BUILD, ["lammps"]), "", 1, SMALL)
            result, = carry_out([job], 1)
            # Pictures every 5 ms after the first quarter
            self.assertEqual(result["pictures"], 15)
            lives = run.pooled([job], [result])
            self.assertEqual(list(lives), ["hard"])
            found = {kind: analyse.figures(of, *beds.KINDS[kind]) for kind, of in lives.items()}
            self.assertIn("bubbles", run.table(found))
            picture.draw(Path(folder) / "result.png", [job], lives)
            self.assertGreater((Path(folder) / "result.png").stat().st_size, 10000)

    def test_expected_are_figures_of_its_beds(self):
        known = analyse.figures([(0.06, 0.1, 0.3, 0, 0)] * 2, *beds.KINDS["hard"])
        for row in expected.rows(run.HERE / "expected.csv"):
            self.assertIn(row["case"], beds.KINDS)
            self.assertIn(row["quantity"], known)


if __name__ == "__main__":
    unittest.main()
