# SPDX-License-Identifier: BSD-3-Clause
"""A gas step that follows the Courant number: always a whole number of particle steps, the times to be
written and the end met, the exchange balanced in every step of whatever length, and the same steps after a
restart."""

import re
import unittest

import numpy as np

from cohesion_tests.coupling.cases import CONTROL, COUPLING, exchange_lines
from cohesion_tests.coupling.fields import field, numbers
from cohesion_tests.coupling.test_case import CoupledTestCase

PARTICLE_STEP, END, INTERVAL, MAX_CO, MAX_DT = 1e-5, 0.03, 0.006, 0.05, 1e-3
CELL_HEIGHT = 0.02
# The updraft sets in, and the step has to become shorter.
UPDRAFT = "table ((0 (0 0 0.5)) (0.012 (0 0 0.5)) (0.02 (0 0 4)) (1 (0 0 4)))"
ADJUST = {"adjustTimeStep": "yes", "maxCo": MAX_CO, "maxDeltaT": MAX_DT, "deltaT": 2 * PARTICLE_STEP}


def case_of(column, name, settings):
    case = column(name)
    case.set(COUPLING, "lammpsCoeffs/script", '"$FOAM_CASE/continued.lmp"')
    case.set(COUPLING, "voidFraction", "sphereOverlap")
    case.set("0.orig/U", "boundaryField/bottom/superficialVelocity", UPDRAFT)
    case.set("system/fvSolution", 'solvers/"p.*"/tolerance', 1e-13)
    common = {"endTime": END, "writeControl": "adjustableRunTime", "writeInterval": INTERVAL,
              "writePrecision": 17, "timePrecision": 9}
    for entry, value in {**common, **settings}.items():
        case.set(CONTROL, entry, value)
    case.mesh()
    return case


def steps(log):
    """(deltaT, steps of the particles) of every gas step."""
    found = re.findall(r"^deltaT = (\S+), (\d+) steps of the particles", log, re.M)
    return [(float(dt), int(n)) for dt, n in found]


def times(case):
    return sorted(float(x.name) for x in case.folder.iterdir() if re.fullmatch(r"[\d.e-]+", x.name))


def velocity(case):
    cloud = case.folder / f"{END:g}" / "lagrangian/particles"
    return numbers(cloud / "U", 3)[np.argsort(numbers(cloud / "id", 1)[:, 0])]


class AdaptiveStep(CoupledTestCase):
    @classmethod
    def setUpClass(cls):
        cls.case = case_of(cls.column, "adjusted", ADJUST)
        cls.log = cls.case.solve()
        cls.found = steps(cls.log)

    def test_steps(self):
        found, case = self.found, self.case
        lengths = np.array([n for _, n in found])
        self.expect_below("steps that are no whole number of particle steps, relative error",
                          max(abs(dt / (n * PARTICLE_STEP) - 1) for dt, n in found), 1e-6)
        self.expect_equal("particle steps in all", int(lengths.sum()), round(END / PARTICLE_STEP))
        # At the end all cells have the whole updraft or more.
        most = MAX_CO * CELL_HEIGHT / 4 / PARTICLE_STEP
        self.expect_true(f"the step grows, to {lengths.max()}, and shrinks, to {lengths[-1]}, at most {most:g}",
                         lengths[0] <= 3 and lengths.max() > most and lengths[-1] <= most)
        self.expect_true("it grows by a fifth or by one at most",
                         bool(np.all(lengths[1:] <= np.maximum(lengths[:-1] + 1, 1.2 * lengths[:-1]))))
        self.expect_equal("times written", [round(t / INTERVAL, 6) for t in times(case)], [0, 1, 2, 3, 4, 5])
        # The flow of a step is that of its end, the step follows from the flow at its start: above what is
        # asked for by what the updraft grows in the longest step, 3.5 m/s in 8 ms, between the spheres.
        lowest = min(field(case, f"{k * INTERVAL:g}", "voidFraction").min() for k in range(1, 6))
        grown = 3.5 / 8e-3 * MAX_DT**2 / CELL_HEIGHT / lowest
        courant = [float(x) for x in re.findall(r"Courant Number mean: \S+ max: (\S+)", self.log)]
        self.expect_below("largest Courant number", max(courant), MAX_CO + grown)

    def test_balance(self):
        lines = exchange_lines(self.log)
        self.expect_equal("gas steps", len(lines), len(self.found))
        self.expect_balance("adjusted", lines)
        self.expect_true("they move", np.abs(velocity(self.case)).max() > 0.1)

    def test_stopped_and_continued(self):
        halves = case_of(self.column, "halves", {**ADJUST, "endTime": 3 * INTERVAL})
        first = steps(halves.solve())
        halves.set(CONTROL, "startFrom", "latestTime")
        halves.set(CONTROL, "endTime", END)
        second = steps(halves.solve())
        self.expect_equal("steps of the particles in those of the gas", [n for _, n in first + second],
                          [n for _, n in self.found])

    def test_step_that_is_written_with_six_digits(self):
        step = 1.23457e-5  # its multiples have more digits
        rounded = case_of(self.column, "rounded", {**ADJUST, "deltaT": 2 * step, "endTime": INTERVAL,
                                                   "writeControl": "adjustable", "writePrecision": 6,
                                                   "writeFormat": "binary"})
        script = rounded.folder / "continued.lmp"
        script.write_text(script.read_text().replace("${dt}", repr(step)))
        first = steps(rounded.solve())
        rounded.set(CONTROL, "startFrom", "latestTime")
        rounded.set(CONTROL, "endTime", 2 * INTERVAL)
        second = steps(rounded.solve())
        self.expect_true(f"it goes on with {second[0][1]} steps after {first[-1][1]}",
                         first[-1][1] > 2 and second[0][1] > first[-1][1] / 2)
        self.expect_equal("particle steps in all", sum(n for _, n in first + second), round(2 * INTERVAL / step))


if __name__ == "__main__":
    unittest.main()
