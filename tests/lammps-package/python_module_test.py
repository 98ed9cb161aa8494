# SPDX-License-Identifier: BSD-3-Clause
"""The first script of docs/how-to/python.md, with the preload library where the engine has no `plugin load`."""
import os
import re
import subprocess
import sys
import unittest
from pathlib import Path

from cohesion_tests import lammps as engine, page_expected
from cohesion_tests.readme_python import python_blocks
from cohesion_tests.test_cases import FolderTestCase

HERE = Path(__file__).resolve().parent
PAGE = "docs/how-to/python.md"


def library():
    """The one that the engine under test loads."""
    linked = subprocess.run(["ldd", os.environ["COHESION_PLAIN_LMP"]], text=True, stdout=subprocess.PIPE, check=True)
    return re.search(r"liblammps\S* => (\S+)", linked.stdout)[1]


class PythonModule(FolderTestCase):
    def run_script(self, script, preload):
        environment = {**os.environ, "COHESION_LIBRARY": library(), "PYTHONPATH": str(HERE / "library-module")}
        if preload:
            environment["LD_PRELOAD"] = preload
        file = Path(self.folder) / "escape.py"
        file.write_text(script)
        return subprocess.run([sys.executable, str(file)], cwd=self.folder, env=environment, text=True, timeout=100,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT)

    def test_script_of_the_page(self):
        script, _ = python_blocks(HERE.parents[1] / PAGE)
        preload = os.environ.get("COHESION_PRELOAD")
        if not preload:
            script = script.replace("cohesionplugin.so", engine.plugin())
        done = self.run_script(script, preload)
        self.assertEqual(done.returncode, 0, done.stdout)
        self.assertEqual(page_expected.faults(page_expected.expected(PAGE), done.stdout), [])
        if preload:
            self.assertNotIn("escape velocity", self.run_script(script, None).stdout)


if __name__ == "__main__":
    unittest.main()
