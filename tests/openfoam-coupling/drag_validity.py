# SPDX-License-Identifier: BSD-3-Clause
"""A drag closure used outside the range it was fitted to: a warning, once, with the numbers, and a
count at the end of the run, the same on any number of ranks. The bed is that of packed_bed.py, blown so
fast that Hill, Koch and Ladd's Reynolds number, 200, is exceeded in two of its three layers."""

import re
import unittest

from cohesion_tests.coupling.cases import drag_report
from cohesion_tests.coupling.held_layers import DENSE, DILUTE, LOOSE, MU, RHO, ROWS, STEPS, blow
from cohesion_tests.coupling.test_case import CoupledTestCase

SUPERFICIAL = 1.3


def reynolds(row):
    return RHO * SUPERFICIAL * row[1] / MU


class DragValidity(CoupledTestCase):
    def test_warning_and_count(self):
        self.expect_true(f"the case is what it should be: Re {reynolds(DENSE):.0f}, {reynolds(LOOSE):.0f}, "
                         f"{reynolds(DILUTE):.0f}", reynolds(LOOSE) < 200 < reynolds(DENSE))
        spheres = 9 * sum(row[0] for row in ROWS)
        outside = 9 * sum(row[0] for row in ROWS if reynolds(row) > 200)
        for ranks in (1, 2):
            _, _, log = blow(self.column, f"ranks{ranks}", {"drag": "hillKochLadd"}, SUPERFICIAL, ranks)
            warnings = re.findall(r"drag (\w+) was fitted for void fraction 0.36 to 1 and Reynolds number "
                                  r"up to 200; (\d+) of (\d+) particles are outside, at void fractions "
                                  r"from (\S+) to (\S+) and Reynolds numbers up to (\S+)\. ", log)
            self.assertEqual(len(warnings), 1, f"{ranks} ranks: warnings")
            name, count, all_spheres, lowest, highest, fastest = warnings[0]
            self.expect_equal(f"{ranks} ranks: who, how many", (name, int(count), int(all_spheres)),
                              ("hillKochLadd", outside, spheres))
            # Written with 12 digits; the void fractions below with 10.
            self.expect_near(f"{ranks} ranks: lowest void fraction", float(lowest), 0.424826745, 1e-9)
            self.expect_near(f"{ranks} ranks: highest void fraction", float(highest), 0.8869026645, 1e-9)
            # Set in motion from rest in one step, the gas is not yet at its velocity to the digits of
            # packed_bed.py. Any other layer, or diameter for radius, would be off by tens of per cent.
            self.expect_near(f"{ranks} ranks: highest Reynolds number", float(fastest), reynolds(DILUTE),
                             1e-4 * reynolds(DILUTE))
            # The gas is at rest when the particles are first asked.
            self.expect_equal(f"{ranks} ranks: evaluations and how many were outside", drag_report(log),
                              (STEPS * spheres, (STEPS - 1) * outside))


if __name__ == "__main__":
    unittest.main()
