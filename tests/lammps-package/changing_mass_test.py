# SPDX-License-Identifier: BSD-3-Clause
"""Masses that change between two lists of neighbours: the event scheme follows contacts with those of the step,
however seldom lists are made."""
import math
import unittest

import numpy

import lammps_engine as engine
from script_test_case import ScriptTestCase

R, DENSITY = 5e-4, 2500.0
MASS = 4 / 3 * math.pi * R**3 * DENSITY
DT = 1e-5
STIFFNESS = 0.5 * MASS * (math.pi / (20 * DT))**2  # a contact of two lasts 20 steps, with a heavier one more
SPEED = 0.005 * R / DT
STEPS = 300
LISTS = {"new in each step": ("neigh_modify every 1 delay 0 check no", "1e-3"),
         "made once": ("neigh_modify delay 1000000", "4e-3")}
CONTACT = f"stiffness {STIFFNESS:.17g} restitution 1"
PAIR = f"pair_style gran/hamaker\npair_coeff * * {CONTACT}\n"
MOVE = "fix move all nve/sphere\n"


def growing(steps):
    """To twice the diameter and eight times the mass within `steps`, as a fix of the first particle."""
    return (f"variable size equal {2 * R}*(1+(step<{steps})*step/{steps}+(step>={steps}))\n"
            "group first id 1\nfix grow first adapt 1 atom diameter v_size mass yes\n")


class ChangingMass(ScriptTestCase):
    def course(self, commands):
        """The first sphere comes to the second, behind which is a wall; the third, far away, is as large as
        the first may become. Of each step x and its velocity; they do not depend on the lists."""
        spheres = [(R, 2e-3, SPEED), (R, 2e-3 + 3.5 * R, 0.0), (2 * R, 1.5e-2, 0.0)]
        engine.write_spheres(self.folder, [
            {"type": 1, "diameter": 2 * r, "density": DENSITY, "x": (x, 0.01, 0.01), "v": (v, 0.0, 0.0)}
            for r, x, v in spheres], 3 * [(0.0, 0.02)], 1)
        courses = []
        for name, (lists, skin) in LISTS.items():
            output = self.goes(f"""
plugin load ${{plugin}}
units si
atom_style sphere 1
newton off
boundary f f f
comm_modify vel yes
read_data data.spheres
neighbor {skin} bin
{lists}
{commands}
timestep {DT!r}
dump out all custom 1 out.txt id x vx
dump_modify out format float %.17g
thermo {STEPS}
run {STEPS}
""")
            built = [line.split()[-1] for line in output.splitlines() if "Neighbor list builds" in line]
            self.assertEqual(int(built[0]), STEPS if "check no" in lists else 0)
            courses.append(numpy.array(engine.dumps(self.folder, "out.txt")))
        numpy.testing.assert_array_equal(*courses)
        return courses[0][:, :2, 1:]

    def test_one_that_has_grown_meets_another(self):
        """Both leave as spheres of eight masses and of one do."""
        for name, commands in (("pairs first", PAIR + growing(50)), ("growth first", growing(50) + PAIR)):
            with self.subTest(name):
                end = self.course(commands + MOVE)[-1, :, 1]
                # In some 40 steps of contact both places, of 5e-3 m, are rounded; the spring makes pi/(20 DT)
                # times that a speed, in the lighter one.
                room = 40 * 2 * 2**-53 * 5e-3 * math.pi / (20 * DT)
                self.assertLess(room, 1e-9 * SPEED)
                self.assertLess(abs(end - SPEED * numpy.array([7 / 9, 16 / 9])).max(), room)

    def test_one_that_grows_while_it_touches_another_and_a_wall(self):
        wall = f"fix w all wall/gran/hamaker {CONTACT} xplane NULL {2e-3 + 4.75 * R}\n"
        for name, commands in (("pairs first", PAIR + wall + growing(STEPS)),
                               ("growth first", growing(STEPS) + PAIR + wall)):
            with self.subTest(name):
                end = self.course(commands + MOVE)[-1, :, 1]
                self.assertLess(end[0], 0.9 * SPEED)


if __name__ == "__main__":
    unittest.main()
