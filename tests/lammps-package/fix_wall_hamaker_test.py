# SPDX-License-Identifier: BSD-3-Clause
"""Forces of plane walls against the law; a wall is a sphere of infinite radius."""
import math
import unittest

import numpy

from cohesion_tests import lammps as engine
from cohesion_tests.test_cases import FolderTestCase
from cohesion_tests.theory import hamaker_reference as law
from cohesion_tests.thermo import thermo_end

RADII = [0.5e-3, 0.2e-3]
SIZE = 0.02


class WallHamaker(FolderTestCase):
    FORM = "small_gap"
    LAW = (7.49e-19, 4e-10, 1e-7)
    WORDS = "hamaker 7.49e-19 cutoff 4e-10 1e-7"
    GAPS = [-1e-6, 0.0, 3e-10, 5e-10, 1e-9, 1e-8, 9e-8, 2e-7]

    def spheres(self, axis, dimension):
        """For each wall of an axis, gap and radius one sphere; the last one is outside the group."""
        atoms = []
        beside = 1 if axis == 0 else 0
        for side in (0, 1):
            for k, gap in enumerate(self.GAPS):
                for n, radius in enumerate(RADII):
                    x = numpy.full(3, 0.5 * SIZE)
                    if dimension == 2:
                        x[2] = 0.0
                    x[axis] = radius + gap if side == 0 else SIZE - radius - gap
                    x[beside] = 1e-3 * (1 + 2 * k + n)
                    atoms.append({"type": 1, "diameter": 2 * radius, "density": 2650.0, "x": x})
        atoms.append({**atoms[0], "type": 2})
        return atoms

    def check(self, axis, dimension=3, boundary="f f f", planes=None):
        atoms = self.spheres(axis, dimension)
        box = [(0.0, SIZE), (0.0, SIZE), (0.0, SIZE) if dimension == 3 else (-1e-3, 1e-3)]
        engine.write_spheres(self.folder, atoms, box, 2)
        planes = planes or f"{'xyz'[axis]}plane 0 {SIZE}"
        values = thermo_end(engine.run("in.wall", self.folder, dimension=dimension,
                                          boundary=boundary, law=self.WORDS, planes=planes))
        forces = engine.dump(self.folder, "forces.txt")[:, 4:7]
        energy = numpy.zeros(3)
        virial = 0.0
        on_wall = 0.0
        for atom, force in zip(atoms[:-1], forces):
            position, radius = atom["x"][axis], atom["diameter"] / 2
            upper = position > SIZE / 2
            gap = (SIZE - position if upper else position) - radius
            expected = law.force(self.FORM, gap, radius, math.inf, *self.LAW) * (1 if upper else -1)
            self.assertLessEqual(abs(force[axis] - expected),
                                 law.position_tolerance(SIZE, gap, self.LAW[1]) * abs(expected),
                                 f"gap {gap} radius {radius}")
            self.assertEqual(numpy.count_nonzero(numpy.delete(force, axis)), 0)
            energy += law.energy(self.FORM, gap, radius, math.inf, *self.LAW)
            virial += force[axis] * position
            on_wall -= force[axis]
        self.assertEqual(numpy.count_nonzero(forces[-1]), 0, "a sphere outside the fix's group")
        # The gap's rounding, 2^-53 SIZE per operation, at the smallest gap that it matters for.
        tolerance = law.position_tolerance(SIZE, self.LAW[1], self.LAW[1])
        self.assertLessEqual(abs(values["f_walls"] - energy[0]), tolerance * abs(energy[0]))
        self.assertLessEqual(abs(values["PotEng"] - energy[0]), tolerance * abs(energy[0]))
        size = numpy.abs(forces).sum()
        for k in range(3):
            expected = on_wall if k == axis else 0.0
            self.assertLessEqual(abs(values[f"f_walls[{k + 1}]"] - expected), 1e-13 * size)
            pressure = virial / values["v_volume"] if k == axis else 0.0
            if dimension == 3:
                self.assertLessEqual(abs(values["P" + 2 * "xyz"[k]] - pressure),
                                     1e-13 * size * SIZE / values["v_volume"])

    def test_walls_across_x(self):
        self.check(0)

    def test_walls_across_y(self):
        self.check(1)

    def test_walls_across_z(self):
        self.check(2)

    def test_two_dimensions(self):
        self.check(1, dimension=2, boundary="f f p")

    def test_one_wall_of_two(self):
        atoms = self.spheres(2, 3)
        engine.write_spheres(self.folder, atoms, 3 * [(0.0, SIZE)], 2)
        engine.run("in.wall", self.folder, dimension=3, boundary="f f f", law=self.WORDS,
                   planes="zplane 0 NULL")
        forces = engine.dump(self.folder, "forces.txt")[:, 6]
        half = len(self.GAPS) * len(RADII)
        self.assertGreater(numpy.count_nonzero(forces[:half]), 0)
        self.assertEqual(numpy.count_nonzero(forces[half:]), 0)


class ExactForm(WallHamaker):
    FORM = "exact"
    LAW = (7.49e-19, 4e-10, 4e-4)
    WORDS = "hamaker 7.49e-19 cutoff 4e-10 4e-4 form exact"
    GAPS = [-1e-6, 3e-10, 5e-10, 1e-8, 1e-6, 2e-5, 3e-4, 5e-4]


class SmallGapWithAsperities(WallHamaker):
    LAW = (7.49e-19, 4e-10, 1e-7, 2e-8)
    WORDS = "hamaker 7.49e-19 cutoff 4e-10 1e-7 asperity 2e-8"


class ExactFormWithAsperities(ExactForm):
    LAW = (7.49e-19, 4e-10, 4e-4, 2e-8)
    WORDS = "hamaker 7.49e-19 cutoff 4e-10 4e-4 asperity 2e-8 form exact"


class SmallGapOfRoughSurfaces(WallHamaker):
    LAW = (7.49e-19, 4e-10, 1e-7, (5e-9, 5e-7))
    WORDS = "hamaker 7.49e-19 cutoff 4e-10 1e-7 roughness 5e-9 5e-7"


if __name__ == "__main__":
    unittest.main()
