# SPDX-License-Identifier: BSD-3-Clause
"""Capture and escape with scheme exact in LIGGGHTS: pairs, planes, cylinders and meshes of 1, 2 and 200 triangles,
every law, head-on to 80 degrees, at any step and any phase of it, against an integration that knows nothing of the
package. The same for LAMMPS: tests/lammps-package/escape_test.py."""
import unittest

from cohesion_tests import escape_table, lammps as engine
from cohesion_tests.escape_table import CYLINDER_WALL, LAWS, PAIR, PLANE, Body, Table
from cohesion_tests.liggghts import Run
from cohesion_tests.liggghts_scenes.mesh import rectangle, stl

BOX = [(-0.025, 0.12), (-0.025, 0.12), (-1e-3, 0.12)]
# Of x and y where spheres are beside planes; one triangle is twice as large.
CORNER, EDGE = (0.025, 0.0), 0.09
MESHES = {Body("triangle"): 1, Body("square"): 2, Body("squares"): 200}
BODIES = (PLANE, *MESHES, PAIR, CYLINDER_WALL)


def property_lines(values, kinds):
    """Of the engine's global properties. A matrix has rows of pairs of a kind with itself and of each kind beside the
    wall, which is the last kind; pairs of unlike kinds do not meet."""
    for name, shape, given in values:
        if shape == "scalar":
            numbers = [given]
        elif shape == "peratomtype":
            numbers = [*given, given[-1]]
        else:
            pairs, walls = given
            numbers = [walls[min(i, j)] if max(i, j) == kinds and min(i, j) < kinds else pairs[min(i, j, kinds - 1)]
                       for i in range(kinds + 1) for j in range(kinds + 1)]
        size = f"{kinds + 1} " if shape == "peratomtypepair" else ""
        yield f"fix {name} all property/global {name} {shape} {size}{' '.join(f'{x:.17g}' for x in numbers)}"


def mesh(body, table):
    """Triangles of a plane."""
    corner, count = (*CORNER, table.height(body)), MESHES[body]
    if count == 1:
        return [(corner, (corner[0] + 2 * EDGE, *corner[1:]), (corner[0], corner[1] + 2 * EDGE, corner[2]))]
    return rectangle(corner, (EDGE, 0, 0), (0, EDGE, 0), 1 if count == 2 else 10)


def script(table, number):
    """Of a run whose files end in the number."""
    law, kinds = table.law, len(table.law.STRENGTHS)
    models = f"model {law.MODEL} tangential off cohesion {law.NAME}"
    settings = "absolute_damping on tangential_damping off scheme exact" + law.SETTINGS
    wall = f"all wall/gran {models} "
    meshes = [body.name for body in MESHES]
    return "\n".join([
        "units si", "atom_style granular", "atom_modify map array", "boundary f f f", "newton off",
        "communicate single vel yes", f"read_data spheres{number}.data", "neighbor 2e-4 bin", "neigh_modify delay 0",
        *property_lines(law.liggghts(), kinds),
        f"pair_style gran {models} {settings}", "pair_coeff * *",
        f"fix plane {wall} primitive type {kinds + 1} zplane 0 {settings}",
        f"fix cylinder {wall} primitive type {kinds + 1} zcylinder {escape_table.CYLINDER} 0 0 {settings}",
        *(f"fix {name} all mesh/surface file {name}.stl type {kinds + 1}" for name in meshes),
        f"fix meshes {wall} mesh n_meshes {len(meshes)} meshes {' '.join(meshes)} {settings}",
        "fix move all nve/sphere", f"timestep {table.dt:.17g}", f"thermo {table.steps}",
        f"dump path all custom {table.every} path{number}.txt id x y z",
        'dump_modify path format "%d %.17g %.17g %.17g" sort id', f"run {table.steps}", "clear", ""])


class Escape(unittest.TestCase):
    def test_every_law_body_step_and_angle(self):
        # One engine runs all: its start takes longer than most runs.
        tables = [Table(law, BODIES, division) for law in LAWS for division in law.DIVISIONS]
        inputs = {f"{body.name}.stl": stl(mesh(body, tables[0])) for body in MESHES}
        with engine.temporary_folder() as folder:
            for number, table in enumerate(tables):
                engine.write_spheres(folder, table.atoms(), BOX, len(table.law.STRENGTHS) + 1, f"spheres{number}.data")
                inputs[f"spheres{number}.data"] = open(f"{folder}/spheres{number}.data").read()
        run = Run("".join(script(table, number) for number, table in enumerate(tables)), inputs=inputs)
        for number, table in enumerate(tables):
            with self.subTest(law=table.law.NAME, division=table.division):
                path = [[frame[n] for n in sorted(frame)] for frame in run.frames(f"path{number}.txt")]
                wrong = list(table.wrong(path))
                self.assertFalse(wrong, "\n".join(wrong))


if __name__ == "__main__":
    unittest.main()
