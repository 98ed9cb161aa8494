# SPDX-License-Identifier: BSD-3-Clause
"""Gas blown through three layers of spheres that are held where they are, free rows of cells below and above."""

import re

import numpy as np

from cohesion_tests.coupling.cases import use_script
from cohesion_tests.coupling.fields import field
from cohesion_tests.theory.closure_formulas import DOUBLE

RHO, MU, G = 1.205, 1.75e-5, 9.81
SUPERFICIAL = 0.5
DT, STEPS = 1e-4, 20
HEIGHT, ROW, CELL = 0.2, 0.02, 0.02**3  # of the mesh, a row and a cell (column/system)
# Spheres per cell and diameter in the ten rows, from the lattices of column/packed.lmp.
FREE, DENSE, LOOSE, DILUTE = (0, 1e-3), (4 * 5**3, 2.6e-3), (8**3, 2e-3), (4**3, 3e-3)
ROWS = [FREE, FREE, DENSE, DENSE, LOOSE, LOOSE, DILUTE, FREE, FREE, FREE]


def solid(row):
    number, diameter = row
    return number * np.pi / 6 * diameter**3 / CELL


def drag(row, closure):
    """Drag per volume of gas and spheres at rest, beta U [N/m3]."""
    if solid(row) == 0:
        return 0.0
    eps, diameter = 1 - solid(row), row[1]
    slip = SUPERFICIAL / eps
    return (1 - eps) * slip * closure(DOUBLE, eps, slip, diameter, RHO, MU)


def rows(case, time, name):
    """Mean of the field's cells in each row, the lowest first."""
    return field(case, time, name).reshape(len(ROWS), 9, -1).mean(axis=1).squeeze()


def drop(case, time):
    """Pressure in the middle of the lowest row less that of the highest [Pa]."""
    p = rows(case, time, "p")
    return RHO * (p[0] - p[-1])


def blow(column, name, settings, superficial=SUPERFICIAL, ranks=1, script="packed"):
    """Runs the bed with `settings` of couplingProperties; the case, its last error of continuity, and
    the solver's log."""
    case = column(name)
    for entry, value in settings.items():
        case.set("constant/couplingProperties", entry, value)
    use_script(case, script)
    case.set("0.orig/U", "boundaryField/bottom/superficialVelocity", f"(0 0 {superficial})")
    # Central, for convection to have no part in the pressure drop: see viscous().
    case.set("system/fvSchemes", "divSchemes/div(voidFractionPhi,U)", "Gauss linear")
    case.set("system/controlDict", "deltaT", DT)
    case.set("system/controlDict", "endTime", STEPS * DT)
    case.set("system/controlDict", "writeInterval", STEPS * DT / 2)
    if ranks > 1:
        case.set("system/decomposeParDict", "coeffs/n", f"(2 {ranks // 2} 1)")
    case.mesh()
    log = case.solve(ranks=ranks)
    errors = re.findall(r"Continuity error, mean of the sizes: (\S+)", log)
    return case, float(errors[-1]), log


def flux_limit(expected):
    """Largest error of the flux [m/s] at a pressure drop of `expected` [Pa].

    The fluxes through two levels differ by no more than the sum of the errors of all cells. The
    solver of p brings that sum to 1e-10 of the sum of the sizes of its terms, here over the area of
    the column: with faces that let pass at most dt/rho of the pressure gradient, and with a
    pressure that falls from cell to cell, 12 dt/rho times the drop over one row."""
    return 1e-10 * 12 * DT / RHO * expected / ROW


def drop_error(limit, steps, eps):
    """Error of the pressure drop [Pa] for that of the flux [m/s], the drops over the rows [Pa] and
    their void fractions: it meets drag, at most quadratic in U, and the inertia rho/(eps dt) of a row."""
    return limit * (2 * steps.sum() / SUPERFICIAL + RHO / DT * np.sum(1 / eps) * ROW)


def viscous(eps):
    """Most that viscous stress adds to the pressure drop [Pa].

    A flux F of momentum through a face adds F (1/eps_below - 1/eps_above) to the drop. That of
    convection, rho eps U (U_below + U_above)/2 with the central scheme, adds differences of
    rho U^2/2, whose sum is zero between free rows. The viscous one is at most mu (1 + 1/3) dU/dz;
    the two end rows count half, which leaves 1/2 of it on either side."""
    speed = SUPERFICIAL / eps
    return (4 / 3 * MU * np.abs(np.diff(speed)).max() / ROW
            * (np.abs(np.diff(1 / eps)).sum() + 1))
