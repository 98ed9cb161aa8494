#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Noise of the void-fraction kernels: a suspension that gas and spheres carry along at the same, constant
velocity. Seen from there nothing happens; so the gas's velocity should stay, and the pressure be the same
everywhere: what they do instead is made by spheres that cross faces of cells.

    kernel_noise.py BUILD WORK [--cell N ...] [--courant C ...] [--steps N] [--csv FILE]

For each kernel, without and with smoothing over one and two diameters, root mean square over cells and steps of:
the change of the void fraction over h/v, the time in which a sphere crosses a cell; the pressure over the weight
of the spheres above a square of the size of a cell, phi rho_s g h, the scale of pressures in a bed; the velocity
over v. And the processor time of the exchange per sphere and gas step, of a second run that writes nothing.
Spheres of the fluidised bed's size and density in air, 30 % of the volume, at 1 m/s."""

import re

import numpy as np
from scipy.spatial import cKDTree

from cohesion_tests import csv_table, measuring_program
from cohesion_tests.coupling.cases import COUPLING, Columns, use_script
from cohesion_tests.coupling.fields import field
from cohesion_tests.coupling.free_spheres import periodic
from cohesion_tests.progress import Progress
from speed_beside_dpmfoam import used

D, DENSITY, G, SOLID, SPEED = 1e-3, 2650.0, 9.81, 0.3, 1.0
BOX = 18 * D
KERNELS = ("particleCentre", "dividedVolume", "sphereOverlap")
WIDTHS = (0, 1, 2)  # of the smoothing [diameters]
SEED = 1
HEAD = 5  # steps left out: those that the start needs


def places():
    """Centres of spheres put down one after the other where there is room, in the periodic box, [n, 3]."""
    random = np.random.default_rng(SEED)
    n = round(SOLID * BOX**3 / (np.pi / 6 * D**3))
    # Room for 1 + 1e-3 diameters: none touch.
    apart, kept = 1.001 * D, np.empty((0, 3))
    while len(kept) < n:
        new = random.uniform(0, BOX, (4 * n, 3))
        if len(kept):
            new = new[cKDTree(kept, boxsize=BOX).query(new)[0] > apart]
        taken = np.ones(len(new), bool)
        for i, j in sorted(cKDTree(new, boxsize=BOX).query_pairs(apart)):
            taken[j] &= not taken[i]
        kept = np.concatenate([kept, new[taken]])[:n]
    return kept


def make(column, where, cells, courant, steps, kernel, width):
    case = column("case")
    dt = float(f"{courant * BOX / cells / SPEED:.6g}")
    periodic(case, BOX, cells, SPEED)
    use_script(case, "carried")
    (case.folder / "places").write_text("".join(
        "create_atoms 1 single {!r} {!r} {!r} units box\n".format(*place) for place in where.tolist()))
    for variable, value in (("places", "places"), ("box", BOX), ("diameter", D), ("speed", SPEED), ("dt", dt)):
        case.set(COUPLING, f"lammpsCoeffs/variables/{variable}", value)
    case.set(COUPLING, "voidFraction", kernel)
    case.set(COUPLING, "particleGravity", "any")
    if width:
        case.set(COUPLING, "smoothingWidth", width * D)
    for entry, value in (("deltaT", dt), ("endTime", steps * dt), ("writeControl", "timeStep"),
                         ("writeInterval", 1), ("writePrecision", 12)):
        case.set("system/controlDict", entry, value)
    case.mesh()
    return case


def noise(case, cells, courant, steps):
    """Of the void fraction, the pressure and the velocity, as above."""
    # Short times have names like 5e-05.
    folders = {f.parent.name for f in case.folder.glob("[0-9]*/p")}
    times = sorted(folders - {"0", "0.orig"}, key=float)
    assert len(times) == steps, times
    eps, p, u = (np.array([field(case, time, name) for time in times]) for name in ("voidFraction", "p", "U"))
    density = float(re.search(r"^rho +(\S+);", (case.folder / "constant/transportProperties").read_text(), re.M)[1])
    p = density * (p - p.mean(axis=1, keepdims=True))[HEAD:]
    u = (u.reshape(steps, -1, 3) - [0, 0, SPEED])[HEAD:]
    change = np.diff(eps, axis=0)[HEAD - 1:] / courant
    weight = SOLID * DENSITY * G * BOX / cells
    return [np.sqrt((change**2).mean()), np.sqrt((p**2).mean()) / weight,
            np.sqrt((u**2).sum(axis=2).mean()) / SPEED]


def microseconds(case, spheres, steps):
    """Of the exchange per sphere and gas step: its share by the clock, of the processor time."""
    case.set("system/controlDict", "writeInterval", 10 * steps)
    processor, _ = used(case, "cohesiveBedFoam", "-overwrite")
    log = case.log("cohesiveBedFoam").read_text()
    return 1e6 * processor * float(re.search(r"^    exchange +\S+ s, (\S+) %", log, re.M)[1]) / 100 / (steps * spheres)


def enter(file, cell, courant, kernel, width, found):
    """Into void_fraction.csv, whose cells have three diameters and steps 0.15 h/v where a case does not name others."""
    case = kernel + (f", smoothing [diameters] {width}" if width else "") + (f", cells of {cell:g} d" if cell != 3 else "")
    case += f", step {courant:g} h/v" if courant != 0.15 else ""
    names = ("change of void fraction", "pressure", "velocity")
    csv_table.enter_quantities(file, "noise", case, {name: f"{value:.2g}" for name, value in zip(names, found)})


def main():
    parser = measuring_program.coupling_parser(__doc__, table=True)
    parser.add_argument("--cell", type=float, nargs="+", default=[3], help="size of the cells [diameters]")
    parser.add_argument("--courant", type=float, nargs="+", default=[0.15, 0.0375], metavar="C",
                        help="steps of the gas in units of h/v; that of the bed is 0.15")
    parser.add_argument("--steps", type=int, default=45, help="gas steps")
    args = parser.parse_args()
    column, where = Columns(args.build, args.work), places()
    cases = [(cell, courant, kernel, width) for cell in args.cell for courant in args.courant for width in WIDTHS
             for kernel in KERNELS]
    progress = Progress(len(cases))
    rows = []
    for cell, courant, kernel, width in cases:
        cells = round(BOX / D / cell)
        case = make(column, where, cells, courant, args.steps, kernel, width)
        case.solve()
        rows.append([*noise(case, cells, courant, args.steps), microseconds(case, len(where), args.steps)])
        progress.add(1)
    print(f"\n{len(where)} spheres\n\n| cell/d | step v/h | kernel | width/d | change of void fraction | pressure "
          "| velocity | exchange [us] |\n|---|---|---|---|---|---|---|---|")
    for (cell, courant, kernel, width), found in zip(cases, rows):
        print(f"| {cell:g} | {courant:g} | `{kernel}` | {width or ''} | "
              + " | ".join(f"{value:.2g}" for value in found) + " |")
        enter(args.csv, cell, courant, kernel, width, found)


if __name__ == "__main__":
    main()
