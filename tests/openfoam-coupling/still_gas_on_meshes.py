# SPDX-License-Identifier: BSD-3-Clause
"""Gas at rest stays at rest on meshes with leaning, warped and hanging faces and around a snapped cone: alone, around
fixed spheres, and around mobile spheres that rest on the floor."""

import re
import shutil
import unittest

import numpy as np

from cohesion_tests import csv_table
from cohesion_tests.coupling.cases import COUPLING, append, edit, make_periodic, use_script
from cohesion_tests.coupling.fields import field
from cohesion_tests.coupling.meshes import CONE, FIXED, MESHES, NAMES, perturbed
from cohesion_tests.coupling.test_case import CoupledTestCase
from cohesion_tests.theory.closure_formulas import DOUBLE, ergun_pressure_gradient

STEPS, DT = 20, 1e-4
ALL = {**MESHES, **FIXED}
RESTING = "resting"
COLUMNS = {"empty": "empty", "held": "fixed spheres", RESTING: "resting spheres"}  # of still_gas.csv
# Round-off of the weight over the steps
STILL = 1e-10  # [m/s]


def fluidisation_velocity(d=0.06 / 14, solid=1000, g=9.81, eps=0.4, rho=1.2, mu=1.8e-5):
    """Of resting.lmp, by Ergun's equation, by bisection [m/s]"""
    low, high = 0.0, 10.0
    for _ in range(60):
        mean = 0.5 * (low + high)
        carries = ergun_pressure_gradient(DOUBLE, eps, mean, d, rho, mu) > (1 - eps) * (solid - rho) * g
        low, high = (low, mean) if carries else (mean, high)
    return low


def keep_off_cone(case):
    """Removes the spheres that the cone would cut."""
    (x, y, z), radius, height = CONE
    edit(case, "packed.lmp", "set          group all density 1e12",
         f"region       cone cone z {x} {y} {radius + 4e-3} 2e-3 {z} {height + 4e-3} units box\n"
         "delete_atoms region cone\nset          group all density 1e12")


def zero_gradient(case):
    edit(case, "0.orig/p", "sides   { type fixedFluxPressure; value uniform 0; }", "sides   { type zeroGradient; }")


def closed_vessel(case):
    edit(case, "0.orig/p", "type fixedValue", "type fixedFluxPressure")
    edit(case, "0.orig/U", "type pressureInletOutletVelocity", "type fixedValue")
    append(case, "system/fvSolution", "PIMPLE { pRefCell 0; pRefValue 3; }")


def uncorrected(case):
    append(case, "system/fvSchemes", "laplacianSchemes { default Gauss linear uncorrected; }")


def limited(case):
    append(case, "system/fvSchemes", "laplacianSchemes { default Gauss linear limited 0.33; }")
    append(case, "system/fvSchemes", "gradSchemes { default cellLimited leastSquares 1; }")


def water(case):
    append(case, "constant/transportProperties", "rho 1000; nu 1e-6;")


def symmetry(case):
    edit(case, "constant/polyMesh/boundary", "wall;", "symmetry;")
    for name in ("p", "U", "voidFraction"):
        path = case.folder / "0.orig" / name
        path.write_text(re.sub(r"sides +\{[^}]*\}", "sides { type symmetry; }", path.read_text()))


def duct(case):
    """Periodic across the weight"""
    make_periodic(case)
    edit(case, "packed.lmp", "boundary     f f f", "boundary     p f f")
    perturbed(case)


class StillGas(CoupledTestCase):
    def greatest_speed(self, mesh, spheres, kernel="particleCentre", ranks=1, changes=None):
        """Of the gas after the run [m/s]; the mesh is made by the first case of it."""
        change = getattr(changes, "__name__", "as-is")
        case = self.column(f"{mesh}-{spheres}-{kernel}-{ranks}-{change}")
        if spheres == "empty":
            edit(case, "packed.lmp", "density 1e12", "density 1e12\nset          group all diameter 1e-6")
        case.set(COUPLING, "voidFraction", kernel)
        if spheres == RESTING:
            use_script(case, "resting")
            case.set(COUPLING, "lammpsCoeffs/variables/dt", "2e-5")
            # Tetrahedra are as small as three spheres.
            case.set(COUPLING, "minVoidFraction", 0.01)
        else:
            use_script(case, "packed")
            case.set(COUPLING, "lammpsCoeffs/variables/dt", DT)
            if mesh == "cone":
                keep_off_cone(case)
        case.set("system/fvSolution", "PIMPLE/nNonOrthogonalCorrectors", 1)
        case.set("system/fvSolution", 'solvers/"p.*"/tolerance', 1e-12)
        for entry, value in (("endTime", STEPS * DT), ("writeInterval", STEPS * DT), ("writePrecision", 17)):
            case.set("system/controlDict", entry, value)
        self.make_mesh(case, mesh)
        if changes:
            changes(case)
        shutil.copytree(case.folder / "0.orig", case.folder / "0", dirs_exist_ok=True)
        case.solve(ranks=ranks)
        if ranks > 1:
            case.run("reconstructPar", "-latestTime")
        time = f"{STEPS * DT:g}"
        if "internalField   uniform (0 0 0)" in (case.folder / time / "U").read_text():
            return 0.0
        return np.linalg.norm(field(case, time, "U").reshape(-1, 3), axis=1).max()

    made = {}

    def make_mesh(self, case, mesh):
        if mesh in self.made:
            for part in ("constant/polyMesh", "0.orig"):
                shutil.copytree(self.made[mesh] / part, case.folder / part, dirs_exist_ok=True)
        else:
            ALL[mesh](case)
            self.made[mesh] = case.folder

    def check(self, mesh, spheres, **options):
        limit = 1e-3 * fluidisation_velocity() if spheres == RESTING else STILL
        speed = self.greatest_speed(mesh, spheres, **options)
        what = ", ".join([mesh, spheres, *(str(getattr(x, "__name__", x)) for x in options.values())])
        print(f"{what}: {speed:.2e} m/s", flush=True)
        if not options:
            csv_table.enter(csv_table.of_test("still_gas"), {"mesh": NAMES[mesh]}, key=("mesh",),
                            **{COLUMNS[spheres]: csv_table.power(speed)})
        self.expect_below(f"{what}: greatest speed of the gas [m/s]", speed, limit)

    def test_gas_alone(self):
        for mesh in ALL:
            self.check(mesh, "empty")

    def test_fixed_spheres(self):
        for mesh in ALL:
            self.check(mesh, "held")
        self.check("polyhedra", "held", kernel="dividedVolume")

    def test_resting_spheres(self):
        for mesh in [*MESHES, "perturbed"]:
            self.check(mesh, RESTING)
        self.check("tetrahedra", RESTING, kernel="dividedVolume")

    def test_other_set_ups(self):
        for changes in (zero_gradient, closed_vessel, uncorrected, limited, water, symmetry, duct):
            self.check("perturbed", "held", changes=changes)

    def test_two_ranks(self):
        self.check("polyhedra", RESTING, ranks=2)
        self.check("perturbed", "held", changes=duct, ranks=2)


if __name__ == "__main__":
    unittest.main()
