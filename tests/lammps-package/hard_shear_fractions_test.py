# SPDX-License-Identifier: BSD-3-Clause
"""Temperature and stress of sheared smooth discs at three area fractions, damped and nearly elastic."""
import unittest
from concurrent.futures import ThreadPoolExecutor

from cohesion_tests.lammps_scenes.steady_shear import SteadyShear


class Fractions(SteadyShear, unittest.TestCase):
    def test_fractions(self):
        """Strains of 200 and more; nearly elastic discs forget their temperature in a strain of some 10."""
        cases = [(24, 0.1, 0.9, 0.025, 10000, 2.0), (16, 0.3, 0.9, 0.02, 10000, 2.0),
                 (24, 0.1, 0.99, 0.01, 24000, 4.0), (16, 0.2, 0.99, 0.01, 20000, 3.0),
                 (16, 0.3, 0.99, 0.01, 30000, 3.0)]
        with ThreadPoolExecutor(2) as pool:
            for case, done in [(case, pool.submit(self.sheared, *case[:5], every=10, skin=case[5]))
                               for case in cases]:
                with self.subTest(case):
                    done.result()


if __name__ == "__main__":
    unittest.main()
