# SPDX-License-Identifier: BSD-3-Clause
"""Light spheres in a liquid: added mass, lift, drag of one coefficient. One sphere let go at rest, its terminal rise, its
lift in a uniform shear, against closed forms; and the momentum of both together with all forces at once, by the balance
of every step."""

import unittest

import numpy as np

from cohesion_tests.coupling.cases import COUPLING, append, edit, exchange_lines, script_file, use_script
from cohesion_tests.coupling.fields import numbers
from cohesion_tests.coupling.test_case import CoupledTestCase

RHO, MU, G, C = 400.0, 1.0, 9.81, 0.5
DENSITY = RHO / 1000
COEFFICIENT = 4 / (3 * 0.711**2)
BLOCK = """
scale 1;
vertices ((0 0 0) ({0} 0 0) ({0} {0} 0) (0 {0} 0) (0 0 {1}) ({0} 0 {1}) ({0} {0} {1}) (0 {0} {1}));
blocks ( hex (0 1 2 3 4 5 6 7) (3 3 5) simpleGrading (1 1 1) );
boundary
(
    left   {{ type wall; faces ((0 4 7 3)); }}
    right  {{ type wall; faces ((1 2 6 5)); }}
    front  {{ type cyclic; neighbourPatch back; faces ((0 1 5 4)); }}
    back   {{ type cyclic; neighbourPatch front; faces ((3 7 6 2)); }}
    bottom {{ {2} faces ((0 3 2 1)); }}
    top    {{ {3} faces ((4 5 6 7)); }}
);
"""


def write_field(case, name, kind, dimensions, inside, patches):
    cyclic = "{ type cyclic; }"
    rows = {"front": cyclic, "back": cyclic, **patches}
    (case.folder / "0.orig" / name).write_text(
        f"FoamFile {{ version 2.0; format ascii; class {kind}; object {name}; }}\ndimensions {dimensions};\n"
        f"internalField {inside};\nboundaryField\n{{\n"
        + "".join(f"    {patch} {row}\n" for patch, row in rows.items()) + "}\n")


class Liquid(CoupledTestCase):
    def sphere(self, name, d, cell, dt, steps, settings, **variables):
        """A case of one sphere in 3 x 3 x 5 cells, written after each gas step of five steps of the particles."""
        case = self.column(name)
        wide, high = 3 * cell, 5 * cell
        periodic = variables.get("along") == "p"
        block = case.folder / "system/blockMeshDict"
        ends = [f"type cyclic; neighbourPatch {other};" if periodic else "type patch;" for other in ("top", "bottom")]
        block.write_text(block.read_text().split("// A column")[0] + BLOCK.format(repr(wide), repr(high), *ends))
        values = {"wide": wide, "high": high, "x": 0.5 * wide, "y": 0.5 * wide, "z": 0.3 * high, "vx": 0, "vz": 0,
                  "along": "f", "gravity": G, "density": DENSITY, "diameter": d, "dt": dt / 5, **variables}
        use_script(case, "bubble")
        for variable, value in values.items():
            case.set(COUPLING, f"lammpsCoeffs/variables/{variable}", f'"{value}"')
        append(case, COUPLING, settings)
        append(case, "constant/transportProperties", f"rho {RHO}; nu {MU / RHO};")
        append(case, "system/controlDict",
               f"deltaT {dt!r}; endTime {steps * dt!r}; writeControl timeStep; writeInterval 1; writePrecision 17;")
        append(case, "system/fvSolution", 'solvers { "p.*" { tolerance 1e-13; } } PIMPLE { pRefCell 0; pRefValue 0; }')
        self.fields(case, periodic)
        return case

    def fields(self, case, periodic, shear=0.0, wide=0.0):
        still = "uniform (0 0 0)"
        ends = dict.fromkeys(("bottom", "top"), "{ type cyclic; }")
        zero = {"left": "{ type zeroGradient; }", "right": "{ type zeroGradient; }"}
        flux = {"left": "{ type fixedFluxPressure; value uniform 0; }",
                "right": "{ type fixedFluxPressure; value uniform 0; }"}
        walls = {"left": "{ type fixedValue; value uniform (0 0 0); }",
                 "right": f"{{ type fixedValue; value uniform (0 0 {shear * wide!r}); }}"}
        if shear:
            x = np.tile((np.arange(3) + 0.5) * wide / 3, 15)
            still = "nonuniform List<vector> 45 (" + " ".join(f"(0 0 {shear * a})" for a in x) + ")"
        elif not periodic:
            walls = {"left": "{ type slip; }", "right": "{ type slip; }"}
        open_u = {"bottom": "{ type superficialVelocity; superficialVelocity (0 0 0); }",
                  "top": "{ type pressureInletOutletVelocity; value uniform (0 0 0); }"}
        open_p = {"bottom": "{ type fixedFluxPressure; value uniform 0; }",
                  "top": "{ type fixedValue; value uniform 0; }"}
        open_e = dict.fromkeys(("bottom", "top"), "{ type zeroGradient; }")
        write_field(case, "U", "volVectorField", "[0 1 -1 0 0 0 0]", still,
                    {**walls, **(ends if periodic else open_u)})
        write_field(case, "p", "volScalarField", "[0 2 -2 0 0 0 0]", "uniform 0",
                    {**flux, **(ends if periodic else open_p)})
        write_field(case, "voidFraction", "volScalarField", "[0 0 0 0 0 0 0]", "uniform 1",
                    {**zero, **(ends if periodic else open_e)})

    def velocities(self, case, dt, steps):
        """Of the sphere after each gas step."""
        return np.array([numbers(case.folder / f"{n * dt:.8g}" / "lagrangian/particles/U", 3)[0]
                         for n in range(1, steps + 1)])

    def test_let_go_at_rest(self):
        # With each response and form: (rho_e - rho_b) g/(rho_b + C rho_e), from the change of the velocity from the
        # fifth gas step to the tenth, in a column 300 diameters wide. Drag takes (v/v_t)^2 < (2 g 1e-3 s/0.4 m/s)^2 =
        # 2.4e-3 of it, which the hyperbolic tangent has; in a cell the liquid is 2e6 times the sphere's. Asked for:
        # 0.1 %. The first half of an engine's step has no gas yet, which the difference does not see.
        d, dt, steps = 0.032, 1e-4, 10
        volume = np.pi / 6 * d**3
        free_fall = (RHO - DENSITY) * G / (DENSITY + C * RHO)
        terminal = 0.711 * np.sqrt(G * d)
        for form in "AB":
            for response in ("held", "free"):
                case = self.sphere(f"rest-{form}-{response}", d, 100 * d, dt, steps,
                                   f"form {form}; response {response}; drag davidsonTaylor; addedMass on;")
                case.mesh()
                lines = exchange_lines(case.solve())
                v = self.velocities(case, dt, steps)[:, 2]
                t = dt * np.array([5, 10])
                right = np.diff(terminal * np.tanh(free_fall * t / terminal))[0]
                self.expect_near(f"form {form}, {response}: acceleration [m/s2]", (v[9] - v[4]) / (5 * dt),
                                 right / (5 * dt), 1e-3 * right / (5 * dt))
                # The share of the cell that the sphere takes, 5e-7, is what an eps that is rounded to 1.1e-16 leaves of 1.
                self.expect_below(f"form {form}, {response}: imbalance", max(x["imbalance"] for x in lines),
                                  2 * 1.1e-16 / (volume / (100 * d) ** 3))
                self.expect_true(f"{response}: the pressure lifts it by rho V g to 1e-3",
                                 abs(lines[-1]["pressure"][2] / (RHO * volume * G) - 1) < 1e-3)

    def test_terminal_rise(self):
        # 0.711 sqrt(g d), asked for within 1 %. Approached as tanh(t/tau), tau = v_t/(2 g): 1 - tanh(10) = 4e-9. Gas
        # steps of tau/2, 5 steps of the particles in each: stable whatever they are, and exact in the end. The column
        # is 300 diameters wide: of the liquid's velocity F t/(rho cell) 1e-6.
        for d in (0.008, 0.032, 0.080):
            terminal = 0.711 * np.sqrt(G * d)
            dt = float(f"{0.5 * terminal / (2 * G):.3g}")
            for response in ("held", "free"):
                case = self.sphere(f"rise-{d}-{response}", d, 100 * d, dt, 20,
                                   f"response {response}; drag davidsonTaylor; addedMass on;")
                case.mesh()
                case.solve()
                self.expect_near(f"{1000 * d} mm, {response}: rise [m/s]", self.velocities(case, dt, 20)[-1, 2],
                                 terminal, 1e-4 * terminal)

    def test_constant_coefficient(self):
        # A heavy sphere held by nothing falls with sqrt(4 (s - 1) g d/(3 C_d)).
        d, density, coefficient = 0.01, 1000.0, 0.44
        terminal = np.sqrt(4 * (density / RHO - 1) * G * d / (3 * coefficient))
        # tau = v_t (rho_b + C rho)/((rho_b - rho) g), by the balance of weight and inertia
        dt = float(f"{0.5 * terminal * (density + C * RHO) / ((density - RHO) * G):.3g}")
        case = self.sphere("falls", d, 100 * d, dt, 24, f"drag constantCd; dragCoefficient {coefficient}; addedMass on;",
                           density=density, z=0.7 * 500 * d)
        case.mesh()
        case.solve()
        self.expect_near("fall [m/s]", self.velocities(case, dt, 24)[-1, 2], -terminal, 1e-4 * terminal)

    def test_lift_in_a_shear(self):
        # Between walls, the right one moving along z; no gravity, and next to no drag. A sphere in the middle, slip s
        # against it: M dv/dt = s x L with L = C_L rho V omega, omega = -shear y, so that the slip turns with the rate
        # C_L shear/(C + 1e-3) at one length; u . grad u is 0 along the path but for that turn, below 1e-3 of it. The
        # first tenth of a gas step has no liquid yet, which the turn, below 0.1 in all, makes 5e-4 of at most.
        shear, s, d, cell, dt, steps = 2.0, 0.3, 0.02, 2.0, 1e-3, 5
        wide = 3 * cell
        for lift, coefficient in (("inviscid", 0.5), ("inviscid; liftCoefficient 0.25", 0.25),
                                  ("saffmanMei", self.saffman_mei(d, s, shear))):
            case = self.sphere(f"lift-{coefficient:.3g}", d, cell, dt, steps,
                               f"lift {lift}; drag constantCd; dragCoefficient 1e-9; addedMass on; response free;",
                               along="p", gravity=0, vz=shear * wide / 2 + s)
            append(case, "constant/g", "value (0 0 0);")
            self.fields(case, True, shear, wide)
            case.mesh()
            lines = exchange_lines(case.solve())
            v = self.velocities(case, dt, steps)
            # (u - v) x omega = (-s z) x (-shear y) = -s shear x
            turn = coefficient * shear / (C + 1e-3) * dt
            expected = -s * (np.sin(5 * turn) - np.sin(turn))
            self.expect_near(f"{lift}: change of v_x [m/s]", v[4, 0] - v[0, 0], expected, 1e-3 * abs(expected))
            self.expect_below(f"{lift}: imbalance", max(x["imbalance"] for x in lines),
                              2 * 1.1e-16 / (np.pi / 6 * d**3 / cell**3))

    @staticmethod
    def saffman_mei(d, s, shear):
        """C_L from the force as Saffman and Mei print it, J = 1.615 d^2 sqrt(rho mu/omega) s omega x factor."""
        reynolds, a = RHO * s * d / MU, d * shear / (2 * s)
        assert reynolds < 40
        factor = (1 - 0.3314 * np.sqrt(a)) * np.exp(-reynolds / 10) + 0.3314 * np.sqrt(a)
        force = 1.615 * d**2 * np.sqrt(RHO * MU / shear) * s * shear * factor
        return force / (RHO * np.pi / 6 * d**3 * s * shear)

    def test_momentum_with_every_force(self):
        # A swarm of spheres of a thousandth of the liquid's density that collide, with all forces on, in both forms and
        # responses, on one rank and two: what the liquid gave is what the spheres got, in every step.
        settings = "drag davidsonTaylor; addedMass 0.6; lift saffmanMei; voidFraction sphereOverlap; minVoidFraction 0.1;"
        for name, more in (("A-free", "form A; response free;"), ("B-held", "form B; response held;"),
                           ("smoothed", "form A; response free; smoothingWidth 0.01; slip interpolated;")):
            for ranks in (1, 2) if name == "smoothed" else (1,):
                case = self.column(f"swarm-{name}-{ranks}")
                use_script(case, "swarm")
                script = script_file("swarm")
                edit(case, script, "density 1000", "density 1")
                edit(case, script, "create 1.6e17", "create 1.6e14")
                edit(case, script, "hooke/history 500 NULL 500 NULL", "hooke/history 0.5 NULL 0.5 NULL")
                text = (case.folder / script).read_text()
                (case.folder / script).write_text(text.replace("hooke/history 500 NULL 500", "hooke/history 0.5 NULL 0.5"))
                append(case, COUPLING, settings + more)
                append(case, "constant/transportProperties", "rho 1000; nu 1e-5;")
                case.set("system/controlDict", "endTime", 1e-3)
                case.set("system/controlDict", "writeInterval", 1e-3)
                case.mesh()
                lines = exchange_lines(case.solve(ranks=ranks))
                self.expect_equal(f"{name}, {ranks} ranks: gas steps", len(lines), 10)
                self.expect_balance(f"{name}, {ranks} ranks", lines)
                self.expect_true(f"{name}, {ranks} ranks: forces act", all(abs(x["drag"][2]) > 0 for x in lines[1:]))


if __name__ == "__main__":
    unittest.main()
