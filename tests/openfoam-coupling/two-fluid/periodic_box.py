# SPDX-License-Identifier: BSD-3-Clause
"""A suspension in a box that is periodic along gravity, by twoPhaseEulerFoam with suspendedWeight: gas and particles part
at the slip of the force balance, and the box as a whole stays where it is. constant/g beside it is refused."""

import os
import re
import unittest
from pathlib import Path

import numpy as np

from cohesion_studies.foam_case import CaseError, FoamCase, environment
from cohesion_studies.foam_results import function_table
from cohesion_tests import SOURCE
from cohesion_tests.coupling.two_fluid import SOLVER, edit, nonuniform, replace
from cohesion_tests.theory.closure_formulas import CLOSURES, DOUBLE

WORK, ENV = Path(os.environ["COHESION_WORK"]), environment(os.environ["COHESION_BUILD"])
CASE = SOURCE / "examples/filtered-two-fluid/case"
CELLS, PHI, RHO, GAS, G, STEP = 8, 0.05, 1500.0, 1.199, 9.81, 1e-3


class PeriodicBox(unittest.TestCase):
    def box(self, name, noise=0.0):
        case = FoamCase(CASE, WORK / name, ENV, overwrite=True)
        edit(case, "system/blockMeshDict", columns=CELLS, rows=CELLS)
        solid = PHI * (1 + noise * np.random.default_rng(1).uniform(-1, 1, CELLS**2))
        replace(case, "0.orig/alpha.particles", "uniform 0", nonuniform(solid))
        replace(case, "0.orig/alpha.air", "uniform 1", nonuniform(1 - solid))
        edit(case, "system/controlDict", deltaT=STEP, endTime=0.3)
        return case

    @staticmethod
    def flows(case):
        """Of particles and gas, the integral of alpha U over the volume at the end, over the volume [m/s]."""
        rows = [np.loadtxt(re.sub(r"[()]", " ", function_table(case.folder, name, "volFieldValue.dat").read_text())
                           .splitlines()) for name in ("momentum", "momentumOfGas")]
        return [row[-1, 1:] / 2.56e-4 for row in rows]

    def test_slip_and_momentum(self):
        """Even: beta slip = phi eps (rho_s - rho) g. Its relaxation, phi rho_s eps rho/(beta mean rho) < 1e-3 s, is over;
        the gas has 1.19 to 1.21 kg/m3, of which the slip sees the weight alone, below 1e-4. 0.1 %."""
        case = self.box("even")
        case.mesh()
        case.run(SOLVER)
        particles, gas = self.flows(case)
        slip = gas[1] / (1 - PHI) - particles[1] / PHI
        beta = PHI * CLOSURES["wenYu"](DOUBLE, 1 - PHI, abs(slip), 75e-6, GAS, 1.8e-5)
        self.assertLessEqual(abs(beta * slip / (PHI * (1 - PHI) * (RHO - GAS) * G) - 1), 1e-3, slip)

    def test_the_box_stays(self):
        """Uneven: what one step loses of the momentum, 1 % of g for STEP, is left when it is taken away in the next."""
        case = self.box("uneven", 0.3)
        case.mesh()
        case.run(SOLVER)
        particles, gas = self.flows(case)
        velocity = (RHO * particles + GAS * gas) / (RHO * PHI + GAS * (1 - PHI))
        self.assertLess(np.abs(velocity).max(), 0.01 * G * STEP)

    def test_gravity_twice_is_refused(self):
        case = self.box("twice")
        replace(case, "constant/g", "(0 0 0)", "(0 -9.81 0)")
        case.mesh()
        with self.assertRaises(CaseError):
            case.run(SOLVER)
        self.assertIn("constant/g is (0 -9.81 0): set it to (0 0 0)", case.log(SOLVER).read_text())


if __name__ == "__main__":
    unittest.main()
