# SPDX-License-Identifier: BSD-3-Clause
"""Balls with rolling friction in LAMMPS (in.rolling): what the tests of them share."""
import math
import sys

import numpy

from cohesion_tests import lammps as engine
from cohesion_tests.test_cases import FolderTestCase
from cohesion_tests.theory.pair_motion import DENSITY, DIAMETER, MASS, STIFFNESS
from cohesion_tests.thermo import thermo_lines

RADIUS = DIAMETER / 2
INERTIA = 0.4 * MASS * RADIUS**2
G = 9.81
WALL_TIME = math.pi * math.sqrt(MASS / STIFFNESS)  # of a contact with a wall, no damping
CONTACT = f"stiffness {STIFFNESS} restitution 0.3"
# A height of 5e-4 m is rounded by 5e-20 m, the overlap under the weight is 1.7e-8 m: 3e-12 of the
# load in each step, at random; a mean over a hundred steps and a few operations more.
ROUNDING = 1e-11


def report(text):
    print(text, file=sys.stderr)


class Rolling(FolderTestCase):
    def run_spheres(self, atoms, dt, steps, every, box=((-0.02, 0.06), (-0.02, 0.02), (-0.01, 0.02)),
                    **options):
        """Snapshots (snapshot, atom, column from x on) and the thermo output by column."""
        engine.write_spheres(self.folder, atoms, box, 1)
        settings = {"start": "data", "boundary": "f f f", "skin": 2e-4, "scheme": "exact",
                    "pair": "stiffness 800", "wall": "none", "gx": 0.0, "gy": 0.0, "gz": 0.0,
                    "sort": 0, "save": 0, **options}
        settings["walls"] = int(settings["wall"] != "none")
        self.output = engine.run("in.rolling", self.folder, dt=dt, steps=steps, every=every,
                                 **settings)
        names, lines = thermo_lines(self.output)
        path = numpy.array(engine.dumps(self.folder, "path.txt"))[:, :, 1:]
        return path, dict(zip(names, numpy.array(lines).T))


def ball(height, v=(0.0, 0.0, 0.0), spin=(0.0, 0.0, 0.0), x=0.0, y=0.0):
    return {"type": 1, "diameter": DIAMETER, "density": DENSITY, "x": (x, y, height), "v": v,
            "omega": spin}
