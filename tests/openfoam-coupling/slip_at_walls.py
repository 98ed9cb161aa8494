# SPDX-License-Identifier: BSD-3-Clause
"""Gas blown between walls that hold it, noSlip, through spheres that fill the column evenly and are held: the boundary
layer is far thinner than a cell, and the gas flows evenly but for what viscosity makes of it over a cell. The drag is
what the closure says on paper, with the gas of the cells and with that interpolated to each sphere, whatever the void
fraction is said to be where the gas comes in. On 1 and 2 ranks."""

import unittest

import numpy as np

from cohesion_tests.coupling.cases import append, edit, exchange_lines, use_script
from cohesion_tests.coupling.fields import cells, field
from cohesion_tests.coupling.test_case import CoupledTestCase
from cohesion_tests.theory.closure_formulas import CLOSURES, DOUBLE

RHO, SUPERFICIAL = 1.205, 0.5
MU = RHO * 1.452282e-5  # column/constant/transportProperties
CELL, SPACING, DIAMETER = 0.02, 4e-3, 3.2e-3
NUMBER = 15 * 15 * 50
EPS = 1 - np.pi / 6 * (DIAMETER / SPACING) ** 3
VELOCITY = SUPERFICIAL / EPS
COEFFICIENT = CLOSURES["diFelice"](DOUBLE, EPS, VELOCITY, DIAMETER, RHO, MU)
DRAG = NUMBER * np.pi / 6 * DIAMETER**3 * COEFFICIENT * VELOCITY
# A wall takes eps mu U/(h/2) over the area of a cell, a corner twice that; drag per volume is (1 - eps) of the
# coefficient times U, and grows with U at least. So the gas of a corner is slower than that in the middle by no more
# than the ratio of the two. Convection evens it out further.
UNEVEN = 4 * EPS * MU / CELL**2 / ((1 - EPS) * COEFFICIENT)


def blow(column, slip, patch, ranks):
    case = column(f"{slip}-{patch}-{ranks}")
    use_script(case, "layers")
    edit(case, "layers.lmp", "0.05 0.14", "0 0.2")
    edit(case, "layers.lmp", "a3 0 0 3.3e-3", f"a3 0 0 {SPACING}")
    case.set("constant/couplingProperties", "drag", "diFelice")
    case.set("constant/couplingProperties", "slip", slip)
    append(case, "0.orig/U", f"""boundaryField
{{
    bottom {{ superficialVelocity (0 0 {SUPERFICIAL}); }}
    sides {{ type noSlip; }}
}}""")
    append(case, "0.orig/voidFraction", f"boundaryField {{ bottom {{ type {patch}; value uniform 1; }} }}")
    case.set("system/fvSolution", 'solvers/"p.*"/tolerance', 1e-13)
    # As in interpolated_slip.py
    case.set("system/fvSolution", "PIMPLE/nCorrectors", 8)
    case.set("system/fvSolution", "PIMPLE/nOuterCorrectors", 8)
    case.set("system/controlDict", "endTime", 10e-4)
    case.set("system/controlDict", "writeInterval", 10e-4)
    case.mesh()
    return case, case.solve(ranks=ranks)


def unevenness(case, ranks):
    """Largest difference of a cell's flux eps U from the superficial velocity, over that [1]."""
    if ranks > 1:
        case.run("reconstructPar")
    flux = cells(case, "0.001", "voidFraction")[:, None] * field(case, "0.001", "U").reshape(-1, 3)
    return np.linalg.norm(flux - [0, 0, SUPERFICIAL], axis=1).max() / SUPERFICIAL


class SlipAtWalls(CoupledTestCase):
    def check(self, slip, patch, ranks=1):
        what = f"{slip}, {patch} at the inlet, {ranks} ranks"
        case, log = blow(self.column, slip, patch, ranks)
        uneven = unevenness(case, ranks)
        # 1e-6: what the corrections leave, as in interpolated_slip.py
        self.expect_below(f"{what}: unevenness of the gas", uneven, UNEVEN + 1e-6)
        lines = exchange_lines(log)
        # Drag goes with at most the second power of the gas velocity; and the digits of the log.
        self.expect_near(f"{what}: drag [N]", lines[-1]["drag"][2], DRAG, (2 * uneven + 1e-11) * DRAG)
        self.expect_balance(what, lines)

    def test_cell(self):
        self.check("cell", "zeroGradient")

    def test_interpolated(self):
        for patch in ("zeroGradient", "fixedValue"):
            self.check("interpolated", patch)

    def test_ranks(self):
        self.check("interpolated", "fixedValue", ranks=2)


if __name__ == "__main__":
    unittest.main()
