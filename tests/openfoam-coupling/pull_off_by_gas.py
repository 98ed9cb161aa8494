# SPDX-License-Identifier: BSD-3-Clause
"""Grains at rest that adhere to a plane and to a fixed grain leave when the force of the gas equals F_ad plus the
weight, whatever the particle step. The gas comes through the plane, and its velocity rises slowly.

Grains of 75 um and 1500 kg/m3 with F_ad of twelve weights, in air of up to 2 m/s, where the Reynolds number is 10. The
grains fill 3e-8 of their cells. So the gas velocity U in all cells is that of the inlet, and the force of the gas on a
grain of volume V follows in closed form: the drag of a single sphere by Schiller and Naumann, plus the pressure force
V rho (g + dU/dt). The test also reads the force that the engine applies, b u - V dp/dz on a grain at rest.

A grain parts when its gap exceeds H_cut, up to which the attraction is F_ad. The load at parting is that of the gas
step in which this happens. Expected deviations of this load from F_ad + m g, over F_ad:

| cause | size |
|---|---|
| The load grows while the grain crosses H_cut, by at most (6 H_cut m k^2/F_ad)^(1/3), k = dL/dt/F_ad. | LAG = 1.0e-3 |
| The load is constant over a gas step and rises by k dt in the next. The grain overshoots by this at most. | 0.7e-3 |
| The drag coefficient is that of the gas of the step before: k dt d(ln b)/d(ln U). | 0.2e-3 |
| The dashpot resists as the contact opens by F_ad/K in the time 1/k: 2 alpha m k/K. | 0.1e-3 |

Their sum is the tolerance, 2.0e-3. The first is smaller on a soft spring, since the grain arrives at a gap of 0 with
the speed k F_ad/K: 0.6e-3 here. The reaction of a grain slows the gas in its cell by F/(rho U h^2) = 5e-6 m/s, h the
width of the column.

In LIGGGHTS a contact has the overlap F_ad/K - L/K' (docs/theory/exact_contacts.md) until it is resolved
within the step, where it has (F_ad - L)/K. It swings by the difference and may part at a load that is lower by half a
hundredth of F_ad (contact_solver.h), which is added to the tolerance there. At the step t_c/20 it does.
"""

import math
import sys
import unittest

import numpy as np
from scipy.optimize import brentq

from cohesion_tests.coupling.cases import CONTROL, COUPLING, ENGINE, append, edit, script_file
from cohesion_tests.coupling.test_case import CoupledTestCase
from cohesion_tests.theory.slow_ramp import CUT, DENSITY, OUT, rate_of_lag

RHO, MU, G = 1.205, 1.75e-5, 9.81
D = 75e-6
VOLUME = math.pi / 6 * D**3
MASS = DENSITY * VOLUME
A = 1e-21  # of grain and plane, rough ones; twice as much between grains gives the same F_ad
F_AD = A * D / 2 / (6 * CUT**2)
WEIGHT = MASS * G

RESTITUTION = 0.9
GAS_STEP = 1e-4
CONTACT_TIME = 2 * GAS_STEP
ALPHA = -math.log(RESTITUTION) / CONTACT_TIME
STIFFNESS = MASS * ((math.pi / CONTACT_TIME) ** 2 + ALPHA**2)

LAG = 1e-3
TOLERANCE = 2.0e-3 if ENGINE == "lammps" else 7.0e-3
DIVISIONS = (4, 10, 50) if ENGINE == "lammps" else (4, 10, 20, 50)
FIXED = 0.11  # height of the grain that is held, in the middle of a cell


def drag(speed):
    return 3 * math.pi * MU * D * speed * (1 + 0.15 * (RHO * speed * D / MU) ** 0.687)


def slope(speed):
    """d drag/d speed"""
    return 3 * math.pi * MU * D * (1 + 1.687 * 0.15 * (RHO * speed * D / MU) ** 0.687)


LIFTING = float(brentq(lambda speed: drag(speed) + VOLUME * RHO * G - F_AD - WEIGHT, 0.1, 10))  # [m/s]
# dU/dt, by which the load grows at the rate of the lag
RISE = rate_of_lag(LAG, F_AD, MASS) * F_AD / slope(LIFTING)
FIRST, LAST = 0.6 * LIFTING, 1.01 * LIFTING  # gas velocities: from 0.52 to 1.013 of the load
STEPS = round((LAST - FIRST) / RISE / GAS_STEP)
END = STEPS * GAS_STEP


def force(time):
    """Of the gas on a grain at rest [N]"""
    return drag(FIRST + (LAST - FIRST) * time / END) + VOLUME * RHO * (G + RISE)


class PullOffByGas(CoupledTestCase):
    def pulled(self, division):
        """Of grains 1, 2 and 3 at the end of each gas step: arrays of heights, and of the force that the gas applies to
        a grain at rest there in that gas step."""
        case = self.column(f"division-{division}")
        at_rest = (F_AD + WEIGHT - force(0)) / STIFFNESS  # overlap
        per_gas_step = round(division * GAS_STEP / CONTACT_TIME)
        variables = {
            "dt": GAS_STEP / per_gas_step, "every": per_gas_step, "diameter": D, "density": DENSITY,
            "on_plane": D / 2 - at_rest, "fixed": FIXED, "on_fixed": FIXED + D - at_rest,
            "stiffness": STIFFNESS, "restitution": RESTITUTION, "damping": 2 * ALPHA,
            "A_plane": A, "A_grains": 2 * A, "H_cut": CUT, "H_out": OUT}
        append(case, COUPLING, f"""drag wenYu;
{ENGINE}Coeffs
{{
    script "$FOAM_CASE/{script_file("pulled")}";
    variables {{ {" ".join(f'{name} "{value!r}";' for name, value in variables.items())} }}
}}""")
        case.set("0.orig/U", "internalField", f"uniform (0 0 {FIRST!r})")
        case.set("0.orig/U", "boundaryField/bottom/superficialVelocity",
                 f"table ((0 (0 0 {FIRST!r})) ({END!r} (0 0 {LAST!r})))")
        append(case, CONTROL, f"deltaT {GAS_STEP!r}; endTime {END!r}; writeInterval {END!r};")
        edit(case, "system/blockMeshDict", "(3 3 10)", "(1 1 10)")
        case.mesh()
        case.solve()
        rows = [line.split() for line in (case.folder / "pulled.dump").read_text().splitlines()]
        rows = np.array([row for row in rows if len(row) == 5 and row[0].isdigit()], float).reshape(-1, 3, 5)
        rows = rows[np.arange(len(rows))[:, None], np.argsort(rows[:, :, 0])]
        z, coefficient, gas, gradient = rows[:, :, 1:].transpose(2, 0, 1)
        return z, coefficient * gas - VOLUME * gradient

    def test_at_any_step(self):
        for division in DIVISIONS:
            z, applied = self.pulled(division)
            self.expect_equal(f"t_c/{division}: states, that of the start included", len(z), STEPS + 1)
            for partner, grain, gap in (("plane", 0, z[:, 0] - D / 2), ("fixed grain", 2, z[:, 2] - z[:, 1] - D)):
                what = f"{ENGINE}, t_c/{division}, {partner}"
                parts = np.flatnonzero(gap < CUT)[-1] + 1
                self.assertLessEqual(parts, STEPS, f"{what}: the grain stays")
                load = {"closed form": force(parts * GAS_STEP), "as applied": applied[parts, grain]}
                found = {name: (value - WEIGHT) / F_AD for name, value in load.items()}
                print(what, *(f"{name} {value:.5f}" for name, value in found.items()), file=sys.stderr)
                for name, value in found.items():
                    self.expect_near(f"{what}: load at parting less the weight, over F_ad, {name}", value, 1, TOLERANCE)


if __name__ == "__main__":
    unittest.main()
