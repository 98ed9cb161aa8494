# SPDX-License-Identifier: BSD-3-Clause
"""A `change_box` between two runs that moves no particle changes nothing, whatever the phase of a contact: pairs, those
through a boundary, and spheres at walls."""
import math
import unittest

import numpy

from cohesion_tests import lammps as engine
from cohesion_tests.test_cases import ScriptTestCase

R, DENSITY, K, SPEED = 5e-4, 2650.0, 800.0, 0.1
MASS = DENSITY * 4 / 3 * math.pi * R**3
DT = math.pi * math.sqrt(MASS / 2 / K) / 10
LAWS = {"hamaker": "hamaker 5e-19 cutoff 4e-10 1e-7", "squarewell": "well 1e-11 1.002", "liquidbridge": "bridge 2e-5 5e-6"}
PHASES, HALF, STEPS = 40, 20, 60  # of each of three kinds of contact; in half of them the middle step meets a contact
BOX, ROW = (-0.01, 0.01), 2.5e-3
CHANGES = ("x delta 1e-6 1e-6", "y final -0.011 0.0105", "z delta -1e-4 1e-4", "boundary p p s", "triclinic",
           "triclinic ortho")


class BoxChanges(ScriptTestCase):
    """40 of each kind, which meet half a step apart: two spheres in the middle of the box, two through its boundary
    along x, and one at a plane along z. The shift along x takes the latter pairs' centres through the boundary."""

    def spheres(self):
        atoms = []
        for n in range(PHASES):
            y, z = BOX[0] + ROW * (0.5 + n % 8), ROW * (n // 8) - 0.006
            gap = SPEED * DT * (0.5 * n + 0.25)
            for x in (2 * BOX[1] - 3e-3, 0.0):  # the first nearest to each other through the boundary
                middle = x if x == 0.0 else BOX[1] + 2e-7
                for side in (-1, 1):
                    place = middle + side * (R + gap / 2)
                    place -= 2 * BOX[1] * math.floor((place - BOX[0]) / (2 * BOX[1]))
                    atoms.append({"type": 1, "diameter": 2 * R, "density": DENSITY, "x": (place, y, z),
                                  "v": (-side * SPEED / 2, 0.01 * SPEED, 0.0)})
            atoms.append({"type": 1, "diameter": 2 * R, "density": DENSITY,
                          "x": (-0.005 + 1.2e-3 * (n % 3), BOX[0] + 1.4e-3 * (n // 3), BOX[0] + R + gap),
                          "v": (0.0, 0.0, -SPEED)})
        return atoms

    def ends(self, law, scheme, changes, ranks=1):
        engine.write_spheres(self.folder, self.spheres(), 3 * [BOX], 1)
        words = f"stiffness {K} restitution 0.9 {LAWS[law]}"
        self.goes(f"""
plugin load ${{plugin}}
units si
atom_style sphere
boundary p p f
newton off
comm_modify vel yes
read_data data.spheres
neighbor 2e-4 bin
pair_style gran/{law} scheme {scheme}
pair_coeff * * {words}
fix floor all wall/gran/{law} {words} zplane {BOX[0]} NULL scheme {scheme}
fix move all nve/sphere
timestep {DT:.17g}
run {HALF}
{changes}
run {STEPS - HALF}
write_dump all custom ends.dump id vx vz modify format float %.17g
""", ranks=ranks)
        return engine.dump(self.folder, "ends.dump")[:, 1:]

    def test_nothing_changes(self):
        """To some roundings of places of 0.01 m, 2e-18 m, over a way of 1.7e-6 m in a step: 1e-12 of speeds, a hundred
        times more behind an edge or a dashpot."""
        for law in LAWS:
            for scheme in ("exact", "sampled"):
                plain = self.ends(law, scheme, "")
                self.assertGreater(numpy.abs(plain[:, 1]).max(), 0.5 * SPEED)
                for change in CHANGES if (law, scheme) == ("hamaker", "exact") else CHANGES[:2]:
                    changes = f"change_box all {change} units box"
                    if "triclinic" in change:
                        changes = "\n".join(f"change_box all {one}" for one in change.split())
                    with self.subTest(law, scheme=scheme, change=change):
                        numpy.testing.assert_allclose(self.ends(law, scheme, changes), plain, rtol=0, atol=1e-9 * SPEED)

    def test_on_two_processes(self):
        for change in CHANGES[:2]:
            changed = self.ends("hamaker", "exact", f"change_box all {change} units box", ranks=2)
            numpy.testing.assert_allclose(changed, self.ends("hamaker", "exact", ""), rtol=0, atol=1e-9 * SPEED)


if __name__ == "__main__":
    unittest.main()
