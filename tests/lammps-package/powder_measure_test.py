# SPDX-License-Identifier: BSD-3-Clause
"""cohesion-powder --measure: the engine runs with the lines that the program prints, which reports their times."""
import unittest

from cohesion_tests import lammps as engine
from cohesion_tests.csv_program import CsvProgram

program = CsvProgram("COHESION_POWDER")

GLASS = ("--diameter", 5e-4, "--density", 2500, "--young", 63e9, "--hamaker", 6.5e-20, "--width", 0.05, "--depth", 0.04,
         "--height", 0.1)


class Measure(unittest.TestCase):
    def test_a_second_of_the_bed(self):
        words = ("--measure", "--lammps", engine.program(), "--plugin", engine.plugin())
        for more in ((), ("--asperity", 1e-7, "--keep", "force"), ("--stiffness", 500),
                     ("--law", "square_well", "--diameter", 4e-4, 6e-4)):
            found = program.values(*(GLASS if "--diameter" not in more else GLASS[2:]), *more, *words)
            # Between what no computer reaches and what no user waits for
            self.assertGreater(found["seconds_per_grain_step"], 1e-9)
            self.assertLess(found["seconds_per_grain_step"], 1e-3)
            hours = found["seconds_per_grain_step"] * found["grains"] * found["steps_per_second"] / 3600
            self.assertAlmostEqual(found["hours_per_second"] / hours, 1, delta=1e-12)


if __name__ == "__main__":
    unittest.main()
