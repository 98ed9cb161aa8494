# SPDX-License-Identifier: BSD-3-Clause
"""The script of lammps-package/README.md for Python, with the preload library where the engine has no `plugin load`."""
import math
import os
import re
import subprocess
import sys
import unittest
from pathlib import Path

from cohesion_tests import lammps as engine
from cohesion_tests.readme_python import python_blocks
from cohesion_tests.test_cases import FolderTestCase

HERE = Path(__file__).resolve().parent
README = HERE.parents[1] / "lammps-package" / "README.md"


def library():
    """The one that the engine under test loads."""
    linked = subprocess.run(["ldd", os.environ["COHESION_PLAIN_LMP"]], text=True, stdout=subprocess.PIPE, check=True)
    return re.search(r"liblammps\S* => (\S+)", linked.stdout)[1]


class PythonModule(FolderTestCase):
    def run_script(self, script, preload):
        environment = {**os.environ, "COHESION_LIBRARY": library(), "PYTHONPATH": str(HERE / "library-module")}
        if preload:
            environment["LD_PRELOAD"] = preload
        file = Path(self.folder) / "impact.py"
        file.write_text(script)
        return subprocess.run([sys.executable, str(file)], cwd=self.folder, env=environment, text=True, timeout=100,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT)

    def test_script_of_the_readme(self):
        script, = python_blocks(README)
        preload = os.environ.get("COHESION_PRELOAD")
        if not preload:
            script = script.replace("cohesionplugin.so", engine.plugin())
        done = self.run_script(script, preload)
        self.assertEqual(done.returncode, 0, done.stdout)
        lost = float(re.search(r"lost in the dashpot: (\S+) J", done.stdout)[1])
        reduced_mass = 2650 * math.pi / 6 * 1e-9 / 2
        # Places are rounded by 1e-18 m of an overlap of 1e-6 m, in each of the steps of contact.
        self.assertAlmostEqual(lost / (0.5 * (1 - 0.9**2) * reduced_mass * 0.05**2), 1, delta=1e-10)
        if preload:
            self.assertIsNone(re.search(r"^lost in", self.run_script(script, None).stdout, re.M))


if __name__ == "__main__":
    unittest.main()
