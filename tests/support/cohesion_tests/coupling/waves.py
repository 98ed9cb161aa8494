# SPDX-License-Identifier: BSD-3-Clause
"""Waves of free spheres in a periodic cloud of spheres that pass through each other, without gravity."""

import re

import numpy as np

from cohesion_tests.coupling.cases import COUPLING, append, use_lattice
from cohesion_tests.coupling.free_spheres import DT, RHO, periodic
from cohesion_tests.theory.closure_formulas import CLOSURES, DOUBLE

CELL = 5e-3
NOISE = 1e-12  # so little that nothing moves far in 40 steps [m/s]
CLOUD = "create_atoms 1 region filled"  # of lattice.lmp


def solve(column, name, case, cells, spheres, steps, form="A", free=False, noise=NOISE, columns=0, every=1, ideal=""):
    """The case after `steps` gas steps, written after `every` of them, its log, and x = b dt/m. `cells` of the box,
    wide and high; `spheres` in a cell at random places; or, with `columns` along its edge, as many squared on it and
    as many spheres in each, every column a bit higher than the one before, so that a face between two rows cuts as
    many as any other plane. `ideal`: words of an ideal gas of the density RHO in the place of a constant one."""
    eps, ratio, viscous, engine_steps, stiffness = case
    wide, high = cells
    d = CELL * (6 * (1 - eps) / np.pi / spheres) ** (1 / 3)
    mu = float(f"{viscous / 4 * CELL**2 / DT * RHO:.6g}")
    closure = CLOSURES["hillKochLadd"](DOUBLE, eps, 1e-9, d, RHO, mu)
    drag = stiffness * eps * RHO / DT / (1 - eps)  # b of a sphere per volume of it, in both forms
    factor = float(f"{drag / closure * (eps if form == 'B' else 1):.6g}")
    folder = column(name)
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
    path = folder.folder / "constant/transportProperties"
    path.write_text(re.sub(r"\brho +[\d.]+;", ideal or f"rho {RHO!r};", path.read_text()))
    append(folder, "constant/transportProperties", f"nu {mu / RHO!r};")
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
