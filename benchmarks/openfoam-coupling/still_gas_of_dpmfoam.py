#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Speed of gas at rest in OpenFOAM's own DPMFoam on the meshes of tests/openfoam-coupling/still_gas_on_meshes.py.

    still_gas_of_dpmfoam.py BUILD WORK [--mesh NAME ...] [--csv FILE]

Prints the greatest speed after the steps of that test, in the column alone and around 2940 heavy spheres."""

import shutil

import numpy as np

from cohesion_tests import csv_table, measuring_program
from cohesion_tests.coupling.cases import Columns, append
from cohesion_tests.coupling.dictionaries import FILE
from cohesion_tests.coupling.fields import field
from cohesion_tests.coupling.meshes import CONE, FIXED, MESHES, NAMES

ALL = {**MESHES, **FIXED}
END = 0.002
D = 2.6e-3
CLOUD = """
solution
{
    active true; coupled true; transient yes; cellValueSourceCorrection on; maxCo 1;
    interpolationSchemes { rho.air cell; U.air cell; mu.air cell; }
    averagingMethod basic;
    integrationSchemes { U Euler; }
    sourceTerms { schemes { U semiImplicit 1; } }
}
constantProperties { rho0 1e12; alphaMax 0.9; youngsModulus 1e8; poissonsRatio 0.35; }
subModels
{
    particleForces { ErgunWenYuDrag { alphac alpha.air; } }
    injectionModels { INJECTION }
    dispersionModel none; patchInteractionModel none; surfaceFilmModel none; stochasticCollisionModel none;
    collisionModel none;
}
cloudFunctions { }
"""
INJECTION = """
spheres
{
    type manualInjection; massTotal 1; parcelBasisType fixed; nParticle 1; SOI 0; positionsFile "positions";
    U0 (0 0 0); sizeDistribution { type fixedValue; fixedValueDistribution { value DIAMETER; } }
}
"""


def positions(mesh):
    """On a lattice of 4 mm between heights of 0.04 m and 0.1 m, outside the cone."""
    across = np.arange(0.0031, 0.0585, 0.004)
    found = np.stack(np.meshgrid(across, across, np.arange(0.0413, 0.1, 0.004)), axis=-1).reshape(-1, 3)
    if mesh == "cone":
        (x, y, _), radius, height = CONE
        away = np.hypot(found[:, 0] - x, found[:, 1] - y)
        found = found[away > (radius + 4e-3) * (1 - found[:, 2] / (height + 4e-3)) + 2e-3]
    return found


def set_up(case, mesh, spheres):
    ALL[mesh](case)
    shutil.copytree(case.folder / "0.orig", case.folder / "0", dirs_exist_ok=True)
    (case.folder / "0/voidFraction").unlink()
    velocity = (case.folder / "0/U").read_text()
    for old, new in (("object      U;", "object U.air;"),
                     ("pressureInletOutletVelocity;", "pressureInletOutletVelocity; phi phi.air;"),
                     ("superficialVelocity; superficialVelocity (0 0 0);", "fixedValue; value uniform (0 0 0);")):
        velocity = velocity.replace(old, new)
    (case.folder / "0/U").unlink()
    (case.folder / "0/U.air").write_text(velocity)
    for name, text in (
            ("transportProperties", "continuousPhase air; rho.air 1.205; transportModel Newtonian; nu 1.452282e-5;"),
            ("turbulenceProperties.air", "simulationType laminar;"),
            ("kinematicCloudProperties",
             CLOUD.replace("INJECTION", INJECTION.replace("DIAMETER", repr(D)) if spheres else ""))):
        (case.folder / "constant" / name).write_text(FILE.format("dictionary", name) + text + "\n")
    rows = "\n".join(f"({x!r} {y!r} {z!r})" for x, y, z in positions(mesh).tolist())
    (case.folder / "constant/positions").write_text(FILE.format("vectorField", "positions") + f"(\n{rows}\n)\n")
    append(case, "system/fvSchemes", "divSchemes { default Gauss linear; }")
    append(case, "system/fvSolution",
           'PIMPLE { nNonOrthogonalCorrectors 1; } solvers { "p.*" { tolerance 1e-12; } }')
    append(case, "system/controlDict",
           f"application DPMFoam; libs (); endTime {END}; writeInterval {END}; writePrecision 17;")


def main():
    parser = measuring_program.coupling_parser(__doc__, table=True)
    parser.add_argument("--mesh", nargs="+", choices=ALL, default=list(ALL))
    args = parser.parse_args()
    columns = Columns(args.build, args.work)
    print("| mesh | empty [m/s] | fixed spheres [m/s] |\n|---|---|---|")
    for mesh in args.mesh:
        speeds = []
        for spheres in (False, True):
            case = columns(f"{mesh}-{'spheres' if spheres else 'empty'}")
            set_up(case, mesh, spheres)
            case.run("DPMFoam")
            speeds.append(np.linalg.norm(field(case, f"{END:g}", "U.air").reshape(-1, 3), axis=1).max())
        print(f"| {mesh} | " + " | ".join(f"{speed:.1e}" for speed in speeds) + " |", flush=True)
        csv_table.enter(args.csv, {"mesh": NAMES[mesh]}, key=("mesh",), **{
            f"DPMFoam, {name}": csv_table.power(speed) for name, speed in zip(("empty", "fixed spheres"), speeds)})


if __name__ == "__main__":
    main()
