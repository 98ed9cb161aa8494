# SPDX-License-Identifier: BSD-3-Clause
"""Every model of libcohesionTwoFluid at 20 points, made by its name as twoPhaseEulerFoam makes it, against the formula
as it is printed, and against the solver's own model where there is one of the same law."""

import os
import subprocess
import unittest
from pathlib import Path

import numpy as np

from cohesion_studies.foam_case import environment
from cohesion_tests.coupling.two_fluid import column, nonuniform
from cohesion_tests.theory import filtered_drag
from cohesion_tests.theory.closure_formulas import CLOSURES, DOUBLE

WORK = Path(os.environ["COHESION_WORK"])
D, RHO, MU = 1e-3, 1.205, 1.75e-5
HEIGHT = 0.2  # of 20 square cells in one column [m]
E, ALPHA_MAX = 0.9, 0.643
# In each cell: solid fraction and slip [m/s]. Of the kinetic theory the cells have the temperatures below beside.
POINTS = [(1 - eps, slip) for eps in (0.38, 0.55, 0.7, 0.9, 1.0) for slip in (1e-9, 2e-3, 0.4, 20.0)]
THETA = np.geomspace(1e-6, 1.0, len(POINTS))
FRACTIONS = np.concatenate([np.linspace(0, 0.64, 18), [ALPHA_MAX, 0.66]])

# The solver has them too.
SAME_DRAG = {"wenYu": "WenYu", "ergunWenYu": "GidaspowErgunWenYu", "syamlalOBrien": "SyamlalOBrien"}
SAME_RADIAL = {"carnahanStarling": "CarnahanStarling"}

# Some forty roundings of 1.1e-16 in a law and as many in the fields that its arguments come from; Syamlal and
# O'Brien's loses a factor of 2400 at the largest Reynolds number (tests/src/drag/drag_closure_test.cpp), and
# 1 - phi/phi_m near phi_m another 400.
ROUNDING = 1e-14
TOLERANCE = {"syamlalOBrien": 2400 * 2 * 1.1e-16, "SyamlalOBrien": 2400 * 2 * 1.1e-16, "maAhmadi": 4e-12}


def ma_ahmadi(phi):
    return ((1 + 2.5 * phi + 4.5904 * phi**2 + 4.515456 * phi**3)
            / (1 - (phi / 0.64356)**3)**0.67802)


def carnahan_starling(phi):
    """In the three terms of G. A. Mansoori et al. (1971)."""
    return 1 / (1 - phi) + 3 * phi / (2 * (1 - phi) ** 2) + phi**2 / (2 * (1 - phi) ** 3)


def slope(function, phi):
    """By a step along the imaginary axis: no difference, no error of truncation."""
    return np.imag(function(phi + 1e-30j)) / 1e-30


def igci(phi, x):
    """Igci et al. (2012) as MFiX has it, of x = Delta g/v_t^2."""
    h = np.piecewise(phi, [phi < 0.0012, (phi >= 0.0012) & (phi < 0.014), (phi >= 0.014) & (phi < 0.25),
                           (phi >= 0.25) & (phi < 0.455), (phi >= 0.455) & (phi <= 0.59)],
                     [lambda p: 2.7 * p**0.234, lambda p: -0.019 / p**0.455 + 0.963,
                      lambda p: 0.868 * np.exp(-0.38 * p) - 0.176 * np.exp(-119.2 * p),
                      lambda p: -4.59e-5 * np.exp(19.75 * p) + 0.852 * np.exp(-0.268 * p),
                      lambda p: (p - 0.59) * (-1501 * p**3 + 2203 * p**2 - 1054 * p + 162), 0])
    g = np.where(phi < 0.18, phi**0.24 * (1.48 + np.exp(-18 * phi)), 1)
    return 1 - x**1.6 / (x**1.6 + 0.4) * h * g


def models(folder, settings, fractions, slips, theta, diameter=D):
    """What the program prints: values by (model, name, quantity)."""
    case = column(folder, environment(os.environ["COHESION_BUILD"]), len(POINTS), HEIGHT, (RHO, MU), (diameter, 1500.0),
                  "type wenYu;")
    case.run("blockMesh")
    fields = {"alpha.particles": (fractions, "[0 0 0 0 0 0 0]"), "Theta.particles": (theta, "[0 2 -2 0 0 0 0]")}
    (case.folder / "0").mkdir()
    for file in (case.folder / "0.orig").iterdir():
        (case.folder / "0" / file.name).write_text(file.read_text())
    radial = carnahan_starling(np.asarray(fractions))
    fields["g0"] = (radial, "[0 0 0 0 0 0 0]")
    fields["g0prime"] = (slope(carnahan_starling, np.asarray(fractions)), "[0 0 0 0 0 0 0]")
    fields["rho.particles"] = ([1500.0 + 100 * k for k in range(len(POINTS))], "[1 -3 0 0 0 0 0]")
    fields["U.particles"] = ([(0, -slip, 0) for slip in slips], "[0 1 -1 0 0 0 0]")
    fields["U.air"] = ([(0.0, 0.0, 0.0)] * len(POINTS), "[0 1 -1 0 0 0 0]")
    for name, (values, dimensions) in fields.items():
        kind = "volVectorField" if name[0] == "U" else "volScalarField"
        (case.folder / "0" / name).write_text(
            f"FoamFile {{ version 2.0; format ascii; class {kind}; object {name}; }}\n"
            f"dimensions {dimensions};\ninternalField {nonuniform(values)};\n"
            "boundaryField { frontAndBack { type empty; } \".*\" { type zeroGradient; } }\n")
    (case.folder / "constant/models").write_text(
        "FoamFile { version 2.0; format ascii; class dictionary; object models; }\n" + settings)
    said = subprocess.run([os.environ["COHESION_MODEL_VALUES"]], cwd=case.folder, env=case.env, capture_output=True,
                          text=True)
    assert said.returncode == 0, said.stdout[-3000:] + said.stderr[-3000:]
    rows = [line.split() for line in said.stdout.splitlines()]
    return {tuple(row[:3]): np.array(row[3:], float) for row in rows
            if row and row[0] in ("drag", "radial", "pressure")}


def drag_settings(names, more=""):
    return (f"drag ({' '.join(names)}); radial (); pressure ();\n"
            f"e {E}; alphaMax {ALPHA_MAX}; residualRe 1e-300; swarmCorrection {{ type none; }}\n{more}")


class Models(unittest.TestCase):
    def near(self, what, found, expected, tolerance):
        for point, (value, right) in enumerate(zip(found, expected, strict=True)):
            with self.subTest(what, point=point):
                self.assertLessEqual(abs(value / right - 1), tolerance, f"{value!r}, expected {right!r}")

    def drags(self, name, names, more=""):
        return models(WORK / name, drag_settings(names, more), *zip(*POINTS), THETA)

    def test_each_drag_closure_has_the_values_of_its_formula(self):
        found = self.drags("drag", [*CLOSURES, *SAME_DRAG.values()])
        self.assertEqual(len(found), 2 * len(CLOSURES) + 2 * len(SAME_DRAG))
        for name, closure in CLOSURES.items():
            tolerance = TOLERANCE.get(name, ROUNDING)
            per_solid = np.array([closure(DOUBLE, 1 - solid, slip, D, RHO, MU) for solid, slip in POINTS])
            self.near(f"{name}: CdRe", found["drag", name, "CdRe"], per_solid * D**2 / (0.75 * MU), tolerance)
            # beta, of at least the solver's residualAlpha of 1e-6
            solid = np.maximum([point[0] for point in POINTS], 1e-6)
            self.near(f"{name}: K", found["drag", name, "K"], solid * per_solid, tolerance)
        for ours, own in SAME_DRAG.items():
            self.near(f"{ours}: the solver's {own}", found["drag", ours, "CdRe"], found["drag", own, "CdRe"],
                      2 * TOLERANCE.get(ours, ROUNDING))

    def test_factor_and_exponent(self):
        found = self.drags("exponent", ["wenYu", "ergunWenYu"], "dragFactor 0.15; dragExponent 9.6;")
        for name in ("wenYu", "ergunWenYu"):
            expected = [0.15 * CLOSURES[name](DOUBLE, 1 - solid, slip, D, RHO, MU, n="9.6") * D**2 / (0.75 * MU)
                        for solid, slip in POINTS]
            self.near(name, found["drag", name, "CdRe"], expected, ROUNDING)

    def test_filters(self):
        """In cells of 1 cm, 1.4 v_t^2/g of grains of 75 um. igci: what h loses where terms of 600 leave less than 1, near
        0.5: some four roundings of 1.1e-16 of them times 0.135, 4e-14, over a factor of above 0.8; elsewhere some 1e-14 of
        the volumes of cells, whose places are known to 1.4e-17 m of 0.01. radlSundaresan: the speed expected is known to
        5e-14, of which L has two thirds and the share at most half that; and what 1 - h/(...) loses where it leaves a tenth
        of 1, some 1e-14."""
        phi = np.array([0, 1e-4, 1e-3, 2e-3, 0.01, 0.013, 0.015, 0.05, 0.1, 0.15, 0.17, 0.19, 0.24, 0.26, 0.35, 0.45, 0.46,
                        0.5, 0.58, 0.62])
        d, laws, cell = 75e-6, ("wenYu", "beetstra"), HEIGHT / 20

        def drags(name, more=""):
            return models(WORK / name, drag_settings(laws, more), phi, [0.2] * 20, THETA, d)

        fall = (1500 - RHO) * 9.81 * d**2 / (18 * MU)
        shares = {"igci": igci(phi, cell * 9.81 / fall**2),
                  "radlSundaresan": np.array([filtered_drag.share(x, cell, d, 1500, RHO, MU, 9.81) for x in phi])}
        closure, none = drags("closure"), drags("none", "filter none;")
        for key, values in closure.items():
            self.assertEqual(list(none[key]), list(values), f"{key}: none changes digits")
        for name, share in shares.items():
            found = drags(name, f"filter {name};")
            self.assertLess(share.min(), 0.5)
            for key, values in closure.items():
                self.near(f"{name}, {key}: the share", found[key], values * share, 6e-14)

    def test_radial_functions(self):
        found = models(WORK / "radial", "drag (); pressure ();"
                       f"e {E}; alphaMax {ALPHA_MAX};radial (maAhmadi carnahanStarling CarnahanStarling);",
                       FRACTIONS, [0] * 20, THETA)
        within = np.minimum(FRACTIONS, ALPHA_MAX)
        for name, formula in (("maAhmadi", ma_ahmadi), ("carnahanStarling", carnahan_starling)):
            tolerance = TOLERANCE.get(name, ROUNDING)
            self.near(f"{name}: g0", found["radial", name, "g0"], formula(within), tolerance)
            self.near(f"{name}: g0prime", found["radial", name, "g0prime"], slope(formula, within), tolerance)
        for quantity in ("g0", "g0prime"):
            # The solver's own goes on above alphaMax.
            self.near(f"the solver's own: {quantity}", found["radial", "carnahanStarling", quantity][:-1],
                      found["radial", "CarnahanStarling", quantity][:-1], ROUNDING)

    def test_pressure_with_wells(self):
        """At each point another D/T, from 0.02 to 3e4, beyond what was measured; phi beyond it, too."""
        depth, ratio, mass, phi = 2e-12, 1.05, 1e-9, np.linspace(0.01, 0.64, 20)
        wells = "squareWellCoeffs {{ wellDepth {}; wellRatio {}; grainMass {}; }}"
        settings = (f"drag (); radial (); e {E}; alphaMax {ALPHA_MAX}; pressure (Lun squareWell);")
        theta = np.geomspace(depth / mass / 3e4, depth / mass / 0.02, 20)[::-1]
        theta = np.concatenate([theta[::2], theta[1::2]])  # cold and warm among thin and dense
        found = models(WORK / "wells", settings + wells.format(depth, ratio, mass), phi, [0] * 20, theta)
        gathered = 0.157625 * np.expm1(np.minimum(depth / (mass * theta), 1))

        def excess(x):
            within = np.where(np.real(x) > 0.5, 0.5, x)
            left = 1 - gathered * (1 + 2.764 * within - 0.969 * within**2 - 4.836 * within * gathered)
            return 2 * (1 + E) * x * carnahan_starling(x) * left

        rho = 1500.0 + 100 * np.arange(20)
        self.near("squareWell", found["pressure", "squareWell", "PsCoeff"], rho * phi * (1 + excess(phi)), ROUNDING)
        self.near("its slope", found["pressure", "squareWell", "PsCoeffPrime"],
                  rho * slope(lambda x: x * (1 + excess(x)), phi), ROUNDING)
        for name, words in (("none", wells.format(0, ratio, mass)), ("no-width", wells.format(depth, 1, mass))):
            found = models(WORK / f"wells-{name}", settings + words, phi, [0] * 20, theta)
            for quantity in ("PsCoeff", "PsCoeffPrime"):
                self.near(f"without wells, {name}: the solver's Lun, {quantity}",
                          found["pressure", "squareWell", quantity], found["pressure", "Lun", quantity], ROUNDING)


if __name__ == "__main__":
    unittest.main()
