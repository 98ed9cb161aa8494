# SPDX-License-Identifier: BSD-3-Clause
"""A manufactured solution of the volume-averaged equations, in a periodic square:
void fraction, superficial velocity and pressure are given, and every cell has one sphere, of the size that
makes the void fraction and with the velocity whose drag is the force that is missing in the gas's momentum
equation. Nothing in the solver knows of it. The spheres stay where they are."""

import shutil

import numpy as np

from cohesion_tests.coupling.cases import COUPLING
from cohesion_tests.coupling.dictionaries import FIELD
from cohesion_tests.coupling.fields import field
from cohesion_tests.theory.closure_formulas import CLOSURES, DOUBLE

RHO, NU, K = 1.0, 0.05, 2 * np.pi  # the square has edges of 1 m
RATE = 5.0  # about that of the drag, beta/rho [1/s]
CLOSURE = CLOSURES["diFelice"]
BLOCK = """
scale 1;
vertices ((0 0 0) (1 0 0) (1 {1} 0) (0 {1} 0) (0 0 1) (1 0 1) (1 {1} 1) (0 {1} 1));
blocks ( hex (0 1 2 3 4 5 6 7) ({0} 1 {0}) simpleGrading (1 1 1) );
boundary
(
    x0 {{ type cyclic; neighbourPatch x1; faces ((0 4 7 3)); }}
    x1 {{ type cyclic; neighbourPatch x0; faces ((1 2 6 5)); }}
    z0 {{ type cyclic; neighbourPatch z1; faces ((0 3 2 1)); }}
    z1 {{ type cyclic; neighbourPatch z0; faces ((4 5 6 7)); }}
    sides {{ type empty; faces ((0 1 5 4) (3 7 6 2)); }}
);
"""


def derivative(values, axis):
    """Of periodic values on a grid in the unit square, exact for what the grid resolves."""
    n = values.shape[axis]
    wave = 2j * np.pi * np.fft.fftfreq(n, 1 / n)
    shape = [1, 1]
    shape[axis] = n
    return np.fft.ifft(np.fft.fft(values, axis=axis) * wave.reshape(shape), axis=axis).real


def solution(n):
    """At the centres of n x n cells, first index z: void fraction, U and the force that is missing, both
    (x, z), and p. U and p are the gas's, p over its density.

    div(eps U U) = -eps grad p + div(eps nu (grad U + grad U^T - 2/3 div U)) + force"""
    fine = 16 * n if n < 32 else 8 * n
    at = np.arange(fine) / fine
    z, x = np.meshgrid(at, at, indexing="ij")
    eps = 0.7 + 0.1 * np.sin(K * x) * np.cos(K * z) + 0.05 * np.cos(K * x)
    # From a stream function and a mean: free of divergence
    flux = [0.5 - 0.3 * np.cos(K * x) * np.sin(K * z), 0.3 + 0.3 * np.sin(K * x) * np.cos(K * z)]
    u = [q / eps for q in flux]
    p = 0.4 * np.cos(K * x) * np.sin(K * z) + 0.2 * np.sin(K * z)
    axes = (1, 0)  # of x and z

    gradient = [[derivative(u[i], axes[j]) for j in range(2)] for i in range(2)]
    divergence = gradient[0][0] + gradient[1][1]
    force = []
    for i in range(2):
        total = eps * derivative(p, axes[i])
        for j in range(2):
            stress = eps * NU * (gradient[i][j] + gradient[j][i] - (i == j) * 2 / 3 * divergence)
            total += derivative(flux[j] * u[i] - stress, axes[j])
        force.append(total)
    step = fine // n
    centres = np.s_[step // 2::step, step // 2::step]
    return eps[centres], [c[centres] for c in u], [c[centres] for c in force], p[centres]


def spheres(case, n):
    """The data file; the drag factor that the case needs."""
    eps, u, force, _ = solution(n)
    h = 1 / n
    diameter = np.cbrt(6 / np.pi * (1 - eps) * h**3)
    mean = CLOSURE(DOUBLE, 0.7, 0.5, 0.8 * h, RHO, NU * RHO)
    factor = float(f"{RATE * RHO / (0.3 * mean):.6g}")
    missing = RHO * np.hypot(*force) / (factor * (1 - eps))
    # |force| = beta slip/rho, the drag falls with the slip less than its inverse
    slip = missing / mean
    for _ in range(60):
        law = np.array([CLOSURE(DOUBLE, *where, RHO, NU * RHO)
                        for where in zip(eps.flat, slip.flat, diameter.flat)]).reshape(eps.shape)
        if np.all(np.abs(missing / law / slip - 1) < 1e-13):
            break
        slip = missing / law
    else:
        raise AssertionError("no slip found")
    v = [a + f * RHO / (factor * (1 - eps) * law) for a, f in zip(u, force)]
    centre = (np.arange(n) + 0.5) * h
    lines = ["spheres, their places, sizes and velocities", "", f"{n * n} atoms", "1 atom types", "",
             "0 1 xlo xhi", f"0 {h!r} ylo yhi", "0 1 zlo zhi", "", "Atoms", ""]
    places = [(k, i) for k in range(n) for i in range(n)]
    lines += [f"{m + 1} 1 {diameter[k, i]:.17g} 1e12 {centre[i]:.17g} {h / 2!r} {centre[k]:.17g}"
              for m, (k, i) in enumerate(places)]
    lines += ["", "Velocities", ""]
    lines += [f"{m + 1} {v[0][k, i]:.17g} 0 {v[1][k, i]:.17g} 0 0 0" for m, (k, i) in enumerate(places)]
    (case.folder / "table.data").write_text("\n".join(lines) + "\n")
    return factor


def run(column, n, dt, end):
    """U (x, z) and p in all cells [z, x] at the end."""
    case = column(f"{n}-{dt:g}-{end:g}")
    h = 1 / n
    block = case.folder / "system/blockMeshDict"
    block.write_text(block.read_text().split("// A column")[0] + BLOCK.format(n, repr(h)))
    patches = "".join(f"    {d}{i} {{ type cyclic; }}\n" for d in "xz" for i in "01")
    patches += "    sides { type empty; }\n"
    fields = {"U": ("volVectorField", "[0 1 -1 0 0 0 0]", "uniform (0 0 0)"),
              "p": ("volScalarField", "[0 2 -2 0 0 0 0]", "uniform 0"),
              "voidFraction": ("volScalarField", "[0 0 0 0 0 0 0]", "uniform 1")}
    for name, (kind, dimensions, inside) in fields.items():
        (case.folder / "0.orig" / name).write_text(FIELD.format(kind, name, dimensions, inside, patches))
    case.set("constant/g", "value", "(0 0 0)")
    case.set("constant/transportProperties", "rho", RHO)
    case.set("constant/transportProperties", "nu", NU)
    case.set(COUPLING, "drag", "diFelice")
    case.set(COUPLING, "dragFactor", repr(spheres(case, n)))
    case.set(COUPLING, "lammpsCoeffs/script", '"$FOAM_CASE/table.lmp"')
    for variable, value in (("table", "table.data"), ("dt", repr(dt)), ("cutoff", repr(0.4 * h))):
        case.set(COUPLING, f"lammpsCoeffs/variables/{variable}", f'"{value}"')
    for entry, value in (("PIMPLE/pRefCell", 0), ("PIMPLE/pRefValue", 0),
                         ('solvers/"p.*"/tolerance', 1e-11)):
        case.set("system/fvSolution", entry, value)
    case.set("system/fvSchemes", "divSchemes/div(voidFractionPhi,U)", "Gauss linear")
    for entry, value in (("deltaT", dt), ("endTime", end), ("writeInterval", end)):
        case.set("system/controlDict", entry, value)
    case.mesh()
    case.solve()
    time = f"{end:g}"
    u = field(case, time, "U").reshape(n, n, 3)
    p = field(case, time, "p").reshape(n, n)
    shutil.rmtree(case.folder)
    return [u[:, :, 0], u[:, :, 2]], p - p.mean()


def size(values):
    return np.sqrt(np.mean(np.square(values)))


def in_space(column, meshes):
    """Errors of U and p in the steady state, from which exp(-RATE/eps t) is left, 1e-6."""
    rows = []
    for n in meshes:
        _, u, _, p = solution(n)
        found, pressure = run(column, n, 0.5 / n, 2.0)
        rows.append((n, size(np.array(found) - np.array(u)), size(pressure - p + p.mean())))
    return rows


def in_time(column, steps, n=16, end=0.16):
    """By how much U on its way to the steady state, on one mesh, differs between each of the steps and the next."""
    flow = [np.array(run(column, n, dt, end)[0]) for dt in steps]
    return [size(a - b) for a, b in zip(flow, flow[1:])]


def orders(errors):
    return np.log2(np.array(errors[:-1]) / np.array(errors[1:]))
