# SPDX-License-Identifier: BSD-3-Clause
"""Gas blown past spheres that are held on the vertical axes of the columns of cells, in layers of
different void fraction: the drag they feel, with the gas and void fraction of their cell and with those
interpolated to each of them, against the closure written out again. On the axis of a cell, with a field
that varies along it only, OpenFOAM's interpolation is linear between cell centres."""

import unittest

import numpy as np

from cohesion_tests.coupling.cases import exchange_lines
from cohesion_tests.coupling.fields import field
from cohesion_tests.coupling.test_case import CoupledTestCase
from cohesion_tests.theory.closure_formulas import CLOSURES, DOUBLE

RHO, SUPERFICIAL = 1.205, 0.5
MU = RHO * 1.452282e-5  # column/constant/transportProperties
ROW, ROWS, AXES = 0.02, 10, 9
CENTRES = (np.arange(ROWS) + 0.5) * ROW
# column/axes.lmp: on each axis
Z = 0.04 + 2.5e-3 * (np.arange(40) + 0.5)
DIAMETER = np.select([Z < 0.08, Z < 0.12], [8e-3, 6e-3], 9e-3)
VOLUME = np.pi / 6 * DIAMETER**3
CELL = (Z / ROW).astype(int)


def drag(at):
    """Drag on all spheres [N], with the fields of the cells brought to the spheres by `at`."""
    eps = 1 - np.bincount(CELL, VOLUME, ROWS) / ROW**3
    law = CLOSURES["diFelice"]
    return AXES * sum(
        volume * law(DOUBLE, e, u, d, RHO, MU) * u
        for volume, e, u, d in zip(VOLUME, at(eps), at(SUPERFICIAL / eps), DIAMETER))


EXPECTED = {
    "cell": drag(lambda field: field[CELL]),
    "interpolated": drag(lambda field: np.interp(Z, CENTRES, field)),
}


def blow(column, slip, ranks):
    case = column(f"{slip}-{ranks}")
    case.set("constant/couplingProperties", "lammpsCoeffs/script", '"$FOAM_CASE/axes.lmp"')
    case.set("constant/couplingProperties", "drag", "diFelice")
    case.set("constant/couplingProperties", "slip", slip)
    case.set("0.orig/U", "boundaryField/bottom/superficialVelocity", f"(0 0 {SUPERFICIAL})")
    case.set("system/fvSolution", 'solvers/"p.*"/tolerance', 1e-13)
    # The gas is set in motion within one step: what few corrections leave of that dies out slowly.
    case.set("system/fvSolution", "PIMPLE/nCorrectors", 8)
    case.set("system/fvSolution", "PIMPLE/nOuterCorrectors", 8)
    case.set("system/controlDict", "endTime", 10e-4)
    case.set("system/controlDict", "deltaT", 1e-4)
    case.set("system/controlDict", "writeInterval", 10e-4)
    case.mesh()
    return case, case.solve(ranks=ranks)


def unevenness(case, ranks):
    """Largest difference of a cell's flux eps U from the mean over its row, over that [1]."""
    if ranks > 1:
        case.run("reconstructPar")
    eps, velocity = (field(case, "0.001", name) for name in ("voidFraction", "U"))
    flux = eps[:, None] * velocity.reshape(-1, 3)
    return np.linalg.norm(flux - [0, 0, SUPERFICIAL], axis=1).max() / SUPERFICIAL


class InterpolatedSlip(CoupledTestCase):
    def test_the_two_differ(self):
        difference = EXPECTED["interpolated"] / EXPECTED["cell"] - 1
        self.expect_true(f"the two differ ({difference:.3%})", abs(difference) > 1e-3)

    def test_drag(self):
        for slip, expected in EXPECTED.items():
            for ranks in (1, 2):
                case, log = blow(self.column, slip, ranks)
                lines = exchange_lines(log)
                drag_force = lines[-1]["drag"]
                across = max(abs(drag_force[0]), abs(drag_force[1]))
                self.expect_below(f"{slip}, {ranks} ranks: force across the axes [N]", across, 1e-11 * expected)
                # Continuity gives each row its flux, but not its cells. The drag goes with at most the second
                # power of the flux at the sphere. And the digits of the log.
                uneven = unevenness(case, ranks)
                self.expect_below(f"{slip}, {ranks} ranks: unevenness of a row", uneven, 1e-6)
                self.expect_near(f"{slip}, {ranks} ranks: drag [N]", drag_force[2], expected,
                                 (2 * uneven + 1e-11) * expected)
                self.expect_balance(f"{slip}, {ranks} ranks", lines)


if __name__ == "__main__":
    unittest.main()
