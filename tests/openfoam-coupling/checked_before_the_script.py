# SPDX-License-Identifier: BSD-3-Clause
"""A particle script may settle for minutes. What is wrong in the case without it stops the solver before the script
runs."""

import unittest

from cohesion_tests.coupling.cases import COUPLING, append, edit
from cohesion_tests.coupling.dictionaries import FIELD, FILE
from cohesion_tests.coupling.test_case import CoupledTestCase

SOLUTION, SCHEMES, CONTROL = "system/fvSolution", "system/fvSchemes", "system/controlDict"
GAS = "constant/transportProperties"


def turbulence(case, text):
    (case.folder / "constant/turbulenceProperties").write_text(FILE.format("dictionary", "turbulenceProperties") + text)


TURBULENCE = "simulationType RAS; RAS { RASModel kEpsilon; turbulence on; }"
# What the model needs of the files
TURBULENT_SCHEMES = {
    "div(((voidFraction*nuEff)*dev2(T(grad(U)))))": "Gauss linear",
    "div(voidFractionPhi,k)": "Gauss upwind",
    "div(voidFractionPhi,epsilon)": "Gauss upwind",
}


def turbulent(case, model=TURBULENCE, schemes=TURBULENT_SCHEMES, solvers="k|epsilon"):
    """The k-epsilon model with these schemes and linear solvers alone."""
    turbulence(case, model)
    append(case, GAS, "transportModel Newtonian;")
    for name, dimensions, value in (("k", "[0 2 -2 0 0 0 0]", 0.01), ("epsilon", "[0 2 -3 0 0 0 0]", 0.1),
                                    ("nut", "[0 2 -1 0 0 0 0]", 1e-4)):
        patches = "".join(f"    {patch} {{ type zeroGradient; }}\n" for patch in ("bottom", "top", "sides"))
        field = FIELD.format("volScalarField", name, dimensions, f"uniform {value}", patches)
        (case.folder / "0" / name).write_text(field)
    append(case, SCHEMES, "divSchemes { " + " ".join(f"{name} {scheme};" for name, scheme in schemes.items()) + " }")
    append(case, SOLUTION, f'solvers {{ "({solvers}).*" {{ solver PBiCGStab; preconditioner DILU; tolerance 1e-8;'
           ' relTol 0; } }')


def without(scheme):
    return {name: value for name, value in TURBULENT_SCHEMES.items() if name != scheme}


def end_of_patch(case, file, patch, condition):
    """Another condition on a patch of the field 0/file."""
    append(case, f"0/{file}", f"boundaryField {{ {patch} {{ {condition} }} }}")


def observe(case, entries):
    append(case, CONTROL, f"functions {{ observed {{ libs (cohesionFunctionObjects); {entries} }} }}")


# name: (what makes the case bad, parts of the message)
CASES = {
    "viscosity that turbulence cannot have": (
        lambda c: turbulence(c, "simulationType laminar;"), ["transportModel is missing", "it must be Newtonian"]),
    "viscosity that depends on the shear rate": (
        lambda c: append(c, GAS, "transportModel CrossPowerLaw; CrossPowerLawCoeffs { nu0 1e-3; m 1; }"),
        ["transportModel is CrossPowerLaw; it must be Newtonian", "transportProperties"]),
    "turbulence model that there is not": (
        lambda c: (turbulence(c, "simulationType RAS; RAS { RASModel kEpsillon; turbulence on; }"),
                   append(c, GAS, "transportModel Newtonian;")), ["kEpsillon"]),
    "stress of turbulence without a scheme": (
        lambda c: turbulent(c, schemes=without("div(((voidFraction*nuEff)*dev2(T(grad(U)))))")),
        ["div(((voidFraction*nuEff)*dev2(T(grad(U)))))", "fvSchemes"]),
    "stress of a laminar model without a scheme": (
        lambda c: turbulent(c, "simulationType laminar;", schemes={}),
        ["div(((voidFraction*nuEff)*dev2(T(grad(U)))))", "fvSchemes"]),
    "equation of turbulence without a scheme": (
        lambda c: turbulent(c, schemes=without("div(voidFractionPhi,epsilon)")),
        ["div(voidFractionPhi,epsilon)", "fvSchemes"]),
    "equation of turbulence without a solver": (
        lambda c: turbulent(c, solvers="k"), ["epsilonFinal", "fvSolution"]),
    "pressure beside a given velocity": (
        lambda c: end_of_patch(c, "p", "bottom", "type fixedValue; value uniform 0;"),
        ["patch bottom: the file p gives the pressure, by type fixedValue, and the file U the flux, by type"
         " superficialVelocity", "'type fixedFluxPressure; value uniform 0;'", "'type pressureInletOutletVelocity;"]),
    "pressure on a wall": (
        lambda c: end_of_patch(c, "p", "sides", "type fixedValue; value uniform 0;"),
        ["patch sides: the file p gives the pressure, by type fixedValue, and the file U the flux, by type slip"]),
    "total pressure at a wall that holds the gas": (
        lambda c: (end_of_patch(c, "p", "sides", "type totalPressure; p0 uniform 0; value uniform 0;"),
                   end_of_patch(c, "U", "sides", "type noSlip;")),
        ["by type totalPressure", "by type noSlip"]),
    "inlet full of solid": (
        lambda c: end_of_patch(c, "voidFraction", "bottom", "type fixedValue; value uniform 0;"),
        ["patch bottom: the void fraction is 0, by type fixedValue", "above 0 and at most 1", "'type zeroGradient;'"]),
    "inlet whose value is that of its file": (
        lambda c: end_of_patch(c, "voidFraction", "bottom", "type calculated; value uniform 0;"),
        ["patch bottom: the void fraction is 0, by type calculated"]),
    "inlet with more than all": (
        lambda c: end_of_patch(c, "voidFraction", "top", "type fixedValue; value uniform 1.2;"),
        ["patch top: the void fraction is 1.2, by type fixedValue"]),
    "void fraction of another name": (
        lambda c: edit(c, "0/U", "superficialVelocity (0 0 0);", "superficialVelocity (0 0 0); voidFraction alpha;"),
        ["patch bottom of ", "voidFraction is alpha, and there is no field of that name", "Remove the entry"]),
    "limit above the void fraction of an empty cell": (
        lambda c: append(c, COUPLING, "minVoidFraction 1.5;"),
        ["minVoidFraction = 1.5: must be below 1", "couplingProperties"]),
    "script in other units": (
        lambda c: edit(c, "particles.lmp", "units        si", "units        cgs"),
        ["particles.lmp has units cgs", "use 'units si'", "couplingProperties"]),
    "script without units": (
        lambda c: edit(c, "particles.lmp", "units        si", ""),
        ["particles.lmp has no command units, and then has units lj", "use 'units si'"]),
    "box of another size": (
        lambda c: edit(c, "particles.lmp", "0 0.2", "0 0.3"),
        ["in direction z", "from 0 to 0.3 m", "the mesh from 0 to 0.2 m"]),
    "gas step that is no multiple": (
        lambda c: append(c, CONTROL, "deltaT 1.05e-4;"),
        ["deltaT = 0.000105", "10.5 steps", "whole multiple", "controlDict"]),
    "no gas step": (
        lambda c: append(c, CONTROL, "deltaT 0;"),
        ["deltaT = 0: must be a finite number greater than zero", "controlDict"]),
    "gas step backwards": (
        lambda c: append(c, CONTROL, "deltaT -1e-4;"),
        ["deltaT = -0.0001: must be a finite number greater than zero", "controlDict"]),
    "written all the time": (
        lambda c: append(c, CONTROL, "writeInterval 0;"),
        ["writeInterval = 0: must be a finite number greater than zero", "controlDict"]),
    "end at the start": (
        lambda c: append(c, CONTROL, "endTime 0;"),
        ["endTime = 0 s is not after the start at 0 s: no step would be computed", "deltaT = 0.0001 s", "controlDict"]),
    "end before the start": (
        lambda c: append(c, CONTROL, "endTime -1;"), ["endTime = -1 s is not after the start at 0 s"]),
    "pressure that is not solved": (
        lambda c: append(c, SOLUTION, "PIMPLE { nCorrectors 0; }"),
        ["nCorrectors = 0: the pressure would not be solved", "at least 1", "fvSolution"]),
    "gas that is not solved": (
        lambda c: append(c, SOLUTION, "PIMPLE { nOuterCorrectors 0; }"),
        ["nOuterCorrectors = 0: the gas would not be solved", "at least 1"]),
    "solutions less than one": (
        lambda c: append(c, SOLUTION, "PIMPLE { nNonOrthogonalCorrectors -1; }"),
        ["nNonOrthogonalCorrectors = -1", "at least 0"]),
    "solver of p missing": (
        lambda c: edit(c, SOLUTION, '"p.*"', '"q.*"'), ["Entry 'p' not found", "fvSolution"]),
    "solver of U missing": (
        lambda c: edit(c, SOLUTION, '"U.*"', "U"), ["Entry 'UFinal' not found", "fvSolution"]),
    "solver that there is not": (
        lambda c: edit(c, SOLUTION, "solver PCG", "solver PCGG"), ["PCGG", "fvSolution"]),
    "solver of matrices that are others": (
        lambda c: edit(c, SOLUTION, "solver PBiCGStab; preconditioner DILU", "solver PCG; preconditioner DIC"),
        ["PCG", "fvSolution"]),
    "preconditioner that there is not": (
        lambda c: edit(c, SOLUTION, "preconditioner DILU", "preconditioner DLU"), ["DLU"]),
    "convection without a scheme": (
        lambda c: edit(c, SCHEMES, "div(voidFractionPhi,U) Gauss limitedLinearV 1;", ""),
        ["div(voidFractionPhi,U)", "fvSchemes"]),
    "scheme that there is not": (
        lambda c: edit(c, SCHEMES, "limitedLinearV", "limitedLinerV"), ["limitedLinerV", "fvSchemes"]),
    "stress without a scheme": (
        lambda c: edit(c, SCHEMES, "div(((voidFraction*nu)*dev2(T(grad(U))))) Gauss linear;", ""),
        ["div(((voidFraction*nu)*dev2(T(grad(U)))))", "fvSchemes"]),
    "function object of an entry that cannot be": (
        lambda c: observe(c, "type mixingIndex; cells (3 0 10);"), ["observed: cells = (3 0 10)", "controlDict"]),
    "largest Courant number below zero": (
        lambda c: append(c, CONTROL, "adjustTimeStep yes; maxCo -1;"),
        ["maxCo = -1: must be a finite number greater than zero", "controlDict"]),
    "sources that there are not": (
        lambda c: (c.folder / "constant/fvOptions").write_text(
            FILE.format("dictionary", "fvOptions") + "push { type pushing; }"), ["pushing", "fvOptions"]),
}


class CheckedBeforeTheScript(CoupledTestCase):
    def test_each_is_refused(self):
        for number, (name, (spoil, parts)) in enumerate(CASES.items()):
            case = self.column(str(number))
            case.mesh()
            spoil(case)
            log = self.refused(name, case, *parts)
            self.expect_equal(f"{name}: scripts that were run", log.count("Particle engine lammps runs"), 0)
            self.expect_true(f"{name}: no log of the engine", not (case.folder / "log.lammps").exists())

    def test_on_two_ranks(self):
        for number, name in enumerate(("inlet full of solid", "pressure on a wall", "script in other units",
                                       "no gas step", "end at the start", "equation of turbulence without a solver")):
            spoil, parts = CASES[name]
            case = self.column(f"ranks-{number}")
            case.mesh()
            spoil(case)
            # The rank that is the first to end the run may know the file by another name.
            self.refused(f"{name}, two ranks", case, parts[0], ranks=2)

    def test_turbulence_is_tried_without_a_trace(self):
        for ranks in (1, 2):
            case = self.column(f"turbulent-{ranks}")
            case.mesh()
            turbulent(case)
            append(case, CONTROL, "endTime 1e-4; writeInterval 1e-4;")
            log = case.solve(ranks=ranks)
            self.expect_equal("solved once in the step", log.count("Solving for epsilon"), 1)
            self.expect_true("in the step", log.index("\nTime = ") < log.index("Solving for epsilon"))

    def test_nothing_left_to_compute(self):
        case = self.column("done")
        case.mesh()
        append(case, CONTROL, "endTime 1e-4; writeInterval 1e-4;")
        case.solve()
        (case.folder / "log.lammps").unlink()
        append(case, CONTROL, "startFrom latestTime;")
        log = case.solve()
        self.expect_equal("steps", log.count("\nTime = "), 0)
        self.expect_true("message", "The case has reached endTime = 0.0001 s: there is nothing left to compute" in log)
        self.expect_true("no log of the engine", not list(case.folder.glob("log.lammps*")))


if __name__ == "__main__":
    unittest.main()
