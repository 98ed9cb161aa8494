# SPDX-License-Identifier: BSD-3-Clause
"""What a rank sends in the exchange of gas and particles does not grow with the ranks: on 12 it is what follows from
its neighbours alone, and 12 are more than any has neighbours. (For figures: exchange_traffic.py of the benchmarks.)"""

import unittest

from cohesion_tests.coupling.growing_swarm import differing, run
from cohesion_tests.coupling.test_case import CoupledTestCase


class ExchangeGrowth(CoupledTestCase):
    def test_messages_are_those_to_neighbours(self):
        ranks, steps, kernel = 12, 2, "sphereOverlap"
        counts, _, error = run(self.column, ranks, steps, kernel)
        self.expect_equal(f"{ranks} ranks: counts that differ, of {counts}", differing(counts, ranks, kernel), [])
        # As expect_balance() asks
        self.expect_below(f"{ranks} ranks: imbalance of the forces, error of the solid volume", error, 1e-12)


if __name__ == "__main__":
    unittest.main()
