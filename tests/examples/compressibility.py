# SPDX-License-Identifier: BSD-3-Clause
"""compressibility.py BUILD_FOLDER: a small version of examples/compressibility: pressure of hard and of soft gases, power,
viscosity of a sheared one; its theory and its readers beside closed forms; what the example expects and reads."""

import math
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np

import analyse
import laws
import run
import theory
from cohesion_studies import expected, study_table
from cohesion_studies.job_pool import carry_out

SOURCE = Path(__file__).resolve().parents[2]

BUILD = sys.argv.pop(1) if len(sys.argv) > 1 else str(SOURCE / "build")
SMALL = {"elastic": {"side": 6, "collisions": 400},
         "driven": {"side": 6, "e": 0.8, "by": "random", "collisions": 200},
         "rescaled": {"side": 6, "e": 0.8, "by": "rescale", "collisions": 200},
         "dense": {"side": 6, "phi": 0.5, "collisions": 400},
         "wells": {"side": 6, "D": 0.6, "w": 1.05, "by": "rescale", "collisions": 400},
         "redrawn": {"side": 6, "D": 0.6, "w": 1.05, "by": "redraw", "collisions": 400},
         "soft": {"script": "soft", "side": 6, "e": 0.9, "by": "random", "K": 20000, "collisions": 100},
         "sheared": {"script": "flow", "side": 6, "rate": 0.4, "collisions": 400}}
# Of y, over the root of the number of collisions: impulses of collisions, and how many there are, of 1000 spheres at 0.3.
SCATTER = 0.8


class SmallGases(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.keeper = tempfile.TemporaryDirectory(prefix="cohesion-")
        cls.addClassCleanup(cls.keeper.cleanup)
        engine = run.launcher(BUILD)
        cls.table = {name: {**run.KNOWN, **row} for name, row in SMALL.items()}
        cls.jobs = [run.SCRIPTS[row["script"]](Path(cls.keeper.name), engine, name, row, 1)
                    for name, row in cls.table.items()]
        results = carry_out(cls.jobs, 2)
        cls.found = laws.rows(study_table.by_kind(cls.jobs, results), cls.table)

    def assertPressure(self, name, value, expectation=1.0, more=0.0):
        """Within four standard errors, and what as few as 216 spheres make of it: one part in their number."""
        row = self.table[name]
        error = 4 * SCATTER / math.sqrt(row["collisions"] * 216 / 2)
        self.assertLess(error, 0.035)
        self.assertAlmostEqual(self.found[name][value], expectation, delta=error + 1 / 216 + more)

    def test_elastic_spheres_have_the_pressure_of_the_equation_of_state(self):
        self.assertPressure("elastic", "y_over_cs")
        self.assertPressure("dense", "y_over_cs", more=0.014)  # half of what laws differ by there
        for name in ("elastic", "dense"):
            pair = self.found[name]
            self.assertAlmostEqual(pair["y_events"] / pair["y"], 1, delta=0.013)  # four of 0.52/sqrt(43200), and drift

    def test_driven_spheres_have_the_share_of_the_momentum(self):
        """(1 + e)/2 to 4 %: neighbours that move together meet more softly."""
        for name in ("driven", "rescaled"):
            self.assertPressure(name, "y_over_cs", more=0.04)

    def test_power_put_in_is_power_lost(self):
        """To rounding with hard spheres, whose temperature is what it was; with soft ones see the test of the fix."""
        for name in ("driven", "rescaled"):
            self.assertAlmostEqual(self.found[name]["power"], 1, delta=1e-9)
        self.assertAlmostEqual(self.found["soft"]["power"], 1, delta=2e-3)

    def test_velocities_drawn_anew_leave_the_pressure(self):
        """Of wells: both ways keep the temperature, and differ by a part in the number of spheres."""
        redrawn, rescaled = self.found["redrawn"], self.found["wells"]
        error = 4 * math.hypot(redrawn["y_over_cs_error"], rescaled["y_over_cs_error"])
        self.assertLess(error, 0.1)
        self.assertAlmostEqual(redrawn["y_over_cs"], rescaled["y_over_cs"], delta=error + 1 / 216)

    def test_soft_spheres_are_hard_ones_of_another_diameter(self):
        self.assertPressure("soft", "y_over_cs", more=0.02)

    def test_wells_lower_the_pressure(self):
        """By 1 - b of few spheres, 0.13, and more where there are many. Pairs in their wells: 0.374 to a sphere with the
        contact value of hard spheres everywhere in the well, exp(0.6) times as many at the most with attraction; each has
        an energy of -0.6."""
        self.assertLess(self.found["wells"]["y_over_cs"], 0.97)
        self.assertGreater(self.found["wells"]["y_over_cs"], 0.5)
        self.assertLess(self.found["wells"]["potential"], -0.6 * 0.374 * 1.1)
        self.assertGreater(self.found["wells"]["potential"], -0.6 * 0.374 * math.exp(0.6) * 1.05)

    def test_sheared_spheres_have_the_viscosity_of_enskog(self):
        """Noise of the mean stress sqrt(2 mu T/(V t)) over mu times the rate: 6 % here; three of that, and 5 %."""
        given = self.table["sheared"]
        volume, time = math.pi * 216 / 6 / 0.3, given["collisions"] / theory.frequency(0.3)
        noise = math.sqrt(2 / (theory.enskog(0.3) * volume * time)) / given["rate"]
        self.assertLess(noise, 0.06)
        self.assertAlmostEqual(self.found["sheared"]["over_enskog"], 1, delta=0.05 + 3 * noise)
        self.assertAlmostEqual(self.found["sheared"]["T"], 1, delta=0.01)

    def test_finished_runs_are_taken_over(self):
        before = [(job.folder / "log").stat().st_mtime_ns for job in self.jobs]
        carry_out(self.jobs, 2)
        self.assertEqual([(job.folder / "log").stat().st_mtime_ns for job in self.jobs], before)


class Theory(unittest.TestCase):
    def test_compressibilities(self):
        """Four digits, from the coefficients of van der Hoef et al. 2006, table III."""
        for phi, cs, ma in ((0.05, 0.2274, 0.2275), (0.3, 2.9738, 2.9480), (0.45, 8.385, 8.285), (0.5, 12.0, 12.17)):
            self.assertAlmostEqual(theory.y_of(theory.carnahan_starling, phi) / cs, 1, delta=3e-4)
            self.assertAlmostEqual(theory.y_of(theory.ma_ahmadi, phi) / ma, 1, delta=3e-4)

    def test_crystal_has_the_pressure_of_the_fluid_where_both_are_in_balance(self):
        """11.58 T/d^3 at 0.9392 and 1.0376 spheres in d^3: within half a per cent of both laws."""
        fluid, solid = 0.9392 * math.pi / 6, 1.0376 * math.pi / 6
        self.assertAlmostEqual((1 + theory.crystal(solid)) * 1.0376 / 11.58, 1, delta=0.005)
        self.assertAlmostEqual((1 + theory.y_of(theory.carnahan_starling, fluid)) * 0.9392 / 11.58, 1, delta=0.005)

    def test_wells(self):
        for w, D, b in ((1.05, 1, 0.729), (1.1, 0.5, 0.785), (1.1, 1, 0.431)):
            self.assertAlmostEqual(theory.well(w, D), b, delta=0.0005)

    def test_springs_without_attraction(self):
        """b = 3 int (1 - exp(-K (1 - r)^2/2)) r^2 dr: by moments of a half normal distribution, 1 - 3 s sqrt(pi/2) + 3 s^2
        - ..., s = 1/sqrt(K)."""
        for K in (1000.0, 66826.0):
            s = K**-0.5
            exact = 1 - 3 * (s * math.sqrt(math.pi / 2) - 2 * s**2 + s**3 * math.sqrt(math.pi / 2))
            self.assertAlmostEqual(theory.hamaker(K, 1e-15, 0.02, 0.2, True), exact, delta=1e-6)

    def test_attraction_of_hard_ones(self):
        """Springs so stiff that nothing is in them, and a force without a tail: closed form of exp(a (Hc - H)) (1 + H)^2."""
        K, Hc, a = 1e9, 0.02, 50.0

        def part(H):
            return ((1 + H)**2 / a + 2 * (1 + H) / a**2 + 2 / a**3) * math.exp(a * (Hc - H))
        exact = 1 - 3 * (part(0) - part(Hc) - ((1 + Hc)**3 - 1) / 3)
        found = theory.hamaker(K, 24 * a * Hc**2, Hc, Hc * (1 + 1e-7), False)
        springs = 3 * math.exp(a * Hc) * math.sqrt(math.pi / 2 / K)
        self.assertAlmostEqual(found, exact, delta=1.1 * springs)

    def test_enskog_for_few_spheres(self):
        self.assertAlmostEqual(theory.enskog(1e-9) * 16 * math.sqrt(math.pi) / 5, 1, delta=1e-6)


class Reading(unittest.TestCase):
    def flow(self, stress, rate, dt=0.01, every=3):
        """A log of in.flow with given stresses of each line, (6, lines), half kinetic and half carried."""
        lines = stress.shape[1]
        volume = math.pi * 512 / 6 / 0.3
        carried = np.cumsum(np.concatenate([np.zeros((6, 1)), stress / 2 * volume * every * dt], axis=1), axis=1)
        names = (["Step", "c_flow", "c_flow[1]"] + [f"f_kinetic[{k}]" for k in range(1, 7)]
                 + [f"c_stress[1][{k}]" for k in range(1, 7)])
        text = [" ".join(names)]
        for n in range(lines + 1):
            kinetic = stress[:, n - 1] / 2 if n else np.zeros(6)
            text.append(" ".join(f"{x:.15g}" for x in [n * every, 511 / 512, rate, *kinetic, *carried[:, n]]))
        return analyse.flow("\n".join(["Per MPI rank memory", *text, "Loop time of 1"]),
                            {"count": 512, "phi": 0.3, "rate": rate, "dt": dt})

    def test_viscosity_of_a_shear_stress(self):
        found = self.flow(np.full((6, 100), -0.3), 0.5)
        self.assertAlmostEqual(found["viscosity"], 0.6, delta=1e-12)
        self.assertAlmostEqual(found["kinetic"], 0.3, delta=1e-12)
        self.assertAlmostEqual(found["over_enskog"], 0.6 / theory.enskog(0.3), delta=1e-9)

    def test_viscosity_of_noise(self):
        """Stress without memory of the variance s^2 in each line of the length t has the viscosity V s^2 t/2. Of 8000
        lines, each a mean free time long, and five shears the way between lags of 5 and 15 is known to 5.8/sqrt(40000): four
        of that."""
        every, dt, s = 3, 0.1 / 3, 0.2
        draw = np.random.default_rng(3).standard_normal((6, 8000)) * s
        draw[:3] *= math.sqrt(2)  # so that differences of normal stresses are shears
        found = self.flow(draw, 0.0, dt, every)
        volume = math.pi * 512 / 6 / 0.3
        self.assertAlmostEqual(found["viscosity"] / (volume * s**2 * every * dt / 2), 1, delta=0.12)

    def test_limits_are_on_the_line_through_two_rows(self):
        table = {f"well-{phi}": {**run.KNOWN, "phi": phi} for phi in (0.01, 0.03)}
        found = {name: {"y_over_cs": 0.7 + 2 * row["phi"], "y_over_cs_error": 0.001, "b": 0.7} for name, row in table.items()}
        limit = laws.limits(found, table)["well limit"]
        self.assertAlmostEqual(limit["limit"], 0.7, delta=1e-12)
        self.assertAlmostEqual(limit["limit_error"], 0.001 * math.hypot(1.5, 0.5), delta=1e-12)

    def test_expected_are_figures_of_rows(self):
        table = study_table.read_table(run.HERE / "gases.csv", run.KNOWN)
        for row in expected.rows(run.HERE / "expected.csv"):
            if row["case"] != "law":
                self.assertIn(row["case"].removesuffix(" limit").removesuffix(" law"),
                              [*table, *(name.rpartition("-")[0] for name in table)])


if __name__ == "__main__":
    unittest.main()
