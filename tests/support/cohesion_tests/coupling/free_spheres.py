# SPDX-License-Identifier: BSD-3-Clause
"""Gas blown through spheres that are free to move, in a periodic box without gravity: case, and exact solution."""

import numpy as np

from cohesion_tests.coupling.cases import COUPLING, append, use_lattice
from cohesion_tests.coupling.fields import cells, particle_velocities
from cohesion_tests.theory.closure_formulas import CLOSURES, DOUBLE

RHO, U0, DT, SUB_STEPS, STEPS = 1.0, 1.0, 1e-3, 5, 20
# So viscous that Hill, Koch and Ladd's drag is linear: its inertial part is below 1e-6 of it.
RE = 1e-7
BLOCK = """
scale 1;
vertices ((0 0 0) ({0} 0 0) ({0} {0} 0) (0 {0} 0) (0 0 {2}) ({0} 0 {2}) ({0} {0} {2}) (0 {0} {2}));
blocks ( hex (0 1 2 3 4 5 6 7) ({1} {1} {3}) simpleGrading (1 1 1) );
boundary
(
    x0 {{ type cyclic; neighbourPatch x1; faces ((0 4 7 3)); }}
    x1 {{ type cyclic; neighbourPatch x0; faces ((1 2 6 5)); }}
    y0 {{ type cyclic; neighbourPatch y1; faces ((0 1 5 4)); }}
    y1 {{ type cyclic; neighbourPatch y0; faces ((3 7 6 2)); }}
    z0 {{ type cyclic; neighbourPatch z1; faces ((0 3 2 1)); }}
    z1 {{ type cyclic; neighbourPatch z0; faces ((4 5 6 7)); }}
);
"""


class Setting:
    """stiffness: beta dt/(eps rho_g), of the gas's step; ratio of the densities; cell: size/diameter;
    cfl: of the gas's step; per_edge: spheres along the edge of a cell, below 1 where cells are many to
    a sphere; layer: spheres in the lower half of a box four times as high; finer: steps in each of DT; steps: of DT."""

    def __init__(self, stiffness, eps=0.62, ratio=1000.0, cell=3.0, cfl=0.2, kernel="particleCentre",
                 width=0.0, free=False, form="A", layer=False, reynolds=RE, finer=1, steps=STEPS):
        self.asked = stiffness
        self.ratio, self.cell, self.cfl = ratio, cell, cfl
        self.kernel, self.width, self.free = kernel, width, free
        self.form, self.layer, self.finer, self.steps = form, layer, finer, steps
        self.h = U0 * DT / cfl
        self.d = self.h / cell
        # Spacing of the lattice nearest to eps that fits the cells
        per_edge = (6 / np.pi * (1 - eps) * cell**3) ** (1 / 3)
        if per_edge >= 1:
            self.per_edge, self.cells = max(1, round(per_edge)), 2
            self.d = self.h / self.per_edge * (6 / np.pi * (1 - eps)) ** (1 / 3)
            self.spacing = self.h / self.per_edge
        else:
            every = round(1 / per_edge)
            self.per_edge, self.cells, self.spacing = 1 / every, 2 * every, every * self.h
            self.d = self.spacing * (6 / np.pi * (1 - eps)) ** (1 / 3)
        self.eps = eps
        self.box = self.cells * self.h
        self.high = self.cells * (4 if layer else 1)
        self.height = self.high * self.h
        self.volume = np.pi / 6 * self.d**3
        # foamDictionary writes six digits.
        self.mu = float(f"{RHO * U0 * self.d / reynolds:.6g}")
        closure = CLOSURES["hillKochLadd"](DOUBLE, eps, U0, self.d, RHO, self.mu)
        # b is what is given, in form B, too, where the drag is 1/eps of form A's.
        in_form = eps if form == "B" else 1.0
        self.factor = float(f"{stiffness * eps * RHO / DT / ((1 - eps) * closure) * in_form:.6g}")
        self.b = self.factor / in_form * closure * self.volume
        self.stiffness = self.b / self.volume * (1 - eps) / (eps * RHO) * DT
        self.mass = ratio * RHO * self.volume
        self.loading = (1 - eps) * ratio / eps  # mass of the particles over that of the gas

    def __str__(self):
        return (f"gas {self.stiffness:7.0e}  particle sub-step {self.b * DT / SUB_STEPS / self.mass:7.0e}"
                f"  eps {self.eps:5.3f}  density ratio {self.ratio:6.0f}  cell/d {self.h / self.d:5.2f}"
                f"  CFL {self.cfl:4.1f}  {self.kernel}{f' smoothed {self.width:g} d' * bool(self.width)}"
                f"{'  response free' * self.free}")


def exact(s):
    """Velocities of gas and particles at the steps' ends."""
    t = DT * np.arange(1, STEPS + 1)
    slip = U0 * np.exp(-s.stiffness / DT * (1 + 1 / s.loading) * t)
    mean = U0 / (1 + s.loading)
    return mean + slip * s.loading / (1 + s.loading), mean - slip / (1 + s.loading)


def periodic(case, box, cells, speed, height=None, high=None):
    """A box of edge `box` [m] and so many cells along it, `height` and `high` along z if those are others, without
    gravity, the gas moving along z."""
    block = case.folder / "system/blockMeshDict"
    block.write_text(block.read_text().split("// A column")[0]
                     + BLOCK.format(repr(box), cells, repr(height or box), high or cells))
    for file, value in (("U", f"uniform (0 0 {speed})"), ("p", "uniform 0"), ("voidFraction", "uniform 1")):
        path = case.folder / "0.orig" / file
        text = path.read_text().split("internalField")[0]
        patches = "".join(f"    {d}{i} {{ type cyclic; }}\n" for d in "xyz" for i in "01")
        path.write_text(text + f"internalField {value};\nboundaryField\n{{\n{patches}}}\n")
    append(case, "constant/g", "value (0 0 0);")
    append(case, "system/fvSolution", "PIMPLE { pRefCell 0; pRefValue 0; }")


def solve(column, name, s):
    """The case, solved, and its log. It is written after each DT."""
    case = column(name)
    periodic(case, s.box, s.cells, U0, s.height, s.high)
    dt = DT / s.finer
    variables = {"box": s.box, "height": s.height, "top": s.height / 2 if s.layer else s.height,
                 "spacing": s.spacing, "diameter": s.d, "density": s.ratio * RHO, "dt": dt / SUB_STEPS,
                 "cutoff": 0.4 * min(s.box, s.spacing)}
    append(case, "constant/transportProperties", f"rho {RHO!r}; nu {s.mu / RHO!r};")
    append(case, COUPLING, f"""form {s.form}; drag hillKochLadd; dragFactor {s.factor!r}; voidFraction {s.kernel};
response {'free' if s.free else 'held'};
{f'smoothingWidth {s.width * s.d!r};' if s.width else ''}""")
    use_lattice(case, variables)
    append(case, "system/controlDict", f"deltaT {dt!r}; endTime {s.steps * DT!r}; writeControl timeStep;"
           f" writeInterval {s.finer}; writePrecision 17;")
    case.mesh()
    return case, case.solve()


def times():
    return [f"{n * DT:.8g}" for n in range(1, STEPS + 1)]


def run(column, name, s):
    """Mean velocities after each step by the solver, and its log."""
    case, log = solve(column, name, s)
    found = [(cells(case, time, "U").mean(), particle_velocities(case, time).mean()) for time in times()]
    return np.array(found).T, log
