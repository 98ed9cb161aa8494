# SPDX-License-Identifier: BSD-3-Clause
"""The same end on one rank and on two, and with the run stopped and restarted half-way."""
import unittest

import numpy

from cohesion_tests import lammps as engine
from cohesion_tests.thermo import thermo_end

# Force of 10 weights at most; the surface cut-off is wide so that a step of 1e-6 s resolves it.
A = 3.3e-14

# Ranks and restarts order the sums differently: 2^-53 of 0.012 m, 1e-18 m, some ten times a step.
# Where the attraction falls with the gap, by 2 F_ad/H_cut = 2.7e3 N/m at most, a difference grows as
# exp(sqrt(2.7e3 N/m / 7e-7 kg) t); the gap is that small for 1e-7 m at 0.1 m/s = 1e-6 s, and the
# whole attraction, 1e-5 m with a mean slope a hundred times smaller, takes 1e-4 s: e^0.6 a passage.
# Three passages and the collisions' own divergence (2 d/(mean path) = 10 each) make 1e4: 1e-13 m.
TOLERANCE = 1e-12  # [m]; speeds: times the frequency of a contact, 3.4e4 1/s


def spheres():
    random = numpy.random.default_rng(4711)
    grid = 0.6e-3 + numpy.arange(10) * 1.2e-3
    atoms = []
    for place in numpy.array(numpy.meshgrid(grid, grid, grid)).reshape(3, -1).T:
        atoms.append({"type": 1, "diameter": 1e-3 * random.uniform(0.9, 1.0), "density": 2650.0,
                      "x": place + random.uniform(-5e-5, 5e-5, 3), "v": random.uniform(-.1, .1, 3)})
    return atoms


class RanksAndRestart(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        keeper = engine.temporary_folder()
        cls.addClassCleanup(keeper.cleanup)
        cls.folder = keeper.name
        engine.write_spheres(cls.folder, spheres(), 3 * [(0.0, 0.012)], 1)
        cls.serial, cls.output = cls.end()

    @classmethod
    def end(cls, ranks=1, start="data", constant=A, mu=0.3):
        output = engine.run("in.cohesive_box", cls.folder, ranks=ranks, start=start, A=constant,
                            mu=mu, file="end.txt")
        return engine.dump(cls.folder, "end.txt"), thermo_end(output)

    def same(self, one, other):
        self.assertEqual(len(one), 1000)
        numpy.testing.assert_array_equal(one[:, 0], other[:, 0])
        self.assertLessEqual(numpy.abs(one[:, 1:4] - other[:, 1:4]).max(), TOLERANCE)
        self.assertLessEqual(numpy.abs(one[:, 4:7] - other[:, 4:7]).max(), 3.4e4 * TOLERANCE)

    def test_two_ranks(self):
        ends, values = self.end(ranks=2)
        self.same(self.serial, ends)
        for name in ("f_sides", "f_sides[3]"):
            # Energies and forces of wall gaps that differ by the tolerance: the steepest slope is
            # 1/H_cut of the largest value.
            self.assertLessEqual(abs(values[name] - self.output[name]),
                                 TOLERANCE / 1e-7 * abs(self.output[name]) + 1e-18, name)

    def test_restart(self):
        # Without friction: LAMMPS' own contact styles lose the history of contacts when a hybrid style
        # is given again after a restart, and a flag (limit_damping) when it is not.
        for ranks in (1, 2):
            whole = self.end(ranks=ranks, mu=0)[0]  # writes the restart file half-way
            self.same(whole, self.end(start="restart", mu=0)[0])

    def test_adhesion_matters_here(self):
        without = self.end(constant=0.0)[0]
        self.assertGreater(numpy.abs(without[:, 1:4] - self.serial[:, 1:4]).max(), 1e-6)
        self.assertNotEqual(self.output["f_sides"], 0.0)


if __name__ == "__main__":
    unittest.main()
