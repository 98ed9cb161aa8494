# SPDX-License-Identifier: BSD-3-Clause
"""twoPhaseEulerFoam with every drag closure of libcohesionTwoFluid: a uniform suspension that settles through gas at
rest, in by the upper end and out by the lower, and gas blown through grains too heavy to move. Far from the ends
nothing depends on the place, so that neither the mesh nor the schemes have a part in it: the speed of settling and the
pressure gradient are those of the force balance with the formula of closure_formulas.py."""

import os
import re
import unittest
from pathlib import Path

import numpy as np
from scipy.optimize import brentq

from cohesion_studies.foam_case import environment
from cohesion_tests.coupling.two_fluid import SOLVER, column, edit, replace, times, without_stress
from cohesion_tests.theory.closure_formulas import CLOSURES, DOUBLE
from cohesion_tests.theory.filtered_drag import share

WORK, ENV = Path(os.environ["COHESION_WORK"]), environment(os.environ["COHESION_BUILD"])
G = 9.81
RHO, MU = 1.2, 1.8e-5
# Suspensions: diameter [m], density of the grains, solid fraction, and of the column height [m] and time [s], in
# which they do not fall far in it. Slow and with inertia, Reynolds numbers near 0.1 and 20.
SUSPENSIONS = {"powder": (75e-6, 1500.0, 0.3, 0.4, 0.4), "sand": (3e-4, 2500.0, 0.15, 40.0, 4.0)}
# Of a powder with the little drag that is left in coarse cells
COARSE = (75e-6, 1500.0, 0.3, 80.0, 4.0)
CELLS, HEIGHT, STEPS = 20, 0.4, 100
MIDDLE = slice(5, 15)
# The solver makes velocities of cells of the fluxes through their faces. At an end of the column that is off, and from
# there velocities alternate from cell to cell: by no more than WIGGLE in the middle (checked), which the mean over ten
# cells divides by ten. Drag goes with no more than the square of it. The solid fraction there is to stay to UNEVEN
# (checked), and what is expected is that of its mean, of which speeds are a smooth function. A start with another slip
# has died out but for START (checked). 2 WIGGLE/10, a fifth of the 0.5 % at which a closure would be called wrong:
WIGGLE, UNEVEN, START, TOLERANCE = 5e-3, 2e-3, 1e-6, 1e-3


def slip_of(law, d, density, solid):
    """Slip [m/s] at which the drag holds up grains in form A, beta/(1 - eps) slip = eps (rho_s - rho) g, and the time
    [s] in which they come to it in gas that stays at rest."""
    eps = 1 - solid

    def excess(slip):
        return law(DOUBLE, eps, slip, d, RHO, MU) * slip - eps * (density - RHO) * G

    slip = brentq(excess, 1e-9, 1e2, xtol=1e-15, rtol=1e-14)
    return slip, density / law(DOUBLE, eps, slip, d, RHO, MU)


def factored(ctx, *where):
    return 0.15 * CLOSURES["wenYu"](ctx, *where, n="9.6")


LAWS = {**{name: (f"type {name};", law) for name, law in CLOSURES.items()},
        "factor": ("type wenYu; dragFactor 0.15; dragExponent 9.6;", factored)}


def solved(case, step, end):
    times(case, step, end)
    path = case.folder / "system/fvSolution"
    path.write_text(re.sub(r"tolerance +1e-\d+;", "tolerance 1e-12;", path.read_text()))
    case.run("blockMesh")
    (case.folder / "0").mkdir()
    for file in (case.folder / "0.orig").iterdir():
        (case.folder / "0" / file.name).write_text(file.read_text())
    case.run(SOLVER)
    return case.folder / f"{end:g}"


def cells(folder, field, components=1):
    """Values in the cells, in the rows of the column: (CELLS, components)."""
    text = (folder / field).read_text()
    uniform = re.search(r"internalField\s+uniform \(?([^);]*)\)?;", text)
    if uniform:
        return np.tile(np.array(uniform[1].split(), float), (CELLS, 1))
    block = re.search(r"internalField\s+nonuniform[^(]*\((.*?)\n\)\s*;", text, re.S)[1]
    return np.array(re.sub(r"[()]", " ", block).split(), float).reshape(CELLS, components)


class UniformBeds(unittest.TestCase):
    def near(self, what, found, expected):
        with self.subTest(what):
            self.assertLessEqual(abs(found / expected - 1), TOLERANCE, f"{found!r}, expected {expected!r}")

    def even(self, what, velocity):
        with self.subTest(f"{what}: velocities of cells are alike"):
            self.assertLess(np.abs(velocity / velocity.mean() - 1).max(), WIGGLE)

    def fill(self, case, solid):
        replace(case, "0.orig/alpha.particles", "uniform 0;", f"uniform {solid!r};")
        replace(case, "0.orig/alpha.air", "uniform 1;", f"uniform {1 - solid!r};")

    def settle(self, name, words, law, of, suspension):
        d, density, solid, height, end = suspension
        time = slip_of(law, d, density, solid)[1]
        # Implicit steps of dt/time = x leave 1/(1 + x) each.
        self.assertLess((1 + end / STEPS / time) ** -STEPS, START, f"{name} {of}: not yet steady")
        case = column(WORK / f"settle-{of}-{name}", ENV, CELLS, height, (RHO, MU), (d, density), words)
        without_stress(case)
        for end_of in ("inlet", "outlet"):
            replace(case, "0.orig/U.particles", f"{end_of} {{ type fixedValue; value uniform (0 0 0); }}",
                    f"{end_of} {{ type zeroGradient; }}")
        self.fill(case, solid)
        edit(case, "constant/gasVelocity", velocity=0)
        # Nothing holds grains without stress apart: no fraction is to rise by what alternates at the ends.
        edit(case, "system/fvSolution", extremaCoeff=0)
        folder = solved(case, end / STEPS, end)
        where = f"{name}, {of}"
        fractions = cells(folder, "alpha.particles")[MIDDLE]
        self.assertLess(np.abs(fractions / solid - 1).max(), UNEVEN, where)
        solid = fractions.mean()
        slip = slip_of(law, d, density, solid)[0]
        speed = cells(folder, "U.air", 3)[MIDDLE, 1] - cells(folder, "U.particles", 3)[MIDDLE, 1]
        self.even(where, speed)
        self.near(f"{where}: slip [m/s]", speed.mean(), slip)
        self.near(f"{where}: settling [m/s]", cells(folder, "U.particles", 3)[MIDDLE, 1].mean(), -slip)
        p = cells(folder, "p")[MIDDLE, 0]
        # The gas carries them: dp/dy is the weight of both.
        weight = (solid * density + (1 - solid) * RHO) * G
        self.near(f"{where}: pressure gradient [Pa/m]", (p[0] - p[-1]) / (9 * height / CELLS), weight)

    def test_suspensions_settle(self):
        for name, (words, law) in LAWS.items():
            # Packed beds have each closure with inertia; here two of them, a drag and a force.
            for of in SUSPENSIONS if name in ("wenYu", "tang") else ("powder",):
                self.settle(name, words, law, of, SUSPENSIONS[of])

    def test_a_suspension_in_coarse_cells_settles_with_what_is_left_of_the_drag(self):
        """In cells of 4 m, in which the filter leaves 5 % of the drag."""
        cell = COARSE[3] / CELLS

        def filtered(ctx, eps, slip, d, rho, mu):
            return CLOSURES["wenYu"](ctx, eps, slip, d, rho, mu) * share(1 - eps, cell, d, COARSE[1], rho, mu, G)

        self.settle("radlSundaresan", "type wenYu; filter radlSundaresan;", filtered, "coarse", COARSE)

    def test_packed_beds_have_their_pressure_drop(self):
        """Grains of 1e18 kg/m3 stay where they are, and without gravity; all else as it is."""
        for name, (words, law) in LAWS.items():
            for superficial, solid, d in ((0.05, 0.58, 3e-4), (2.0, 0.45, 1e-3)):
                eps = 1 - solid
                case = column(WORK / f"packed-{name}-{superficial}", ENV, CELLS, HEIGHT, (RHO, MU), (d, 1e18), words)
                without_stress(case)
                self.fill(case, solid)
                replace(case, "constant/g", "(0 -9.81 0)", "(0 0 0)")
                edit(case, "constant/gasVelocity", velocity=superficial)
                # Through all cells from the first step on
                for start in ("internalField", "alpha alpha.air; value", "phi phi.air; value"):
                    replace(case, "0.orig/U.air", f"{start} uniform (0 $velocity 0)",
                            f"{start} uniform (0 {superficial / eps!r} 0)")
                folder = solved(case, 2e-4, 4e-3)
                slip = superficial / eps
                beta = solid * law(DOUBLE, eps, slip, d, RHO, MU)
                self.even(f"{name}, {superficial} m/s", cells(folder, "U.air", 3)[MIDDLE, 1])
                p = cells(folder, "p")[MIDDLE, 0]
                # eps dp/dy = -beta slip, between the middles of cells far from the ends
                drop = (p[0] - p[-1]) / (9 * HEIGHT / CELLS)
                self.near(f"{name}, {superficial} m/s: pressure gradient [Pa/m]", drop, beta * slip / eps)


if __name__ == "__main__":
    unittest.main()
