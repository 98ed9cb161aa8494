#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Instructions per sphere and gas step of the exchange before the gas is solved: cells, shares, void fraction and
drag, all that depositParticles() does, counted by callgrind. A count does not go with what else the machine does.

    exchange_cost.py BUILD WORK [--steps N] [--kernel NAME ...] [--scene NAME ...] [--csv FILE]

Scenes: the suspension of kernel_noise.py, cells of three diameters, all faces periodic; the bed of
examples/fluidised-bed a thousand particle steps after its start, with those of the 40 particle steps, too; and
the column of meshes.py in cubes of 20 mm and in cells of other shapes, with held spheres of 20/3 mm. Each
takes some half a minute, the bed two."""

import re
import shutil

import numpy as np

from cohesion_studies.bed import bed_case
from cohesion_tests import csv_table, measuring_program
from cohesion_tests.coupling.cases import COUPLING, Columns, append, use_script
from cohesion_tests.coupling.meshes import MESHES, SIZE, plain, tetrahedra
from kernel_noise import KERNELS, make, places

DIAMETER, SPACING = 0.02 / 3, 8.5e-3
# The tetrahedra of about the volume of a cube
SHAPES = {"cubes": plain, **MESHES, "tetrahedra": lambda case: tetrahedra(case, (2, 2, 5))}


def suspension(column, kernel, steps):
    where = places()
    return make(column, where, 6, 0.15, steps, kernel, 0), len(where)


def plane_bed(column, kernel, steps):
    case = bed_case.make_case(column.work / "case", {"engine": "lammps", "schedule": "short", "A": 0, "settle": 0,
                                                     "voidFraction": kernel}, column.environment)
    case.env["FOAM_CASE"] = str(case.folder)
    step = float(re.search(r"^deltaT +(\S+);", (case.folder / "system/controlDict").read_text(), re.M)[1])
    append(case, "system/controlDict", f"endTime {steps * step!r};")
    return case, 4000


def shaped(shape):
    def scene(column, kernel, steps):
        case = column("case")
        use_script(case, "few")
        along = [np.arange(0.5 * SPACING, size - 0.4 * SPACING, SPACING) for size in SIZE]
        where = np.stack(np.meshgrid(*along, indexing="ij"), axis=-1).reshape(-1, 3)
        where += np.random.default_rng(1).uniform(-1, 1, where.shape) * 0.4 * (SPACING - DIAMETER)
        (case.folder / "places").write_text("".join(
            "create_atoms 1 single {!r} {!r} {!r} units box\n".format(*place) for place in where.tolist()))
        for variable, value in (("places", "places"), ("diameter", DIAMETER), ("period", "f")):
            case.set(COUPLING, f"lammpsCoeffs/variables/{variable}", value)
        case.set(COUPLING, "voidFraction", kernel)
        append(case, "system/controlDict", f"endTime {steps * 1e-4!r};")
        SHAPES[shape](case)
        shutil.copytree(case.folder / "0.orig", case.folder / "0", dirs_exist_ok=True)
        return case, len(where)
    return scene


SCENES = {"suspension": suspension, "plane bed": plane_bed, **{shape: shaped(shape) for shape in SHAPES}}


# Of void_fraction.csv
CASES = {"suspension": "suspension in cells of three diameters, periodic",
         "cubes": "column in cubes of three diameters, walls",
         "tetrahedra": "the same in tetrahedra of about that volume"}


def inclusive(listing, name):
    """Instructions in all calls of a function of the coupling, of a listing by callgrind_annotate."""
    return float(re.search(rf"^ *([\d,]+)[^\n]*::gasParticleCoupling::{name}\(", listing, re.M)[1].replace(",", ""))


def count(case, spheres, steps):
    """Of depositParticles() and advanceParticles(), per sphere and gas step."""
    counts = case.folder / "counts"
    case.run("valgrind", "--tool=callgrind", f"--callgrind-out-file={counts}", "cohesiveBedFoam", "-overwrite")
    case.run("callgrind_annotate", "--inclusive=yes", "--threshold=100", str(counts))
    listing = case.log("callgrind_annotate").read_text()
    return [inclusive(listing, name) / (steps * spheres) for name in ("depositParticles", "advanceParticles")]


def main():
    parser = measuring_program.coupling_parser(__doc__, table=True)
    parser.add_argument("--steps", type=int, default=10, help="gas steps (%(default)s)")
    parser.add_argument("--kernel", nargs="+", choices=KERNELS, default=KERNELS)
    parser.add_argument("--scene", nargs="+", choices=SCENES, default=list(SCENES))
    args = parser.parse_args()
    column = Columns(args.build, args.work)
    print("| scene | kernel | before the gas is solved | particle steps and what is handed over |\n|---|---|---|---|")
    for scene in args.scene:
        for kernel in args.kernel:
            case, spheres = SCENES[scene](column, kernel, args.steps)
            before, particles = count(case, spheres, args.steps)
            print(f"| {scene} | `{kernel}` | {before:.0f} | {particles:.0f} |", flush=True)
            csv_table.enter_quantities(args.csv, "instructions per sphere and gas step", CASES.get(scene, scene),
                                       {kernel: csv_table.grouped(before)})


if __name__ == "__main__":
    main()
