# SPDX-License-Identifier: BSD-3-Clause
"""Spheres with square wells, in LAMMPS: what the tests of them share."""
import math
import sys
from pathlib import Path

import numpy

from cohesion_tests import lammps as engine
from cohesion_tests.test_cases import FolderTestCase
from cohesion_tests.theory import pair_motion
from cohesion_tests.theory.pair_motion import DAMPING, DIAMETER, MU, STIFFNESS
from cohesion_tests.thermo import thermo_lines

T_C = pair_motion.CONTACT_TIME
RESTITUTION = math.exp(-pair_motion.ALPHA * T_C)


def report(text):
    print(text, file=sys.stderr)


def well_speed(depth, mass=MU):
    return math.sqrt(2 * depth / mass)


def escape_velocity(depth, mass=MU, restitution=RESTITUTION):
    return well_speed(depth, mass) * math.sqrt(1 / restitution**2 - 1)


def words(depth, ratio, damping=DAMPING, **more):
    text = f"stiffness {STIFFNESS:.17g} damping {damping:.17g} well {depth:.17g} {ratio:.17g}"
    return text + "".join(f" {name} {value:.17g}" for name, value in more.items())


def relative(end):
    return end[..., 1, :] - end[..., 0, :]


def gaps(end):
    return numpy.linalg.norm(relative(end)[..., :3], axis=-1) - DIAMETER


class Scene(FolderTestCase):
    def sphere(self, x, v=(0.0, 0.0, 0.0), kind=1, diameter=DIAMETER, **more):
        return {"type": kind, "diameter": diameter, "density": 2650.0, "x": x, "v": v, **more}

    def follow(self, atoms, pair, dt, steps, fixes=(), box=3 * [(0.0, 0.01)], ranks=1, **options):
        if atoms:
            engine.write_spheres(self.folder, atoms, box, 3)
        (Path(self.folder) / "coefficients.txt").write_text(
            "".join(f"pair_coeff {line}\n" for line in pair))
        (Path(self.folder) / "fixes.txt").write_text("\n".join(fixes) + "\n")
        settings = {"style": "gran/squarewell", "boundary": "f f f", "skin": 4e-4, "mode": "whole",
                    "file": "end.txt", "every": steps, **options}
        output = engine.run("in.gran_square_well", self.folder, ranks=ranks, dt=dt, steps=steps,
                            **settings)
        names, lines = thermo_lines(output)
        self.output = output
        return engine.dump(self.folder, settings["file"])

    def course(self):
        return numpy.array(engine.dumps(self.folder, "course.txt"))


class Gas(Scene):
    """512 spheres of the types 1 and 3, in a box that the tests give a floor and a lid."""
    BOX = 3 * [(0.0, 0.0106)]

    def write_gas(self):
        random = numpy.random.default_rng(4711)
        grid = 0.7e-3 + numpy.arange(8) * 1.3e-3
        return [self.sphere(place + random.uniform(-5e-5, 5e-5, 3), random.uniform(-.05, .05, 3),
                            kind=int(random.integers(0, 2)) * 2 + 1,
                            diameter=1e-3 * random.uniform(0.8, 1.0),
                            omega=random.uniform(-30, 30, 3))
                for place in numpy.array(numpy.meshgrid(grid, grid, grid)).reshape(3, -1).T]
