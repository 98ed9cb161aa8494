# SPDX-License-Identifier: BSD-3-Clause
"""The reading of a fluidisation curve on tables whose answer is known, and the schedules."""

import re
import shutil
import tempfile
import unittest
from pathlib import Path

import numpy as np

from cohesion_studies import ergun
from cohesion_studies.bed import analyse, particles
from cohesion_studies.case_entries import particle_step

BED = Path(__file__).resolve().parents[2] / "examples/fluidised-bed"


def steps(minimum, highest, rising):
    """Packed bed 0.4 u + 0.6 u^2 with u = U/minimum, one step at `highest`, the weight beyond."""
    found = []
    for k in range(1, 25):
        velocity = 0.05 * k
        u = velocity / minimum
        ratio = 0.4 * u + 0.6 * u**2 if u < 1 else 1.0
        if rising and abs(velocity - highest[0]) < 1e-9:
            ratio = highest[1]
        found.append(analyse.Step(velocity, 0.0, 0.1, ratio, 0.0, rising))
    return found


class FluidisationCurve(unittest.TestCase):
    def test_finds_the_velocities(self):
        curve = steps(0.72, None, False) + steps(0.81, (0.85, 1.12), True)
        found = analyse.velocities(curve)
        # The points lie on the fitted form: only round-off is left.
        self.assertAlmostEqual(found.falling[0], 0.72, places=10)
        self.assertAlmostEqual(found.rising[0], 0.81, places=10)
        self.assertEqual(found.opens.velocity, 0.05 * 17)

    def rising(self, beyond, error=lambda velocity: 0.0):
        """A rising branch: packed, with the weight at 0.8 m/s, up to that, and pressures beyond, functions of the
        velocity."""
        return [analyse.Step(u, 0.0, 0.1, beyond(u) if u > 0.76 else 0.5 * u / 0.8 + 0.5 * (u / 0.8)**2, error(u), True)
                for u in (0.2, 0.3, 0.4, 0.5, 0.6, 0.65, 0.7, 0.75, 0.8, 0.85, 0.9, 1.0, 1.1)]

    def test_the_bed_opens_at_the_pressure_maximum(self):
        """At the vertex of a parabola, in between of the steps; what bubbles reach later is no overshoot."""
        opens, velocity, overshoot = analyse.opening(
            self.rising(lambda u: 1.3 if u == 1.1 else 1.07 - 8 * (u - 0.86)**2))
        self.assertEqual(opens.velocity, 0.85)
        self.assertAlmostEqual(velocity[0], 0.86, places=10)
        self.assertAlmostEqual(overshoot[0], 0.07, places=10)
        self.assertEqual((velocity[1], overshoot[1]), (0.0, 0.0))

    def test_a_dip_while_the_bed_is_packed_is_no_maximum(self):
        """0.98 at 0.8 m/s, 0.97 at 0.85 m/s, 8 % below the packed bed there, then 1.05: the bed goes on to rise."""
        opens, _, _ = analyse.opening(self.rising({0.8: 0.98, 0.85: 1.0, 0.9: 1.05, 1.0: 0.9, 1.1: 1.1}.get))
        self.assertEqual(opens.velocity, 0.9)

    def test_a_maximum_at_the_step_that_has_opened(self):
        """Pressures that go on to rise: at the step itself, to half of the way from the one before."""
        opens, velocity, overshoot = analyse.opening(self.rising(lambda u: 0.92 + 0.1 * (u - 0.8), lambda u: 0.01))
        self.assertEqual(opens.velocity, 0.85)
        self.assertAlmostEqual(velocity[1], 0.025, places=12)
        self.assertAlmostEqual(overshoot[0], -0.075, places=12)
        self.assertEqual(overshoot[1], 0.01)

    def test_error_of_the_opening(self):
        """Steps h = 0.05 on both sides lower by D: the velocity has h e/(4 D) of each neighbour's e, the height e."""
        _, velocity, overshoot = analyse.opening(self.rising(lambda u: 1.07 - 8 * (u - 0.85)**2, lambda u: 1e-3))
        self.assertAlmostEqual(velocity[1], 2**0.5 * 0.05 * 1e-3 / (4 * 8 * 0.05**2), places=10)
        self.assertAlmostEqual(overshoot[1], 1e-3, places=10)

    def test_a_bed_that_has_not_opened(self):
        """The pressure follows the packed bed to the end, or there is none to follow."""
        packed = self.rising(lambda u: 0.5 * u / 0.8 + 0.5 * (u / 0.8)**2)
        for steps in (packed, packed[8:]):
            opens, velocity, overshoot = analyse.opening(steps)
            self.assertIsNone(opens)
            self.assertNotEqual(velocity[0], velocity[0])  # nan
            self.assertNotEqual(overshoot[0], overshoot[0])

    def test_the_slowest_step_is_not_the_maximum(self):
        """With the highest pressure there is no packed bed to have opened."""
        steps = self.rising(lambda u: 1.07 - 8 * (u - 0.86)**2)
        steps[0].ratio = 1.2
        opens, velocity, overshoot = analyse.opening(steps)
        self.assertIsNone(opens)
        self.assertTrue(np.isnan([*velocity, *overshoot]).all())

    def test_the_end_of_the_packed_points_is_an_error(self):
        """A falling bed that still expands above 0.65 of the weight: the velocity is that of the slower points; its
        error what other ends make of it, the largest that of 0.9."""
        curve = steps(0.8, None, False)
        for step in curve:
            if 0.65 < step.ratio < 1:
                step.ratio = 0.65 + 0.7 * (step.ratio - 0.65)
        velocity, error = analyse.packed_curve_meets_weight(curve)
        ends = [analyse.PackedCurve.through(analyse.packed_points(curve, end)).meets_weight()[0] for end in (0.6, 0.9)]
        self.assertAlmostEqual(ends[0], 0.8, places=10)
        self.assertLess(abs(velocity - 0.8), 0.3 * abs(ends[1] - 0.8))
        self.assertGreaterEqual(error, abs(ends[1] - velocity))

    def test_leaves_out_what_comes_after_the_bed_has_moved(self):
        # A bubbling bed whose pressure falls below the packed range again must not enter the fit.
        curve = steps(0.72, None, False)
        curve[-1].ratio = 0.5
        self.assertAlmostEqual(analyse.velocities(curve + steps(0.8, (0.85, 1.0), True)).falling[0],
                               0.72, places=10)

    def test_leaves_out_a_bed_that_gas_passes_before_it_has_the_weight(self):
        # Channels or walls: the pressure falls from 0.75 of the weight on and does not come to 0.9 of it.
        curve = steps(0.72, None, False)
        for step in curve:
            if step.velocity > 0.61:
                step.ratio = 0.85 - 0.2 * step.velocity
        self.assertAlmostEqual(analyse.packed_curve_meets_weight(curve)[0], 0.72, places=10)

    def test_too_few_points_give_no_velocity(self):
        velocity, _ = analyse.packed_curve_meets_weight(steps(0.72, None, False)[10:])
        self.assertNotEqual(velocity, velocity)  # nan


class Minimum(unittest.TestCase):
    def test_ergun_at_the_void_fractions_of_the_thesis(self):
        # The void fractions are printed with two digits: half of the last one, 0.005, is 0.018 m/s.
        for void_fraction, velocity in ((0.43, 0.685), (0.46, 0.809)):
            found = ergun.minimum_fluidisation(void_fraction, 1e-3, 2650, 1.205, 1.75e-5, 9.81)
            self.assertAlmostEqual(found, velocity, delta=0.018)
            # There the gradient is the weight.
            viscous, inertial = ergun.coefficients(void_fraction, 1e-3, 1.205, 1.75e-5)
            weight = (1 - void_fraction) * (2650 - 1.205) * 9.81
            self.assertAlmostEqual((viscous * found + inertial * found**2) / weight, 1, places=12)


class ParticleStep(unittest.TestCase):
    def test_is_that_of_the_engine_that_the_case_names(self):
        text = (BED / "case/constant/couplingProperties").read_text()
        self.assertEqual(text.count("dt      1.125e-5;"), 2)
        for number, engine in enumerate(("lammps", "liggghts")):
            with tempfile.TemporaryDirectory() as folder, self.subTest(engine=engine):
                before, first, second = text.split("dt      1.125e-5;")
                steps = ["1e-5", "1e-5"]
                steps[number] = "2e-5"
                changed = f"{before}dt {steps[0]};{first}dt {steps[1]};{second}"
                (Path(folder) / "constant").mkdir()
                (Path(folder) / "constant/couplingProperties").write_text(
                    changed.replace("demEngine       lammps;", f"demEngine {engine};"))
                self.assertEqual(particle_step(folder), 2e-5)


class Schedules(unittest.TestCase):
    def read(self, name):
        with tempfile.TemporaryDirectory() as folder:
            (Path(folder) / "constant").mkdir()
            shutil.copy(BED / "case/constant" / name, Path(folder) / "constant/schedule")
            return analyse.read_schedule(folder)

    def test_an_interval_of_the_movement_has_the_thesis_velocity(self):
        """0.25 s are 556 gas steps of 4.5e-4 s, to whose ends the intervals are."""
        gas_step = 4.5e-4
        for name in ("schedule", "schedule.brief", "schedule.thesis"):
            text = (BED / "case/constant" / name).read_text()
            points = re.findall(r"\(([\d.]+) \(0 ([\d.]+) 0\)\)", text)
            time, velocity = np.array(points, float).T
            start = float(re.search(r"^movementStart (\S+);", text, re.M)[1])
            rest = time[velocity == 0][0]
            means = []
            while start + 556 * gas_step < rest:
                means.append(np.interp(np.linspace(start, start + 556 * gas_step, 5000), time, velocity).mean())
                start += 556 * gas_step
            # Written with two digits.
            self.assertLess(min(abs(mean - particles.MOVEMENT_AT) for mean in means), 0.005, name)

    def test_both_go_down_to_rest_and_up_the_same_way(self):
        for name in ("schedule", "schedule.thesis"):
            velocities = [v for _, _, v in self.read(name)]
            self.assertEqual(velocities, velocities[::-1], name)
            self.assertEqual(min(velocities), 0.0)
            self.assertEqual(max(velocities), 1.2)

    def test_the_thesis_has_37_steps_of_one_size_and_three_to_rest(self):
        down = [v for _, _, v in self.read("schedule.thesis")][:41]
        self.assertAlmostEqual(down[37], 0.5676, places=6)
        for k in range(37):  # six digits are printed
            self.assertAlmostEqual(down[k] - down[k + 1], (1.2 - 0.5676) / 37, delta=2e-5)
        self.assertEqual(down[40], 0.0)


if __name__ == "__main__":
    unittest.main()
