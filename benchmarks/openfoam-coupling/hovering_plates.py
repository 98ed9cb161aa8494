#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Plates of packed spheres that hover at rest over empty cells: a row of cells that is filled in part, on top of the
plate, has the void fraction of its mean, hence next to no drag, and weighs on the rows below, which more than their
weight lifts.

    hovering_plates.py BUILD WORK [--cell N ...] [--smoothing N ...] [--slip NAME ...] [--ratio N ...]
                       [--spheres N] [--rows] [--csv FILE]

A pile of 310 spheres, 7.5 diameters high, or of so many, begins in the air, its lower end at a face between cells six
diameters above the inlet, in a box six diameters wide that is periodic across. The gas blows at `ratio` times the
minimum fluidisation velocity of the law at a void fraction of 0.4. For cells of so many diameters, smoothing over so
many, and each slip: the share of the spheres that, 0.6 and 0.8 s later, are at rest above an empty row of cells, and
the mean speed of all. --rows: besides, of each row with spheres, the force of the gas over their weight, as the
spheres feel it and as the law has it at the row's void fraction on paper.

Then the bound on paper: `n` rows of cells that are full, at the void fraction 0.4, under one that is filled to the
share f, hover when n (F - 1) = f (1 - F_f), F and F_f the force over the weight in both; up to which ratio some f
does.
"""
import re

import numpy as np
from scipy.optimize import brentq

from cohesion_tests import csv_table, measuring_program
from cohesion_tests.coupling.cases import COUPLING, Columns, append, use_script
from cohesion_tests.coupling.fields import cells, numbers
from cohesion_tests.coupling.free_spheres import BLOCK
from cohesion_tests.progress import Progress
from cohesion_tests.theory.closure_formulas import CLOSURES, DOUBLE

D, DENSITY, RHO, MU, G = 2.5e-3, 2524.0, 1.2, 1.8e-5, 9.81
LAW, PACKED = "ergunWenYu", 0.4
WIDTH, HEIGHT, FLOOR = 6 * D, 36 * D, 6 * D
SUB_STEP, STEP, END, EVERY = 6.25e-5, 5e-4, 0.8, 0.2
WEIGHT = (DENSITY - RHO) * G * np.pi / 6 * D**3
AT_REST = 0.01  # most that spheres of a plate move on average: they fall faster within 1 ms [m/s]
EMPTY = 0.02  # most solid of an empty row: a sphere or two of the some 125 that fill one of three diameters


def force(eps, velocity):
    """Of gas at this superficial velocity on a sphere that rests in it, drag and pressure, over its weight in it."""
    slip = velocity / eps
    return CLOSURES[LAW](DOUBLE, eps, slip, D, RHO, MU) * slip / eps / ((DENSITY - RHO) * G)


U_MF = brentq(lambda velocity: force(PACKED, velocity) - 1, 1e-3, 20)


def make(column, count, cell, smoothing, slip, ratio):
    """cell, smoothing [diameters]"""
    case = column(f"{count}-cell-{cell:g}-smoothing-{smoothing:g}-{slip}-{ratio:g}")
    block = BLOCK.format(repr(WIDTH), round(6 / cell), repr(HEIGHT), round(36 / cell))
    for side, name in (("z0", "bottom"), ("z1", "top")):
        block = re.sub(rf"{side} \{{ type cyclic; neighbourPatch z. *;", f"{name} {{ type patch;", block)
    path = case.folder / "system/blockMeshDict"
    path.write_text(path.read_text().split("// A column")[0] + block)
    sides = "".join(f"    {d}{i} {{ type cyclic; }}\n" for d in "xy" for i in "01")
    for file in (case.folder / "0.orig").iterdir():
        file.write_text(re.sub(r" +sides .*\n", sides, file.read_text()))
    append(case, "0.orig/U", f"boundaryField {{ bottom {{ superficialVelocity (0 0 {ratio * U_MF!r}); }} }}")
    append(case, "constant/transportProperties", f"rho {RHO}; nu {MU / RHO!r};")
    use_script(case, "plate")
    variables = {"width": WIDTH, "height": HEIGHT, "floor": FLOOR, "count": count, "d": D, "density": DENSITY,
                 "dt": SUB_STEP}
    append(case, COUPLING, f"""drag {LAW}; voidFraction sphereOverlap; slip {slip};
{f'smoothingWidth {smoothing * D!r};' if smoothing else ''}
lammpsCoeffs {{ variables {{ {' '.join(f'{name} "{value!r}";' for name, value in variables.items())} }} }}""")
    append(case, "system/controlDict", f"deltaT {STEP}; endTime {END}; writeInterval {EVERY}; writePrecision 9;")
    case.mesh()
    return case


class Rows:
    """Spheres and cells at a time, by rows of cells."""

    def __init__(self, case, time, cell, ratio):
        cloud = case.folder / f"{time:g}/lagrangian/particles"
        self.velocity = ratio * U_MF
        self.row = (numbers(cloud / "positions", 4)[:, 2] / (cell * D)).astype(int)
        self.speed = np.linalg.norm(numbers(cloud / "U", 3), axis=1)
        self.force = numbers(cloud / "gasForce", 3)[:, 2] / WEIGHT
        self.eps = cells(case, f"{time:g}", "voidFraction").reshape(round(36 / cell), -1).mean(axis=1)

    def hovering(self):
        """Share of the spheres that are at rest above an empty row."""
        empty = np.flatnonzero(self.eps > 1 - EMPTY)
        below = [k for k in empty if (self.row > k).any()]
        above = self.row > min(below) if below else np.zeros(len(self.row), bool)
        return above.mean() if above.any() and self.speed[above].mean() < AT_REST else 0.0

    def __str__(self):
        """Lowest first"""
        lines = []
        for k in np.unique(self.row):
            here = self.row == k
            lines.append(f"  row {k}: void fraction {self.eps[k]:.3f}, {here.sum()} spheres, gas over weight "
                         f"{self.force[here].mean():.3f}, on paper {force(self.eps[k], self.velocity):.3f}, speed "
                         f"{self.speed[here].mean():.4f} m/s")
        return "\n".join(lines)


def run(column, count, *setting):
    """Rows some time before the end, and at the end"""
    case = make(column, count, *setting)
    case.solve()
    return [Rows(case, time, *setting[::3]) for time in (END - EVERY, END)]


def largest_ratio(n):
    """Up to which ratio of velocities n full rows hover under one that is filled in part."""
    def surplus(ratio):
        shares = np.linspace(0, 1, 401)[1:-1]
        lid = max(f * (1 - force(1 - f * (1 - PACKED), ratio * U_MF)) for f in shares)
        return n * (force(PACKED, ratio * U_MF) - 1) - lid
    return brentq(surplus, 1, 10)


def enter(file, cell, smoothing, slip, ratio, found):
    """Into void_fraction.csv."""
    case = f"cells of {cell:g} d" + (f", smoothing {smoothing:g} d" if smoothing else "")
    case += f", slip {slip}" if slip != "cell" else ""
    csv_table.enter_quantities(file, "beds that lock, mean speeds after 0.6 and 0.8 s", case, {
        f"{ratio:g} of minimum fluidisation [m/s]": ", ".join(f"{rows.speed.mean():.3f}" for rows in found)})


def main():
    parser = measuring_program.coupling_parser(__doc__, table=True)
    parser.add_argument("--cell", type=float, nargs="+", default=[3, 2, 1.5])
    parser.add_argument("--smoothing", type=float, nargs="+", default=[0])
    parser.add_argument("--slip", nargs="+", default=["cell"])
    parser.add_argument("--ratio", type=float, nargs="+", default=[1.1, 1.2, 1.3, 1.4])
    parser.add_argument("--spheres", type=int, default=310)
    parser.add_argument("--rows", action="store_true")
    args = parser.parse_args()
    column = Columns(args.build, args.work)
    settings = [(*setting, ratio) for setting in
                [(c, w, s) for c in args.cell for w in args.smoothing for s in args.slip] for ratio in args.ratio]
    progress = Progress(len(settings))
    print(f"minimum fluidisation {U_MF:.4f} m/s")
    for setting in settings:
        found = run(column, args.spheres, *setting)
        print("cells of {:g} d, smoothing {:g} d, slip {}, {:g} of minimum fluidisation: ".format(*setting)
              + "; ".join(f"{rows.hovering():.3f} hover, {rows.speed.mean():.4f} m/s" for rows in found)
              + (f"\n{found[-1]}" if args.rows else ""), flush=True)
        enter(args.csv, *setting, found)
        progress.add(1)
    for n in (1, 2, 3, 5, 10):
        print(f"on paper {n} full rows hover up to {largest_ratio(n):.3f}")


if __name__ == "__main__":
    main()
