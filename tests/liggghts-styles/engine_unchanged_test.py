# SPDX-License-Identifier: BSD-3-Clause
"""A script that uses no style of this package runs under the launcher as in the stock program."""

import unittest

from cohesion_tests.liggghts import Run


def thermo(run):
    """The lines between the header of the thermo output and the timings."""
    log = run.files["log.liggghts"]
    return log.split("    Step ")[1].split("Loop time")[0].split("\n")


class EngineUnchanged(unittest.TestCase):
    def test_thermo_output_is_the_same_to_the_last_bit(self):
        expected = thermo(Run("in.stock", "stock"))
        self.assertGreater(len(expected), 20)
        energies = {line.split()[2] for line in expected[1:-1]}
        self.assertGreater(len(energies), 15, "nothing moves in this script")
        for how in ("launcher", "preload"):
            with self.subTest(how=how):
                self.assertEqual(thermo(Run("in.stock", how)), expected)


if __name__ == "__main__":
    unittest.main()
