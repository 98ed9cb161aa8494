#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A fine powder that falls in air at rest and sticks together: how much faster it is when its agglomerates have less
drag.

    falling_powder.py BUILD WORK [--seed N ...] [--end S]

2000 grains of 60 um and 1500 kg/m3 with the attraction of Hamaker, 2 % of the volume, thrown at each other at random,
normal with 0.1 m/s along each axis, fall between walls 0.9 mm apart, to which they stick, too. Contacts, cells and,
but for 1 %, steps are those that `cohesion-powder` plans for such grains. From the same places and velocities, of
each seed, a run without a law for agglomerates and one with `equivalentSphere`. Prints the speeds downwards, of all
and of those that no wall attracts, and how many one does; the share of the exchange in the run by the solver's log;
what that says of the agglomerates, in the last step and over all; then the means over the seeds, and of each the
change of the mean speeds.
"""
import re
import time

import numpy as np
from scipy.spatial import cKDTree

from cohesion_tests import measuring_program
from cohesion_tests.coupling.cases import COUPLING, Columns, append, use_script
from cohesion_tests.coupling.fields import numbers
from cohesion_tests.coupling.free_spheres import BLOCK
from cohesion_tests.lammps import write_spheres
from cohesion_tests.progress import Progress

D, DENSITY, RHO, MU, HAMAKER = 60e-6, 1500.0, 1.205, 1.82e-5, 2e-20
WIDTH, HEIGHT, LOW, HIGH = 15 * D, 0.032, 0.016, 0.031
COUNT, SPEED = 2000, 0.1
OUTER = 1e-7  # outer cut-off of the attraction [m]
SUB_STEP, STEP = 2.5e-6, 6e-4
LAWS = ("none", "equivalentSphere")
SHARES = (0.5, 0.1, 0.01)  # of the grains that are faster than what is printed
BOUND = (r"bound (\S+) of (\S+), with less drag (\S+), factor (\S+) in the mean of the bound, least (\S+),"
         r" bound to their own image")


def grains(seed):
    """Places and velocities [number, 3]: at random, 2 % of a diameter or more between two, and off the walls."""
    random = np.random.default_rng(seed)
    low, high = [0.55 * D, 0.55 * D, LOW], [WIDTH - 0.55 * D, WIDTH - 0.55 * D, HIGH]
    places = random.uniform(low, high, (COUNT, 3))
    while True:
        close = cKDTree(places).query_pairs(1.02 * D, output_type="ndarray")
        if not len(close):
            return places, random.normal(0, SPEED, (COUNT, 3))
        again = np.unique(close[:, 1])
        places[again] = random.uniform(low, high, (len(again), 3))


def make(column, seed, law, end):
    case = column(f"{seed}-{law}")
    block = BLOCK.format(repr(WIDTH), round(WIDTH / (3 * D)), repr(HEIGHT), round(HEIGHT / (3 * D)))
    sides = "    sides { type wall; faces ((0 4 7 3) (1 2 6 5) (0 1 5 4) (3 7 6 2)); }\n"
    block = re.sub(r" +[xy][01] .*\n", "", block).replace("boundary\n(\n", f"boundary\n(\n{sides}")
    for side, name in (("z0", "bottom"), ("z1", "top")):
        block = re.sub(rf"{side} \{{ type cyclic; neighbourPatch z. *;", f"{name} {{ type patch;", block)
    path = case.folder / "system/blockMeshDict"
    path.write_text(path.read_text().split("// A column")[0] + block)
    append(case, "0.orig/U", "boundaryField { sides { type noSlip; } }")
    append(case, "constant/transportProperties", f"rho {RHO}; nu {MU / RHO!r};")
    atoms = [{"type": 1, "diameter": D, "density": DENSITY, "x": x, "v": v} for x, v in zip(*grains(seed))]
    write_spheres(case.folder, atoms, [(0, WIDTH), (0, WIDTH), (0, HEIGHT)], 1)
    use_script(case, "falling")
    variables = {"width": WIDTH, "height": HEIGHT, "A": HAMAKER, "outer": OUTER, "skin": D, "dt": SUB_STEP}
    append(case, COUPLING, f"""drag beetstra; voidFraction sphereOverlap; agglomerateDrag {law};
lammpsCoeffs {{ variables {{ {' '.join(f'{name} "{value!r}";' for name, value in variables.items())} }} }}""")
    append(case, "system/controlDict", f"deltaT {STEP}; endTime {end}; writeInterval {end};")
    case.mesh()
    return case


def run(column, seed, law, end):
    """Speeds downwards at the end: mean of all, of those that no wall attracts, and what SHARES of the grains exceed;
    how many a wall attracts; the log; seconds that it took."""
    case = make(column, seed, law, end)
    begin = time.monotonic()
    log = case.solve()
    seconds = time.monotonic() - begin
    cloud = case.folder / f"{end:g}/lagrangian/particles"
    down = -numbers(cloud / "U", 3)[:, 2]
    across = numbers(cloud / "positions", 4)[:, :2]
    held = np.minimum(across, WIDTH - across).min(axis=1) < D / 2 + OUTER
    speeds = [down.mean(), down[~held].mean(), *np.quantile(down, [1 - share for share in SHARES])]
    return np.array(speeds), held.sum(), log, seconds


def agglomerates(log):
    """Of the log: what it says of the last step, and of all."""
    lines = []
    for name, found in zip(("at the end", "over all steps"), re.findall(BOUND, log)[-2:]):
        bound, count, less, factor, least = np.array(found, float)
        lines.append(f"  {name}: {bound / count:.3f} of the grains bound, {less / bound:.3f} of these with less drag, "
                     f"factor {factor:.3f} in the mean of the bound, least {least:.3f}")
    return "\n".join(lines)


def main():
    parser = measuring_program.coupling_parser(__doc__)
    parser.add_argument("--seed", type=int, nargs="+", default=[5, 6, 7])
    parser.add_argument("--end", type=float, default=0.06, help="of the runs [s] (%(default)s)")
    args = parser.parse_args()
    column = Columns(args.build, args.work)
    progress = Progress(len(args.seed) * len(LAWS))
    head = "speed downwards [m/s]: mean, off the walls, " + ", ".join(f"{share:g} are faster than" for share in SHARES)
    found = []
    for seed in args.seed:
        print(f"seed {seed}, {head}")
        found.append([])
        for law in LAWS:
            speeds, held, log, seconds = run(column, seed, law, args.end)
            found[-1].append(speeds)
            share = float(re.search(r"exchange +\S+ s, (\S+) %", log)[1])
            print(f"  {law}: {' '.join(f'{speed:.4f}' for speed in speeds)}; {held} at a wall; {seconds:.1f} s, "
                  f"{share:.1f} % of it the exchange", flush=True)
            progress.add(1)
        print(agglomerates(log), flush=True)
    found = np.array(found)
    print(f"mean over the seeds, {head}")
    for law, speeds in zip(LAWS, found.mean(axis=0)):
        print(f"  {law}: {' '.join(f'{speed:.4f}' for speed in speeds)}")
    for name, law in zip(LAWS, np.moveaxis(found, 1, 0)):
        spread = law.max(axis=0) / law.min(axis=0) - 1
        print(f"  {name}, largest over least of the seeds, less 1: {' '.join(f'{x:.3f}' for x in spread)}")
    for k, name in enumerate(("mean of all", "mean off the walls")):
        changes = found[:, 1, k] / found[:, 0, k] - 1
        print(f"change of the {name}, by seed: " + " ".join(f"{change:+.3f}" for change in changes))


if __name__ == "__main__":
    main()
