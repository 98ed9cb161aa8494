# SPDX-License-Identifier: BSD-3-Clause
"""A case begins at any time at which there are initial fields, and is then what it is from 0 on; where there are none it
is refused, with what would do."""

import unittest

import numpy as np

from cohesion_tests.coupling.cases import CONTROL, append, use_script
from cohesion_tests.coupling.fields import field
from cohesion_tests.coupling.swarm import complete
from cohesion_tests.coupling.test_case import CoupledTestCase

STEPS, DT = 5, 1e-4


class StartTimes(CoupledTestCase):
    def begin(self, name, start, begin="startTime"):
        """The falling swarm, with its initial fields at the time `start`."""
        case = self.column(name)
        use_script(case, "continued")
        append(case, CONTROL, f"startFrom {begin}; startTime {start}; endTime {start + STEPS * DT!r};"
                              f" writeControl timeStep; writeInterval {STEPS}; writePrecision 17;")
        case.mesh()
        if start:
            (case.folder / "0").rename(case.folder / str(start))
        return case

    def end(self, case, start, ranks=1):
        case.solve(ranks=ranks)
        if ranks > 1:
            case.run("reconstructPar", "-latestTime")
        return np.concatenate([field(case, f"{start + STEPS * DT:.8g}", name) for name in ("U", "p")])

    def test_begins_there(self):
        right = self.end(self.begin("0", 0), 0)
        for name, start, begin, ranks in (("5", 5, "startTime", 1), ("5-latest", 5, "latestTime", 1),
                                          ("before-0", -1, "startTime", 1), ("5-shared", 5, "startTime", 2)):
            case = self.begin(name, start, begin)
            found = self.end(case, start, ranks)
            # Ranks add in another order; a swarm of 5 steps makes no chaos of that.
            self.expect_below(f"{name}: largest difference from a start at 0, over the largest value",
                              np.abs(found - right).max() / np.abs(right).max(), 1e-9)
            if start > 0:
                self.expect_equal(f"{name}: complete times", complete(case, ranks), [start + STEPS * DT])

    def test_continues_there(self):
        """A run that began at another time is continued as any."""
        case = self.begin("continued", 5, "latestTime")
        case.solve()
        append(case, CONTROL, f"endTime {5 + 2 * STEPS * DT!r};")
        case.solve()
        self.expect_equal("complete times", complete(case, 1), [5 + STEPS * DT, 5 + 2 * STEPS * DT])

    def test_refused(self):
        case = self.begin("nothing", 0)
        append(case, CONTROL, "startTime 5; endTime 6;")
        self.refused("no fields at the time", case, "the run would start at time 5, where no folder of that name is",
                     "Fields to begin with are at 0: use 'startFrom startTime; startTime 0;', or give that folder the name 5")
        case = self.begin("written", 5)
        (case.folder / "5/uniform").mkdir()
        self.refused("a time that is not complete", case, "where 'uniform/completeState' is missing",
                     "put its fields in a folder 5 without a folder 'uniform'")


if __name__ == "__main__":
    unittest.main()
