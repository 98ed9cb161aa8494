# SPDX-License-Identifier: BSD-3-Clause
"""The function object bedPressureDrop. Gas through a bed of spheres that are held: the drop is Ergun's, and the same
in a column along any direction. Spheres that the gas just carries: drop over weight is 1 but for the momentum that
they gain. In both forms, with an ideal gas, on 2 ranks and in a round column that leans the drop is what the gas
puts on the particles by the engine's tally. And what is no column is refused."""

import re
import unittest

import numpy as np

from cohesion_tests.coupling.cases import BED, COUPLING, append
from cohesion_tests.coupling.fields import field, table
from cohesion_tests.coupling.held_layers import G, MU, RHO, drag, drop_error, flux_limit, viscous
from cohesion_tests.coupling.test_case import CoupledTestCase
from cohesion_tests.theory.closure_formulas import CLOSURES

CLOSURE = CLOSURES["ergunWenYu"]
SUPERFICIAL = 0.5
DT, STEP, STEPS = 1e-4, 1e-5, 40
SIDE, HEIGHT, ROW = 0.06, 0.2, 0.02
AREA = SIDE**2
# Spheres per cell and diameter in the ten rows: free, three rows of bed, free
FREE, BED = (0, 1e-3), (5**3, 3.8e-3)
ROWS = [FREE] * 2 + [BED] * 3 + [FREE] * 5
EPS = np.array([1 - n * np.pi / 6 * d**3 / ROW**3 for n, d in ROWS])
# By Ergun, over the rows [Pa]; eps grad p = -drag
LOSS = np.array([drag_ / eps * ROW for drag_, eps in zip((drag(row, CLOSURE) for row in ROWS), EPS)])
# At which the gas carries the spheres: their weight less buoyancy is the drop
CARRIED = RHO + LOSS.max() / ROW / (1 - EPS.min()) / G
TILTED = (1, 2, 3)


def turned(axis):
    """Rotation that takes z to `axis`."""
    z = np.array(axis) / np.linalg.norm(axis)
    x = np.cross((0, 1, 0) if abs(z[1]) < 0.9 else (0, 0, 1), z)
    x /= np.linalg.norm(x)
    return np.column_stack((x, np.cross(z, x), z))


def words(vector):
    return " ".join(repr(float(x)) for x in vector)


class Box:
    """Two blocks of cells of 20 mm beside each other, the faces below each a patch."""
    corners = [(0, 0), (0.02, 0), (0.06, 0), (0, 0.06), (0.02, 0.06), (0.06, 0.06)]
    arcs = []
    blocks = ("hex (0 1 4 3 6 7 10 9) (1 3 10) simpleGrading (1 1 1)"
              " hex (1 2 5 4 7 8 11 10) (2 3 10) simpleGrading (1 1 1)")
    lower = {"bottom": "(0 3 4 1)", "other": "(1 4 5 2)"}
    upper = "(6 7 10 9) (7 8 11 10)"
    sides = "(0 1 7 6) (1 2 8 7) (3 4 10 9) (4 5 11 10) (0 3 9 6) (2 5 11 8)"
    empty = ""
    radius, depth = np.inf, SIDE  # within which there are spheres


class Plane(Box):
    """The same in two dimensions, one cell deep, and spheres in a third of the depth."""
    blocks = Box.blocks.replace("(1 3 10)", "(1 1 10)").replace("(2 3 10)", "(2 1 10)")
    sides = "(0 3 9 6) (2 5 11 8)"
    empty = "(0 1 7 6) (1 2 8 7) (3 4 10 9) (4 5 11 10)"
    depth = SIDE / 3


class Round:
    """One block between four arcs of a circle."""
    a = SIDE / 2 * np.sqrt(0.5)
    corners = [(SIDE / 2 + x, SIDE / 2 + y) for x, y in ((-a, -a), (a, -a), (a, a), (-a, a))]
    arcs = [(SIDE / 2, 0), (SIDE, SIDE / 2), (SIDE / 2, SIDE), (0, SIDE / 2)]
    blocks = "hex (0 1 2 3 4 5 6 7) (3 3 10) simpleGrading (1 1 1)"
    lower = {"bottom": "(0 3 2 1)"}
    upper = "(4 5 6 7)"
    sides = "(0 1 5 4) (1 2 6 5) (2 3 7 6) (3 0 4 7)"
    empty = ""
    radius, depth = 0.4 * SIDE, SIDE


def write_mesh(case, shape, turn):
    n = len(shape.corners)
    vertices = [turn @ (x, y, z) for z in (0, HEIGHT) for x, y in shape.corners]
    arcs = [f"arc {k + level * n} {(k + 1) % n + level * n} ({words(turn @ (*middle, level * HEIGHT))})"
            for level in (0, 1) for k, middle in enumerate(shape.arcs)]
    lower = "".join(f"{name} {{ type patch; faces ({face}); }}\n" for name, face in shape.lower.items())
    block = case.folder / "system/blockMeshDict"
    block.write_text(block.read_text().split("// A column")[0] + f"""
scale 1;
vertices ({' '.join(f'({words(v)})' for v in vertices)});
edges ({' '.join(arcs)});
blocks ({shape.blocks});
boundary
(
{lower}    top {{ type patch; faces ({shape.upper}); }}
    sides {{ type wall; faces ({shape.sides}); }}
    plane {{ type empty; faces ({shape.empty}); }}
);
""")


def write_fields(case, shape, turn, velocities):
    """Those of the case, the patches below alike but for their velocities."""
    for file in (case.folder / "0.orig").iterdir():
        line = next(line for line in file.read_text().splitlines() if line.startswith("    bottom"))
        for name, velocity in zip(shape.lower, velocities):
            blown = re.sub(r"\(0 0 0\)", f"({words(velocity * turn[:, 2])})", line).replace("bottom", name)
            append(case, f"0.orig/{file.name}", f"boundaryField {{ {blown} }}")
        append(case, f"0.orig/{file.name}", "boundaryField { plane { type empty; } }")


def write_places(case, shape, turn, density):
    """Spheres as in ROWS, in a box as the mesh has it; how many."""
    along = (np.arange(15) + 0.5) * SIDE / 15
    up = 2 * ROW + (np.arange(15) + 0.5) * 3 * ROW / 15
    at = np.stack(np.meshgrid(along, along, up, indexing="ij"), axis=-1).reshape(-1, 3)
    x, y = np.abs(at[:, :2] - SIDE / 2).T
    at = at[(np.hypot(x, y) < shape.radius) & (y < shape.depth / 2)] @ turn.T
    points = (case.folder / "constant/polyMesh/points").read_text()
    points = np.array(re.findall(r"\((\S+) (\S+) (\S+)\)", points), float)
    box = "\n".join(f"{low!r} {high!r} {d}lo {d}hi"
                    for d, low, high in zip("xyz", points.min(axis=0).tolist(), points.max(axis=0).tolist()))
    atoms = "\n".join(f"{i} 1 {BED[1]!r} {float(density)!r} {words(place)}" for i, place in enumerate(at, 1))
    (case.folder / "places").write_text(f"Spheres\n\n{len(at)} atoms\n1 atom types\n\n{box}\n\nAtoms\n\n{atoms}\n")
    return len(at)


def function(kind, name, entries=""):
    return (f"{name} {{ type {kind}; libs (cohesionFunctionObjects); writeControl timeStep;"
            f" writeInterval {STEPS // 2}; writePrecision 14; {entries} }}")


def make(column, name, shape=Box, axis=(0, 0, 1), density=1e12, moved="nobody", velocities=(SUPERFICIAL,) * 2,
         entries="", coupling="", gas=f"rho {RHO!r}; nu {MU / RHO!r};"):
    """The bed in a column along `axis`; the case, and the number of spheres."""
    case = column(name)
    turn = turned(axis)
    write_mesh(case, shape, turn)
    write_fields(case, shape, turn, velocities)
    append(case, "constant/g", f"value ({words(-G * turn[:, 2])});")
    append(case, "constant/transportProperties", gas)
    append(case, "system/fvSolution", 'solvers { "p.*" { tolerance 1e-14; } }')
    # Central, for convection to have no part in the pressure drop
    append(case, "system/fvSchemes", "divSchemes { default Gauss linear; div(voidFractionPhi,U) Gauss linear; }")
    append(case, COUPLING, f"""drag ergunWenYu; {coupling}
lammpsCoeffs {{ script "$FOAM_CASE/carrying.lmp";
variables {{ places places; moved {moved}; dt "{STEP}"; down "{words(-turn[:, 2])}"; }} }}""")
    end = DT * STEPS
    append(case, "system/controlDict", f"""deltaT {DT}; endTime {end}; writeInterval {end};
functions {{ {function('bedPressureDrop', 'drop', entries)} {function('forceBudget', 'forces')} }}""")
    case.mesh()
    return case, write_places(case, shape, turn, density)


class Found:
    """Last row of both tables, the mean of the second half of the run; forces along the axis."""

    def __init__(self, case, axis):
        rows = table(case, "drop", "bedPressureDrop")
        self.over, self.velocity, self.drop, self.weight, self.ratio = rows[-1, 1:]
        forces = table(case, "forces", "forceBudget")[-1, 2:].reshape(5, 3) @ turned(axis)[:, 2]
        _, drag_, pressure, _, self.gain = forces
        self.gas = drag_ + pressure


def blow(column, name, ranks=1, axis=(0, 0, 1), **what):
    case, number = make(column, name, axis=axis, **what)
    case.solve(ranks=ranks)
    return Found(case, axis), number * np.pi / 6 * BED[1]**3


def by_forces(found, volume, area=AREA, rho=RHO):
    """The drop [Pa] by what the gas puts on spheres of so much volume."""
    return (found.gas - rho * G * volume) / area


class BedPressureDrop(CoupledTestCase):
    def close(self, what, found, expected, share=1e-9):
        """share: what the solver of p leaves, 1e-14 of its scale, which is below 1e4 of the drop"""
        self.expect_near(what, found, expected, share * abs(expected))

    def test_held(self):
        """Ergun's drop; the same along x, along a diagonal on 2 ranks, and in two dimensions; and in form B."""
        expected = LOSS.sum()
        limit = flux_limit(expected)
        drops = {}
        for name, what in (("z", {}), ("x", {"axis": (1, 0, 0)}), ("tilted", {"axis": TILTED, "ranks": 2}),
                           ("form B", {"coupling": "form B;"}),
                           ("plane", {"shape": Plane, "coupling": f"depth {Plane.depth!r};"})):
            found, volume = blow(self.column, f"held-{name.replace(' ', '-')}", **what)
            self.expect_near(f"held, {name}: over [s]", found.over, DT * STEPS / 2, 1e-12)
            self.expect_near(f"held, {name}: superficial velocity [m/s]", found.velocity, SUPERFICIAL, limit)
            # fix gas/coupling takes spheres to fall within its step: up to G STEP/2 more slip.
            self.expect_near(f"held, {name}: drop [Pa] by Ergun", found.drop, expected,
                             viscous(EPS) + drop_error(limit, LOSS, EPS) + 2 * G * STEP / 2 / SUPERFICIAL * expected)
            area = AREA / (3 if name == "plane" else 1)
            weight = (1e12 - RHO) * volume * G / area
            self.close(f"held, {name}: weight [Pa]", found.weight, weight)
            self.close(f"held, {name}: drop over weight", found.ratio, found.drop / weight)
            self.close(f"held, {name}: drop [Pa] by the forces", found.drop, by_forces(found, volume, area))
            drops[name] = found.drop
        for name in ("x", "tilted", "plane"):
            self.close(f"held, {name}: drop [Pa] as along z", drops[name], drops["z"])

    def test_carried(self):
        found, volume = blow(self.column, "carried", axis=TILTED, density=CARRIED, moved="all")
        # In the first step the gas meets them with the coefficient of no slip, and its pressure gradient, which makes
        # it pass them by SUPERFICIAL/EPS, gives them RHO/CARRIED of that.
        slip = SUPERFICIAL / EPS.min()
        self.expect_near("carried: drop over weight", found.ratio, 1, 2 * (G * DT / slip + RHO / CARRIED))
        # forceBudget counts the first and the last of the forces by half, and these change by less than the weight.
        self.expect_near("carried: drop over weight, by the momentum gained", found.ratio - 1,
                         found.gain / AREA / found.weight, STEP / found.over * abs(found.ratio - 1) + 1e-9)
        self.close("carried: weight [Pa]", found.weight, (CARRIED - RHO) * volume * G / AREA)

    def test_leaning_round(self):
        """Where the flow is not even the gas carries momentum out of the top that did not come in."""
        case, number = make(self.column, "round", shape=Round, axis=TILTED)
        case.solve()
        found, volume = Found(case, TILTED), number * np.pi / 6 * BED[1]**3
        area = 12 / 2 * (SIDE / 2)**2 * np.sin(np.pi / 6)
        self.expect_near("round: superficial velocity [m/s]", found.velocity, SUPERFICIAL, flux_limit(LOSS.sum()))
        self.close("round: weight [Pa]", found.weight, (1e12 - RHO) * volume * G / area)
        velocity = field(case, f"{DT * STEPS:g}", "U").reshape(10, 9, 3) @ turned(TILTED)[:, 2]
        uneven = np.abs(velocity[[0, -1]] - SUPERFICIAL).max()
        self.expect_near("round: drop [Pa] by the forces", found.drop, by_forces(found, volume, area),
                         RHO * 2 * SUPERFICIAL * uneven + 4 / 3 * MU * uneven / (ROW / 2))

    def test_ideal_gas(self):
        """Long enough for sound to die out, which steps of 1 ms see to. As it expands the gas carries out more momentum
        than it brings."""
        law = {"pressure": 1e5, "temperature": 288, "molWeight": 28.85}
        density = law["pressure"] * law["molWeight"] / 8314.47 / law["temperature"]
        case, number = make(self.column, "ideal", gas=f"""#remove rho
density idealGas; nu {MU / density!r}; idealGas {{ {" ".join(f"{k} {v};" for k, v in law.items())} }}""")
        append(case, "system/controlDict", f"deltaT {10 * DT}; endTime {10 * DT * STEPS};")
        case.solve()
        found, volume = Found(case, (0, 0, 1)), number * np.pi / 6 * BED[1]**3
        self.expect_near("ideal gas: superficial velocity [m/s]", found.velocity, SUPERFICIAL, 1e-9)
        expected = by_forces(found, volume, rho=density)
        expands = (expected + density * G * HEIGHT) / law["pressure"]
        self.expect_near("ideal gas: drop [Pa] by the forces", found.drop, expected,
                         expands * (density * SUPERFICIAL**2 + density * G * HEIGHT))

    def test_patches(self):
        """Gas by two patches, of which one blows harder; the pressure on both as OpenFOAM has it."""
        case, _ = make(self.column, "patches", velocities=(0.2, 0.65))
        mean = "\n".join(f"""{name} {{ type surfaceFieldValue; libs (fieldFunctionObjects); regionType patch;
name {name}; operation areaIntegrate; fields (p); writeFields no; writePrecision 14; }}""" for name in Box.lower)
        append(case, "system/controlDict", f"""functions {{ {mean}
{function('bedPressureDrop', 'one', 'inlets ("oth.*");')} }}""")
        case.solve()
        both, one = Found(case, (0, 0, 1)), table(case, "one", "bedPressureDrop")[-1, 1:]
        self.expect_near("patches: superficial velocity [m/s] of both", both.velocity, (0.2 + 2 * 0.65) / 3, 1e-9)
        self.expect_near("patches: superficial velocity [m/s] of one", one[1], 2 * 0.65 / 3, 1e-9)
        integrals = sum(table(case, name, "surfaceFieldValue") for name in Box.lower)[-STEPS // 2:, 1]
        # The pressure on a patch follows from the momentum that the cell beside it carries, which is that of the patch
        # only where all moves alike.
        self.expect_near("patches: drop [Pa] by the pressure on them", both.drop,
                         RHO * integrals.mean() / AREA - RHO * G * HEIGHT, RHO * 0.65**2)

    def test_horizontal(self):
        """Gravity across the axis, of a run of ten steps."""
        case, _ = make(self.column, "horizontal", axis=(1, 0, 0), entries="direction (1 0 0); writeInterval 10;")
        append(case, "constant/g", f"value (0 0 {-G});")
        append(case, COUPLING, 'lammpsCoeffs { variables { down "0 0 -1"; } }')
        append(case, "system/controlDict", f"endTime {10 * DT};")
        case.solve()
        row, = table(case, "drop", "bedPressureDrop")
        self.expect_true(f"horizontal: drop {row[3]} Pa, weight {row[4]} Pa, drop over weight {row[5]}",
                         row[3] > 0 and row[4] == 0 and np.isnan(row[5]))

    def test_refused(self):
        case, _ = make(self.column, "refused")
        control = (case.folder / "system/controlDict").read_text()
        for entries, message in (
                ("direction (0 0.1 1);",
                 "drop: the mesh is no column of one cross-section along direction (0 0.099503"),
                ('inlets ("b.*" floor);',
                 "drop: inlets: 'floor' is no patch of the mesh; it has (bottom other top sides")):
            append(case, "system/controlDict", f"functions {{ drop {{ {entries} }} }}")
            self.refused(entries, case, message)
            (case.folder / "system/controlDict").write_text(control)


if __name__ == "__main__":
    unittest.main()
