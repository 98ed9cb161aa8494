# SPDX-License-Identifier: BSD-3-Clause
"""Triangles and STL files of the mesh walls that tests use."""


def rectangle(corner, one, other, cells=1):
    """2 cells^2 triangles between corner, corner + one and corner + other."""
    def node(a, b):
        return tuple(c + a * p / cells + b * q / cells for c, p, q in zip(corner, one, other))

    triangles = []
    for i in range(cells):
        for j in range(cells):
            low, high = node(i, j), node(i + 1, j + 1)
            triangles += [(low, node(i + 1, j), high), (low, high, node(i, j + 1))]
    return triangles


def stl(triangles):
    text = "solid wall\n"
    for triangle in triangles:
        text += "facet normal 0 0 0\nouter loop\n"
        text += "".join("vertex {!r} {!r} {!r}\n".format(*map(float, node)) for node in triangle)
        text += "endloop\nendfacet\n"
    return text + "endsolid wall\n"


def wall(models, name="plate"):
    """Lines that make a wall of the mesh in NAME.stl; for scene.script."""
    return [f"fix {name} all mesh/surface file {name}.stl type 2",
            f"fix {name}wall all wall/gran {models} mesh n_meshes 1 meshes {name}"]
