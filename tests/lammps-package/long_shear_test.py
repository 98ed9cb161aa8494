# SPDX-License-Identifier: BSD-3-Clause
"""shear-long.py, small: the same events on one rank, on two and after a restart; nothing lost, no drift, a
straight profile. 1e7 steps are that program's."""
import unittest

import numpy

from cohesion_tests import lammps as engine
from cohesion_tests.lammps_scenes import long_shear


class LongShear(unittest.TestCase):
    def test_same_events_whoever_works_them_out(self):
        side, steps, strain = 8, 4000, 100.0
        with engine.temporary_folder() as folder:
            done = long_shear.all_runs(folder, side, steps, strain, 100, lambda steps: None)
        for run in done:
            with self.subTest(run.name):
                self.assertEqual(run.events, done[0].events)
                self.assertGreater(run.count, 5000)
                numpy.testing.assert_array_equal(run.end, done[0].end)
                self.assertTrue((run.table["Atoms"] == side**2).all())
                self.assertLess(abs(run.table["f_shear"][-1] / strain - 1), 1e-14)
                room = long_shear.momentum_room(2 * run.count, side**2)
                for k in (1, 2):
                    self.assertLess(abs(run.table[f"c_sums[{k}]"]).max(), room)
        off, error = long_shear.crooked(done[0].profile, long_shear.length(side))
        # Student's t of nine degrees: beyond 5 once in 700 layers. Slow enough to see a tenth of the
        # difference between the faces.
        self.assertLess(off, 5)
        self.assertLess(error, 0.1 * long_shear.length(side))


if __name__ == "__main__":
    unittest.main()
