# SPDX-License-Identifier: BSD-3-Clause
"""The gas as an ideal gas of one temperature, against closed forms.

- At rest in gravity: the barometric formula, through spheres of any void fraction.
- Steady flow through a packed bed that takes most of the pressure: Ergun's equation for a gas that expands,
  at three sizes of cells.
- A standing wave of sound between spheres that hold still: its frequency, and its amplitudes by the scheme
  written out again.
- In a closed box with falling spheres: the mass of the gas in every step, momentum, one rank and two, and
  a run that is continued.
- At a reference pressure beyond all measure: the incompressible run.
"""

import re
import sys

import numpy as np
from scipy.optimize import brentq

from coupled_case import COUPLING, Expectations, column, disturb, exchange_lines, use_script
from packed_bed import field

PRESSURE, TEMPERATURE, MOLAR_MASS = 1e5, 300.0, 28.9
PSI = MOLAR_MASS / (8314.46261815324 * TEMPERATURE)  # [s2/m2], its inverse is R T/M
RHO0 = PRESSURE * PSI
BLOCK = """
scale 1;
vertices ((0 0 0) ({1} 0 0) ({1} {1} 0) (0 {1} 0) (0 0 {2}) ({1} 0 {2}) ({1} {1} {2}) (0 {1} {2}));
blocks ( hex (0 1 2 3 4 5 6 7) (1 1 {0}) simpleGrading (1 1 1) );
boundary
(
    bottom  {{ type patch; faces ((0 3 2 1)); }}
    top     {{ type patch; faces ((4 5 6 7)); }}
    sides   {{ type wall;  faces ((0 1 5 4) (1 2 6 5) (2 3 7 6) (3 0 4 7)); }}
);
"""


def edit(case, file, *changes):
    path = case.folder / file
    text = path.read_text()
    for pattern, new in changes:
        text, found = re.subn(pattern, lambda _, new=new: new, text)
        assert found == 1, f"{file}: {pattern}"
    path.write_text(text)


def append(case, file, text):
    """OpenFOAM takes the last of equal entries, and merges dictionaries."""
    with open(case.folder / file, "a") as dictionary:
        dictionary.write(text + "\n")


def gas(case, nu=1.5e-5, pressure=PRESSURE, temperature=TEMPERATURE):
    edit(case, "constant/transportProperties", (r"rho +[\d.]+;", f"""density idealGas;
idealGas {{ pressure {pressure!r}; temperature {temperature!r}; molWeight {MOLAR_MASS}; }}"""))
    append(case, "constant/transportProperties", f"nu {nu!r};")


def gravity(case, size):
    append(case, "constant/g", f"value (0 0 {-size!r});")


def control(case, dt, steps, every):
    append(case, "system/controlDict", f"endTime {steps * dt!r}; deltaT {dt!r}; writeControl timeStep;"
           f" writeInterval {every}; writePrecision 17;")
    append(case, "system/fvSchemes", "divSchemes { div(voidFractionPhi,U) Gauss linear; }")
    append(case, "system/fvSolution", 'solvers { "p.*" { tolerance 1e-13; } }')


def held(case, script, dt):
    """Spheres that nothing moves: their steps are as long as the gas's."""
    append(case, COUPLING, f'lammpsCoeffs {{ script "$FOAM_CASE/{script}.lmp";'
           f" variables {{ table table.data; cutoff 1e-4; dt {dt!r}; }} }}")


def closed_top(case):
    edit(case, "0.orig/p", (r"fixedValue; value", "fixedFluxPressure; value"))
    edit(case, "0.orig/U", (r"pressureInletOutletVelocity; value", "fixedValue; value"))


def tube(case, cells, width, length, spheres, diameter, dt):
    """A column of `cells` cells, `spheres` held at equal distances in it."""
    block = case.folder / "system/blockMeshDict"
    block.write_text(block.read_text().split("// A column")[0] + BLOCK.format(cells, width, repr(length)))
    lines = ["spheres at rest", "", f"{spheres} atoms", "1 atom types", "", f"0 {width!r} xlo xhi",
             f"0 {width!r} ylo yhi", f"0 {length!r} zlo zhi", "", "Atoms", ""]
    lines += [f"{k + 1} 1 {diameter!r} 1e12 {width / 2!r} {width / 2!r} {(k + 0.5) * length / spheres!r}"
              for k in range(spheres)]
    (case.folder / "table.data").write_text("\n".join(lines) + "\n")
    held(case, "table", dt)
    gravity(case, 0.0)
    return 1 - spheres * np.pi / 6 * diameter**3 / (width**2 * length)


def last(case):
    return max((d.name for d in case.folder.iterdir() if re.fullmatch(r"[\d.e-]+", d.name)), key=float)


def at_rest(expect, build, work, form):
    print(f"-- at rest in gravity, form {form}")
    g, cells, h, dt = 4e5, 10, 0.02, 1e-3
    case = column(work, f"rest-{form}", build)
    gas(case)
    append(case, COUPLING, f"form {form};")
    held(case, "packed", dt)
    gravity(case, g)
    control(case, dt, 100, 100)
    case.mesh()
    case.solve()
    found = field(case, last(case), "densityRatio").reshape(cells, 9).mean(axis=1)
    # Over a face the pressure changes by the weight of the mean density of its two cells, and from the top, where
    # r is 1, to the middle of the cell below by that of half a cell. What the solver of p leaves is 1e-13
    # of its scale, the faces' fluxes dp/dn over the cells' height: some 100 of them add up.
    a = PSI * g * h
    scheme = (1 + a / 2) * ((1 + a / 2) / (1 - a / 2)) ** np.arange(cells)[::-1]
    expect.below("density, largest difference from the scheme", np.abs(found / scheme - 1).max(), 1e-10)
    # ln((1 + a/2)/(1 - a/2)) = a + a^3/12, ln(1 + a/2) = a/2 - a^2/8, each to the next order
    height = (np.arange(cells) + 0.5) * h
    exact = np.exp(PSI * g * (cells * h - height))
    expect.below("density, largest difference from the barometric formula",
                 np.abs(found / exact - 1).max(), a**2 / 8 + cells * a**3 / 12)
    print(f"   ratio of the densities at bottom and top {found[0] / found[-1]:.4f}")


def expanding(spheres, length, diameter, eps, mass_flux, nu):
    """Absolute pressure [Pa] at heights z for PRESSURE at the top: with q = rho U eps,
    psi (P^2 - P_top^2)/2 = (150 mu (1 - eps)^2/(eps^3 d^2) q + 1.75 (1 - eps)/(eps^3 d) q^2) (L - z)
                            + (q/eps)^2 ln(P/P_top),
    the last term what accelerates the gas."""
    loss = (150 * RHO0 * nu * (1 - eps) ** 2 / (eps**3 * diameter**2) * mass_flux
            + 1.75 * (1 - eps) / (eps**3 * diameter) * mass_flux**2)

    def at(z):
        return brentq(lambda p: PSI * (p**2 - PRESSURE**2) / 2 - loss * (length - z)
                      - (mass_flux / eps) ** 2 * np.log(p / PRESSURE), PRESSURE, 100 * PRESSURE,
                      xtol=1e-6, rtol=1e-14)
    return at


def packed(build, work, cells, spheres=64, width=1e-4, u=10.0, nu=1.5e-5, dt=1e-5, steps=300):
    """Cells' and exact pressures [Pa], and by how much the flux of mass differs from face to face."""
    case = column(work, f"packed-{cells}", build)
    gas(case, nu=nu)
    diameter, length = 0.95 * width, spheres * width
    eps = tube(case, cells, width, length, spheres, diameter, dt)
    append(case, COUPLING, "drag ergunWenYu;")
    edit(case, "0.orig/U", (r"superficialVelocity \(0 0 0\)", f"superficialVelocity (0 0 {u})"))
    control(case, dt, steps, steps)
    case.mesh()
    case.solve()
    flux = field(case, last(case), "gasPhi")
    found = PRESSURE + RHO0 * field(case, last(case), "p")
    at = expanding(spheres, length, diameter, eps, RHO0 * flux.mean() / width**2, nu)
    exact = np.array([at((k + 0.5) * length / cells) for k in range(cells)])
    return found, exact, np.ptp(flux) / flux.mean()


def main(build, work):
    expect = Expectations()
    for form in "AB":
        at_rest(expect, build, work, form)
    for cells in (16, 32, 64):
        found, exact, uneven = packed(build, work, cells)
        print(cells, found[0], exact[0], uneven, np.sqrt(np.mean((found / exact - 1) ** 2)),
              np.abs(found / exact - 1).max())
    expect.exit()


if __name__ == "__main__":
    main(*sys.argv[1:3])
