# SPDX-License-Identifier: BSD-3-Clause
"""Regions that are walls in tests, and the head of their scripts."""
import math

HALF = math.sqrt(0.5)
# Of each: the words of the region, a point of a face, and the normal there, towards the particles. Sizes [m]; the faces
# are 20 radii of the spheres (0.5 mm) and more away from each other.
SLOPE = math.hypot(0.06, 0.02)  # of the cones: from radius 0.02 to 0.04 over 0.06
SHAPES = {
    "block in": ("block -0.04 0.04 -0.04 0.04 -0.04 0.04", (0.01, -0.04, 0.01), (0, 1, 0)),
    "block out": ("block -0.02 0.02 -0.02 0.02 -0.02 0.02 side out", (0.01, 0.01, 0.02), (0, 0, 1)),
    "edge": ("block -0.02 0.02 -0.02 0.02 -0.02 0.02 side out", (0.02, 0.01, -0.02), (HALF, 0, -HALF)),
    "corner": ("block -0.02 0.02 -0.02 0.02 -0.02 0.02 side out", (0.02, 0.02, 0.02), 3 * (1 / math.sqrt(3),)),
    "barrel in": ("cylinder x 0.001 0 0.03 -0.04 0.04", (0.01, 0.001 + 0.018, 0.024), (0, -0.6, -0.8)),
    "end in": ("cylinder x 0.001 0 0.03 -0.04 0.04", (0.04, 0.01, 0.01), (-1, 0, 0)),
    "barrel out": ("cylinder y 0 0 0.02 -0.03 0.03 side out", (0.012, 0.01, 0.016), (0.6, 0, 0.8)),
    "rim": ("cylinder y 0 0 0.02 -0.03 0.03 side out", (0.012, 0.03, 0.016), (0.6 * HALF, HALF, 0.8 * HALF)),
    "open in": ("cylinder y 0 0 0.03 -0.03 0.03 open 1 open 2", (0.018, 0.01, 0.024), (-0.6, 0, -0.8)),
    "open out": ("cylinder y 0 0 0.03 -0.03 0.03 open 1 open 2", (0.018, 0.01, 0.024), (0.6, 0, 0.8)),
    "cone in": ("cone z 0 0 0.02 0.04 -0.03 0.03", (0.018, 0.024, 0.0),
                (-0.6 * 0.06 / SLOPE, -0.8 * 0.06 / SLOPE, 0.02 / SLOPE)),
    "cone out": ("cone x 0 0 0.02 0.04 -0.03 0.03 side out", (0.0, 0.018, 0.024),
                 (-0.02 / SLOPE, 0.6 * 0.06 / SLOPE, 0.8 * 0.06 / SLOPE)),
    "cone end out": ("cone z 0 0 0.02 0.04 -0.03 0.03 side out", (0.0, 0.0, 0.03), (0, 0, 1)),
    "sphere in": ("sphere 0 0 0 0.03", (0.018, 0, 0.024), (-0.6, 0, -0.8)),
    "sphere out": ("sphere 0 0 0 0.03 side out", (0.018, 0, 0.024), (0.6, 0, 0.8)),
    "plane": ("plane 0 0 0 1 2 2", (0.02, -0.01, 0), (1 / 3, 2 / 3, 2 / 3)),
    "prism": ("prism -0.04 0.04 -0.04 0.04 -0.04 0.04 0.08 0 0", (0.0, 0.0, 0.01), (HALF, -HALF, 0)),
}
HEAD = """
plugin load ${{plugin}}
units si
atom_style sphere
boundary f f f
newton off
comm_modify vel yes
{begin}
neighbor 3e-4 bin
{more}
"""


def regions():
    return "".join(f"region shape{k} {words} units box\n" for k, (words, _, _) in enumerate(SHAPES.values(), 1))
