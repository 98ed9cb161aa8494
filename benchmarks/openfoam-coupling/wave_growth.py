#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""How fast waves of free spheres grow from noise, in a periodic cloud of spheres that pass through each
other, without gravity: by the solver, and by the eigenvalues of a step of the waves that the cells carry
(src/drag/viscous_waves.h, here without its conditions of Jury).

    wave_growth.py BUILD WORK [--spheres N] [--cells WIDE HIGH] [--steps N] [--form B]
                   [--case EPS RATIO M ENGINE_STEPS STIFFNESS]

M: 4 nu dt/h^2, of waves in one direction. STIFFNESS: beta dt/(eps rho_g). RATIO: of the densities. Without --case it
runs cases without drag; each takes some 20 s. The growth printed is the mean of the last 20 steps. Conclusions:
docs/verification/coupled_flow.md. With stiff drag the eigenvalues say nothing: see free_waves.py, whose spheres stand in
columns."""


import numpy as np

from cohesion_tests import measuring_program
from cohesion_tests.coupling.cases import Columns
from cohesion_tests.coupling.fields import cells, particle_velocities
from cohesion_tests.coupling.free_spheres import DT
from cohesion_tests.coupling.waves import solve

CASES = [(0.62, 1, 24, 5, 1e-6), (0.62, 10, 240, 5, 1e-6), (0.62, 10, 240, 1, 1e-6), (0.62, 10, 100, 5, 1e-6),
         (0.62, 10, 60, 5, 1e-6)]


def eigenvalue(kappa, viscous, engine_steps, along):
    """The largest in size, of the waves that so many cells along one direction carry."""
    def of(seen):
        k, n, w = kappa * seen, viscous * (1 - seen), 0.5 * (1 - 1 / engine_steps)
        now, before = 1 + n, 1 - n * seen / 3
        return np.abs(np.roots([1, k * w * now - 1, k * ((1 - w) * now - w * before), -k * (1 - w) * before])).max()
    return max(of(np.cos(np.pi * i / along) ** 2) for i in range(along))


def sizes(folder, steps):
    """Root mean squares of the particles' velocity and of the pressure after each step."""
    times = [f"{n * DT:.8g}" for n in range(1, steps + 1)]
    return np.array([[np.sqrt((values**2).mean()) for values in
                      (particle_velocities(folder, t), cells(folder, t, "p"))] for t in times])


def main():
    parser = measuring_program.coupling_parser(__doc__)
    parser.add_argument("--spheres", type=int, default=200, help="in a cell (%(default)s)")
    parser.add_argument("--cells", type=int, nargs=2, default=(2, 16), help="of the box, wide and high (2 16)")
    parser.add_argument("--steps", type=int, default=40, help="of the gas, more than 20 (%(default)s)")
    parser.add_argument("--case", type=float, nargs=5, help="one case in the place of the page's")
    parser.add_argument("--form", choices="AB", default="A", help="of the model (%(default)s)")
    given = parser.parse_args()
    # Two cells along a direction carry no wave that they see; more carry those along it in all.
    directions = 3 if given.cells[0] > 2 else 1
    print("| eps | kappa | M | steps of the particles | found, by velocity | by pressure | eigenvalue | warned |\n"
          + "|---" * 8 + "|", flush=True)
    column = Columns(given.build, given.work)
    for n, case in enumerate([given.case] if given.case else CASES):
        eps, ratio, viscous, engine_steps, _ = case
        kappa = (1 - eps) / eps / ratio
        folder, log, _ = solve(column, f"case-{n}", case, given.cells, given.spheres, given.steps,
                               given.form)
        found = sizes(folder, given.steps)
        growth = (found[-1] / found[-21]) ** (1 / 20)
        # Of form A
        formula = eigenvalue(kappa, directions * viscous, engine_steps, given.cells[1])
        print(f"| {eps:g} | {kappa:.2g} | {directions * viscous:g} | {engine_steps:g} | {growth[0]:.4g} |"
              f" {growth[1]:.4g} | {formula:.4g} | {'would' in log and 'grow by a factor' in log} |", flush=True)


if __name__ == "__main__":
    main()
