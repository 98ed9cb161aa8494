# SPDX-License-Identifier: BSD-3-Clause
"""The wall of a round column as a mesh of triangles, for LIGGGHTS."""

import math
from pathlib import Path

SIDES = 72  # a bead sees planes that lean by 5 degrees


def corners(radius, sides=SIDES):
    """Of a polygon whose sides enclose the area of the circle (src/powder/plan.h, corners_of_equal_area)."""
    angle = 2 * math.pi / sides
    reach = radius * math.sqrt(angle / math.sin(angle))
    return [(reach * math.cos(k * angle), reach * math.sin(k * angle)) for k in range(sides)]


def write_stl(file, radius, top, sides=SIDES):
    """Triangles from z = 0 to `top` [m] about the z axis; ASCII."""
    polygon = corners(radius, sides)
    lines = ["solid column"]
    for (x0, y0), (x1, y1) in zip(polygon, polygon[1:] + polygon[:1]):
        middle = -(x0 + x1) / 2, -(y0 + y1) / 2
        size = math.hypot(*middle)
        for triangle in (((x0, y0, 0), (x1, y1, 0), (x1, y1, top)), ((x0, y0, 0), (x1, y1, top), (x0, y0, top))):
            lines.append(f"facet normal {middle[0] / size:.9g} {middle[1] / size:.9g} 0\n outer loop")
            lines += [f"  vertex {x:.9g} {y:.9g} {z:.9g}" for x, y, z in triangle]
            lines.append(" endloop\nendfacet")
    Path(file).write_text("\n".join([*lines, "endsolid column", ""]))


def as_mesh(script):
    """The script of cohesion-powder with a mesh, column.stl, in place of the cylinder."""
    cylinder = '"fix sides all wall/gran ${model} primitive type ${wall} zcylinder ${radius} 0 0 ${keywords}" &\n'
    mesh = ('"fix column all mesh/surface file column.stl type ${wall}" &\n'
            '  "fix sides all wall/gran ${model} mesh n_meshes 1 meshes column ${keywords}" &\n')
    if cylinder not in script:
        raise ValueError("the script has no cylinder where one is expected")
    return script.replace(cylinder, mesh)
