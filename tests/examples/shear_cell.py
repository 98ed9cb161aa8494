# SPDX-License-Identifier: BSD-3-Clause
"""shear_cell.py BUILD_FOLDER: a small version of examples/shear, 256 discs with and without wells:
script, block rule, resumed runs, analysis; the stress by kind is the whole, work is dissipation, without
wells kinetic theory holds."""

import math
import re
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np

import analyse
import claims
import events
import run
import sweep
from cohesion_tests.theory import sheared_discs as theory

SOURCE = Path(__file__).resolve().parents[2]

BUILD = sys.argv.pop(1) if len(sys.argv) > 1 else str(SOURCE / "build")
PHI, E, DISCS = 0.2, 0.9, 256
SIDE = math.sqrt(DISCS * math.pi / PHI)
RULE = sweep.Rule(200, 400, 4, 7, SIDE)
RUNS = [sweep.Run(PHI, D, 1.1, E) for D in (0, 4)]


class ShearCell(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.keeper = tempfile.TemporaryDirectory(prefix="cohesion-")
        cls.addClassCleanup(cls.keeper.cleanup)
        cls.out = Path(cls.keeper.name)
        cls.results = run.carry_out(cls.jobs(), 2)
        cls.free, cls.wells = cls.results

    @classmethod
    def jobs(cls, rule=RULE):
        return [run.ShearRun(r, rule, cls.out, run.launcher(BUILD)) for r in RUNS]

    def test_stress_by_kind_is_the_whole(self):
        """Means over the same samples and time: the same but for round-off of totals over 1e5 events and
        the 15 digits that are printed."""
        for result in self.results:
            self.assertEqual(result["settings"]["count"], DISCS)
            for component in ("xx", "yy", "xy"):
                parts = [result[f"{kind}_{component}"][0] for kind in analyse.KINDS]
                self.assertAlmostEqual(sum(parts), result[f"stress_{component}"][0],
                                       delta=1e-10 * sum(map(abs, parts)))
        for kind in ("approach", "escape", "capture"):
            self.assertEqual(self.free[f"{kind}_xx"], [0, 0])
            self.assertNotEqual(self.wells[f"{kind}_xx"][0], 0)

    def test_work_is_dissipation(self):
        """What the shear does per area and time, stress x rate, is lost in collisions, but for what the own
        motion has gained from end to end: T rho pi over the strain, its spread sqrt(2/DISCS) of it twice."""
        for result in self.results:
            (work, a), (loss, b) = result["stress_xy"], result["dissipated"]
            stored = 2 * math.sqrt(2 / DISCS) * PHI * result["temperature"][0] / result["strain"]
            self.assertLess(abs(work - loss), 3 * math.hypot(a, b) + stored)
            self.assertLess(3 * math.hypot(a, b) + stored, 0.1 * work)

    def test_without_wells_kinetic_theory(self):
        """As tests/lammps-package/steady_shear.py: T larger by up to 2.2 % (velocities that are no Gaussian)
        and what waves add; the pressure of collisions goes with T; four standard errors."""
        expected = theory.steady(PHI, E)
        T, error = (v / 4 for v in self.free["temperature"])  # per diameter^2
        waves = theory.waves(PHI, expected, SIDE / 2)  # in diameters
        sampling = 4 * error / expected.temperature
        self.assertLess(sampling, 0.1)
        self.assertGreater(T / expected.temperature, 1 - sampling)
        self.assertLess(T / expected.temperature, 1 + 0.022 + waves + sampling)
        pressure = (self.free["collision_xx"][0] + self.free["collision_yy"][0]) / math.pi / T
        self.assertLess(abs(pressure / (np.trace(expected.impulsive) / expected.temperature) - 1), 0.022)

    def test_ends_by_the_rule_or_the_limit(self):
        """By the changes that the log tells in per cent with two digits: all that are waited for below their
        tolerances, or one that is not after the last block."""
        for run_, result in zip(RUNS, self.results):
            log = (self.out / "runs" / run_.name / "log").read_text()
            changes = [float(x) for x in re.findall(r"last change (\S+) %", log)]
            self.assertEqual(len(changes), len(analyse.WATCHED))
            tolerances = (1, 1, 1) if run_.D == 0 else (1, 1, 1, 2, 2)
            if result["stationary"]:
                self.assertTrue(all(c <= t for c, t in zip(changes, tolerances)), changes)
                self.assertLessEqual(result["blocks"], RULE.most)
            else:
                self.assertTrue(any(c >= t for c, t in zip(changes, tolerances)), changes)
                self.assertEqual(result["blocks"], RULE.most)
            self.assertGreaterEqual(result["blocks"], 2)
            # A collision has two partners; blocks end at the next sample.
            collisions = 2 * result["collisions"][0] * result["strain"]
            self.assertGreater(collisions, 0.9 * (RULE.start + result["blocks"] * RULE.block))

    def test_finished_runs_are_taken_over(self):
        before = [(job.folder / "log").stat().st_mtime_ns for job in self.jobs()]
        for job, result in zip(self.jobs(), self.results):
            job.dt *= 2  # as of a run that was started once more: the step is the log's
            self.assertEqual(job.figures()["dt"], result["dt"])
        run.require_ours(self.jobs(), run.MARK)
        again = run.carry_out(self.jobs(), 2)
        self.assertEqual(again, self.results)
        with self.assertRaisesRegex(run.RunError, "--overwrite"):
            run.require_ours(self.jobs(RULE._replace(most=RULE.most + 1)), run.MARK)
        self.assertEqual([(job.folder / "log").stat().st_mtime_ns for job in self.jobs()], before)
        self.assertTrue(all(job.result() is None for job in self.jobs(RULE._replace(seed=8))))

    def test_agglomerates_only_with_wells(self):
        self.assertEqual(self.free["largest"][0], 1 / DISCS)
        self.assertEqual(self.free["size"][0], 0)
        self.assertGreaterEqual(self.wells["size"][0], 2)
        self.assertGreater(self.wells["duration"][0], 0)
        sizes = np.loadtxt(self.out / "runs" / RUNS[1].name / "discs.txt", skiprows=9)[:, 3]
        self.assertEqual(len(sizes), DISCS)
        # Each agglomerate of n has n discs of size n.
        self.assertTrue({1, 2} <= set(sizes))
        for n in set(sizes):
            self.assertEqual(np.count_nonzero(sizes == n) % n, 0)


    def test_record_of_events(self):
        """By capture and escape, in wells so thin that held pairs are the same; every collision is recorded."""
        thin = sweep.starred(0.3, sweep.TEN)
        with tempfile.TemporaryDirectory(prefix="cohesion-") as name:
            job = run.ShearRun(thin, sweep.Rule(60, 30, 4, 7, 50), Path(name), run.launcher(BUILD), record=True)
            result, = run.carry_out([job], 1)
            self.assertFalse((job.folder / "events.txt").exists())
        hits = result["recorded"]["collision"]
        self.assertLess(abs(hits / (result["collisions"][0] * result["strain"] * result["settings"]["count"]) - 1), 0.1)
        for quantity in ("duration", "size"):
            (a, da), (b, db) = result[f"captured_{quantity}"], result[quantity]
            self.assertLess(abs(a - b), 4 * math.hypot(da, db))
        (along, error) = result["free_along_shear"]
        self.assertGreater(along - 3 * error, 0.5)


class Events(unittest.TestCase):
    def test_nearest_images_of_a_tilted_box(self):
        at = np.array([[0, 0], [1, 9.5], [8, 0.5]])
        np.testing.assert_allclose(events.separation((10, 3, at), 1, 2), (0, 1))

    def test_along_the_shear(self):
        """The upper disc is the faster one: from behind, then before the other."""
        for x, along in ((-1, True), (1, False)):
            at = np.array([[0, 0], [5, 5], [5 + x, 6]])
            self.assertEqual(events.along_shear({3: (50, 0, at), 4: (50, 0, at)}, 3.5, 1, 2), along)
        self.assertIsNone(events.along_shear({}, 3.5, 1, 2))

    def test_size(self):
        self.assertEqual(events.size({1: {2}, 2: {1, 3}, 3: {2}, 5: {6}, 6: {5}}), 2.5)


class Claims(unittest.TestCase):
    def test_trend(self):
        up, same, down = ([(1, 0.1), (m, 0.1)] for m in (2, 1.1, 0))
        for sets, verdict in (([up, up], "agrees"), ([up, up, same], "agrees"), ([up, same], "cannot tell"), ([same, same, up], "cannot tell"),
                              ([up, up, down], "differs")):
            self.assertEqual(claims.trend("", [("", s) for s in sets], 1)[2], verdict)

    def test_report_of_made_up_runs(self):
        """All quantities grow with D* and the width: claims that they fall differ, claims that they grow agree."""
        quantities = [*(f"stress_{c}" for c in ("xx", "yy", "xy")), "duration", "size",
                      *(f"{kind}_{c}" for kind in analyse.KINDS for c in ("xx", "xy")), "captured_duration",
                      "captured_size", "free_along_shear", "captured_along_shear"]

        def made(run, record):
            return {"settings": {**run._asdict(), "record": record}, "stationary": 1, "processor_seconds": 1,
                    "elastic": 0, **{q: [1 + run.D + run.w, 1e-3] for q in quantities}}
        text = claims.report([made(run, "no") for run, _ in sweep.thesis()]
                             + [made(run, "yes") for run, _ in sweep.recorded()])
        self.assertIn("stress_xx falls with D*: DIFFERS", text)
        self.assertIn("collision part of tau_xx rises with D*: AGREES", text)
        self.assertIn("duration grows with r_out/r: AGREES", text)
        self.assertIn("of captured pairs against it: DIFFERS", text)


class Reading(unittest.TestCase):
    def test_transition_is_between_neighbours(self):
        def result(phi, largest):
            return {"settings": sweep.Run(phi, 8, sweep.WIDTH, sweep.RESTITUTION)._asdict(),
                    "largest": [largest, 0.0]}
        found = analyse.transition(analyse.Results([result(0.3, 0.4), result(0.1, 0.01),
                                                    result(0.2, 0.02)]), 8)
        self.assertAlmostEqual(found[0], 0.25)
        self.assertAlmostEqual(found[1], 0.05)
        self.assertIsNone(analyse.transition(analyse.Results([result(0.3, 0.01)]), 8))

    def test_rises(self):
        self.assertEqual(analyse.rises([(1, 0.1), (2, 0.1), (3, 0.1)]), "agrees")
        self.assertEqual(analyse.rises([(1, 0.1), (2, 0.1), (1.9, 0.1)]), "cannot tell")
        self.assertEqual(analyse.rises([(1, 0.1), (2, 0.1), (1, 0.1)]), "differs")

    def test_errors_are_shown_with_two_digits(self):
        self.assertEqual(analyse.show((12.345, 0.0123)), "12.345 +- 0.012")
        self.assertEqual(analyse.show((1234.5, 12.3)), "1234 +- 12")


if __name__ == "__main__":
    unittest.main()
