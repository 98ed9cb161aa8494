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
import shutil
import unittest

import numpy as np
from scipy.optimize import brentq

from cohesion_tests import csv_table
from cohesion_tests.coupling.cases import COUPLING, append, disturb, exchange_lines, use_script
from cohesion_tests.coupling.dictionaries import FILE, LAMINAR
from cohesion_tests.coupling.fields import field
from cohesion_tests.coupling.test_case import CoupledTestCase

PRESSURE, TEMPERATURE, MOLAR_MASS = 1e5, 300.0, 28.9
PSI = MOLAR_MASS / (8314.46261815324 * TEMPERATURE)  # [s2/m2], its inverse is R T/M
RHO0 = PRESSURE * PSI
DT, STEPS = 1e-4, 40  # of the falling spheres
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


def held(case, script, dt, cutoff=1e-3):
    """Spheres that nothing moves: their steps are as long as the gas's."""
    append(case, COUPLING, f'lammpsCoeffs {{ script "$FOAM_CASE/{script}.lmp";'
           f" variables {{ table table.data; cutoff {cutoff!r}; dt {dt!r}; }} }}")


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
    held(case, "table", dt, cutoff=0.4 * width)
    gravity(case, 0.0)
    return 1 - spheres * np.pi / 6 * diameter**3 / (width**2 * length)


def last(case):
    return max((d.name for d in case.folder.iterdir() if re.fullmatch(r"[\d.e-]+", d.name)), key=float)


def expanding(length, diameter, eps, mass_flux, nu):
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


# Of the packed bed
SPHERES, WIDTH, NU = 64, 1e-4, 1.5e-5


def packed(column, cells, model=False, u=6.0, dt=1e-5, steps=400):
    """The case, solved, and its void fraction. model: the stress is that of a turbulence model, laminar."""
    case = column(f"packed-{cells}-{model}")
    gas(case, nu=NU)
    eps = tube(case, cells, WIDTH, SPHERES * WIDTH, SPHERES, 0.95 * WIDTH, dt)
    if model:
        append(case, "constant/transportProperties", "transportModel Newtonian;")
        append(case, "system/fvSchemes", "divSchemes { div(((gasContent*nuEff)*dev2(T(grad(U))))) Gauss linear; }")
        path = case.folder / "constant/turbulenceProperties"
        path.write_text(FILE.format("dictionary", path.name) + LAMINAR)
    append(case, COUPLING, "drag ergunWenYu;")
    edit(case, "0.orig/U", (r"superficialVelocity \(0 0 0\)", f"superficialVelocity (0 0 {u})"))
    control(case, dt, steps, steps)
    case.mesh()
    case.solve()
    return case, eps


def bed_errors(case, cells, eps):
    """Errors of the cells' pressures, as shares of them: what is found, the part of the outlet in it, and what the
    largest may be; and by how much the flux of mass differs from face to face."""
    flux = field(case, last(case), "gasPhi")
    found = PRESSURE + RHO0 * field(case, last(case), "p")
    q = RHO0 * flux.mean() / WIDTH**2
    length = SPHERES * WIDTH
    at = expanding(length, 0.95 * WIDTH, eps, q, NU)
    h = length / cells
    exact = np.array([at((k + 0.5) * h) for k in range(cells)])
    # P P' = -K but for the acceleration: P'' = -K^2/P^3, P''' = 3 K^3/P^5, largest at the top. Each face errs by
    # h^3 P''' (1/24 + 1/8), by its difference and by the mean of two cells' resistances, and the half cell at
    # the top, with the resistance of its middle, by h^2 P''/8.
    k = (at(0.0) ** 2 - PRESSURE**2) / 2 / length
    second = h**2 * (k**2 / PRESSURE**3 / 8 + length * 3 * k**3 / PRESSURE**5 / 6)
    # The gas leaves with the velocity of the last cell, slower by h/2 dU/dz than it should: so much less
    # momentum leaves.
    outlet = q / eps * h / 2 * (q / eps / RHO0) * k / PRESSURE**2
    error = found / exact - 1
    return error, outlet / exact, (second + outlet) / PRESSURE, np.ptp(flux) / flux.mean()


def wave(w, smear, steps):
    """Amplitudes of the pressure of a standing wave by the scheme, w the step times the frequency between the
    faces. Flux q and pressure p of the new step, with the old q0: q = q0 - w p, p = p0 + w q; in the second
    correction the share `smear` of the flux, what its mean in cells and back to faces loses, is that
    of the first."""
    p, q = 1.0, 0.0
    amplitudes = [p]
    for _ in range(steps):
        first = q - w * (p + w * q) / (1 + w**2)
        inertia = (1 - smear) * q + smear * first
        p = (p + w * inertia) / (1 + w**2)
        q = inertia - w * p
        amplitudes.append(p)
    return np.array(amplitudes)


def mass(case, time):
    """Of the gas per reference density, in cells [1]"""
    return (field(case, time, "voidFraction") * field(case, time, "densityRatio")).sum()


def swarm(column, name, by=0.0):
    """Falling spheres that collide, in a column that is open at the top"""
    case = column(f"swarm-{name}")
    use_script(case, "continued")
    if by:
        disturb(case, "continued", by)
    control(case, DT, STEPS, STEPS // 4)
    return case


def drag(log):
    return np.array([x["drag"] for x in exchange_lines(log)])


def enter(quantity, case, computed, closed="0"):
    """Into coupled_flow.csv."""
    csv_table.enter(csv_table.of_test("coupled_flow"), {"quantity": quantity, "case": case, "closed form": closed},
                    computed=computed)


class GasDensity(CoupledTestCase):
    def at_rest(self, form):
        g, cells, h, dt = 4e5, 10, 0.02, 1e-3
        case = self.column(f"rest-{form}")
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
        self.expect_below(f"form {form}: density, largest difference from the scheme", np.abs(found / scheme - 1).max(),
                          1e-10)
        # ln((1 + a/2)/(1 - a/2)) = a + a^3/12, ln(1 + a/2) = a/2 - a^2/8, each to the next order
        height = (np.arange(cells) + 0.5) * h
        exact = np.exp(PSI * g * (cells * h - height))
        largest = np.abs(found / exact - 1).max()
        self.expect_below(f"form {form}: density, largest difference from the barometric formula", largest,
                          a**2 / 8 + cells * a**3 / 12)
        enter("error of the density of an ideal gas at rest, barometric formula", f"{cells} cells", csv_table.power(largest))

    def test_flow_through_a_bed(self):
        corrected = []
        for cells in (8, 16, 32):
            case, eps = packed(self.column, cells)
            error, outlet, limit, uneven = bed_errors(case, cells, eps)
            # Steady to what the solver of p leaves, 1e-13 of its scale; sums over the faces.
            self.expect_below(f"{cells} cells: flux of mass, largest difference between faces", uneven, 1e-10)
            self.expect_below(f"{cells} cells: largest error of the absolute pressure", np.abs(error).max(), limit)
            corrected.append(np.sqrt(np.mean((error + outlet) ** 2)))
            enter("error of the pressure of expanding gas in a packed bed, Ergun's equation", f"{cells} cells",
                  csv_table.power(np.abs(error).max()))
        # Without the outlet's, which is of first order, errors are of second order, with a remainder of third: h P''/P'
        # = 0.02 to 0.1 of it.
        for order in np.log2(np.array(corrected[:-1]) / corrected[1:]):
            self.expect_near("order in space", order, 2, 0.15)

        case.run("cohesiveBedFoam", "-postProcess", "-latestTime", "-func", "patchAverage(name=top,densityRatio)")
        text = case.log("cohesiveBedFoam").read_text()
        self.expect_near("postProcess: density at the top, over the reference",
                         float(text.split("areaAverage(top) of densityRatio = ")[1].split()[0]), 1, 1e-6)
        plain, model = (field(c, last(c), "p") for c in (case, packed(self.column, cells, model=True)[0]))
        # The stress is 4/3 mu dU/dz, some 1e-7 of the pressure, with a viscosity that goes with the density a third
        # more; the solver of p leaves 1e-13 of its scale.
        self.expect_below("pressure with simulationType laminar, largest difference", np.abs(model / plain - 1).max(),
                          1e-9)

    def sound(self, form, cells=32, h=0.01, dt=2e-5, steps=110):
        case = self.column(f"sound-{form}")
        gas(case, nu=1e-9)
        eps = tube(case, cells, h, cells * h, cells, 0.9 * h, dt)
        append(case, COUPLING, f"form {form}; dragFactor 1e-15;")
        closed_top(case)
        control(case, dt, steps, 1)
        k = np.pi / (cells * h)
        mode = np.cos(k * h * (np.arange(cells) + 0.5))
        size = 1e-6 / PSI
        edit(case, "0.orig/p", (r"internalField +uniform 0;", f"internalField nonuniform List<scalar> {cells}"
                                f"({' '.join(repr(float(size * x)) for x in mode)});"))
        case.mesh()
        case.solve()
        times = [f"{n * dt:.8g}" for n in range(1, steps + 1)]
        found = np.array([1] + [2 / cells * field(case, t, "p") @ mode / size for t in times])
        # In form B all of the pressure gradient acts on the gas, also between spheres that gas does not flow past.
        c = np.sqrt(1 / PSI / (1 if form == "A" else eps))
        # Products of amplitudes are 1e-6 of them, over some 6 radians.
        self.expect_below(f"form {form}: amplitudes, largest difference from the scheme",
                          np.abs(found - wave(dt * c * 2 / h * np.sin(k * h / 2), np.sin(k * h / 2) ** 2, steps)).max(),
                          1e-5)
        # A damped wave obeys a[n+1] = 2 Re(z) a[n] - |z|^2 a[n-1]; an implicit step turns it by arg z = atan(w).
        (twice, minus), *_ = np.linalg.lstsq(np.array([found[1:-1], found[:-2]]).T, found[2:], rcond=None)
        turn = np.arccos(twice / 2 / np.sqrt(-minus))
        # The faces' differences lose (k h)^2/24 of k, the smearing (k h/2)^2 of the inertia.
        self.expect_near(f"form {form}: speed of sound [m/s]", np.tan(turn) / dt / k, c,
                         c * (k * h) ** 2 * (1 / 24 + 1 / 4))
        enter(f"speed of sound between spheres [m/s], void fraction {eps:.2f}", f"form {form}",
              f"{np.tan(turn) / dt / k:.1f}", f"{c:.1f}")

    def balanced(self, name, case, log):
        errors = [float(x) for x in re.findall(r"Continuity error, mean of the sizes: (\S+)", log)]
        # The solver of p leaves 1e-13 of the sum of its terms, and psi p is below 1e-2.
        self.expect_below(f"{name}: largest error of continuity in a step", max(errors), 1e-15)
        masses = [mass(case, f"{n * STEPS / 4 * DT:.8g}") for n in (1, 2, 3, 4)]
        self.expect_below(f"{name}: gas lost or made in {3 * STEPS // 4} steps, of all",
                          np.ptp(masses) / masses[0], sum(errors) + 1e-15)
        self.expect_below(f"{name}: largest imbalance of the forces", max(x["imbalance"] for x in exchange_lines(log)),
                          1e-12)

    def test_falling_in_a_closed_box(self):
        found = {}
        for name, ranks, by in (("one", 1, 0.0), ("two", 2, 0.0), ("other", 1, 1e-8)):
            case = swarm(self.column, f"box-{name}", by)
            gas(case)
            closed_top(case)
            case.mesh()
            log = case.solve(ranks=ranks)
            if ranks > 1:
                case.run("reconstructPar")
            self.balanced(name, case, log)
            found[name] = drag(log)
            if name == "one":
                end = last(case)
                shutil.rmtree(case.folder / end)
                shutil.rmtree(case.folder / f"{3 * STEPS / 4 * DT:.8g}")
                append(case, "system/controlDict", "startFrom latestTime;")
                found["continued"] = drag(case.solve())
        one = found["one"]
        limit = np.abs(found["other"] - one).max()
        self.expect_below("drag, largest difference of 2 ranks from 1 [N]", np.abs(found["two"] - one).max(), limit)
        self.expect_below("drag, largest difference of a run that is continued [N]",
                          np.abs(found["continued"] - one[STEPS // 2:]).max(), limit)

    def test_reference_pressure_beyond_all_measure(self):
        pressure = 1e20  # psi p is below round-off
        runs = []
        for name, by in (("constant", 0.0), ("other", 1e-8), ("ideal", 0.0)):
            case = swarm(self.column, name, by)
            if name == "ideal":
                gas(case, nu=1.452282e-5, pressure=pressure, temperature=pressure * PSI * TEMPERATURE / 1.205)
            case.mesh()
            runs.append(drag(case.solve()))
        constant, other, ideal = runs
        self.expect_below("drag, largest difference from that in a gas of one density [N]",
                          np.abs(ideal - constant).max(),
                          np.abs(other - constant).max())

    def test_at_rest_in_gravity(self):
        for form in "AB":
            self.at_rest(form)

    def test_sound(self):
        for form in "AB":
            self.sound(form)


if __name__ == "__main__":
    unittest.main()
