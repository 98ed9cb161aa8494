# SPDX-License-Identifier: BSD-3-Clause
"""A plugin that is loaded and not used changes no bit of a run. (For its time see
unused-plugin-ratio.py.)"""
import os
import unittest
from pathlib import Path

from cohesion_tests import lammps as engine


def end(load, **options):
    with engine.temporary_folder() as folder:
        engine.run("in.granular", folder, load=load, side=8, steps=2000, **options)
        return (Path(folder) / "end.txt").read_text()


class UnusedPlugin(unittest.TestCase):
    def test_trajectories_are_the_same(self):
        without = end("no", lmp=os.environ["COHESION_PLAIN_LMP"])
        self.assertEqual(without.count("\n"), 8**3 + 9)
        self.assertEqual(end("yes"), without)


if __name__ == "__main__":
    unittest.main()
