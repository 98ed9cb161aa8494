# SPDX-License-Identifier: BSD-3-Clause
"""Two and three spheres with Hamaker adhesion, sampled, in LAMMPS and in LIGGGHTS: the tables of escape velocities
and of struck pairs are one for both."""

import os
import sys
import unittest
from unittest import mock

import numpy

from cohesion_tests import lammps as engine, liggghts
from cohesion_tests.lammps_scenes import bed_couples as couple, couples, triples
from cohesion_tests.liggghts import EPSILON
from cohesion_tests.theory import pair_motion

SPEEDS = numpy.array([0.3, 0.5, 0.8, 0.9, 0.95, 1.0, 1.05, 1.1, 1.3, 1.5, 2.0]) * 4.0013e-3
POSITIONS = 4
STEPS = (2.25e-5, 1.125e-5, 5e-6, 1e-6)
DIVISIONS = (4, 10, 50)


def follow():
    """Of the engine that lammps.py runs: ends of couples by step, of triples by division."""
    found = {}
    for dt in STEPS:
        atoms = []
        for speed in SPEEDS.tolist():
            for position in range(POSITIONS):
                gap = pair_motion.OUT * 1.001 + speed * dt * position / POSITIONS
                atoms += couples.couple(len(atoms) // 2, gap, (0.0, speed, 0.0))
        with engine.temporary_folder() as folder:
            engine.write_spheres(folder, atoms, [(0.0, 0.066), (0.0, 0.18), (0.0, 0.004)], 1)
            engine.run("in.head_on", folder, dt=dt, steps=int(9e-4 / dt) + 40, K=couple.STIFFNESS,
                       gamma=couple.DAMPING / couple.MU, A=couple.A, cut=couple.CUT, out=couple.OUT)
            found[f"two {dt}"] = engine.dump(folder, "end.txt")[:, 1:]
    with engine.temporary_folder() as folder:
        triples.write(folder)
        for division in DIVISIONS:
            velocities, sticks, _ = triples.outcome(folder, division, 0.0, "sampled")
            found[f"three {division}"], found[f"sticks {division}"] = velocities, sticks
    return found


class SameSampled(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.lammps = follow()
        with mock.patch.dict(os.environ, {**liggghts.as_lammps(), "COHESION_PLUGIN": ""}):
            cls.liggghts = follow()

    def test_two(self):
        # The same forces on the same places; a kick may be rounded in two ways, and the last bit of a velocity is
        # lost in the places, which are ten times as long as a way.
        for dt in STEPS:
            with self.subTest(dt=dt):
                one, other = (found[f"two {dt}"] for found in (self.lammps, self.liggghts))
                places, speeds = (numpy.abs(one - other)[:, part].max() for part in (slice(3), slice(3, None)))
                print(f"two, dt {dt}: places apart by {places:.1e} m, velocities by {speeds:.1e} m/s",
                      file=sys.stderr)
                self.assertLess(speeds, 16 * EPSILON * SPEEDS.max())
                self.assertLess(places, 16 * EPSILON * 0.18)
                # Some parted and some did not: 1e-7 m is H_out.
                gaps = numpy.linalg.norm(one[1::2, :3] - one[0::2, :3], axis=1) - 1e-3
                self.assertLess(gaps.min(), 1e-7)
                self.assertGreater(gaps.max(), 1e-7)

    def test_three(self):
        # Sums of several forces are rounded in another order. A place at 0.04 m is good to 7e-18 m, by which the
        # force, whose slope is at most 2 F_ad/H_cut = 1e6 N/m, changes a velocity by 1e6 7e-18 t_c/4/m = 1e-10 m/s
        # in a step within H_cut, and by 7e-14 m/s in one in contact. None of these has more than a few of the first.
        for division in DIVISIONS:
            with self.subTest(division=division):
                self.assertTrue((self.lammps[f"sticks {division}"] == self.liggghts[f"sticks {division}"]).all())
                one, other = (found[f"three {division}"] for found in (self.lammps, self.liggghts))
                print(f"three, t_c/{division}: velocities apart by {numpy.abs(one - other).max():.1e} m/s",
                      file=sys.stderr)
                self.assertLess(numpy.abs(one - other).max(), 1e-9)
                self.assertGreater(numpy.abs(one).max(), 0.01)


if __name__ == "__main__":
    unittest.main()
