# SPDX-License-Identifier: BSD-3-Clause
"""Suspensions that settle in a column closed below: what sinks displaces gas upwards, and the spheres
settle at the speed that the drag closure gives for their void fraction; with Wen and Yu's without inertia
that is Richardson and Zaki's eps^n of a single sphere's."""

import unittest

import numpy as np
from scipy.optimize import brentq

from cohesion_tests.coupling.fields import numbers
from cohesion_tests.coupling.test_case import CoupledTestCase
from cohesion_tests.theory.closure_formulas import CLOSURES, DOUBLE

RHO_P, RHO, MU, G = 1000.0, 1.2, 1.0, 9.81
CELL, CELLS = 0.02, 9
# column/suspension.lmp: columns of spheres to a column of cells, their distance in each [m]
COLUMNS, SPACING = 16, 0.005
DT, STEPS = 1e-4, 200


def volume(d):
    return np.pi / 6 * d**3


def void_fraction(d):
    return 1 - COLUMNS * volume(d) / (CELL**2 * SPACING)


def settle(column, closure, form, d):
    """Mean speed [m/s] of the spheres far from top and bottom."""
    case = column(f"{closure}-{form}-{d}")
    coupling = "constant/couplingProperties"
    case.set("constant/transportProperties", "rho", RHO)
    case.set("constant/transportProperties", "nu", MU / RHO)
    case.set(coupling, "drag", closure)
    case.set(coupling, "form", form)
    # With the centre alone no sphere would enter the lowest row as all sink, and no gas leave it.
    case.set(coupling, "voidFraction", "sphereOverlap")
    case.set(coupling, "lammpsCoeffs/script", '"$FOAM_CASE/suspension.lmp"')
    basis = " ".join(f"basis {(n // 4 + 0.5) / 4} {(n % 4 + 0.5) / 4} {(n + 0.5) / COLUMNS}"
                     for n in range(COLUMNS))
    (case.folder / "lattice").write_text(
        f"lattice custom 1 a1 {CELL} 0 0 a2 0 {CELL} 0 a3 0 0 {SPACING} {basis}\n")
    case.set(coupling, "lammpsCoeffs/variables/lattice", "lattice")
    case.set(coupling, "lammpsCoeffs/variables/diameter", d)
    case.set("system/fvSolution", 'solvers/"p.*"/tolerance', 1e-13)
    for entry, value in (("deltaT", DT), ("endTime", DT * STEPS), ("writeInterval", DT * STEPS)):
        case.set("system/controlDict", entry, value)
    case.mesh()
    case.solve()
    cloud = case.folder / f"{DT * STEPS:g}" / "lagrangian/particles"
    velocity = numbers(cloud / "U", 3)[np.argsort(numbers(cloud / "id", 1)[:, 0])]
    # LAMMPS numbers a lattice from below; the middle of 38 layers
    layers = velocity.reshape(-1, CELLS * COLUMNS, 3)
    assert len(layers) == 38
    return -layers[14:24, :, 2].mean()


def expected(closure, d):
    """Speed at which the drag carries the weight in the suspension. Gas and spheres move such that no
    volume passes: the superficial slip is the speed. F_total = F_drag/eps carries V (rho_p - rho) g."""
    eps = void_fraction(d)

    def surplus(speed):
        law = CLOSURES[closure](DOUBLE, eps, speed / eps, d, RHO, MU)
        return law * speed / eps**2 - (RHO_P - RHO) * G
    return brentq(surplus, 1e-9, 1.0, xtol=1e-15)


def displacement_error(d):
    """Largest share by which the speed is off as the faces between rows do not cut the mean area of
    spheres: the trapezoidal rule, step SPACING/16, for the area pi (d^2/4 - z^2) of a sphere's cuts,
    whose slope changes by pi d at both ends, is off by step^2/12 x 2 pi d of the volume. By as much too
    little of the solid's flux is given up by the gas, (1 - eps) of the slip."""
    step = SPACING / COLUMNS
    return step**2 / 12 * 2 * np.pi * d / volume(d) * (1 - void_fraction(d))


class Suspensions(CoupledTestCase):
    def test_speeds(self):
        speeds = {}
        for closure, form, d in (("ergunWenYu", "A", 2e-3), ("ergunWenYu", "A", 3.6e-3),
                                 ("beetstra", "A", 4e-3), ("beetstra", "B", 4e-3)):
            speed, right = settle(self.column, closure, form, d), expected(closure, d)
            # The slip decays within m/b < 1e-3 s, the run is 20 of these.
            self.expect_near(f"{closure}, form {form}, void fraction {void_fraction(d):.4f}: speed [m/s]", speed,
                             right, (displacement_error(d) + 1e-6) * right)
            speeds[d] = speed / d**2
        # A single sphere's speed without inertia goes with d^2; Schiller and Naumann's 0.15 Re^0.687 at
        # Re < 1e-4 is below 3e-4.
        dilute, dense = 2e-3, 3.6e-3
        ratio = np.log(void_fraction(dilute) / void_fraction(dense))
        self.expect_near("Richardson and Zaki's exponent", np.log(speeds[dilute] / speeds[dense]) / ratio, 4.65,
                         (displacement_error(dilute) + displacement_error(dense) + 3e-4) / ratio)


if __name__ == "__main__":
    unittest.main()
