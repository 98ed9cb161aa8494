# SPDX-License-Identifier: BSD-3-Clause
"""liggghts-shear-long.py, small: nothing lost, no drift, a straight profile and the same means on one rank, on two and
after a restart. 1e7 steps are that program's."""
import os
import unittest
from unittest import mock

from cohesion_tests import lammps as engine, liggghts
from cohesion_tests.liggghts_scenes import long_spheres
from cohesion_tests.liggghts_scenes.steady_spheres import expected, systematic


class LongShear(unittest.TestCase):
    def test_nothing_lost_whoever_works_it_out(self):
        side, steps, strain = 4, 30000, 30.0
        with mock.patch.dict(os.environ, liggghts.as_lammps()), engine.temporary_folder() as folder:
            done = long_spheres.all_runs(folder, side, steps, strain, 100, lambda steps: None)
        results = [long_spheres.Result(one, side, strain) for one in done]
        hard, soft = expected(long_spheres.FRACTION, long_spheres.law(steps, strain), strain / steps)
        for one in results:
            with self.subTest(one.name):
                self.assertEqual(one.atoms, side**3)
                self.assertLess(abs(one.strain / strain - 1), 1e-14)
                self.assertLess(one.momentum, long_spheres.momentum_room(steps, strain, side))
                # Student's t of nine degrees and of eighteen: beyond 5 once in 700 and in 10,000.
                self.assertLess(one.crooked, 5)
                self.assertLess(long_spheres.apart(one, results[0]), 5)
                # Kinetic theory, as sheared_spheres_test.py has it, and of the freedoms those three that are at rest.
                for name, mean, error in (("T", one.means[0], one.errors[0]),
                                          ("stress xy", one.means[1:].sum(), one.errors[1:].sum())):
                    room = systematic(name, hard, soft) + 1 / side**3
                    sampled = 5 * error / abs(soft[name])
                    self.assertLess(sampled, 0.4)  # twice as much is seen, and half as much
                    self.assertLess(abs(mean / soft[name] - 1), room + sampled, name)
        self.assertLess(results[0].layer_error, 0.1 * long_spheres.length(side, long_spheres.FRACTION))


if __name__ == "__main__":
    unittest.main()
