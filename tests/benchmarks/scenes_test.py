# SPDX-License-Identifier: BSD-3-Clause
"""Every way of `dense` runs and takes processor time: scenes_test.py BUILD LAMMPS_ENGINE."""
import sys
import unittest

from programs import Programs  # first: it knows where the others are
import dense
import scenes

PROGRAMS = Programs(sys.argv[1], sys.argv[2])
PARTICLES, STEPS = 500, 20


class Ways(unittest.TestCase):
    def test_each_runs_the_steps_that_it_is_asked_for(self):
        cells = scenes.cells_for("gas", PARTICLES)
        number = scenes.particles("gas", cells)
        ran = 0
        for engine, ways in dense.WAYS.items():
            for name, (way, pair) in ways.items():
                if not PROGRAMS.has(way):
                    continue
                with self.subTest(engine=engine, way=name):
                    text = scenes.text(engine == "LIGGGHTS", "gas", cells, pair, load=way == "lammps+")
                    used = PROGRAMS.run(way, text, STEPS)
                    self.assertRegex(used.output, rf"Loop time of .* for {STEPS} steps with {number} atoms")
                    self.assertGreater(used.seconds, 0)
                    ran += 1
        self.assertGreater(ran, 0)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
