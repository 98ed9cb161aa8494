#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""How fast waves of free spheres grow from noise, in a periodic cloud of spheres that pass through each
other, without gravity: by the solver, and by the eigenvalues of a step of the waves that the cells carry
(src/drag/viscous_waves.h, here without its conditions of Jury).

    wave_growth.py BUILD WORK [--spheres N] [--cells WIDE HIGH] [--steps N] [--form B]
                   [--case EPS RATIO M ENGINE_STEPS STIFFNESS]

M: 4 nu dt/h^2, of waves in one direction. STIFFNESS: beta dt/(eps rho_g). RATIO: of the densities. Without --case the
cases of docs/openfoam-coupling/waves.md that have no drag; each takes some 20 s. The growth printed is the
mean of the last 20 steps. With stiff drag the eigenvalues say nothing: see free_waves.py, whose spheres stand in
columns."""

import argparse

import numpy as np

from cohesion_tests.coupling.cases import COUPLING, append, column, use_lattice
from drag_stiffness import CLOSURES, DOUBLE, DT, RHO, cells, particle_velocities, periodic

CELL = 5e-3
NOISE = 1e-12  # so little that nothing moves far in 40 steps [m/s]
CLOUD = "create_atoms 1 region filled"  # of lattice.lmp
CASES = [(0.62, 1, 24, 5, 1e-6), (0.62, 10, 240, 5, 1e-6), (0.62, 10, 240, 1, 1e-6), (0.62, 10, 100, 5, 1e-6),
         (0.62, 10, 60, 5, 1e-6)]


def eigenvalue(kappa, viscous, engine_steps, along):
    """The largest in size, of the waves that so many cells along one direction carry."""
    def of(seen):
        k, n, w = kappa * seen, viscous * (1 - seen), 0.5 * (1 - 1 / engine_steps)
        now, before = 1 + n, 1 - n * seen / 3
        return np.abs(np.roots([1, k * w * now - 1, k * ((1 - w) * now - w * before), -k * (1 - w) * before])).max()
    return max(of(np.cos(np.pi * i / along) ** 2) for i in range(along))


def solve(build, work, name, case, cells, spheres, steps, form="A", free=False, noise=NOISE, columns=0, every=1):
    """The case after `steps` gas steps, written after `every` of them, its log, and x = b dt/m. `cells` of the box,
    wide and high; `spheres` in a cell at random places; or, with `columns` along its edge, as many squared on it and
    as many spheres in each, every column a bit higher than the one before, so that a face between two rows cuts as
    many as any other plane."""
    eps, ratio, viscous, engine_steps, stiffness = case
    wide, high = cells
    d = CELL * (6 * (1 - eps) / np.pi / spheres) ** (1 / 3)
    mu = float(f"{viscous / 4 * CELL**2 / DT * RHO:.6g}")
    closure = CLOSURES["hillKochLadd"](DOUBLE, eps, 1e-9, d, RHO, mu)
    drag = stiffness * eps * RHO / DT / (1 - eps)  # b of a sphere per volume of it, in both forms
    factor = float(f"{drag / closure * (eps if form == 'B' else 1):.6g}")
    folder = column(work, name, build)
    periodic(folder, wide * CELL, wide, 0.0, high * CELL, high)
    script = folder.folder / "lattice.lmp"
    text = script.read_text()
    assert CLOUD in text
    spacing = CELL
    if columns:
        assert columns**3 == spheres
        spacing = CELL / columns
        row = f"(floor(x/{spacing!r})+{columns}*floor(y/{spacing!r}))"
        text = text.replace(CLOUD, f"{CLOUD}\nvariable higher atom {spacing / columns**2!r}*{row}\n"
                            "displace_atoms all move 0 0 v_higher units box")
    else:
        text = text.replace(CLOUD, f"create_atoms 1 random {spheres * wide**2 * high} 4711 filled")
    script.write_text(text.replace("timestep ", f"variable vz atom {noise}*normal(0,1,77)\n"
                                   "velocity all set 0 0 v_vz\ntimestep "))
    variables = {"box": wide * CELL, "height": high * CELL, "top": high * CELL, "spacing": spacing, "diameter": d,
                 "density": ratio * RHO, "dt": DT / int(engine_steps), "cutoff": 0.2 * d}
    append(folder, "constant/transportProperties", f"rho {RHO!r}; nu {mu / RHO!r};")
    append(folder, COUPLING, f"""form {form}; drag hillKochLadd; dragFactor {factor!r}; voidFraction sphereOverlap;
minVoidFraction 0.05; response {'free' if free else 'held'};""")
    use_lattice(folder, variables)
    append(folder, "system/controlDict", f"deltaT {DT!r}; endTime {steps * DT!r}; writeControl timeStep;"
           f" writeInterval {every}; writePrecision 17;")
    if columns:
        append(folder, "system/fvSolution", 'solvers { "p.*" { tolerance 1e-14; } }')
    folder.mesh()
    log = folder.solve()
    return folder, log, factor / (eps if form == "B" else 1) * closure * DT / (ratio * RHO)


def sizes(folder, steps):
    """Root mean squares of the particles' velocity and of the pressure after each step."""
    times = [f"{n * DT:.8g}" for n in range(1, steps + 1)]
    return np.array([[np.sqrt((values**2).mean()) for values in
                      (particle_velocities(folder, t), cells(folder, t, "p"))] for t in times])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build")
    parser.add_argument("work")
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
    for n, case in enumerate([given.case] if given.case else CASES):
        eps, ratio, viscous, engine_steps, _ = case
        kappa = (1 - eps) / eps / ratio
        folder, log, _ = solve(given.build, given.work, f"case-{n}", case, given.cells, given.spheres, given.steps,
                               given.form)
        found = sizes(folder, given.steps)
        growth = (found[-1] / found[-21]) ** (1 / 20)
        # Of form A
        formula = eigenvalue(kappa, directions * viscous, engine_steps, given.cells[1])
        print(f"| {eps:g} | {kappa:.2g} | {directions * viscous:g} | {engine_steps:g} | {growth[0]:.4g} |"
              f" {growth[1]:.4g} | {formula:.4g} | {'would' in log and 'grow by a factor' in log} |", flush=True)


if __name__ == "__main__":
    main()
