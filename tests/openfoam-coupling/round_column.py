# SPDX-License-Identifier: BSD-3-Clause
"""A round column whose wall is a mesh in LIGGGHTS, read from an STL file, on 1 and 2 ranks: spheres that are
inserted and thrown at it stay inside, the wall attracts those that come near, their momentum is that of wall, gas
and weight, and gas and spheres balance."""

import math
import shutil
import unittest

import numpy as np

from cohesion_tests import dumps
from cohesion_tests.coupling.cases import COUPLING, append, exchange_lines
from cohesion_tests.coupling.test_case import CoupledTestCase
from cohesion_tests.liggghts_scenes.mesh import stl

RADIUS, HEIGHT, SIDES = 0.03, 0.2, 24  # of the column [m]
SPHERE, SPHERES, G = 1.5e-3, 100, 9.81
STEP, DT, END = 1e-5, 2e-4, 0.012  # of particles and gas [s]
HAMAKER = 1e-11  # [J]: nine times the weight at contact


def circle(radius, angle):
    return RADIUS + radius * math.cos(angle), RADIUS + radius * math.sin(angle)


def wall():
    """The sides of the gas's mesh, a prism, as triangles."""
    corners = [circle(RADIUS, 2 * math.pi * k / SIDES) for k in range(SIDES)]
    triangles = []
    for a, b in zip(corners, corners[1:] + corners[:1]):
        low, high = [(*corner, 0) for corner in (a, b)], [(*corner, HEIGHT) for corner in (a, b)]
        triangles += [(low[0], low[1], high[1]), (low[0], high[1], high[0])]
    return triangles


def o_grid(case):
    """A square block in the middle, and four between that and the circle: its corners are at 45 degrees, and the
    faces on a quarter of it SIDES/4."""
    inner, outer = 0.45 * RADIUS, RADIUS
    quarters = [math.pi / 4 + k * math.pi / 2 for k in range(4)]
    vertices = [(*circle(radius, angle), z)
                for z in (0, HEIGHT) for radius in (inner, outer) for angle in quarters]
    cells = SIDES // 4
    blocks = [f"hex (2 3 0 1 10 11 8 9) ({cells} {cells} 10) simpleGrading (1 1 1)"]
    arcs, sides, bottom, top = [], [], ["(0 3 2 1)"], ["(8 9 10 11)"]
    for k in range(4):
        n = (k + 1) % 4
        blocks.append(f"hex ({k} {4 + k} {4 + n} {n} {8 + k} {12 + k} {12 + n} {8 + n}) (2 {cells} 10) "
                      "simpleGrading (1 1 1)")
        x, y = circle(RADIUS, (k + 1) * math.pi / 2)
        arcs += [f"arc {4 + k} {4 + n} ({x} {y} 0)", f"arc {12 + k} {12 + n} ({x} {y} {HEIGHT})"]
        sides.append(f"({4 + k} {4 + n} {12 + n} {12 + k})")
        bottom.append(f"({k} {n} {4 + n} {4 + k})")
        top.append(f"({8 + k} {12 + k} {12 + n} {8 + n})")
    dictionary = case.folder / "system/blockMeshDict"
    dictionary.write_text(dictionary.read_text().split("// A column")[0] + f"""
vertices ({' '.join(f'({x!r} {y!r} {z!r})' for x, y, z in vertices)});
blocks ({' '.join(blocks)});
edges ({' '.join(arcs)});
boundary
(
    bottom {{ type patch; faces ({' '.join(bottom)}); }}
    top {{ type patch; faces ({' '.join(top)}); }}
    sides {{ type wall; faces ({' '.join(sides)}); }}
);
""")
    case.run("blockMesh")


def run(column, name, ranks=1, hamaker=HAMAKER):
    case = column(name, "liggghts")
    (case.folder / "wall.stl").write_text(stl(wall()))
    append(case, COUPLING, f"""voidFraction dividedVolume;
liggghtsCoeffs {{ script "round.liggghts"; variables {{ A {hamaker}; dt {STEP}; }} }}""")
    append(case, "system/controlDict", f"deltaT {DT}; endTime {END}; writeInterval {END}; writePrecision 17;")
    append(case, "system/decomposeParDict", "coeffs { n (2 1 1); }")
    o_grid(case)
    shutil.copytree(case.folder / "0.orig", case.folder / "0", dirs_exist_ok=True)
    lines = exchange_lines(case.solve(ranks=ranks))
    if ranks > 1:
        case.run("reconstructPar", "-latestTime")
    # Per step: force on the wall's spheres [N], their momentum [kg m/s] and mass [kg]
    return case, lines, np.loadtxt(case.folder / "trace.dat")


def farthest(places):
    """Of the places, the largest distance from the axis across a side of the prism, less that of the side [m]."""
    middles = [(k + 0.5) * 2 * math.pi / SIDES for k in range(SIDES)]
    across = np.array([[math.cos(a), math.sin(a)] for a in middles])
    return ((places[:, :2] - RADIUS) @ across.T).max() - RADIUS * math.cos(math.pi / SIDES)


class RoundColumn(CoupledTestCase):
    def check(self, ranks):
        case, lines, trace = run(self.column, f"{ranks}", ranks)
        self.expect_equal(f"{ranks} ranks: gas steps", len(lines), round(END / DT))
        self.expect_balance(f"{ranks} ranks", lines)

        places = np.concatenate([snapshot.table for snapshot in dumps.read(case.folder / "places.dump")])
        self.expect_equal(f"{ranks} ranks: spheres in frames", len(places), SPHERES * (round(END / STEP) // 100))
        # One alone is pressed in by v sqrt(m/k), 0.06 mm at 0.5 m/s or 0.04 radii; with all the energy of four others
        # behind it by sqrt(5) times that.
        self.expect_below(f"{ranks} ranks: farthest sphere beyond its touching the wall / radius",
                          1 + farthest(places) / SPHERE, 0.1)

        # The engine's steps take forces at both ends with half their weight, but that of the gas at the end as a whole.
        on_wall, momentum, mass = trace[:, 1:4], trace[:, 4:7], trace[0, 7]
        sphere = 2000 * 4 / 3 * math.pi * SPHERE**3
        self.expect_near(f"{ranks} ranks: mass [kg]", mass, SPHERES * sphere, 5e-6 * mass)
        wall_impulse = ((on_wall[1:] + on_wall[:-1]) / 2).sum(axis=0) * STEP
        from_gas = np.array([np.add(x["drag"], x["pressure"]) for x in lines])
        weight = np.array([0, 0, -mass * G])
        left = momentum[-1] - momentum[0] - wall_impulse - (from_gas.sum(axis=0) + weight * len(lines)) * DT
        # The engine prints six digits.
        rounding = 5e-6 * (np.abs(on_wall).sum() * STEP + 2 * np.abs(momentum).max() + mass * G * END)
        self.expect_below(f"{ranks} ranks: momentum that neither wall, gas nor weight gave [kg m/s]",
                          np.abs(left).max(),
                          STEP * np.abs(from_gas).max() + rounding)
        self.expect_true(f"{ranks} ranks: the wall turns spheres back", wall_impulse[0] < -0.1 * mass * 0.5)
        return on_wall

    def test_cohesive(self):
        # They fly to larger x, and the wall there pushes to smaller x.
        for ranks in (1, 2):
            on_wall = self.check(ranks)
            self.expect_true(f"{ranks} ranks: the wall attracts", on_wall[:, 0].max() > 0)

    def test_without_cohesion_the_wall_does_not_attract(self):
        _, _, trace = run(self.column, "smooth", hamaker=0)
        self.expect_true("without cohesion it does not", trace[:, 1].max() <= 0)


if __name__ == "__main__":
    unittest.main()
