# SPDX-License-Identifier: BSD-3-Clause
"""The example of the page of cohesiveBedFoam runs as it is printed, in the case of the first coupled bed, for some gas
steps: every block is the file that its first line names."""

import unittest

from cohesion_studies.foam_case import FoamCase
from cohesion_tests.coupling.cases import exchange_lines
from cohesion_tests.coupling.test_case import CoupledTestCase
from cohesion_tests.page_session import Session

CASE = "docs/getting-started/first-coupled-bed.md"
PAGE = "docs/openfoam-coupling/cohesiveBedFoam.md"
STEPS = 100


class PageCase(CoupledTestCase):
    def test_runs_as_printed(self):
        empty = self.work / "empty"
        empty.mkdir(parents=True, exist_ok=True)
        case = FoamCase(empty, self.work / "printed", self._columns.environment, overwrite=True)
        Session(CASE).write(case.folder)
        Session(PAGE, "Example").write(case.folder)
        case.set("system/controlDict", "endTime", STEPS * 2e-4)
        case.run("blockMesh")
        log = case.solve()
        lines = exchange_lines(log)
        self.expect_equal("gas steps", len(lines), STEPS)
        self.expect_balance("printed", lines)
        # Of the engine, or of the coupling
        self.expect_equal("warnings", [line for line in log.splitlines()
                                       if "WARNING" in line or "in file openfoam-coupling" in line], [])


if __name__ == "__main__":
    unittest.main()
