# SPDX-License-Identifier: BSD-3-Clause
"""fluidised_bed.py BUILD_FOLDER short|brief: the main job of examples/fluidised-bed, or a shorter schedule in a case of
a quarter of the width, against its expectations. Takes over the results when this very build has run the job
already."""

import dataclasses
import math
import shutil
import subprocess
import sys
import unittest
from pathlib import Path

from cohesion_studies import expected, package_tree
from cohesion_studies.bed import analyse, figures
from cohesion_tests.narrow_bed import make_narrow

SOURCE = Path(__file__).resolve().parents[2]
BED = SOURCE / "examples/fluidised-bed"
BUILD, SCHEDULE = sys.argv.pop(1), sys.argv.pop(1)

# Of the pressure drop: Ergun's viscous coefficient is 150, that of Macdonald et al. (Ind. Eng. Chem. Fundam. 18 (1979)
# 199) for packed smooth spheres 180; the inertial ones, 1.75 and 1.8, differ less.
SCATTER = 0.2


def ergun_and_tolerance(bed, found):
    """Ergun's velocity at the mean void fraction, and by how much that of the bed may differ from it: two standard
    errors of the void fraction and two of the bed's velocity, and what SCATTER makes of the velocity at which the
    pressure drop is the weight, in squares."""
    mean, _, error = found["void_fraction"]
    velocity = bed.minimum_fluidisation(mean)
    scattered = dataclasses.replace(bed, gravity=bed.gravity / (1 + SCATTER)).minimum_fluidisation(mean)
    parts = (2 * (bed.minimum_fluidisation(mean + error) - velocity), 2 * found["velocities"].rising[1],
             velocity - scattered)
    return velocity, math.hypot(*parts)


# Gas velocities [m/s] of the narrow case: bubbles that mix it, rest, and the rising branch up to where it has opened.
# They last 0.35 s, 0.1 s and 0.05 s each: the gas passes the bed within 0.1 s, and pressure waves within 1 ms.
BUBBLING, REST, RISING = 1, 0, (0.3, 0.4, 0.5, 0.55, 0.6, 0.65, 0.7, 0.8, 0.9)


def schedule():
    """constant/schedule of these velocities, each changed within 1 ms."""
    rows, time = [], 0.0
    for velocity, lasts in ((BUBBLING, 0.35), (REST, 0.1), *((velocity, 0.05) for velocity in RISING)):
        rows += [(time + 0.001 * (time > 0), velocity), (time + lasts, velocity)]
        time += lasts
    table = "\n".join(f"    ({at:.6g} (0 {velocity} 0))" for at, velocity in rows)
    return f"superficialVelocity table\n(\n{table}\n);\n\nendTime {time:.6g};\nmovementStart 0;\n"


def narrow_case(folder):
    """The case in a quarter of the width, its brief schedule shorter; the words of run.py for it."""
    shutil.rmtree(folder, ignore_errors=True)
    shutil.copytree(BED / "case", folder)
    make_narrow(folder)
    (folder / "constant/schedule.brief").write_text(schedule())
    return "--case", str(folder)


class FluidisedBed(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        # Those of the main job are where scripts/run-bed leaves them.
        name = "fluidised-bed" if SCHEDULE == "short" else f"fluidised-bed-{SCHEDULE}"
        cls.out = package_tree.results(Path(BUILD), name)
        command = [sys.executable, str(BED / "run.py"), "--build", BUILD, "--out", str(cls.out), "--schedule", SCHEDULE]
        if SCHEDULE == "brief":
            command += narrow_case(cls.out.with_name(name + "-case"))
        cls.results = cls.run_of(command)
        cls.realisations = [cls.results]
        if SCHEDULE == "brief":  # a small bed: two of them
            other = cls.out.with_name(name + "-2")
            command[command.index("--out") + 1] = str(other)
            cls.realisations.append(cls.run_of([*command, "--seed", "1"], other))

    @classmethod
    def run_of(cls, command, out=None):
        if subprocess.run(command).returncode != 0:
            # Results of another build or of other settings: replace them.
            subprocess.run([*command, "--overwrite"], check=True)
        return {name: figures.evaluate((out or cls.out) / name) for name in ("non-cohesive", "Hamaker")}

    @unittest.skipIf(SCHEDULE == "brief", "its fluidised times are too short for the mean of the weight")
    def test_expected_figures(self):
        held = expected.held(BED / "expected.csv",
                             {name: figures.single(found) for name, found in self.results.items()})
        self.assertEqual(len(held), len(expected.rows(BED / "expected.csv")))
        self.assertTrue(any("balance" in line for line, _ in held), held)
        for line, holds in held:
            with self.subTest(line):
                self.assertTrue(holds, line)

    def test_minimum_fluidisation_is_ergun_s(self):
        """At the mean void fraction of the resting bed [m/s]."""
        free = self.results["non-cohesive"]
        ergun, tolerance = ergun_and_tolerance(analyse.Bed.read(self.out / "non-cohesive"), free)
        self.assertAlmostEqual(free["velocities"].rising[0], ergun, delta=tolerance)

    def test_cohesion_raises_it(self):
        """In the mean over the realisations, by more than three standard errors of the fits."""
        rise, square = 0.0, 0.0
        for results in self.realisations:
            free, cohesive = (results[name]["velocities"].rising for name in ("non-cohesive", "Hamaker"))
            rise += cohesive[0] - free[0]
            square += free[1] ** 2 + cohesive[1] ** 2
        self.assertGreater(rise, 3 * math.sqrt(square))

    def test_every_step_is_read_and_drawn(self):
        for name in self.results:
            with self.subTest(name):
                self.assertEqual(len(analyse.curve(self.out / name)), len(analyse.read_schedule(self.out / name)))
        self.assertGreater((self.out / "result.png").stat().st_size, 10000)
        self.assertIn("U_mf,th", (self.out / "result.txt").read_text())


if __name__ == "__main__":
    unittest.main()
