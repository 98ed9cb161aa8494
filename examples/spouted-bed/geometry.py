# SPDX-License-Identifier: BSD-3-Clause
"""The vessel, a cone with a cylinder on it, its axis along y: writes case/constant/vessel, with the corners of the
blocks of blockMesh.

    geometry.py
"""

from math import cos, pi, radians, sin, sqrt, tan
from pathlib import Path

from cohesion_studies import program

FILE = Path(__file__).resolve().parent / "case/constant/vessel"

INLET = 0.02  # radius of the gas inlet [m]
BASE = 0.03  # radius of the plate around it, where the cone begins [m]
ANGLE = 45  # between opposite sides of the cone [degrees]
SHOULDER = 0.16  # height of the cone [m]
CORE = 0.032  # radius of the blocks above the inlet where the cone ends [m]
HEIGHT = 0.4  # of all [m]

SIDES = 16  # of the polygon that the mesh makes of a circle
INNER = 0.65  # radius of the square block in the middle over that of the core
LAYER, UPPER_LAYER = 0.01, 0.024  # height of cells in the cone and above it [m]
# Corners are this much outside the circle whose area the polygon has.
CORNER = sqrt(2 * pi / (SIDES * sin(2 * pi / SIDES)))


def wall(height):
    """Radius of the wall [m]."""
    return BASE + min(height, SHOULDER) * tan(radians(ANGLE / 2))


def point(height, radius, angle):
    """Of a polygon's corner, as blockMesh reads it; angles [degrees] run from z to x."""
    # Without the round-off of zeros
    x, z = (CORNER * radius * round(part(radians(angle)), 12) + 0.0 for part in (sin, cos))
    return f"({x:.10g} {height:g} {z:.10g})"


def levels():
    """Heights, with the radii of inner block, core and wall."""
    return [(height, INNER * core, core, outer)
            for height, core, outer in ((0, INLET, BASE), (SHOULDER, CORE, wall(SHOULDER)),
                                        (HEIGHT, CORE, wall(HEIGHT)))]


def text():
    """Of the dictionary."""
    vertices, arcs = [], []
    for height, *radii in levels():
        for radius in radii:
            first = 4 * len(vertices)
            vertices.append([point(height, radius, angle) for angle in (45, 135, 225, 315)])
            if radius != radii[0]:
                arcs += [f"    arc {first + k} {first + (k + 1) % 4} {point(height, radius, 90 * (k + 1))}"
                         for k in range(4)]
    rows = [f"    {' '.join(row)}  // {4 * i} to {4 * i + 3}" for i, row in enumerate(vertices)]
    entries = {"inletDiameter": 2 * INLET, "baseDiameter": 2 * BASE, "coneAngle": ANGLE,
               "slope": tan(radians(ANGLE / 2)), "shoulder": SHOULDER, "height": HEIGHT,
               "wallRadius": CORNER * wall(HEIGHT),
               "coneLayers": round(SHOULDER / LAYER), "upperLayers": round((HEIGHT - SHOULDER) / UPPER_LAYER),
               "quarter": SIDES // 4}
    return "\n".join([
        "// The vessel, written by geometry.py: lengths in m; angle between opposite sides of the cone in degrees,",
        "// tangent of half of it; layers of cells, cells on a quarter of a circle.",
        f"// Polygons of {SIDES} sides have the area of the circles, and their corners {CORNER - 1:.1%} outside.",
        *(f"{name:15} {value:.10g};" for name, value in entries.items()),
        "// Of the block in the middle, of those around it above the inlet, of the wall; from plate to top.",
        "vertices", "(", *rows, ");", "edges", "(", *arcs, ");", ""])


if __name__ == "__main__":
    program.words(__doc__, 0)
    FILE.write_text(text())
    print(FILE)
