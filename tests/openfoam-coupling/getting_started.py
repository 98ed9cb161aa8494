# SPDX-License-Identifier: BSD-3-Clause
"""The pages of docs/getting-started run as they are printed: their files in an empty folder, then their commands. They
print what the pages show and draw the pages' pictures, which stay in the folder of the test. Printed files warn of
nothing."""

import os
import shutil
import unittest
from pathlib import Path

from cohesion_tests import SOURCE
from cohesion_tests.coupling.test_case import CoupledTestCase
from cohesion_tests.page_session import Session

PAGES = "docs/getting-started"


class GettingStarted(CoupledTestCase):
    def check(self, page):
        session = Session(f"{PAGES}/{page}.md")
        folder = self.work / page
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir(parents=True)
        # cohesion-powder is among the programs of an installation, and in a folder of its own in a build.
        tools = Path(os.environ["COHESION_POWDER"]).parent
        environment = self._columns.environment
        code, output = session.run(folder, {**environment, "PATH": f"{environment['PATH']}:{tools}"})
        self.expect_equal(f"{page}: code\n{output[-3000:]}", code, 0)
        logs = [output, *(log.read_text() for log in folder.rglob("log.*"))]
        warnings = [line for log in logs for line in log.splitlines()
                    if line.startswith("WARNING") or "in file openfoam-coupling" in line]
        if session.files():  # cases of cohesion-powder have fewer digits, and say so
            self.expect_equal(f"{page}: warnings", warnings, [])
        said = {" ".join(line.split()) for log in logs for line in log.splitlines()}
        self.expect_equal(f"{page}: lines that nothing printed", [x for x in session.printed() if x not in said], [])
        self.expect_equal(f"{page}: pictures that are not drawn",
                          [name for name in session.pictures if not (folder / name).exists()], [])

    def test_every_page_is_tested(self):
        tested = {name[len("test_"):].replace("_", "-") for name in dir(self) if name.startswith("test_")}
        shown = {page.stem for page in (SOURCE / PAGES).glob("*.md") if Session(f"{PAGES}/{page.name}").commands()}
        self.expect_equal("pages with commands that no test runs", shown - tested, set())

    def test_first_dem_script(self):
        self.check("first-dem-script")

    def test_first_dem_script_liggghts(self):
        self.check("first-dem-script-liggghts")

    def test_first_coupled_bed(self):
        self.check("first-coupled-bed")

    def test_from_powder_data(self):
        self.check("from-powder-data")


if __name__ == "__main__":
    unittest.main()
