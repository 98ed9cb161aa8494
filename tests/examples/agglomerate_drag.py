# SPDX-License-Identifier: BSD-3-Clause
"""agglomerate_drag.py BUILD_FOLDER: examples/agglomerate-drag with few spheres and coarse flows; the forms that it
reads, makes and measures against what is known of them."""

import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

import numpy as np

import law
import run
import shapes
from cohesion_studies import expected
from cohesion_studies.drag_run import radius_in_cube

SOURCE = Path(__file__).resolve().parents[2]
EXAMPLE = SOURCE / "examples/agglomerate-drag"

BUILD = sys.argv.pop(1) if len(sys.argv) > 1 else str(SOURCE / "build")


class Shapes(unittest.TestCase):
    def test_balls_are_dense_and_touch(self):
        for n in (13, 43, 135):
            ball = shapes.ball(n)
            gaps = np.linalg.norm(ball[:, None] - ball, axis=2)[np.triu_indices(n, 1)]
            self.assertEqual(len(ball), n)
            self.assertAlmostEqual(gaps.min(), 1, 12)
        self.assertAlmostEqual(shapes.radius_of_gyration(shapes.ball(13)), np.sqrt(12 / 13), 12)

    def test_chain_as_it_is_seen(self):
        # From its end one disc, from the side five; pixels decide within the circumference over their number.
        end, side, other = shapes.projected_radii(shapes.chain(5))
        self.assertAlmostEqual(end, 0.5, delta=0.01)
        self.assertAlmostEqual(side, 0.5 * np.sqrt(5), delta=0.01)
        self.assertEqual(side, other)

    def dump(self, folder, places, edges, tilt):
        bounds = [f"0 {edges[0] + tilt} {tilt}", f"0 {edges[1]} 0", f"0 {edges[2]} 0"]
        rows = [f"{k + 1} {x} {y} {z} 0.5 1 {len(places)}" for k, (x, y, z) in enumerate(places)]
        file = Path(folder) / "spheres.txt"
        file.write_text("\n".join(["ITEM: TIMESTEP", "0", "ITEM: NUMBER OF ATOMS", str(len(places)),
                                   "ITEM: BOX BOUNDS xy xz yz pp pp pp", *bounds, "ITEM: ATOMS", *rows]) + "\n")
        return file

    def test_unfolds_through_a_tilted_box(self):
        # Across the upper face, where the image stands 3 further along x, and across the side.
        edges, tilt = np.array([10.0, 8.0, 9.0]), 3.0
        chain = np.array([[0.4, 6.6, 8.8], [0.4, 7.6, 8.8], [0.4 - 3.0 + 10, 0.6, 8.8], [0.4 - 3.0 + 10, 0.6, 0.8]])
        with tempfile.TemporaryDirectory() as folder:
            found, = shapes.found_in(self.dump(folder, chain, edges, tilt), [4])
        np.testing.assert_allclose(np.diff(found, axis=0), [[0, 1, 0], [0, 1, 0], [0, 0, 1]], atol=1e-12)

    def test_ring_around_the_box_has_no_form(self):
        edges = np.array([4.0, 8.0, 8.0])
        ring = np.array([[k + 0.5, 4.0, 4.0] for k in range(4)])
        with tempfile.TemporaryDirectory() as folder:
            self.assertEqual(shapes.found_in(self.dump(folder, ring, edges, 0.0), [4]), [])

    def test_suspension_does_not_overlap(self):
        places, edge = shapes.suspension(shapes.ball(13), 4, 0.1, 1)
        self.assertAlmostEqual(52 * np.pi / 6 / edge**3, 0.1, 12)
        steps = places[:, None] - places
        steps -= edge * np.round(steps / edge)
        gaps = np.linalg.norm(steps, axis=2)[np.triu_indices(52, 1)]
        self.assertGreater(gaps.min(), 1 - 1e-9)
        with self.assertRaisesRegex(ValueError, "no room"):
            shapes.suspension(shapes.ball(13), 4, 0.5, 1, tries=100)


class Law(unittest.TestCase):
    def test_radius_in_a_cube(self):
        # Zick and Homsy, simple cubic, K 1.212 at a fraction of 0.001: the sphere itself, to the series' last digit
        self.assertAlmostEqual(radius_in_cube(1.212, 1, (np.pi / 6 / 0.001)**(1 / 3)), 1.0, delta=1e-3)

    def test_fit_finds_its_own_law(self):
        runs = [{"n": n, "gyration": g, "radius": float(law.radius_by(n, g, 0.3))} for n, g in ((2, 1), (9, 2), (50, 6))]
        self.assertAlmostEqual(law.fitted(runs), 0.3, 12)

    def test_limits(self):
        self.assertEqual(law.radius_by(1, 0.0, 0.3), 1)
        # Nothing flows through a dense ball of a million spheres: R = (N/0.6)^(1/3), to what its surface lets in.
        ball = (1e6 / 0.6)**(1 / 3)
        self.assertAlmostEqual(law.radius_by(1e6, np.sqrt(3 / 5 * (ball**2 - 1)), 0.3) / ball, 1, delta=0.002)


class Example(unittest.TestCase):
    def test_whole_run(self):
        small = {"GAS": {**run.GAS, "count": 200, "steps": 2000}, "SOURCES": {"cooling": {}}, "WANTED": [3],
                 "CHAINS": [1, 2], "BALLS": [13], "SUSPENSIONS": {"ball-13": [0.1]}, "TOGETHER": 2, "SEEDS": 1,
                 "SPACINGS": 6, "spacings": lambda edge: 6}
        with tempfile.TemporaryDirectory(prefix="cohesion-") as folder, mock.patch.multiple(run, **small):
            out = Path(folder) / "runs"
            with mock.patch.object(sys, "argv", ["run.py", "--build", BUILD, "--out", str(out)]):
                run.main()
                text = (out / "result.txt").read_text()
                with mock.patch.object(run.DragRun, "start", side_effect=AssertionError("done again")):
                    run.main()
            self.assertEqual((out / "result.txt").read_text(), text)
            self.assertGreater((out / "result.png").stat().st_size, 20000)
        rows = {line.split()[0]: line.split() for line in text.split("\n\n")[0].splitlines()}
        found = {name: dict(zip(words[1::2], map(float, words[2::2]))) for name, words in rows.items()}
        self.assertGreater(found["law"]["of"], 0)
        # At six spacings a sphere is 1 % off, pairs 3 %: examples/agglomerate-drag/README.md
        self.assertAlmostEqual(found["chain-1"]["radius"], 1, delta=0.02)
        self.assertAlmostEqual(found["chain-2"]["along"] / 1.29, 1, delta=0.05)
        self.assertAlmostEqual(found["chain-2"]["across"] / 1.45, 1, delta=0.05)
        # Two balls that are each other's neighbours hold more than one alone and less than free spheres.
        self.assertLess(found["ball-13-at-0.1-seed-1"]["share"], 1)
        self.assertGreater(found["ball-13-at-0.1-seed-1"]["share"], found["ball-13"]["share"])

    def test_every_row_that_is_expected_is_measured(self):
        names = {f"chain-{n}" for n in run.CHAINS} | {f"ball-{n}" for n in run.BALLS}
        for row in expected.rows(EXAMPLE / "expected.csv"):
            source, number = row["case"].split("-")
            if source in run.SOURCES:  # as it grows: of about a number of spheres that is wanted
                self.assertTrue(any(abs(int(number) - n) <= 0.2 * n for n in run.WANTED), row["case"])
            else:
                self.assertIn(row["case"], names)


if __name__ == "__main__":
    unittest.main()
