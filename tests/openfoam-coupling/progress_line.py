# SPDX-License-Identifier: BSD-3-Clause
"""Share done and time left in the solver's log: few digits, and never less than nothing left, also where the last step
reaches beyond the end."""

import re
import unittest

from cohesion_tests.coupling.cases import append
from cohesion_tests.coupling.test_case import CoupledTestCase


class ProgressInTheLog(CoupledTestCase):
    def test_shares_and_times(self):
        case = self.column("case")
        # OpenFOAM ends half a step beside the end at most: three steps of 1e-4.
        append(case, "system/controlDict", "endTime 2.6e-4; writeInterval 1e-4;")
        case.mesh()
        log = case.solve()
        found = re.findall(r"^Time = \S+ +\((\S+) %, (\S+) s elapsed, about (\S+) s left\)$", log, re.M)
        self.expect_equal("shares done [%]", [words[0] for words in found], ["38.46", "76.92", "100.00"])
        for words in found:
            self.expect_true(f"times {words[1]} and {words[2]}: one decimal, none negative",
                             all(re.fullmatch(r"\d+\.\d", word) for word in words[1:]))
        self.expect_equal("as programs read it", case.progress(), (1.0, 0.0))


if __name__ == "__main__":
    unittest.main()
