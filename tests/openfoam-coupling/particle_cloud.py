# SPDX-License-Identifier: BSD-3-Clause
"""The cloud of particles that is written with the gas: each sphere has the type that the engine's script gave it, and
the force of the gas in the mean over the last gas step, by the engine's own record of each step's forces; in the sum
the forces of the line Exchange. At the start the force is 0. On 1 and 2 ranks, which spheres fly between; in form B;
and continued."""

import re
import unittest

import numpy as np

from cohesion_tests import dumps
from cohesion_tests.coupling.cases import COUPLING, ENGINE, append, exchange_lines, use_script
from cohesion_tests.coupling.fields import numbers
from cohesion_tests.coupling.test_case import CoupledTestCase

# Type, diameter [m], density [kg/m3]; there is none of the type between.
KINDS = ((1, 1e-3, 500.0), (3, 2e-3, 1000.0))
NUMBER = 300
GAS_STEP, STEP, GAS_STEPS = 1e-3, 1e-4, 4
# Digits: 17 of what is written, drag impulses of 1e-16 of what they are counted from, and sums of NUMBER
DIGITS = 1e-12


def write_spheres(path):
    """In the middle of the column, so slow that none leaves it and so fast that many change the rank."""
    random = np.random.default_rng(18)
    types = np.arange(NUMBER) % 2
    places = random.uniform((0.026, 0.026, 0.07), (0.034, 0.034, 0.13), (NUMBER, 3))
    velocities = random.uniform(-6, 6, (NUMBER, 3))
    atoms = "\n".join(f"{n} {KINDS[k][0]} {KINDS[k][1]!r} {KINDS[k][2]!r} {x!r} {y!r} {z!r}"
                      for n, (k, (x, y, z)) in enumerate(zip(types, places.tolist()), 1))
    moves = "\n".join(f"{n} {x!r} {y!r} {z!r} 0 0 0" for n, (x, y, z) in enumerate(velocities.tolist(), 1))
    path.write_text(f"Spheres\n\n{NUMBER} atoms\n3 atom types\n\n0 0.06 xlo xhi\n0 0.06 ylo yhi\n0 0.2 zlo zhi\n\n"
                    f"Atoms\n\n{atoms}\n\nVelocities\n\n{moves}\n")
    return np.array([kind for kind, _, _ in KINDS])[types]


def make(column, name, settings):
    """The case, and the types of the spheres in the order of their numbers."""
    case = column(name)
    use_script(case, "passing")
    append(case, COUPLING, f'{settings} {ENGINE}Coeffs {{ variables {{ data spheres; dt "{STEP}"; }} }}')
    append(case, "constant/g", "value (0 0 0);")
    append(case, "0.orig/U", "boundaryField { bottom { type superficialVelocity; superficialVelocity (0 0 1); } }")
    append(case, "system/controlDict", f"deltaT {GAS_STEP}; endTime {GAS_STEPS * GAS_STEP}; writeControl timeStep;"
           " writeInterval 1; writePrecision 17;")
    case.mesh()
    return case, write_spheres(case.folder / "spheres")


def records(case):
    """By step of the engine: type, forces [N] and rank of the spheres, in the order of their numbers."""
    found = {}
    for snapshot in dumps.read(case.folder / "forces.dump"):
        rows = snapshot.sorted()
        found[snapshot.step] = (rows[:, 1], rows[:, 2:5], rows[:, 5:])
    return found


def cloud(case, time):
    """Types and gas forces [N], in the order of the spheres' numbers."""
    folder = case.folder / f"{time:g}" / "lagrangian/particles"
    order = np.argsort(numbers(folder / "id", 1)[:, 0])
    # Of values that are all alike OpenFOAM writes one.
    alike = re.search(r"\n\d+\{\((.*)\)\}", (folder / "gasForce").read_text())
    forces = np.tile(np.array(alike[1].split(), float), (len(order), 1)) if alike else numbers(folder / "gasForce", 3)
    return numbers(folder / "type", 1)[order, 0], forces[order]


class ParticleCloud(CoupledTestCase):
    def check_step(self, what, case, step, types, record, line):
        found_types, forces = cloud(case, step * GAS_STEP)
        self.expect_equal(f"{what}, gas step {step}: spheres of another type than given",
                          int((found_types != types).sum()), 0)
        self.expect_equal(f"{what}, gas step {step}: than in the engine", int((found_types != record[0]).sum()), 0)
        largest = np.abs(record[1]).max()
        self.expect_true(f"{what}, gas step {step}: there are forces", largest > 0)
        self.expect_below(f"{what}, gas step {step}: force, largest difference from the engine's record / largest",
                          np.abs(forces - record[1]).max() / largest, DIGITS)
        self.expect_below(f"{what}, gas step {step}: sum of the forces, difference from Exchange / largest force",
                          np.abs(forces.sum(axis=0) - line["drag"] - line["pressure"]).max() / largest, NUMBER * DIGITS)

    def check(self, name, ranks=1, settings=""):
        what = f"{name}, {ranks} ranks"
        case, types = make(self.column, name, settings)
        lines = exchange_lines(case.solve(ranks=ranks))
        if ranks > 1:
            case.run("reconstructPar", "-withZero")
        start_types, start_forces = cloud(case, 0)
        self.expect_equal(f"{what}, start: spheres of another type than given", int((start_types != types).sum()), 0)
        self.expect_equal(f"{what}, start: largest force [N]", np.abs(start_forces).max(), 0.0)
        found = records(case)
        for step, line in enumerate(lines, 1):
            self.check_step(what, case, step, types, found[10 * step], line)
        if ranks > 1:
            changed = [int((found[10 * k - 10][2] != found[10 * k][2]).sum()) for k in range(1, GAS_STEPS + 1)]
            self.expect_true(f"{what}: {changed} spheres change the rank in the gas steps", min(changed) > 0)
        return case, types

    def continued(self, case, types):
        """From the middle of the run before, whose last times are as if they had not been."""
        append(case, "system/controlDict", f"startFrom startTime; startTime {GAS_STEPS // 2 * GAS_STEP};")
        lines = exchange_lines(case.solve("-overwrite"))
        found = records(case)
        self.expect_equal("continued: gas steps", len(lines), GAS_STEPS - GAS_STEPS // 2)
        for step, line in enumerate(lines, GAS_STEPS // 2 + 1):
            self.check_step("continued", case, step, types, found[10 * step], line)

    def test_plain_and_continued(self):
        case, types = self.check("plain")
        self.continued(case, types)

    @unittest.skipUnless(ENGINE == "lammps", "what the solver does by itself, with every engine")
    def test_form_B(self):
        self.check("form-B", settings="form B; response free; voidFraction sphereOverlap;")

    @unittest.skipUnless(ENGINE == "lammps", "what the solver does by itself, with every engine")
    def test_two_ranks(self):
        self.check("two", ranks=2, settings="voidFraction sphereOverlap; slip interpolated;")


if __name__ == "__main__":
    unittest.main()
