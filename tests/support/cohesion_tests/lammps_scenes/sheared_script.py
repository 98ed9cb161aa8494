# SPDX-License-Identifier: BSD-3-Clause
"""Scripts of spheres and discs that fix deform/shear shears: what the tests of it share."""
from pathlib import Path

import numpy

from cohesion_tests import lammps as engine
from cohesion_tests.test_cases import FolderTestCase

BOX = numpy.array([10.0, 8.0, 6.0])
RATE = 0.5

HEAD = """
plugin load ${plugin}
units lj
dimension %(dimension)d
atom_style sphere
newton off
boundary p p p
comm_modify vel yes
neighbor %(skin)s bin
neigh_modify delay 0 every 1 check yes
read_data data.spheres
"""
DUMP = """
dump out all custom %d out.txt id x y z vx vy vz xu yu zu
dump_modify out format float %%.17g
thermo_modify format float %%.17g
"""


def spheres(number, dimension, seed=1, speed=1.0, diameter=1.0):
    random = numpy.random.default_rng(seed)
    box = BOX.copy()
    if dimension == 2:
        box[2] = 1.0
    atoms = []
    for _ in range(number):
        x, v = random.uniform(0, 1, 3) * box, random.normal(0, speed, 3)
        if dimension == 2:
            x[2] = v[2] = 0.0
        atoms.append({"type": 1, "diameter": diameter, "density": 1.0, "x": x, "v": v})
    return atoms


def dense_gas(seed, diameter):
    """Spheres on a lattice that fills the box, with speeds of 0.5."""
    random = numpy.random.default_rng(seed)
    cells = [8, 6, 5]
    places = numpy.array(numpy.meshgrid(*(numpy.arange(n) + 0.5 for n in cells))).reshape(3, -1).T
    return [{"type": 1, "diameter": diameter, "density": 1.0, "x": x, "v": random.normal(0, 0.5, 3)}
            for x in places * BOX / cells]


def sides_of(box, dimension):
    return [(0.0, box[0]), (0.0, box[1]), (0.0, box[2]) if dimension == 3 else (-0.5, 0.5)]


class Shear(FolderTestCase):
    def write(self, atoms, dimension=3, tilt=0.0):
        engine.write_spheres(self.folder, atoms, sides_of(BOX, dimension), 1,
                             tilt=(tilt, 0.0, 0.0))

    def run_script(self, text, **options):
        code, output = engine.run_text(text, self.folder, **options)
        self.assertEqual(code, 0, output[-3000:])
        return output

    def path(self, name):
        return Path(self.folder) / name

    def snapshots(self):
        return engine.dumps(self.folder, "out.txt")
