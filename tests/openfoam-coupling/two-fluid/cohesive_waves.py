# SPDX-License-Identifier: BSD-3-Clause
"""Sound in a gas of grains, without gravity and nearly without drag, by twoPhaseEulerFoam with the pressures of
libcohesionTwoFluid: a standing wave between two walls. As the solver takes the pressure, its slope at the same Theta,
(2 pi/period)^2 = (pi/L)^2 Theta d(p_s/Theta)/d phi/(rho + rho_gas phi/eps), as gas flows the other way. The wave of
the solver's Lun has this period in cells without size, the wells slow it down as their law has it over that of Lun, and
the log counts cells that are colder than was measured."""

import os
import re
import unittest
from pathlib import Path

import numpy as np

from cohesion_studies.foam_case import environment
from cohesion_studies.foam_results import read_cells, written_times
from cohesion_tests.coupling.two_fluid import SOLVER, column, edit, nonuniform, replace, times

WORK, ENV = Path(os.environ["COHESION_WORK"]), environment(os.environ["COHESION_BUILD"])
CELLS, LENGTH, PHI, SWING = 30, 1.0, 0.2, 1e-3
D, RHO, MASS, RATIO, GAS = 75e-6, 1500.0, 3.3e-10, 1.05, 1.2
THETA = 1.0
STEPS, WRITTEN = 200, 40  # of a period, and how many of these are written
# Parts of the square of the period that are not the law's: (2 pi/STEPS)^2 of the steps times a number of order one,
# 1e-3; (pi/CELLS)^2/12 of the cells, 9e-4; SWING of the wave's own height; drag and viscosity below 1e-4; the straight
# line between two written heights nothing that both crossings of zero do not share. Waves with and without wells have
# as many steps in their period, and share more of these. Wells change it by a quarter and more.
TOLERANCE = 4e-3
# Once the outer correctors of a step agree, cells and steps of half the size leave a quarter of the parts that go with
# the square of either; of cells without size there remain (pi/CELLS)^4, 1e-4, and SWING^2, times numbers of order one.
TOLERANCE_WITHOUT_CELLS = 2e-4


def carnahan_starling(phi):
    return (1 - phi / 2) / (1 - phi) ** 3


def square_of_period(depth_over_t):
    """[s^2], by the slope of phi (1 + 4 phi chi c) along the imaginary axis."""
    gathered = (RATIO**3 - 1) * np.expm1(min(depth_over_t, 1))
    phi = PHI + 1e-30j
    left = 1 - gathered * (1 + 2.764 * phi - 0.969 * phi**2 - 4.836 * phi * gathered)
    slope = np.imag(phi * (1 + 4 * phi * carnahan_starling(phi) * left)) / 1e-30
    return (2 * LENGTH) ** 2 * (1 + GAS / RHO * PHI / (1 - PHI)) / (THETA * slope)


def shape_of(cells):
    """Of the wave in a column of so many cells."""
    return np.cos(np.pi * (np.arange(cells) + 0.5) / cells)


class CohesiveWaves(unittest.TestCase):
    def waves(self, name, model, depth_over_t, finer=1, correctors=1):
        """The case after its run over 0.9 of a period, in cells and steps so many times as fine."""
        cells, step = CELLS * finer, np.sqrt(square_of_period(depth_over_t)) / STEPS / finer
        case = column(WORK / name, ENV, cells, LENGTH, (GAS, 1.8e-5), (D, RHO), "type wenYu; dragFactor 1e-9;")
        theory = "constant/turbulenceProperties.particles"
        edit(case, theory, e=1, radialModel="carnahanStarling", granularPressureModel=model)
        replace(case, theory, "kineticTheoryCoeffs\n    {", "kineticTheoryCoeffs\n    {\n        squareWellCoeffs "
                f"{{ wellDepth {depth_over_t * MASS * THETA!r}; wellRatio {RATIO}; grainMass {MASS!r}; }}")
        replace(case, "constant/g", "(0 -9.81 0)", "(0 0 0)")
        edit(case, "constant/gasVelocity", velocity=0)
        replace(case, "0.orig/Theta.particles", "uniform 1e-4", f"uniform {THETA}")
        solid = PHI * (1 + SWING * shape_of(cells))
        replace(case, "0.orig/alpha.particles", "uniform 0", nonuniform(solid))
        replace(case, "0.orig/alpha.air", "uniform 1", nonuniform(1 - solid))
        replace(case, "system/fvSolution", "tolerance 1e-7;", "tolerance 1e-8; maxIter 60;")
        edit(case, "system/fvSolution", nOuterCorrectors=correctors)
        times(case, step, (0.9 * STEPS * finer + 0.5) * step)
        edit(case, "system/controlDict", writeControl="timeStep", writeInterval=STEPS * finer // WRITTEN)
        case.mesh()
        case.run(SOLVER)
        return case

    @staticmethod
    def period(case, finer=1):
        """Twice the time between the two crossings of zero of the wave."""
        cells, found = CELLS * finer, written_times(case.folder)
        when = np.array(sorted(found))
        height = np.array([read_cells(found[t] / "alpha.particles", cells) @ shape_of(cells) for t in when])
        at = np.nonzero(height[:-1] * height[1:] < 0)[0]
        assert len(at) == 2, height
        crossings = when[at] - height[at] * (when[at + 1] - when[at]) / (height[at + 1] - height[at])
        return 2 * (crossings[1] - crossings[0])

    def test_period_without_wells(self):
        coarse, fine = (self.period(self.waves(f"lun-{finer}", "Lun", 0.0, finer=finer, correctors=3), finer)**2
                        / square_of_period(0) - 1 for finer in (1, 2))
        found = fine + (fine - coarse) / 3
        self.assertLessEqual(abs(found), TOLERANCE_WITHOUT_CELLS, f"{found!r}, of {coarse!r} and {fine!r}")

    def test_wells_slow_sound_down(self):
        without = self.period(self.waves("lun", "Lun", 0.0)) ** 2
        for name, depth_over_t in (("wells", 0.8), ("cold", 3.0)):
            case = self.waves(name, "squareWell", depth_over_t)
            with self.subTest(name, what="square of the period over that of Lun"):
                found = self.period(case) ** 2 / without
                expected = square_of_period(depth_over_t) / square_of_period(0)
                self.assertLessEqual(abs(found / expected - 1), TOLERANCE, f"{found!r}, expected {expected!r}")
            counted = re.findall(rf"squareWell particles: (\d+) of {CELLS} cells, with (\S+) of the grains, are colder",
                                 case.log(SOLVER).read_text())
            with self.subTest(name, counts="cold cells"):
                self.assertGreaterEqual(len(counted), int(0.9 * STEPS) if name == "cold" else 0)
                self.assertEqual(set(counted), {(str(CELLS), "1")} if name == "cold" else set())


if __name__ == "__main__":
    unittest.main()
