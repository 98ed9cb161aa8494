# SPDX-License-Identifier: BSD-3-Clause
"""Gas blown through spheres that are free to move, in a periodic box: both come to the same velocity. By
the coupled solver, for drag from negligible to so stiff that gas and particles would be done in a
millionth of their step; against the scheme written out again, to round-off. How far that is off the exact
solution, for many more cases: stability_table.py; waves of free particles that drag makes: free_waves.py."""

import re
import sys

import numpy as np

from cohesion_tests.coupling.cases import COUPLING, Expectations, append, column, exchange_lines, use_lattice
from cohesion_tests.theory.closure_formulas import CLOSURES, DOUBLE
from packed_bed import field
from restart import numbers

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
    a sphere; layer: spheres in the lower half of a box four times as high; finer: steps in each of DT."""

    def __init__(self, stiffness, eps=0.62, ratio=1000.0, cell=3.0, cfl=0.2, kernel="particleCentre",
                 width=0.0, free=False, form="A", layer=False, reynolds=RE, finer=1):
        self.asked = stiffness
        self.ratio, self.cell, self.cfl = ratio, cell, cfl
        self.kernel, self.width, self.free = kernel, width, free
        self.form, self.layer, self.finer = form, layer, finer
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


def scheme(s):
    """The same by the scheme: gas implicit in the drag of the particles' velocity at its step's start, or
    in what takes them to it when they are free to follow; then the particles' sub-steps, velocity Verlet
    with the mean drag of a sub-step; what they felt and the gas was not charged with, in the next step."""
    u, v, force, owed = U0, 0.0, 0.0, 0.0
    dt, x = DT / SUB_STEPS, s.b * DT / SUB_STEPS / s.mass
    mean = -np.expm1(-x) / x
    charged = -np.expm1(-SUB_STEPS * x) / (SUB_STEPS * x) if s.free else 1.0
    k = s.stiffness * charged
    per_gas = s.loading / s.mass  # gas velocity by an impulse on each particle
    history = []
    for _ in range(STEPS):
        u = (u + k * v - owed * per_gas) / (1 + k)
        owed = -s.b * charged * (u - v) * DT
        for _ in range(SUB_STEPS):
            v += 0.5 * dt * force / s.mass
            force = s.b * mean * (u - v)
            v += 0.5 * dt * force / s.mass
            owed += force * dt
        history.append((u, v))
    return np.array(history).T


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


def solve(build, work, name, s):
    """The case, solved, and its log. It is written after each DT."""
    case = column(work, name, build)
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
    append(case, "system/controlDict", f"deltaT {dt!r}; endTime {STEPS * DT!r}; writeControl timeStep;"
           f" writeInterval {s.finer}; writePrecision 17;")
    case.mesh()
    return case, case.solve()


def particle_velocities(case, time):
    """z components"""
    path = case.folder / time / "lagrangian/particles/U"
    same = re.search(r"\n(\d+)\{\(\S+ \S+ (\S+)\)\}", path.read_text())
    return np.full(int(same[1]), float(same[2])) if same else numbers(path, 3)[:, 2]


def cells(case, time, name):
    """Values of a field in all cells, of vectors the z component"""
    text = (case.folder / time / name).read_text()
    uniform = re.search(r"internalField\s+uniform (?:\(\S+ \S+ )?([^\s;)]+)", text)
    if uniform:
        return np.array([float(uniform[1])])
    values = field(case, time, name)
    return values.reshape(-1, 3)[:, 2] if "volVectorField" in text else values


def times():
    return [f"{n * DT:.8g}" for n in range(1, STEPS + 1)]


def run(build, work, name, s):
    """Mean velocities after each step by the solver, and its log."""
    case, log = solve(build, work, name, s)
    found = [(cells(case, time, "U").mean(), particle_velocities(case, time).mean()) for time in times()]
    return np.array(found).T, log


def error_of_first_step(s):
    """Of the particles' velocity, as a share of the slip, if their sub-steps were exact."""
    x = s.b * DT / s.mass
    gain = -np.expm1(-x * (1 + s.loading)) / (1 + s.loading)
    follow = -np.expm1(-x)
    return abs(gain - follow / (1 + (s.loading * follow if s.free else s.stiffness)))


def check(expect, build, work, number, s):
    print(f"-- {s}")
    found, log = run(build, work, str(number), s)
    lines = exchange_lines(log)
    # Each step is a few roundings of u, v and what is owed; what is owed is up to `stiffness` times as
    # large as u, and divided by 1 + stiffness when it is charged. The drag's inertial part: RE.
    tolerance = 1e-13 * STEPS + RE
    for what, values, expected in zip(("gas", "particles"), found, scheme(s)):
        expect.below(f"{what}: largest difference from the scheme", np.abs(values - expected).max(),
                     tolerance)
    expect.true("the slip falls from step to step",
                bool(np.all(np.diff(np.append(U0, found[0] - found[1])) <= 1e-12)))
    # The gas is charged with `stiffness` times a difference of velocities that are rounded to 1e-16.
    momentum = s.eps * RHO * U0 * s.box**3
    expect.below("imbalance of the momentum of a step / momentum of the gas",
                 max(x["imbalance"] * abs(x["drag"][2]) for x in lines) * DT / momentum,
                 1e-15 * (100 + s.stiffness))
    late = s.b * DT / s.mass > 1 and error_of_first_step(s) > 0.05
    expect.equal("times that it warns of the gas step", log.count("the gas step is"), int(late))
    if s.free and s.b * DT / s.mass > 100:
        expect.below("share of the slip by which the particles are late at the end",
                     abs(found[1] - exact(s)[1])[-1], tolerance)


def largest_root(kappa, viscous, engine_steps):
    """In size, of the steps of viscous_waves.h, over shares C in steps of 1/32."""
    w = 0.5 * (1 - 1 / engine_steps)

    def of(seen):
        k, n = kappa * seen, viscous * (1 - seen)
        now, before = 1 + n, 1 - n * seen / 3
        return np.abs(np.roots([1, k * w * now - 1, k * ((1 - w) * now - w * before), -k * (1 - w) * before])).max()
    return max(of(i / 32) for i in range(1, 33))


def check_said(expect, log, s):
    """What the warning of viscous waves says, by the roots: of cells that are alike, kappa, M of three directions, the
    growth, and a deltaT that is a whole number of the particles' steps in which nothing grows."""
    numbers_of = r"grow by a factor of (\S+) in a gas step.*kappa = \S.* = (\S+), M = .* = (\S+), (\d+) steps"
    factor, kappa, viscous, steps = map(float, re.search(numbers_of, log).groups())
    # Six digits are printed; kappa has the overlaps' round-off.
    expect.near("kappa that is said", kappa, (1 - s.eps) / s.eps / s.ratio, 1e-5 * kappa)
    expect.near("M that is said", viscous, 12 * s.mu / RHO * DT / s.h**2, 1e-5 * viscous)
    expect.equal("steps of the particles", steps, SUB_STEPS)
    # The growth is to 1e-6, and goes with no more than the first power of kappa and M.
    expect.near("growth that is said", factor, largest_root(kappa, viscous, steps), 3e-5 * factor)
    cure = re.search(r"a deltaT of (\S+) s in (\d+) steps of the particles, of (\S+) s each", log)
    if cure:
        longest, steps, particles = map(float, cure.groups())
        expect.near("deltaT / whole steps", longest / particles, steps, 1e-9)
    else:
        longest, steps = map(float, re.search(r"a deltaT of (\S+) s, (\d+) steps of the particles as", log).groups())
        expect.near("deltaT / steps as they are", longest / (DT / SUB_STEPS), steps, 1e-9)
    share = longest / DT
    expect.below("growth in the deltaT that is said", largest_root(kappa, viscous * share, steps), 1 + 2e-6)
    if cure:  # three digits, and what was looked for to 1e-3
        expect.true("and it is the longest", largest_root(kappa, viscous * share * 1.015, steps) > 1 + 2e-6)


def check_viscous(expect, build, work):
    """Free spheres, 16 cells high, in gas so viscous that nu dt/h^2 is 6: light ones move in waves that grow from
    round-off, ten times heavier ones do not, and in form B none; it is said when they do (viscous_waves.h). How fast
    they grow goes with where the lattice's planes are between the faces, so only that they grow is asked for."""
    for ratio, form, grow in ((1.0, "A", True), (10.0, "A", False), (1.0, "B", False)):
        s = Setting(1e-2, ratio=ratio, kernel="sphereOverlap", reynolds=0.01, form=form)
        s.high, s.height = 16, 16 * s.h
        what = f"form {form}, density ratio {ratio:g}"
        case, log = solve(build, work, f"viscous-{form}-{ratio:g}", s)
        middle, end = (np.abs(cells(case, time, "p")).max() for time in (times()[STEPS // 2 - 1], times()[-1]))
        expect.equal(f"{what}: the pressure of waves grows", bool(end > 10 * middle), grow)
        expect.equal(f"{what}: times that it is said", log.count("waves of particles that are free"), int(grow))
        if grow:
            check_said(expect, log, s)
            check_said(expect, case.solve("-overwrite", ranks=2), s)
    # Where fewer of the particles' steps do, where these must be shorter, and where nothing does
    for ratio, reynolds in ((1.0, 0.06), (0.4, 0.1), (0.25, 0.1)):
        s = Setting(1e-2, ratio=ratio, kernel="sphereOverlap", reynolds=reynolds)
        _, log = solve(build, work, f"said-{ratio:g}", s)
        if ratio == 0.25:
            expect.true("kappa above 2: says that no deltaT does", "no deltaT does: somewhere kappa is 2" in log)
        else:
            check_said(expect, log, s)
            expect.equal(f"density ratio {ratio:g}: steps as they are", "steps of the particles as they" in log,
                         ratio == 1.0)


def main(build, work):
    expect = Expectations()
    settings = [Setting(1e-6), Setting(1.0), Setting(1e6), Setting(1e6, ratio=1), Setting(1e9, ratio=1),
                Setting(1e6, eps=0.3, cfl=5), Setting(1.0, eps=0.999, cell=8),
                Setting(1.0, eps=0.9999, cell=17.4), Setting(1e6, ratio=1, free=True),
                Setting(1.0, eps=0.9999, cell=17.4, free=True)]
    for number, s in enumerate(settings):
        check(expect, build, work, number, s)
    check_viscous(expect, build, work)
    expect.exit()


if __name__ == "__main__":
    main(*sys.argv[1:3])
