# SPDX-License-Identifier: BSD-3-Clause
"""Gas without weight whose velocities are random from cell to cell, around one sphere that it hardly feels, slows down
on every mesh: its mean square speed and its greatest speed fall."""

import re
import shutil
import unittest

import numpy as np

from cohesion_tests.coupling.cases import COUPLING, append, edit, use_script
from cohesion_tests.coupling.fields import field
from cohesion_tests.coupling.meshes import MESHES, plain
from cohesion_tests.coupling.test_case import CoupledTestCase

NOISE = 0.01  # standard deviation of each component [m/s]
DT, EARLY, LATE = 5e-5, 10, 200  # [s], steps


def speeds(case, steps):
    return np.linalg.norm(field(case, f"{steps * DT:.8g}", "U").reshape(-1, 3), axis=1)


class NoiseOnMeshes(CoupledTestCase):
    def check(self, mesh, make):
        case = self.column(f"noise-{mesh}")
        make(case)
        shutil.copytree(case.folder / "0.orig", case.folder / "0", dirs_exist_ok=True)
        cells = int(re.search(r"nCells:\s*(\d+)", (case.folder / "constant/polyMesh/owner").read_text())[1])
        noise = np.random.default_rng(1).normal(0, NOISE, (cells, 3)).tolist()
        edit(case, "0/U", "uniform (0 0 0);\nboundaryField",
             f"nonuniform List<vector> {cells} (" + "\n".join(f"({x!r} {y!r} {z!r})" for x, y, z in noise)
             + ");\nboundaryField")
        append(case, "constant/g", "value (0 0 0);")
        use_script(case, "packed")
        edit(case, "packed.lmp", "set          group all density",
             "group        first id 1\ngroup        others subtract all first\n"
             "delete_atoms group others\nset          group all diameter 1e-5\nset          group all density")
        append(case, COUPLING, 'lammpsCoeffs { variables { dt "1e-5"; } }')
        append(case, "system/controlDict", f"deltaT {DT!r}; endTime {LATE * DT!r}; writeControl timeStep;"
               f" writeInterval {EARLY}; writePrecision 17;")
        case.solve()
        early, late = speeds(case, EARLY), speeds(case, LATE)
        print(f"   {mesh}: greatest speed {early.max():.4g}, then {late.max():.4g} m/s", flush=True)
        self.expect_below(f"{mesh}: mean square speed", (late**2).mean(), (early**2).mean())
        self.expect_below(f"{mesh}: greatest speed", late.max(), early.max())

    def test_every_mesh(self):
        for mesh, make in {"plain": plain, **MESHES}.items():
            self.check(mesh, make)


if __name__ == "__main__":
    unittest.main()
