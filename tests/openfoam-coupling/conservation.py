# SPDX-License-Identifier: BSD-3-Clause
"""In every gas step of a swarm of falling, colliding spheres: what the gas lost is what the particles
felt, and the solid volume on the mesh is that of the particles. With every void-fraction kernel, with
smoothing, with the interpolated slip and in form B, on 1 and 2 ranks, whose particles and cells are cut along
different directions. And the pressure on the particles is that of the gas's fields, as they are written."""

import unittest

import numpy as np

from cohesion_tests.coupling.cases import ENGINE, disturb, exchange_lines, use_script
from cohesion_tests.coupling.fields import field
from cohesion_tests.coupling.held_layers import CELL, G, RHO
from cohesion_tests.coupling.test_case import CoupledTestCase

STEPS = 10
# Of couplingProperties
SETTINGS = {
    "cell": {},
    "interpolated": {"slip": "interpolated"},
    "dividedVolume": {"voidFraction": "dividedVolume"},
    "sphereOverlap": {"voidFraction": "sphereOverlap"},
    "formB": {"form": "B", "voidFraction": "sphereOverlap"},
    "smoothed": {"voidFraction": "sphereOverlap", "smoothingWidth": 0.01, "slip": "interpolated"},
}
# On 2 ranks too: both ways to spread a sphere over cells, smoothing and gathering between cells, and form B.
SHARED = ("dividedVolume", "formB", "smoothed")


def run(column, name, ranks, disturbance=0.0):
    case = column(f"{name}-{ranks}-{disturbance}")
    if disturbance:
        disturb(case, "swarm", disturbance)
    for entry, value in SETTINGS[name].items():
        case.set("constant/couplingProperties", entry, value)
    use_script(case, "swarm")
    case.set("system/fvSolution", 'solvers/"p.*"/tolerance', 1e-13)
    case.set("system/controlDict", "endTime", STEPS * 1e-4)
    case.set("system/controlDict", "writeInterval", STEPS * 1e-4)
    case.set("system/controlDict", "writePrecision", 17)
    case.mesh()
    lines = exchange_lines(case.solve(ranks=ranks))
    if ranks > 1:
        case.run("reconstructPar", "-latestTime")
    return lines, pressure_force(case, SETTINGS[name].get("form", "A"))


def pressure_force(case, form):
    """z force [N] of the gas's pressure on the particles in the last step, by the written fields: the
    void fraction is that of the step's start, the gradient that of its end, held over the step. In
    form B it is the buoyancy alone."""
    time = f"{STEPS * 1e-4:g}"
    solid = (1 - field(case, time, "voidFraction")) * CELL
    gradient = RHO * field(case, time, "gradP").reshape(-1, 3)[:, 2] if form == "A" else -RHO * G
    return -(solid * gradient).sum()


class Conservation(CoupledTestCase):
    def check(self, name):
        runs = {ranks: run(self.column, name, ranks) for ranks in ((1, 2) if name in SHARED else (1,))}
        steps = {ranks: lines for ranks, (lines, _) in runs.items()}
        for ranks, (lines, pressure) in runs.items():
            self.expect_equal(f"{name}: gas steps on {ranks} ranks", len(lines), STEPS)
            # Sums of some 1e3 terms, each rounded to 1e-16: 1e-13 at most. Asked for: 1e-12.
            self.expect_balance(f"{name}, {ranks} ranks", lines)
            # Here 1 - eps is some 0.01, of an eps that is rounded to 1e-16: 1e-14 more.
            self.expect_near(f"{name}, {ranks} ranks: pressure on the particles [N]", lines[-1]["pressure"][2],
                             pressure,
                             1e-12 * abs(pressure))
            self.expect_true(f"{name}, {ranks} ranks: drag and pressure act",
                             all(abs(x["drag"][2]) > 0 and abs(x["pressure"][2]) > 0 for x in lines))
        if name not in SHARED:
            return
        # What the solver of p leaves, 1e-13 of its scale, and sums in another order have to make less of a
        # difference than velocities that are off by 1e-8 at the start.
        disturbed, _ = run(self.column, name, 1, disturbance=1e-8)
        one, two, other = (np.array([x["drag"] for x in lines]) for lines in (steps[1], steps[2], disturbed))
        limit = np.abs(other - one).max()
        # Chaos would make the yardstick as long as the drag, and nothing would be compared.
        self.expect_below(f"{name}: drag, largest difference that the disturbance makes / largest drag",
                          limit / np.abs(one).max(), 1e-6)
        self.expect_below(f"{name}: drag, largest difference of 2 ranks from 1 [N]", np.abs(two - one).max(), limit)

    def test_every_setting(self):
        # What passes between particles and cells is the same code with every engine.
        for name in SETTINGS if ENGINE == "lammps" else ["smoothed"]:
            self.check(name)


if __name__ == "__main__":
    unittest.main()
