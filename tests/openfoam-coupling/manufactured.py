# SPDX-License-Identifier: BSD-3-Clause
"""Order of convergence, in space and in time, by a manufactured solution of the volume-averaged equations. (For more
meshes and steps: manufactured_table.py of the benchmarks.)"""

import unittest

from cohesion_tests.coupling.manufactured_solution import in_space, in_time, orders
from cohesion_tests.coupling.test_case import CoupledTestCase


class Manufactured(CoupledTestCase):
    def test_orders_in_space(self):
        rows = in_space(self.column, (16, 32, 64))
        # Errors of second order with a remainder of fourth, (K h)^2/6 = 0.006 of it on the finer two meshes for
        # each derivative in a chain of up to four: 2 +- 0.1 is asked for.
        for k, what in ((1, "U"), (2, "p")):
            self.expect_near(f"order of {what} in space", orders([row[k] for row in rows])[-1], 2, 0.1)

    def test_order_in_time(self):
        # First order, the remainder a share of about RATE/eps dt = 0.04 of the steps of 0.005 s
        apart = in_time(self.column, [0.16 / k for k in (16, 32, 64)])
        self.expect_near("order of U in time", orders(apart)[-1], 1, 0.1)


if __name__ == "__main__":
    unittest.main()
