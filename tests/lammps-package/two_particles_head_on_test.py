# SPDX-License-Identifier: BSD-3-Clause
"""Escape velocity of two spheres of the bed's kind that meet head-on: couples with graded speeds
run through LAMMPS at dt = 1e-8 s; the slowest that part again against an integration of the pair's
motion that knows neither LAMMPS nor the package."""
import math
import sys
import unittest
from unittest import mock

import numpy

from cohesion_tests import lammps as engine
from cohesion_tests.lammps_scenes import bed_couples
from cohesion_tests.lammps_scenes.bed_couples import (A, CUT, DAMPING, DENSITY, DIAMETER, DT, MU, OUT, STIFFNESS,
                                                      energy_after_contact, escape_velocity, steps_needed)


class HeadOn(unittest.TestCase):
    # Graded finely near the reference and coarsely beyond: a wrong answer is measured too.
    OFFSETS = [-0.5, -0.2, -0.1, -0.05, -0.02, -0.01, -0.005, -0.003, -0.002, -0.001, -0.0005,
               0.0005, 0.001, 0.002, 0.003, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5]

    # What the step does to the result: the force is sampled every v dt = 4e-11 m at most. At each
    # kink of the force (at the cut-off and at contact; slope at most 2 F_ad/H_cut = 1e6 N/m) the work
    # is wrong by up to slope (v dt)^2/8 = 2e-16 J, and the dashpot begins or ends up to one step
    # late, eta v (v dt) = 1.3e-16 J. Eight such errors are 1e-15 J of a kinetic energy of 3e-12 J:
    # 3e-4, half of it in speed. The velocity that the dashpot sees is half a step old:
    # eta dt/(2 mu) = 6e-6. Together below 0.0005; the grading adds 0.0005. What is asked is 0.005.
    TOLERANCE = 0.001

    def test_escape_velocity(self):
        reference = escape_velocity()
        order = sorted(self.OFFSETS)
        atoms = []
        for k, offset in enumerate(order):
            speed = reference * (1 + offset)
            # Contact begins at a different place within the step for each couple.
            gap = OUT * 1.001 + speed * DT * (k * 0.618 % 1)
            first = numpy.array([1e-3 + 2e-3 * (k % 5), 1e-3 + 4e-3 * (k // 5), 1e-3])
            second = first + [0.0, DIAMETER + gap, 0.0]
            for x, v in ((first, speed / 2), (second, -speed / 2)):
                atoms.append({"type": 1, "diameter": DIAMETER, "density": DENSITY, "x": x,
                              "v": (0.0, v, 0.0)})
        slowest = reference * (1 + min(o for o in order if o > 0))
        with engine.temporary_folder() as folder:
            engine.write_spheres(folder, atoms, [(0.0, 0.01), (0.0, 0.02), (0.0, 0.004)], 1)
            engine.run("in.head_on", folder, dt=DT, steps=steps_needed(slowest), K=STIFFNESS,
                       gamma=DAMPING / MU, A=A, cut=CUT, out=OUT)
            end = engine.dump(folder, "end.txt")
        gaps = numpy.linalg.norm(end[1::2, 1:4] - end[0::2, 1:4], axis=1) - DIAMETER
        parted = gaps >= OUT
        escaping = [offset for offset, free in zip(order, parted) if free]
        captured = [offset for offset, free in zip(order, parted) if not free]
        self.assertTrue(escaping and captured, f"all couples ended alike: gaps {gaps}")
        low, high = max(captured), min(escaping)
        print(f"escape velocity: reference {reference:.7g} m/s, LAMMPS between "
              f"{1 + low:.4f} and {1 + high:.4f} of it", file=sys.stderr)
        self.assertLess(low, high, "a faster couple was captured than one that escaped")
        self.assertGreaterEqual(low, -self.TOLERANCE)
        self.assertLessEqual(high, self.TOLERANCE)

    def test_reference_without_adhesion_has_the_restitution_of_the_spring(self):
        # Closed form of the spring-dashpot, e = exp(-pi alpha/q); the integration is good to 1e-6.
        alpha = DAMPING / (2 * MU)
        q = math.sqrt(STIFFNESS / MU - alpha**2)
        with mock.patch.multiple(bed_couples, ADHESION=0.0, TAIL=0.0):
            left = energy_after_contact(0.1)
        self.assertAlmostEqual(math.sqrt(2 * left / MU) / 0.1, math.exp(-math.pi * alpha / q),
                               delta=1e-6)


if __name__ == "__main__":
    unittest.main()
