# SPDX-License-Identifier: BSD-3-Clause
"""error_against_run_time.py BUILD_FOLDER: examples/error-against-run-time on made-up errors and noise, on a
program whose error is known, on wrong scenes, and on its own scene of couples."""

import csv
import math
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np

import compare
import job
from scene import Scene, SceneError, Setting

SOURCE = Path(__file__).resolve().parents[2]
EXAMPLE = SOURCE / "examples/error-against-run-time"

BUILD = sys.argv.pop(1) if len(sys.argv) > 1 else str(SOURCE / "build")

# Explicit Euler of x' = -x from 1 over a time of 1, with noise on demand.
EULER = """
title: decay
command: [%s, -c, "import random; n = round(1/{dt}); x = (1 - {dt})**n; random.seed({seed});
  print('Step x'); [print(k, x + {noise}*random.gauss(0, 1)) for k in range(200)];
  print('Loop time of %%g on 1 procs' %% (1e-3*n)); print('100.0%% CPU use')"]
variables: {noise: 0}
step: {variable: dt, unit: s}
schemes:
  euler: {steps: [0.1, 0.05, 0.025, 0.0125]}
seeds: {variable: seed, count: 3}
quantities:
  x: {column: x, take: mean, reference: %.17g}
""" % (sys.executable, math.exp(-1))


def row(step, error, margin=0.0, seconds=None, scheme="s", failure=""):
    return compare.Row(Setting(scheme, step), error, margin, 3 * (seconds or 1 / step,), failure)


class Folder(unittest.TestCase):
    def setUp(self):
        keeper = tempfile.TemporaryDirectory(prefix="cohesion-")
        self.addCleanup(keeper.cleanup)
        self.folder = Path(keeper.name)

    def write(self, text, name="scene.yaml"):
        (self.folder / name).write_text(text)
        return self.folder / name

    def run_py(self, file, *words):
        return subprocess.run([sys.executable, EXAMPLE / "run.py", file, "--build", BUILD, "--out",
                               self.folder / "out", *words], text=True, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT)

    def rows(self, name="scene"):
        with open(self.folder / "out" / name / "result.csv") as file:
            return list(csv.DictReader(file))


class Advice(unittest.TestCase):
    def test_front_and_recommendation(self):
        """Two schemes, errors dt and 0.01 dt, the second twice as dear."""
        coarse = [row(dt, dt) for dt in (0.1, 0.01, 0.001)]
        fine = [row(dt, 0.01 * dt, seconds=2 / dt, scheme="f") for dt in (0.1, 0.01)]
        rows = coarse + fine
        self.assertEqual(compare.front(rows), [coarse[0], fine[0], fine[1]])
        self.assertEqual(compare.recommended(rows, 0.2), coarse[0])
        self.assertEqual(compare.recommended(rows, 0.02), fine[0])
        self.assertIsNone(compare.recommended(rows, 1e-6))
        # Power laws: exact but for round-off.
        self.assertAlmostEqual(compare.order(coarse), 1.0, delta=1e-12)
        for found, known in zip(compare.at_error(coarse, 0.03), (0.03, 1 / 0.03)):
            self.assertAlmostEqual(found / known, 1.0, delta=1e-12)

    def test_what_is_not_known_is_not_recommended(self):
        unknown, noisy = row(0.1, 1e-6, math.nan), row(0.05, 1e-6, 0.1)
        lost, sure = row(0.2, math.nan, math.nan, failure="lost"), row(0.01, 1e-3, 1e-3)
        rows = [lost, unknown, noisy, sure]
        self.assertEqual(compare.recommended(rows, 0.01), sure)
        self.assertFalse(compare.resolved(noisy) or compare.resolved(unknown) or compare.resolved(lost))
        self.assertIsNone(compare.order(rows))
        self.assertIsNone(compare.at_error([lost, unknown, noisy], 0.01))
        self.assertNotIn(lost, compare.front(rows))


class Chance(unittest.TestCase):
    SEEDS, TRIALS = 4, 800

    def covered(self, quantity, outcomes, truth):
        """How often truth lies within error +- margin. With 95 % each, the share of 800 trials has a
        standard deviation of 0.0077; four of them are allowed."""
        hits = 0
        for references, runs in outcomes:
            error, margin = compare.deviation(quantity, runs, references)
            hits += abs(error - truth) <= margin
        self.assertAlmostEqual(hits / len(outcomes), 0.95, delta=0.031)

    def scene(self, reference):
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "s.yaml"
            file.write_text("command: [x]\nschemes: {a: {steps: [0.1, 0.01]}}\nseeds: {variable: s, count: 4}\n"
                            f"quantities: {{q: {{column: q, take: mean, relative_to: 1, reference: {reference}}}}}\n")
            return Scene(file).quantities[0]

    @staticmethod
    def outcome(value, block=None):
        return job.Outcome({"q": (value, block)}, 1.0, {})

    def test_of_seeds(self):
        """An error of 3 in noise of 0.3: the interval of Student's t, which is exact for normal noise."""
        random = np.random.default_rng(1)
        quantity = self.scene(5)
        self.covered(quantity, [(None, [self.outcome(8 + 0.3 * n) for n in random.normal(size=self.SEEDS)])
                                for _ in range(self.TRIALS)], 3)

    def test_of_seeds_in_common_with_the_reference(self):
        """Each seed has its own start, far more different than the noise: it cancels."""
        random = np.random.default_rng(2)
        quantity, outcomes = self.scene("finest"), []
        for _ in range(self.TRIALS):
            starts = 100 * random.normal(size=self.SEEDS)
            outcomes.append(([self.outcome(x + 0.3 * random.normal()) for x in starts],
                             [self.outcome(x + 3 + 0.3 * random.normal()) for x in starts]))
        self.covered(quantity, outcomes, 3)

    def test_of_blocks(self):
        """One seed, 1000 independent samples in time."""
        random = np.random.default_rng(3)
        quantity = self.scene(5)
        self.covered(quantity, [(None, [self.outcome(*job.reduce(8 + 0.3 * random.normal(size=1000), "mean"))])
                                for _ in range(self.TRIALS)], 3)

    def test_one_seed_of_too_few_rows_is_not_known(self):
        error, margin = compare.deviation(self.scene(5), [self.outcome(*job.reduce(np.arange(7.0), "mean"))], None)
        self.assertEqual(error, 2.0)
        self.assertTrue(math.isnan(margin))


class KnownProgram(Folder):
    def test_errors_times_and_table(self):
        """Euler's own error is known exactly: (1 - dt)^n against exp(-1); ten digits come through."""
        done = self.run_py(self.write(EULER), "--wish", "0.03")
        self.assertEqual(done.returncode, 0, done.stdout)
        for found in self.rows():
            dt = float(found["dt"])
            known = abs((1 - dt)**round(1 / dt) / math.exp(-1) - 1)
            self.assertAlmostEqual(float(found["error"]) / known, 1.0, delta=1e-5)  # six digits in the table
            self.assertLess(float(found["margin"]), 1e-15)
            self.assertAlmostEqual(float(found["seconds"]), 1e-3 / dt, delta=1e-9)
            self.assertEqual(found["front"], "yes")
        self.assertIn("recommended euler, dt 0.05 s: 0.02 s", done.stdout)
        self.assertTrue((self.folder / "out/scene/result.png").stat().st_size > 1000)
        slope = float(re.search(r"error goes as dt\^(\S+)", done.stdout)[1])
        # Second-order terms at dt = 0.1: 5 dt/12 of the error, against 5 dt/96.
        self.assertAlmostEqual(slope, 1.0, delta=0.03)

    def test_noise_is_told_apart(self):
        """Noise of 10 in the mean of 200 rows of three seeds is 0.4, far above all errors: none is known."""
        done = self.run_py(self.write(EULER), "--set", "noise=10", "--wish", "0.03")
        self.assertEqual(done.stdout.count(", not resolved\n"), 4, done.stdout)
        self.assertIn("no setting here is surely that good", done.stdout)

    def test_command_line_changes_the_scene(self):
        self.run_py(self.write(EULER), "--seeds", "1", "--steps", "euler=0.2,0.1")
        self.assertEqual([float(r["dt"]) for r in self.rows()], [0.2, 0.1])

    def test_runs_that_fail_are_told_and_others_go_on(self):
        text = EULER.replace("n = round(1/{dt})", "n = round(1/{dt}) if {dt} < 0.06 else 1/0")
        done = self.run_py(self.write(text))
        self.assertEqual(done.returncode, 0, done.stdout)
        failures = [r["failure"] for r in self.rows()]
        self.assertIn("ZeroDivisionError", failures[0])
        self.assertEqual(failures[1:], ["", "", ""])

    def test_quantity_that_is_lost_leaves_the_others(self):
        text = EULER + "  y: {column: y, reference: 1}\n  z: {column: x, reference: finest}\n"
        done = self.run_py(self.write(text.replace("n = round(1/{dt})", "n = round(1/{dt}) if {dt} > 0.02 else 1/0")))
        self.assertEqual(done.returncode, 0, done.stdout)
        found = {(row["quantity"], float(row["dt"])): row["failure"] for row in self.rows()}
        self.assertEqual(found["x", 0.1], "")
        self.assertIn("no column 'y'", found["y", 0.1])
        self.assertIn("reference: ended with code 1", found["z", 0.1])

    def test_no_run_at_all_is_an_error(self):
        done = self.run_py(self.write(EULER.replace("n = round(1/{dt})", "1/0")))
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("no run that succeeded", done.stdout)

    def test_columns_of_a_file(self):
        file = self.write("# t, speed\n0, 1\n1, 3\n", "out.csv")
        np.testing.assert_array_equal(job.columns(file)["speed"], [1, 3])
        file = self.write("# t speed\n0 1\n1 nan\n", "out.txt")
        np.testing.assert_array_equal(job.columns(file)["speed"], [1, math.nan])


class WrongScenes(Folder):
    def test_each_says_what_and_what_is_right(self):
        good = EULER
        for change, to, words in (
                ("title:", "titel:", ["unknown entry 'titel'", "title"]),
                ("command:", "script: in.none\nx:", ["unknown entry 'x'"]),
                ("take: mean", "take: median", ["take 'median'", "mean"]),
                ("0.0125]", "-0.0125]", ["no numbers above zero", "scheme 'euler'"]),
                ("take: mean", "from: late", ["from 'late'", "a number"]),
                ("take: mean", "relative_to: 0", ["relative_to 0", "above zero"]),
                ("0.0125]", "fine]", ["no numbers above zero"]),
                ("column: x", "colunm: x", ["unknown entry 'colunm'", "column"]),
                ("variable: seed, ", "", ["3 seeds", "variable"]),
                (f"reference: {math.exp(-1):.17g}", "reference: 0", ["reference of 0", "relative_to"]),
                (f"reference: {math.exp(-1):.17g}", "reference: best", ["reference 'best'", "finest"]),
                (f"reference: {math.exp(-1):.17g}", "reference: finest heun", ["finest heun", "euler"]),
                ("schemes:", "scheme:", ["unknown entry 'scheme'"])):
            with self.subTest(to):
                self.assertIn(change, good)
                with self.assertRaises(SceneError) as caught:
                    Scene(self.write(good.replace(change, to)))
                for word in words:
                    self.assertIn(word, str(caught.exception))
        with self.assertRaises(SceneError):
            Scene(self.folder / "none.yaml")
        with self.assertRaises(SceneError):
            Scene(self.write(good), steps={"heun": ["0.1"]})
        file = self.write(good.replace("steps: [0.1", "variables: {method: x}, steps: [0.1"))
        for name, right in (("dt", "--steps"), ("seed", "--seeds"), ("method", "edit the scene"), ("nois", "noise")):
            with self.assertRaisesRegex(SceneError, f"--set {name}: .*{right}"):
                Scene(file, variables={name: "1"})
        with self.assertRaisesRegex(SceneError, "count 0"):
            Scene(file, seeds=0)
        for change, to, says in (("{noise}*", "{noize}*", "'{noize}'"), ("count: 3", "count: some", "count 'some'"),
                                 ("variables: {noise: 0}", "variables:", "'{noise}'")):
            with self.assertRaisesRegex(SceneError, says):
                Scene(self.write(good.replace(change, to)))
        with self.assertRaisesRegex(SceneError, "repeats 1.5"):
            Scene(self.write(good + "repeats: 1.5\n"))

    def test_column_that_is_not_there(self):
        done = self.run_py(self.write(EULER.replace("column: x", "column: y")))
        self.assertIn("no column 'y' in the thermo output; there are Step, x", done.stdout)


class OwnScenes(Folder):
    def test_couples(self):
        """The exact scheme is right to the finest grade, 1e-4, at any step; sampled forces are off by
        10 to 80 % at the bed's step, as the couple's energy depends on where in the step it touches."""
        done = self.run_py(EXAMPLE / "scenes/couples.yaml", "--steps", "exact=5e-6,2.25e-5", "--steps",
                           "sampled=5e-6,2.25e-5")
        self.assertEqual(done.returncode, 0, done.stdout)
        found = {(r["scheme"], float(r["dt"])): float(r["error"]) for r in self.rows("couples")}
        for step in (5e-6, 2.25e-5):
            self.assertLess(found["exact", step], 1.5e-4)
        self.assertGreater(found["sampled", 2.25e-5], 0.1)
        self.assertLess(found["sampled", 5e-6], found["sampled", 2.25e-5])
        self.assertIn("recommended exact, dt 2.25e-05 s", done.stdout)

    def test_all_can_be_read(self):
        names = [Scene(file).name for file in sorted((EXAMPLE / "scenes").glob("*.yaml"))]
        self.assertEqual(names, ["bed", "couples", "gas", "restitution", "settling", "sheared-discs"])

    def test_numbers_of_the_couples(self):
        """Escape velocity and restitution in the scene files are those of the pair that the tests integrate."""
        import os
        os.environ.update(COHESION_LMP="none", COHESION_PLUGIN="none")
        from cohesion_tests.theory import pair_motion as pair
        known = Scene(EXAMPLE / "scenes/couples.yaml").variables
        self.assertAlmostEqual(known["speed"] / pair.Pair(7.49e-19).escape_velocity(), 1.0, delta=1e-8)
        for name in ("couples", "restitution"):
            e = Scene(EXAMPLE / f"scenes/{name}.yaml").variables["e"]
            self.assertAlmostEqual(e, math.exp(-math.pi * pair.ALPHA / pair.Q), delta=1e-9)


if __name__ == "__main__":
    unittest.main()
