# SPDX-License-Identifier: BSD-3-Clause
"""Adhesion in a mixture of sizes of one type under gran/hamaker: each pair has the reduced radius of its own two
spheres, each sphere at a wall its own radius, smooth and rough. The force is read from what it presses a spring: a
pair that nothing else moves comes to rest at the overlap F_ad/K."""
import math
import unittest

import numpy

from cohesion_tests import lammps as engine
from cohesion_tests.test_cases import FolderTestCase
from cohesion_tests.theory import hamaker_reference as law

SMALL, LARGE = 0.15e-3, 0.6e-3  # radii
DENSITY, STIFFNESS, RESTITUTION = 2650.0, 800.0, 0.5
SIZE = 0.01
COUPLES = ((SMALL, SMALL), (SMALL, LARGE), (LARGE, LARGE))
CONTACT = f"stiffness {STIFFNESS} restitution {RESTITUTION} "
HEAD = """
plugin load ${plugin}
units si
atom_style sphere
boundary p p f
newton off
comm_modify vel yes
"""
TAIL = """
neighbor 1e-4 bin
fix plate all wall/gran/hamaker %(words)s zplane 0 NULL scheme %(scheme)s form %(form)s
fix move all nve/sphere
timestep %(dt).17g
run %(steps)d
write_restart at_rest.restart noinit
dump end all custom 1 end.txt id x y z
dump_modify end format float %%.17g sort id
run 0
"""


def spheres():
    """Couples that touch, along y, then one of each size that touches the wall."""
    atoms = []
    for column, radii in enumerate(COUPLES):
        first = numpy.array([2e-3 + 3e-3 * column, 2e-3, 0.5 * SIZE])
        for radius, x in zip(radii, (first, first + [0.0, sum(radii), 0.0])):
            atoms.append({"type": 1, "diameter": 2 * radius, "density": DENSITY, "x": x})
    for column, radius in enumerate((SMALL, LARGE)):
        atoms.append({"type": 1, "diameter": 2 * radius, "density": DENSITY,
                      "x": numpy.array([2e-3 + 3e-3 * column, 8e-3, radius])})
    return atoms


# Of a sphere with a wall.
T_C = {radius: math.pi * math.sqrt(4 / 3 * math.pi * DENSITY * radius**3 / STIFFNESS) for radius in (SMALL, LARGE)}
DT = T_C[SMALL] / math.sqrt(2) / 16  # a sixteenth of the shortest, of two small ones


class Smooth(FolderTestCase):
    FORM = "small_gap"
    LAW = (7.49e-19, 4e-10, 1e-7)

    def overlaps(self):
        end = engine.dump(self.folder, "end.txt")[:, 1:4]
        pairs = [sum(radii) - numpy.linalg.norm(end[2 * k + 1] - end[2 * k]) for k, radii in enumerate(COUPLES)]
        return pairs + [SMALL - end[-2, 2], LARGE - end[-1, 2]]

    def check(self):
        partners = [*COUPLES, (SMALL, math.inf), (LARGE, math.inf)]
        for radii, overlap in zip(partners, self.overlaps()):
            force = law.force(self.FORM, 0.0, *radii, *self.LAW)
            # What is left of the first overlap after 40 contact times, 0.5^40; the rounding of places; and that motion
            # ends where its way in a step, K x/eta dt of a distance x from the balance, is lost in it: eta/K is
            # 2 ln(1/e) t_c/pi^2, for so weak a damping.
            rounding = (8 + 2 * math.log(1 / RESTITUTION) / math.pi**2 * T_C[LARGE] / DT) * 2.0**-53 * SIZE
            tolerance = RESTITUTION**40 + rounding * STIFFNESS / force
            self.assertLess(tolerance, 1e-6)
            self.assertLessEqual(abs(STIFFNESS * overlap / force - 1), tolerance, radii)

    def rests(self, scheme, start):
        numbers = {"words": CONTACT + law.words(*self.LAW), "scheme": scheme, "form": self.FORM, "dt": DT,
                   "steps": math.ceil(40 * T_C[LARGE] / DT)}
        code, output = engine.run_text(HEAD + start % numbers + TAIL % numbers, self.folder)
        self.assertEqual(code, 0, output)

    def test_each_pair_and_each_sphere_at_the_wall_has_its_own_force(self):
        engine.write_spheres(self.folder, spheres(), 3 * [(0.0, SIZE)], 1)
        start = ("read_data data.spheres\npair_style gran/hamaker scheme %(scheme)s form %(form)s\n"
                 "pair_coeff * * %(words)s\n")
        for scheme in ("exact", "sampled"):
            with self.subTest(scheme):
                self.rests(scheme, start)
                self.check()
                # The restart file alone knows the pairs.
                self.rests(scheme, "read_restart at_rest.restart\n")
                self.check()


class Rough(Smooth):
    LAW = (7.49e-19, 4e-10, 1e-7, (2e-9, 5e-7))


class RoughInTheExactForm(Rough):
    FORM = "exact"


class RoughByHemispheres(Smooth):
    LAW = (7.49e-19, 4e-10, 1e-7, 2e-8)


if __name__ == "__main__":
    unittest.main()
