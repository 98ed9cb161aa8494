# SPDX-License-Identifier: BSD-3-Clause
"""The second script of docs/how-to/python.md: the stock library has the styles by the preload library."""
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

from cohesion_studies.mpi_start import short_start
from cohesion_tests.liggghts import program
from cohesion_tests.liggghts_scenes.scene import hamaker, script, sphere
from cohesion_tests.readme_python import python_blocks

PAGE = pathlib.Path(__file__).resolve().parents[2] / "docs/how-to/python.md"
SCENE = script([sphere((0, 0, 0), (0.05, 0, 0)), sphere((1.001e-3, 0, 0))],
               "model hooke/stiffness tangential off cohesion hamaker", hamaker(1e-14), steps=10)


class FromPython(unittest.TestCase):
    def run_page(self, **more):
        _, block = python_blocks(PAGE)
        with tempfile.TemporaryDirectory() as name:
            (pathlib.Path(name) / "in.script").write_text(SCENE)
            done = subprocess.run([sys.executable, "-c", block], cwd=name, timeout=100, text=True, errors="replace",
                                  env={**os.environ, **short_start(), **more}, stdout=subprocess.PIPE,
                                  stderr=subprocess.STDOUT)
        return done

    def test_script_of_the_page(self):
        done = self.run_page(LD_PRELOAD=program("PRELOAD"))
        self.assertEqual(done.returncode, 0, done.stdout)
        self.assertEqual(done.stdout.count("Loop time"), 2, done.stdout)
        self.assertIn("Invalid model specified", self.run_page().stdout)


if __name__ == "__main__":
    unittest.main()
