# SPDX-License-Identifier: BSD-3-Clause
"""A folder for each test, and scripts given as text that LAMMPS takes, or stops at with a message."""
import unittest

import lammps_engine as engine


class FolderTestCase(unittest.TestCase):
    """Each test has a folder of its own, `folder`."""

    def setUp(self):
        keeper = engine.temporary_folder()
        self.addCleanup(keeper.cleanup)
        self.folder = keeper.name


class ScriptTestCase(FolderTestCase):
    def goes(self, script, **options):
        code, output = engine.run_text(script, self.folder, **options)
        self.assertEqual(code, 0, output)
        return output

    def stops(self, script, *words, after_a_run=False, **options):
        """With an error of LAMMPS that has all `words`, before a run has ended."""
        code, output = engine.run_text(script, self.folder, **options)
        # LAMMPS ends orderly with 1 (or through MPI_Abort); a signal would be a crash.
        self.assertEqual(code, 1, output)
        errors = " ".join(line for line in output.splitlines() if "ERROR" in line)
        for word in words:
            self.assertIn(word, errors, output)
        if not after_a_run:
            self.assertNotIn("Loop time", output)
        return output
