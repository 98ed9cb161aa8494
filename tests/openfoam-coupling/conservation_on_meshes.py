# SPDX-License-Identifier: BSD-3-Clause
"""On skewed hexahedra, tetrahedra, polyhedra with warped faces and cubes with hanging corners, on 1 and 2
ranks, one of them on 4: in every step of a swarm of falling, colliding spheres the gas gives what the particles get,
the solid volume on the mesh is that of the particles, and no gas is lost; and the ranks see the same."""

import re
import shutil
import unittest

import numpy as np

from cohesion_tests.coupling.cases import COUPLING, disturb, exchange_lines
from cohesion_tests.coupling.meshes import MESHES
from cohesion_tests.coupling.test_case import CoupledTestCase

STEPS, DT = 3, 1e-4
RANKS = {1: "(1 1 1)", 2: "(2 1 1)", 4: "(2 2 1)"}
FOUR = "polyhedra"  # the mesh on 4 ranks: cells of all shapes have corners that four share


def make_mesh(case, mesh):
    """Made once, for one rank without a disturbance."""
    made = case.folder.parent / f"{mesh}-1-0.0/constant/polyMesh"
    if made.is_relative_to(case.folder):
        MESHES[mesh](case)
    else:
        shutil.copytree(made, case.folder / "constant/polyMesh", dirs_exist_ok=True)


def run(column, mesh, ranks, disturbance=0.0):
    case = column(f"{mesh}-{ranks}-{disturbance}")
    # Other places than swarm.lmp's: there some of a sphere's parts are on faces, to the last digit.
    script = case.folder / "swarm.lmp"
    script.write_text(script.read_text().replace("sc 5.6e-3", "sc 5.6137e-3"))
    if disturbance:
        disturb(case, "swarm", disturbance)
    case.set(COUPLING, "voidFraction", "dividedVolume")
    case.set(COUPLING, "lammpsCoeffs/script", '"$FOAM_CASE/swarm.lmp"')
    case.set("system/fvSolution", 'solvers/"p.*"/tolerance', 1e-14)
    case.set("system/fvSolution", "PIMPLE/nNonOrthogonalCorrectors", 2)
    case.set("system/decomposeParDict", "coeffs/n", RANKS[ranks])
    # The ranks' meshes are written and read again.
    for entry, value in (("endTime", STEPS * DT), ("writeInterval", STEPS * DT), ("writePrecision", 17)):
        case.set("system/controlDict", entry, value)
    make_mesh(case, mesh)
    shutil.copytree(case.folder / "0.orig", case.folder / "0", dirs_exist_ok=True)
    log = case.solve(ranks=ranks)
    errors = [float(x) for x in re.findall(r"Continuity error, mean of the sizes: (\S+)", log)]
    return exchange_lines(log), errors


class ConservationOnMeshes(CoupledTestCase):
    def check(self, mesh):
        runs = {ranks: run(self.column, mesh, ranks) for ranks in ((1, 4) if mesh == FOUR else (1, 2))}
        drags = {}
        for ranks, (lines, errors) in runs.items():
            self.expect_equal(f"{mesh}, {ranks} ranks: gas steps", (len(lines), len(errors)), (STEPS, STEPS))
            self.expect_balance(f"{mesh}, {ranks} ranks", lines)
            # The solver of p leaves 1e-14 of the fluxes it adds up; a step's are below a tenth of a cell.
            self.expect_below(f"{mesh}, {ranks} ranks: gas lost or made in a step / volume", max(errors), 1e-13)
            drags[ranks] = np.array([x["drag"] for x in lines])
            self.expect_true(f"{mesh}, {ranks} ranks: drag acts", bool(np.all(np.abs(drags[ranks][:, 2]) > 0)))
        disturbed, _ = run(self.column, mesh, 1, disturbance=1e-8)
        limit = np.abs(np.array([x["drag"] for x in disturbed]) - drags[1]).max()
        for ranks in list(runs)[1:]:
            self.expect_below(f"{mesh}: drag, largest difference of {ranks} ranks from 1 [N]",
                              np.abs(drags[ranks] - drags[1]).max(), limit)

    def test_every_mesh(self):
        for mesh in MESHES:
            self.check(mesh)


if __name__ == "__main__":
    unittest.main()
