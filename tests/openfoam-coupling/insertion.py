# SPDX-License-Identifier: BSD-3-Clause
"""Particles that come and go while the gas flows, on 1 and 2 ranks: in each gas step the solid volume on the
mesh is that of the particles, what the gas gave is what they felt or took along, and the log counts them as the
engine does, to the last one. Those outside the group of fix gas/coupling stop the run. Tables go on
without particles."""

import re
import unittest

import numpy as np

from cohesion_tests.coupling.cases import COUPLING, ENGINE, append, edit, exchange_lines, script_file
from cohesion_tests.coupling.fields import table
from cohesion_tests.coupling.test_case import CoupledTestCase
from cohesion_tests.liggghts_scenes.mesh import rectangle, stl

STEPS, DT = 120, 1e-4
EACH = "writeControl timeStep; writeInterval 1;"
FIRST = 2000 * 4 / 3 * np.pi * 2e-3**3  # the sphere that is there from the start [kg]
SOME = r"(\d+) {} \((\S+) kg\)"


def make(column, name):
    case = column(name)
    (case.folder / "outlet.stl").write_text(stl(rectangle((0, 0, 0.13), (0.06, 0, 0), (0, 0.06, 0))))
    append(case, COUPLING, f'{ENGINE}Coeffs {{ script "{script_file("inserted")}"; }}')
    append(case, "system/controlDict", f"""endTime {STEPS * DT}; writeInterval {STEPS * DT}; writePrecision 15;
functions
{{
    forces {{ type forceBudget; libs (cohesionFunctionObjects); }}
    height {{ type bedHeight; libs (cohesionFunctionObjects); layers 10; restHeight 0.1; {EACH} }}
    drop {{ type bedPressureDrop; libs (cohesionFunctionObjects); {EACH} }}
    mixing {{ type mixingIndex; libs (cohesionFunctionObjects); cells (3 3 10); {EACH} }}
    movement {{ type particleMovement; libs (cohesionFunctionObjects); interval {DT}; }}
    fields {{ type particleFields; libs (cohesionFunctionObjects); {EACH} }}
}}""")
    # Across the ranks of the engine, which cut along z
    append(case, "system/decomposeParDict", "coeffs { n (2 1 1); }")
    case.mesh()
    return case


def counted(log):
    """Per gas step: number and mass of those that came, and of those that went."""
    rows = []
    for step in log.split("\nTime = ")[1:]:
        said = re.search(r"^Particles,.*", step, re.M)
        found = [re.search(SOME.format(word), said[0]) if said else None for word in ("came", "went")]
        rows.append([float(f[k]) if f else 0.0 for f in found for k in (1, 2)])
    return np.array(rows)


def total(log, word):
    found = re.search(rf"Particles in this run\n(?:.*\n)*? +{word} +(\d+), (\S+) kg", log)
    return (float(found[1]), float(found[2])) if found else (float("nan"),) * 2


class Insertion(CoupledTestCase):
    def forces(self, case, mass, went_mass):
        """Nothing touches a wall, nor do spheres each other: beside weight and gas only what the gas gave to spheres in
        the step in which they went, less than their weight."""
        rows = np.loadtxt(case.folder / "postProcessing/forces/0/forceBudget.dat", ndmin=2)
        self.expect_equal("rows of forces", len(rows), STEPS)
        gravity, others = (rows[:, 2 + 3 * k:5 + 3 * k] for k in (0, 3))
        # That of the step's first to its last particle, by six digits of the masses
        self.expect_below("gravity beyond that of the particles / g [kg]", (np.abs(gravity[:, 2]) / 9.81 - mass).max(),
                          1e-5 * mass.max())
        # At both ends of the row half of one of ten particle steps, of the gas's force
        bound = 9.81 * (went_mass + 0.1 * mass + 1e-6 * FIRST)[:, None]
        self.expect_below("others / bound", (np.abs(others) / bound).max(), 1)

    def without_particles(self, case):
        """Columns of tables that have no value once the last particle has gone, and the others."""
        nan = float("nan")
        for name, kind, expected in (("height", "bedHeight", [nan, nan, 0, nan]),
                                     ("mixing", "mixingIndex", [nan, 0, 0]),
                                     ("movement", "particleMovement", [DT, nan, nan, nan, nan, 0])):
            last = table(case, name, kind)[-1][1:]
            self.expect_true(f"{kind} without particles: {last}, expected {expected}",
                             np.allclose(last, expected, rtol=1e-5, atol=1e-12, equal_nan=True))
        weight, share = table(case, "drop", "bedPressureDrop")[-1][-2:]
        self.expect_equal("weight without particles", weight, 0)
        self.expect_true(f"drop over weight without particles: {share}", np.isnan(share))

    def check(self, ranks):
        case = make(self.column, str(ranks))
        log = case.solve(ranks=ranks)
        lines = exchange_lines(log)
        self.expect_equal(f"{ranks} ranks: gas steps", len(lines), STEPS)
        self.expect_balance(f"{ranks} ranks", lines)

        steps = counted(log)
        trace = np.loadtxt(case.folder / "trace.dat")
        trace = trace[trace[:, 0] > 0]
        came, came_mass, went, went_mass = steps.T
        self.expect_true(f"{ranks} ranks: some come while the gas flows", came.sum() > 20)
        self.expect_true(f"{ranks} ranks: some go, too", went.sum() > 0)
        self.expect_equal(f"{ranks} ranks: steps that the engine reports", len(trace), STEPS)
        self.expect_equal(f"{ranks} ranks: largest difference of the numbers of particles by the log and by the engine",
                          np.abs(1 + np.cumsum(came - went) - trace[:, 1]).max(), 0)
        # Both print six digits, the log those of each step.
        mass = FIRST + np.cumsum(came_mass - went_mass)
        self.expect_below(f"{ranks} ranks: mass, by the log less by the engine / largest mass",
                          np.abs(mass - trace[:, 2]).max() / trace[:, 2].max(), 5e-6 * (2 + STEPS))
        self.expect_equal(f"{ranks} ranks: number that went, by the log and by the engine", went.sum(), trace[-1, 3])
        for word, number, of_mass in (("came", came.sum(), came_mass.sum()), ("went", went.sum(), went_mass.sum()),
                                      ("at end", trace[-1, 1], mass[-1])):
            found = total(log, word)
            self.expect_equal(f"{ranks} ranks: at the end of the log: {word}", found[0], number)
            # Six digits are printed.
            self.expect_near(f"{ranks} ranks: {word}: mass [kg]", found[1], of_mass,
                             5e-6 * (FIRST + came_mass.sum() + went_mass.sum()))
        self.forces(case, mass, went_mass)
        if ENGINE == "lammps":
            self.expect_equal(f"{ranks} ranks: particles at the end", trace[-1, 1], 0)
            self.without_particles(case)

    def test_outside_the_group(self):
        case = make(self.column, "group")
        edit(case, script_file("inserted"), "fix gas      all gas/coupling", "group first id 1\nfix gas first gas/coupling")
        self.refused("inserted particles outside the group", case, "fix gas gas/coupling of the script",
                     "acts on group first, and", "particles are outside this group", "use 'fix gas all gas/coupling'",
                     begun=True, written=True, ranks=2)

    def test_come_and_go(self):
        for ranks in (1, 2):
            self.check(ranks)


if __name__ == "__main__":
    unittest.main()
