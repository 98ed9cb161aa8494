# SPDX-License-Identifier: BSD-3-Clause
"""Masses that change between two lists of neighbours: the exact scheme follows contacts with those of the step,
however seldom lists are made."""
import math
import unittest

import numpy

from cohesion_tests import lammps as engine
from cohesion_tests.test_cases import ScriptTestCase

R, DENSITY = 5e-4, 2500.0
MASS = 4 / 3 * math.pi * R**3 * DENSITY
DT = 1e-5
STIFFNESS = 0.5 * MASS * (math.pi / (20 * DT))**2  # a contact of two lasts 20 steps, with a heavier one more
SPEED = 0.005 * R / DT
STEPS = 300
BOX, BEGIN, APART = 0.02, 2e-3, 3.5 * R  # of the first sphere, and the second from it
WALL = BEGIN + 4.75 * R
LISTS = {"new in each step": ("neigh_modify every 1 delay 0 check no", "1e-3"),
         "made once": ("neigh_modify delay 1000000", "4e-3")}
CONTACT = f"stiffness {STIFFNESS:.17g} restitution 1"
PAIR = f"pair_style gran/hamaker\npair_coeff * * {CONTACT}\n"
MOVE = "fix move all nve/sphere\n"


def growing(steps):
    """To twice the diameter and eight times the mass within `steps`, as a fix of the first particle."""
    return (f"variable size equal {2 * R}*(1+(step<{steps})*step/{steps}+(step>={steps}))\n"
            "group first id 1\nfix grow first adapt 1 atom diameter v_size mass yes\n")


def integrated(substeps=50):
    """x and velocity at the end of a first sphere that grows all the time, and of a second that it presses to the wall:
    two springs, the diameter and the mass those of the middle of each step."""
    x, v, h = [BEGIN, BEGIN + APART], [SPEED, 0.0], DT / substeps
    for step in range(STEPS):
        size = 1 + (step + 0.5) / STEPS
        for half in range(2 * substeps):
            pair = STIFFNESS * max(0.0, size * R + R - (x[1] - x[0]))
            wall = STIFFNESS * max(0.0, x[1] + R - WALL)
            v = [v[0] - 0.5 * h * pair / (MASS * size**3), v[1] + 0.5 * h * (pair - wall) / MASS]
            if half % 2 == 0:
                x = [x[0] + h * v[0], x[1] + h * v[1]]
    return numpy.transpose([x, v])


class ChangingMass(ScriptTestCase):
    def course(self, commands, begin=BEGIN, boundary="f f f"):
        """The first sphere comes to the second; the third, far away, is as large as the first may become. Of each step
        x and its velocity; they do not depend on the lists."""
        spheres = [(R, begin, SPEED), (R, (begin + APART) % BOX, 0.0), (2 * R, 1.1e-2, 0.0)]
        engine.write_spheres(self.folder, [
            {"type": 1, "diameter": 2 * r, "density": DENSITY, "x": (x, 0.01, 0.01), "v": (v, 0.0, 0.0)}
            for r, x, v in spheres], 3 * [(0.0, BOX)], 1)
        courses = []
        for name, (lists, skin) in LISTS.items():
            output = self.goes(f"""
plugin load ${{plugin}}
units si
atom_style sphere 1
newton off
boundary {boundary}
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

    def leave_as_eight_masses_and_one(self, size, **scene):
        """After the growth and the contact; `size`: of the numbers that places are written in [m]."""
        for name, commands in (("pairs first", PAIR + growing(50)), ("growth first", growing(50) + PAIR)):
            with self.subTest(name):
                course = self.course(commands + MOVE, **scene)
                # In some 40 steps of contact both places are rounded; the spring makes pi/(20 DT) times that a
                # speed, in the lighter one.
                room = 40 * 2 * 2**-53 * size * math.pi / (20 * DT)
                self.assertLess(room, 1e-9 * SPEED)
                self.assertLess(abs(course[-1, :, 1] - SPEED * numpy.array([7 / 9, 16 / 9])).max(), room)
        return course

    def test_one_that_has_grown_meets_another(self):
        self.leave_as_eight_masses_and_one(5e-3)

    def test_one_that_has_grown_meets_another_beyond_a_periodic_face(self):
        """Each meets a ghost of the other, whose mass has to be that of the step, too."""
        course = self.leave_as_eight_masses_and_one(BOX, begin=BOX - 2 * R, boundary="p f f")
        # Neither centre passes the face, so that all contact is beyond it.
        self.assertTrue((course[:, 0, 0] > BOX / 2).all() and (course[:, 0, 0] < BOX).all())
        self.assertTrue((course[:, 1, 0] > 0).all() and (course[:, 1, 0] < BOX / 2).all())

    def test_one_that_grows_while_it_touches_another_and_a_wall(self):
        """Against an integration of the motion. Growth is known to a step, R/STEPS of the radius: as far may places be
        off, and speeds by the spring's pi/(20 DT) times that, a tenth of SPEED. And each contact knows the other by its
        force of the step before: second order, (pi/20)^2/12 of the way of a contact."""
        wall = f"fix w all wall/gran/hamaker {CONTACT} xplane NULL {WALL}\n"
        expected = integrated()
        for name, commands in (("pairs first", PAIR + wall + growing(STEPS)),
                               ("growth first", growing(STEPS) + PAIR + wall)):
            with self.subTest(name):
                off = abs(self.course(commands + MOVE)[-1] - expected).max(axis=0)
                late = (math.pi / 20)**2 / 12 * SPEED * 20 * DT
                self.assertLess(off[0], R / STEPS + late)
                self.assertLess(off[1], R / STEPS * math.pi / (20 * DT))


if __name__ == "__main__":
    unittest.main()
