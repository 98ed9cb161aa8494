# SPDX-License-Identifier: BSD-3-Clause
"""Spheres that meet walls of the exact scheme, in LAMMPS: what the tests of them share."""
import math
import sys
from pathlib import Path

import numpy

from cohesion_tests import dumps, lammps as engine
from cohesion_tests.test_cases import FolderTestCase

DIAMETER, DENSITY = 1e-3, 2650.0
RADIUS = DIAMETER / 2
MASS = math.pi / 6 * DENSITY * DIAMETER**3
STIFFNESS = 800.0
W0 = math.sqrt(STIFFNESS / MASS)
CUT, OUT = 4e-10, 1e-7
SPEED = 0.1
# A position of 1e-3 m is rounded by 1e-19 m; the overlaps here are 4e-6 m: 3e-14. A contact takes
# some ten operations in each of ten steps.
ROUNDING = 1e-11


def alpha(restitution):
    """Damping rate of the spring-dashpot with this restitution."""
    ln_e = math.log(restitution)
    return -ln_e * W0 / math.hypot(math.pi, ln_e)


def contact_time(restitution=1.0):
    return math.pi / math.sqrt(W0**2 - alpha(restitution) ** 2)


def say(text):
    print(text, file=sys.stderr)


class ExactWall(FolderTestCase):
    def write(self, x, v, box=3 * [(0.0, 0.04)], diameter=DIAMETER, types=2, **more):
        atoms = [{"type": 1, "diameter": diameter, "density": DENSITY, "x": place, "v": speed}
                 for place, speed in zip(x, v)] + more.get("others", [])
        engine.write_spheres(self.folder, atoms, box, types)

    def run_wall(self, wall, dt, steps, **options):
        settings = {"start": "data", "boundary": "f f f", "skin": 1e-3, "pairs": 0,
                    "pair": "none", "moving": "1", "file": "end.txt", "every": 0, "save": 0,
                    "steps": steps, **options}
        self.output = engine.run("in.exact_wall", self.folder, wall=wall, dt=dt, **settings)
        return engine.dump(self.folder, settings["file"])

    def places(self, n):
        """Beside each other on a grid, far enough for no contact."""
        return numpy.array([[2e-3 * (1 + k % 15), 2e-3 * (1 + k // 15), 0.0] for k in range(n)])

    def course(self, columns):
        return numpy.array([snapshot.table[-1, columns] for snapshot in dumps.read(Path(self.folder) / "course.txt")])
