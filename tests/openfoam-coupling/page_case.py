# SPDX-License-Identifier: BSD-3-Clause
"""The complete example of the page of cohesiveBedFoam runs as it is printed: every block is the file that its first line
names."""

import re
import shutil
import unittest

from cohesion_studies.foam_case import FoamCase
from cohesion_tests import SOURCE
from cohesion_tests.coupling.cases import exchange_lines
from cohesion_tests.coupling.test_case import CoupledTestCase
from cohesion_tests.page_session import Session

PAGE = "docs/openfoam-coupling/cohesiveBedFoam.md"


class PageCase(CoupledTestCase):
    def test_runs_as_printed(self):
        example = (SOURCE / PAGE).read_text().split("\n## Example\n")[1].split("\n## ")[0]
        empty = self.work / "empty"
        empty.mkdir(parents=True, exist_ok=True)
        case = FoamCase(empty, self.work / "printed", self._columns.environment, overwrite=True)
        Session(PAGE, "Example").write(case.folder)
        shutil.copytree(case.folder / "0.orig", case.folder / "0")
        case.run("blockMesh")
        log = case.solve()
        lines = exchange_lines(log)
        self.expect_equal("gas steps", len(lines), 100)
        self.expect_balance("printed", lines)
        # All of the bed's spheres, and what the page says of their number
        number = int(re.search(r"Particles: (\d+),", log)[1])
        self.expect_true(f"the page says how many spheres there are: {number}", f"A bed of {number} spheres" in example)
        # Of the engine, or of the coupling
        self.expect_equal("warnings", [line for line in log.splitlines()
                                       if "WARNING" in line or "in file openfoam-coupling" in line], [])


if __name__ == "__main__":
    unittest.main()
