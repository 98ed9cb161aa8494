# SPDX-License-Identifier: BSD-3-Clause
"""Capture and escape with scheme exact in LAMMPS: pairs, planes and cylinders, every law, head-on to 80 degrees, at any
step and any phase of it, against an integration that knows nothing of the package. The same for LIGGGHTS:
tests/liggghts-styles/escape_test.py."""
import math
import unittest
from pathlib import Path

from cohesion_tests import escape_table, lammps as engine
from cohesion_tests.escape_table import CYLINDER_WALL, LAWS, PAIR, PLANE, Table
from cohesion_tests.theory import liquid_bridge
from cohesion_tests.theory.pair_motion import ALPHA, CONTACT_TIME, MU, Pair

BOX = [(-0.025, 0.12), (-0.025, 0.12), (0.0, 0.12)]
WALLS = {"plane": "zplane 0 NULL", "cylinder": f"zcylinder {escape_table.CYLINDER}"}


def contacts(table):
    """Lines of the pair style, and of a wall for each strength that acts on the spheres beside it."""
    law, style = table.law, f"gran/{table.law.NAME}"
    yield f"pair_style {style}"
    for kind, strength in enumerate(law.STRENGTHS, 1):
        yield f"pair_coeff {kind} {kind} {law.lammps(strength, False)}"
    for body in table.bodies[:-1]:
        numbers = [n for encounter, atoms in table.numbers() if encounter.body == body for n in atoms]
        yield f"group {body.name} id {numbers[0] + 1}:{numbers[-1] + 1}"
        for kind, strength in enumerate(law.STRENGTHS, 1):
            group = f"{body.name}{kind}"
            yield f"group strength{group} type {kind}"
            yield f"group {group} intersect {body.name} strength{group}"
            yield f"fix {group} {group} wall/{style} {law.lammps(strength, True)} {WALLS[body.kind]}"


class Escape(unittest.TestCase):
    def test_every_law_body_step_and_angle(self):
        for law in LAWS:
            for division in law.DIVISIONS:
                table = Table(law, (PLANE, CYLINDER_WALL, PAIR), division)
                with self.subTest(law=law.NAME, division=division), engine.temporary_folder() as folder:
                    engine.write_spheres(folder, table.atoms(), BOX, len(law.STRENGTHS))
                    (Path(folder) / "contacts.txt").write_text("\n".join(contacts(table)) + "\n")
                    engine.run("in.escape", folder, dt=table.dt, steps=table.steps, every=table.every)
                    path = [snapshot[:, 1:] for snapshot in engine.dumps(folder, "path.txt")]
                    wrong = list(table.wrong(path))
                    self.assertFalse(wrong, "\n".join(wrong))


    def test_reference_head_on(self):
        """Where there are other ways to know it; all to 1e-9 by their own tolerances."""
        e = math.exp(-ALPHA * CONTACT_TIME)
        hamaker, well, bridge = LAWS[:3]
        for law, known in ((hamaker, lambda A: Pair(A).escape_velocity()),
                           (well, lambda well: math.sqrt(2 * well[0] / MU * (1 / e**2 - 1))),
                           (bridge, lambda bridge: liquid_bridge.escape_velocity(*bridge))):
            for strength in law.STRENGTHS:
                found = escape_table.escape_velocity(law, strength, 0)
                self.assertAlmostEqual(found / known(strength), 1, delta=1e-8, msg=law.NAME)


if __name__ == "__main__":
    unittest.main()
