# SPDX-License-Identifier: BSD-3-Clause
"""discrete_bubbles.py BUILD_FOLDER: a small version of examples/discrete-bubbles, 1.5 s of gas at 0.3 m/s, merging and
not, on 1 and 2 ranks: bubbles and momentum add up, the emulsion begins to turn, and the picture is drawn."""

import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np

import analyse
import picture
import run
from cohesion_studies import expected
from cohesion_tests.coupling.cases import exchange_lines

SOURCE = Path(__file__).resolve().parents[2]

BUILD = sys.argv.pop(1) if len(sys.argv) > 1 else str(SOURCE / "build")
TIME, STEP = 1.5, 0.025
SMALL = {run.REACTOR: {"endTime": TIME, "meanFrom": 1}, "system/controlDict": {"writeInterval": 0.5}}


class SmallReactors(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.keeper = tempfile.TemporaryDirectory(prefix="cohesion-")
        cls.addClassCleanup(cls.keeper.cleanup)
        env = run.environment(BUILD, ["lammps"])
        cls.cases, cls.logs = {}, {}
        for name, kind, ranks in (("fast", "fast", 1), ("merging", "fast-merging", 1), ("two-ranks", "fast-merging", 2)):
            job = run.Reactor(Path(cls.keeper.name) / name, env, "", kind, SMALL)
            job.prepare()
            cls.logs[name] = job.case.solve(ranks=ranks)
            if ranks > 1:
                job.case.run("reconstructPar")
            cls.cases[name] = job.folder
        cls.results = {name: analyse.figures(case) for name, case in cls.cases.items()}

    def test_bubbles_add_up(self):
        for name, found in self.results.items():
            with self.subTest(name):
                self.assertEqual(found["count_missing"], 0)
                self.assertLess(found["volume_missing"], 1e-5)  # six digits
                self.assertEqual(found["merged"] > 20, name != "fast")
                self.assertGreater(found["holdup"], 0.05)
        # Nothing has left: what came in is inside, the flow less what 49 nozzles wait with, a bubble each.
        came = self.results["fast"]["flow_kept"] * 0.3 * TIME
        self.assertLessEqual(0.3 * TIME - came, 49 * np.pi / 6 * 0.12**3)

    def test_emulsion_and_bubbles_balance(self):
        """Sums over some 1e3 bubbles and cells, each rounded to 1e-16; mergers and bubbles that come among them."""
        for name, log in self.logs.items():
            with self.subTest(name):
                lines = exchange_lines(log)
                self.assertEqual(len(lines), round(TIME / STEP))
                self.assertLess(max(line["imbalance"] for line in lines), 1e-12)
                self.assertNotIn("would grow", log)

    def test_emulsion_turns(self):
        """Until bubbles leave they displace their volume over the top, 0.3 m/s of the whole section in the mean: faster in
        the middle and slower at the walls."""
        for name in ("fast", "merging"):
            with self.subTest(name):
                self.assertGreater(self.results[name]["in_the_middle"], 0.3)
                self.assertLess(self.results[name]["at_the_walls"], 0.3)

    def test_picture_and_expectations(self):
        file = Path(self.keeper.name) / "result.png"
        picture.draw(file, [self.cases["merging"]])
        self.assertGreater(file.stat().st_size, 10000)
        kinds = {row["case"] for row in expected.rows(SOURCE / "examples/discrete-bubbles/expected.csv")}
        self.assertEqual(kinds, set(run.KINDS))


if __name__ == "__main__":
    unittest.main()
