#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""How fast waves of free spheres grow from noise in form A, in a periodic cloud of spheres that pass through each
other, without gravity: by the solver, and by the eigenvalues of a step of the waves that the cells carry
(src/drag/viscous_waves.h, here without its conditions of Jury).

    wave_growth.py BUILD WORK [--spheres N] [--cells WIDE HIGH] [--steps N] [--case EPS RATIO M ENGINE_STEPS STIFFNESS]

M: 4 nu dt/h^2, of waves in one direction. STIFFNESS: beta dt/(eps rho_g). RATIO: of the densities. Without --case the cases of
docs/openfoam-coupling/cohesiveBedFoam.md that have no drag; each takes some 20 s. The growth printed is the mean of
the last 20 steps. With stiff drag the eigenvalues say nothing."""

import argparse

import numpy as np

from coupled_case import COUPLING, append, column
from drag_stiffness import CLOSURES, DOUBLE, DT, RHO, cells, particle_velocities, periodic

CELL = 5e-3
NOISE = 1e-12  # so little that nothing moves far in 40 steps [m/s]
CASES = [(0.62, 1, 24, 5, 1e-6), (0.62, 10, 240, 5, 1e-6), (0.62, 10, 240, 1, 1e-6), (0.62, 10, 100, 5, 1e-6),
         (0.62, 10, 60, 5, 1e-6)]


def eigenvalue(kappa, viscous, engine_steps, along):
    """The largest in size, of the waves that so many cells along one direction carry."""
    def of(seen):
        k, n, w = kappa * seen, viscous * (1 - seen), 0.5 * (1 - 1 / engine_steps)
        now, before = 1 + n, 1 - n * seen / 3
        return np.abs(np.roots([1, k * w * now - 1, k * ((1 - w) * now - w * before), -k * (1 - w) * before])).max()
    return max(of(np.cos(np.pi * i / along) ** 2) for i in range(along))


def solve(build, work, name, case, given):
    """Root mean squares of the particles' velocity and of the pressure after each step, and the log."""
    eps, ratio, viscous, engine_steps, stiffness = case
    wide, high = given.cells
    d = CELL * (6 * (1 - eps) / np.pi / given.spheres) ** (1 / 3)
    mu = float(f"{viscous / 4 * CELL**2 / DT * RHO:.6g}")
    closure = CLOSURES["hillKochLadd"](DOUBLE, eps, 1e-9, d, RHO, mu)
    factor = float(f"{stiffness * eps * RHO / DT / ((1 - eps) * closure):.6g}")
    folder = column(work, name, build)
    periodic(folder, wide * CELL, wide, 0.0, high * CELL, high)
    script = folder.folder / "lattice.lmp"
    text = script.read_text()
    spheres = given.spheres * wide**2 * high
    noise = f"variable vz atom {NOISE}*normal(0,1,77)\nvelocity all set 0 0 v_vz\n"
    for old, new in (("create_atoms 1 region filled", f"create_atoms 1 random {spheres} 4711 filled"),
                     ("timestep ", noise + "timestep ")):
        assert old in text
        text = text.replace(old, new)
    script.write_text(text)
    variables = {"box": wide * CELL, "height": high * CELL, "top": high * CELL, "spacing": CELL, "diameter": d,
                 "density": ratio * RHO, "dt": DT / int(engine_steps), "cutoff": 0.2 * d}
    append(folder, "constant/transportProperties", f"rho {RHO!r}; nu {mu / RHO!r};")
    append(folder, COUPLING, f"""form A; drag hillKochLadd; dragFactor {factor!r}; voidFraction sphereOverlap;
minVoidFraction 0.05;
lammpsCoeffs
{{
    script "$FOAM_CASE/lattice.lmp";
    variables {{ {' '.join(f'{name} "{value!r}";' for name, value in variables.items())} }}
}}""")
    append(folder, "system/controlDict", f"deltaT {DT!r}; endTime {given.steps * DT!r}; writeControl timeStep;"
           " writeInterval 1; writePrecision 12;")
    folder.mesh()
    log = folder.solve()
    times = [f"{n * DT:.8g}" for n in range(1, given.steps + 1)]
    sizes = [[np.sqrt((values**2).mean()) for values in (particle_velocities(folder, t), cells(folder, t, "p"))]
             for t in times]
    return np.array(sizes), log


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build")
    parser.add_argument("work")
    parser.add_argument("--spheres", type=int, default=200, help="in a cell (%(default)s)")
    parser.add_argument("--cells", type=int, nargs=2, default=(2, 16), help="of the box, wide and high (2 16)")
    parser.add_argument("--steps", type=int, default=40, help="of the gas, more than 20 (%(default)s)")
    parser.add_argument("--case", type=float, nargs=5, help="one case in the place of the page's")
    given = parser.parse_args()
    # Two cells along a direction carry no wave that they see; more carry those along it in all.
    directions = 3 if given.cells[0] > 2 else 1
    print("| eps | kappa | M | steps of the particles | found, by velocity | by pressure | eigenvalue | warned |\n"
          + "|---" * 8 + "|", flush=True)
    for n, case in enumerate([given.case] if given.case else CASES):
        eps, ratio, viscous, engine_steps, _ = case
        kappa = (1 - eps) / eps / ratio
        sizes, log = solve(given.build, given.work, f"case-{n}", case, given)
        growth = (sizes[-1] / sizes[-21]) ** (1 / 20)
        formula = eigenvalue(kappa, directions * viscous, engine_steps, given.cells[1])
        print(f"| {eps:g} | {kappa:.2g} | {directions * viscous:g} | {engine_steps:g} | {growth[0]:.4g} |"
              f" {growth[1]:.4g} | {formula:.4g} | {'would' in log and 'grow by a factor' in log} |", flush=True)


if __name__ == "__main__":
    main()
