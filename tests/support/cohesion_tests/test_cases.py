# SPDX-License-Identifier: BSD-3-Clause
"""A folder for each test, and scripts given as text that LAMMPS takes, or refuses with a message."""
import unittest

from cohesion_tests import lammps
from cohesion_tests.refusals import assert_refused


class FolderTestCase(unittest.TestCase):
    """Each test has a folder of its own, `folder`."""

    def setUp(self):
        keeper = lammps.temporary_folder()
        self.addCleanup(keeper.cleanup)
        self.folder = keeper.name


class ScriptTestCase(FolderTestCase):
    def goes(self, script, **options):
        code, output = lammps.run_text(script, self.folder, **options)
        self.assertEqual(code, 0, output)
        return output

    def stops(self, script, *words, after_a_run=False, **options):
        """With an error of LAMMPS that has all `words`, before a run has ended; gives what was printed."""
        code, output = lammps.run_text(script, self.folder, **options)
        assert_refused(self, code, output, *words, begun=after_a_run)
        return output
