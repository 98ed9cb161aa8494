# SPDX-License-Identifier: BSD-3-Clause
"""free_cooling.py BUILD_FOLDER: a small version of examples/free-cooling: Haff's law with the rate of kinetic theory,
energy, agglomerates where the gas is as cold as the wells are deep; the theory beside sampled encounters; what the
example expects and reads."""

import math
import re
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np

import analyse
import run
import theory
from cohesion_studies import expected
from cohesion_studies.job_pool import carry_out
from cohesion_studies.lammps_run import tables

SOURCE = Path(__file__).resolve().parents[2]

BUILD = sys.argv.pop(1) if len(sys.argv) > 1 else str(SOURCE / "build")
SMALL = {"side": 10, "intervals": 16}
WELLS = {"side": 8, "intervals": 16, "D": 0.2}
GAS = theory.Gas(0.1, 0.9)


class SmallGas(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.keeper = tempfile.TemporaryDirectory(prefix="cohesion-")
        cls.addClassCleanup(cls.keeper.cleanup)
        engine = run.launcher(BUILD)
        cls.jobs = [run.Cooling(Path(cls.keeper.name), engine, kind, seed, **changed)
                    for kind, seed, changed in (("small", 1, SMALL), ("small", 2, SMALL), ("wells", 1, WELLS))]
        cls.results = carry_out(cls.jobs, 2)
        cls.free, cls.wells = cls.results[:2], cls.results[2]

    def test_haffs_law_with_the_rate_of_kinetic_theory(self):
        """The rate within four standard errors of two runs, 0.028, and downwards twice what common motion takes, 0.027:
        theory.py. The exponent of one run is as uncertain as 0.049, the same noise drawn 300 times; four errors of
        two."""
        count = SMALL["side"]**3
        error = 4 * GAS.scatter(count, 1.1**SMALL["intervals"]) / math.sqrt(2)
        self.assertLess(error, 0.03)
        rate = np.mean([result["rate"] for result in self.free])
        self.assertLess(rate, 1 + error)
        self.assertGreater(rate, 1 - error - 3 * GAS.common_motion(count))
        self.assertAlmostEqual(np.mean([result["exponent"] for result in self.free]), 2, delta=4 * 0.049 / math.sqrt(2))

    def test_collisions_and_what_they_take(self):
        """Collisions are events of a Poisson process: their number in two runs, and the mean of what each takes, which
        has the deviation of its mean, within four standard errors; common motion as above."""
        for name in ("frequency", "loss"):
            found = np.mean([result[name] for result in self.free])
            all_collisions = sum(result["collisions_each"] for result in self.free) * SMALL["side"]**3 / 2
            error = 4 / math.sqrt(all_collisions)
            self.assertLess(error, 0.025)
            self.assertAlmostEqual(found, 1, delta=error + 3 * GAS.common_motion(SMALL["side"]**3))

    def test_energy_of_motion_wells_and_collisions_is_kept(self):
        """To digits: 15, summed up over some 1e5 events."""
        for job in self.jobs:
            found, count = analyse.cooling(job.log()), job.given["side"]**3
            potential = np.array([tables(job.log())[1]["PotEng"][0], *found["potential"][1:]])
            whole = 1.5 * (count - 1) * found["temperature"] + potential + found["lost"]
            self.assertLess(np.ptp(whole) / (1.5 * count), 1e-9)
            self.assertEqual(found["elastic"][-1], 0)
        self.assertLess(potential[-1], potential[0] - 100 * WELLS["D"])

    def test_wells_quicken_and_gather_where_it_is_as_cold_as_they_are_deep(self):
        """Spheres that come with about the depth are captured: the temperature is of the order of the depth. Without
        wells the rate of a run is 1 within some 0.03."""
        self.assertGreater(self.wells["rate"], 1.1)
        self.assertGreater(self.wells["gathered_at"], 1 / 3)
        self.assertLess(self.wells["gathered_at"], 3)
        self.assertGreater(self.wells["largest_end"], analyse.LARGE)
        for result in self.free:
            self.assertTrue(math.isnan(result["gathered_at"]))

    def test_times_are_those_of_the_steps(self):
        """Steps by their length, which the log has with some six digits."""
        for job in self.jobs:
            steps = [np.ptp(table["Step"]) for table in tables(job.log())]
            lengths = [float(words) for words in re.findall(r"^\s*Time step\s*:\s*(\S+)", job.log(), re.M)]
            self.assertEqual(len(steps), len(lengths))
            self.assertEqual(len(steps), 2 + job.given["intervals"])  # the gas before, and its last step once more
            passed = np.dot(steps[2:], lengths[2:])
            self.assertAlmostEqual(passed / analyse.cooling(job.log())["time"][-1], 1, delta=1e-5)

    def test_expected_are_figures_of_kinds_of_run(self):
        for row in expected.rows(run.HERE / "expected.csv"):
            self.assertIn(row["case"], [kind for kind, _, _ in run.KINDS])
            self.assertIn(row["quantity"], self.free[0])

    def test_finished_runs_are_taken_over(self):
        before = [(job.folder / "log").stat().st_mtime_ns for job in self.jobs]
        self.assertEqual(str(carry_out(self.jobs, 2)), str(self.results))  # as texts, in which nan is nan
        self.assertEqual([(job.folder / "log").stat().st_mtime_ns for job in self.jobs], before)


class Theory(unittest.TestCase):
    def test_rate_and_frequency_are_those_of_sampled_encounters(self):
        """Pairs of Maxwell's velocities, an impact parameter for each: 4e5 encounters, flux g, what one takes (1 - e^2)
        u^2/4, u along the centres. The mean of g^3 over pairs has a deviation of about 1.5 times it: 0.0024; four
        errors 0.01. Without a2, which is a factor of 1 + 3 a2/16 and 1 - a2/16."""
        gas, number = theory.Gas(0.1, 0.8), 400000
        draw = np.random.default_rng(3)
        g = np.linalg.norm(draw.standard_normal((number, 3)) * math.sqrt(2), axis=1)
        u2 = g**2 * (1 - draw.random(number))
        flux = math.pi * gas.n * gas.g0 * g
        self.assertAlmostEqual(flux.mean() / gas.frequency * (1 - gas.a2 / 16), 1, delta=0.01)
        lost = (flux * (1 - gas.e**2) * u2 / 4).mean() / 2  # each encounter is of two spheres
        self.assertAlmostEqual(lost * 2 / 3 / gas.zeta * (1 + 3 * gas.a2 / 16), 1, delta=0.01)

    def test_a2_is_that_of_the_paper(self):
        """van Noije and Ernst: nothing at e = 1 and at e = 1/sqrt(2), 16/81 at e = 0."""
        self.assertAlmostEqual(theory.Gas(0.1, 1 - 1e-12).a2, 0, delta=1e-12)
        self.assertAlmostEqual(theory.Gas(0.1, math.sqrt(0.5)).a2, 0, delta=1e-15)
        self.assertAlmostEqual(theory.Gas(0.1, 0).a2, 16 / 81, delta=1e-15)

    def test_wells_of_no_depth_leave_haffs_law(self):
        t = np.array([0.0, 1.0, 10.0, 300.0])
        self.assertTrue(np.allclose(GAS.with_wells(t, 1e-12), GAS.haff(t), rtol=1e-6))

    def test_with_wells_solves_its_equation(self):
        """By differences of 1e-4 of tau: their error is of the order of 1e-8."""
        D, t, h = 0.02, 3 * GAS.tau, 1e-4 * GAS.tau
        before, T, after = GAS.with_wells([t - h, t, t + h], D)
        self.assertAlmostEqual((after - before) / (2 * h) / (-GAS.zeta * T**1.5 * (1 + D / T)), 1, delta=1e-6)


class Reading(unittest.TestCase):
    def test_exponent_of_power_laws(self):
        t = 18 * (1.1**np.arange(33) - 1)
        for alpha, tau in ((2, 18), (1.2, 30), (3, 9)):
            found = analyse.exponent({"time": t, "temperature": (1 + t / tau)**-alpha})
            self.assertAlmostEqual(found[0] / alpha, 1, delta=1e-3)
            self.assertAlmostEqual(found[1] / tau, 1, delta=2e-3)

    def test_collisions_and_loss_of_haffs_law(self):
        """A gas that does as the theory says: exactly 1 but for its momentum, one part in `count`."""
        t = GAS.tau * (1.1**np.arange(17) - 1)
        count = 1000
        collisions = count / 2 * GAS.frequency * GAS.tau * np.log1p(t / GAS.tau)
        found = {"time": t, "temperature": GAS.haff(t), "collisions": collisions}
        frequency, loss = analyse.collisions_and_loss(found, GAS, count)
        self.assertAlmostEqual(frequency, 1, delta=1e-9)
        self.assertAlmostEqual(loss, 1 - 1 / count, delta=1e-9)

    def test_shear_energy_of_a_wave(self):
        """All motion in one of the six modes: N/4 of the equal share, for a wave has two phases, and half of its square
        is the mean."""
        n, side = 8, 5.0
        grid = (np.stack(np.meshgrid(*3 * [np.arange(n)], indexing="ij"), -1).reshape(-1, 3) + 0.3) * side / n
        wave = np.sin(2 * np.pi * grid[:, 1] / side + 0.4)
        with tempfile.TemporaryDirectory(prefix="cohesion-") as folder:
            rows = np.column_stack([np.arange(n**3), grid, np.ones(n**3), wave, 0 * wave, 0 * wave])
            np.savetxt(Path(folder) / "spheres-end.txt", rows, header="\n" * 8, comments="")
            self.assertAlmostEqual(analyse.shear_energy(folder, side) / (n**3 / 4), 1, delta=1e-9)


if __name__ == "__main__":
    unittest.main()
