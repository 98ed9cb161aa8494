# SPDX-License-Identifier: BSD-3-Clause
"""The pages of a folder, COHESION_PAGES, that have commands run as they are printed: their files in an empty folder,
then their commands. They print what the pages show and the results that they expect, and draw the pages' pictures, which stay in
the folder of the test. Printed files warn of nothing."""

import os
import shutil
import unittest
from pathlib import Path

from cohesion_tests import SOURCE, page_expected
from cohesion_tests.coupling.test_case import CoupledTestCase
from cohesion_tests.page_session import Session


class Pages(CoupledTestCase):
    def check(self, page):
        session = Session(str(page.relative_to(SOURCE)))
        folder = self.work / page.stem
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir(parents=True)
        # cohesion-powder is among the programs of an installation, and in a folder of its own in a build.
        tools = Path(os.environ["COHESION_POWDER"]).parent
        environment = self._columns.environment
        code, output = session.run(folder, {**environment, "PATH": f"{environment['PATH']}:{tools}"})
        self.expect_equal(f"code\n{output[-3000:]}", code, 0)
        logs = [output, *(log.read_text() for log in folder.rglob("log.*"))]
        warnings = [line for log in logs for line in log.splitlines()
                    if line.startswith("WARNING") or "in file openfoam-coupling" in line]
        if any("cohesion-powder" in line for line in session.commands()):
            # Its grains may leave the range of the drag law.
            warnings = [line for line in warnings if "dragValidity" not in line]
        self.expect_equal("warnings", warnings, [])
        said = {" ".join(line.split()) for log in logs for line in log.splitlines()}
        self.expect_equal("lines that nothing printed", [x for x in session.printed() if x not in said], [])
        self.expect_equal("results", page_expected.faults(page_expected.expected(session.page), "\n".join(logs)), [])
        self.expect_equal("pictures that are not drawn",
                          [name for name in session.pictures if not (folder / name).exists()], [])


def add_tests():
    for page in sorted((SOURCE / os.environ["COHESION_PAGES"]).glob("*.md")):
        if Session(str(page.relative_to(SOURCE))).commands():
            setattr(Pages, f"test_{page.stem.replace('-', '_')}", lambda self, page=page: self.check(page))


add_tests()

if __name__ == "__main__":
    unittest.main()
