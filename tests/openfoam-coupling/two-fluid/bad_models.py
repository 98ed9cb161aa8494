# SPDX-License-Identifier: BSD-3-Clause
"""What libcohesionTwoFluid refuses: twoPhaseEulerFoam stops before the first step, with a message that says what, where
and what would be right."""

import os
import unittest
from pathlib import Path

from cohesion_studies.foam_case import CaseError, environment
from cohesion_tests.coupling.two_fluid import SOLVER, column, edit, replace, times
from cohesion_tests.theory.closure_formulas import CLOSURES

WORK, ENV = Path(os.environ["COHESION_WORK"]), environment(os.environ["COHESION_BUILD"])


class BadModels(unittest.TestCase):
    @staticmethod
    def case(name, drag):
        return column(WORK / name, ENV, 4, 0.4, (1.2, 1.8e-5), (75e-6, 1500.0), drag)

    def refused(self, name, *parts, drag="type wenYu;", gravity=-9.81, **theory):
        case = self.case(name, drag)
        edit(case, "constant/turbulenceProperties.particles", **theory)
        replace(case, "constant/g", "(0 -9.81 0)", f"(0 {gravity} 0)")
        times(case, 1e-4, 1e-4)
        case.mesh()
        with self.assertRaises(CaseError, msg=f"{name}: runs"):
            case.run(SOLVER)
        log = case.log(SOLVER).read_text()
        for part in parts:
            with self.subTest(name, says=part):
                self.assertIn(" ".join(part.split()), " ".join(log.split()))
        self.assertNotIn("\nTime = ", log.replace("\nTime = 0\n", ""), name)

    def test_names(self):
        """OpenFOAM's own messages list what there is."""
        self.refused("drag", "Unknown dragModel", *CLOSURES, drag="type wenyu;")
        self.refused("radial", "Unknown radialModel", "maAhmadi", "carnahanStarling", radialModel="ma")

    def test_factor_and_exponent(self):
        where = "phaseProperties"
        self.refused("factor", "dragFactor = 0: must be a finite number greater than zero", where,
                     drag="type wenYu; dragFactor 0;")
        self.refused("exponent", "dragExponent = -1: must be a finite number greater than zero", where,
                     drag="type wenYu; dragExponent -1;")
        self.refused("none", "dragExponent = 4.65: drag 'beetstra' has no exponent to choose",
                     "take one of ergunWenYu, ergunRoweHenwood, wenYu", where, drag="type beetstra; dragExponent 4.65;")

    def test_entries_that_nothing_reads(self):
        for name, entry, warnings in (("misspelt", "dragFator 0.5;", 1), ("right", "dragFactor 0.5;", 0)):
            case = self.case(name, f"type wenYu; {entry}")
            times(case, 1e-4, 1e-4)
            case.mesh()
            case.run(SOLVER)
            log = case.log(SOLVER).read_text()
            said = "unknown entry 'dragFator' (the nearest known one is 'dragFactor'): nothing reads it"
            self.assertEqual(log.count(said), warnings, name)
            self.assertEqual(log.count("unknown entry"), warnings, name)

    def test_filter(self):
        self.refused("filter", "filter", "igcy", "none, igci, radlSundaresan", "phaseProperties",
                     drag="type wenYu; filter igcy;")
        for name in ("igci", "radlSundaresan"):
            self.refused(f"weightless-{name}", f"filter {name} goes by the speed at which particles fall, and constant/g is"
                         " zero: remove the entry", "phaseProperties", drag=f"type wenYu; filter {name};", gravity=0)

    def test_packing_beyond_the_radial_function(self):
        self.refused("packing", "alphaMax = 0.65: radialModel maAhmadi diverges at a solid fraction of 0.64356",
                     "kineticTheoryCoeffs", alphaMax=0.65)

    def test_wells(self):
        def well(words):
            return f"squareWell; squareWellCoeffs {{ {words} }} unused"

        for name, words, said in (
                ("depth", "wellDepth -1; wellRatio 1.05; grainMass 1e-9;", "depth D of the well = -1: must be a finite"
                 " number not below zero"),
                ("ratio", "wellDepth 1; wellRatio 0.9; grainMass 1e-9;", "ratio r_out/r of the well = 0.9"),
                ("mass", "wellDepth 1; wellRatio 1.05; grainMass 0;", "mass of a grain = 0"),
                ("missing", "wellDepth 1; wellRatio 1.05;", "grainMass")):
            self.refused(f"well-{name}", said, "kineticTheoryCoeffs", granularPressureModel=well(words) + " 0")


if __name__ == "__main__":
    unittest.main()
