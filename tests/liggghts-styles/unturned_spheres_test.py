# SPDX-License-Identifier: BSD-3-Clause
"""Spheres with friction that a fix moves and does not turn get a warning, once; all others none."""
import unittest

from cohesion_tests.liggghts import Run
from cohesion_tests.liggghts_scenes.scene import hamaker, script, sphere

OFF, SLIDES, ROLLS = (f"model hooke/stiffness tangential {words}" for words in (
    "off cohesion hamaker", "history cohesion hamaker", "off cohesion hamaker rolling_friction cdt"))
RUN = "run 1\nrun 1\n"


class Unturned(unittest.TestCase):
    def run_moved(self, models, move, ranks=0, **options):
        spheres = [sphere((x, 0, 0)) for x in (-4e-3, 0.0, 4e-3)]
        text = script(spheres, models, hamaker(0), run=RUN, **options)
        groups = "group first id 1\ngroup second id 2 3\n"
        run = Run(text.replace("fix move all nve/sphere", groups + move), ranks=ranks)
        self.assertEqual(run.code, 0, run.output[-2000:])
        return run.output

    def test_warned(self):
        wall = [f"fix floor all wall/gran {SLIDES} primitive type 2 zplane -5e-3"]
        for models, move, number, fix, options in (
                (SLIDES, "fix move all nve", 3, "move nve", {}),
                (SLIDES, "fix move all nve", 3, "move nve", dict(ranks=2)),
                (ROLLS, "fix move all nve/limit absolute 1", 3, "move nve/limit", {}),
                (SLIDES, "fix a first nve/sphere\nfix b second nve", 2, "b nve", {}),
                (OFF, "fix move all nve", 3, "move nve", dict(walls=wall))):
            with self.subTest(models=models, move=move, **options):
                printed = self.run_moved(models, move, **options)
                self.assertEqual(printed.count("does not turn"), 1, printed)
                self.assertIn(f"WARNING: friction acts on {number} particles that fix {fix} moves and does not turn",
                              printed)

    def test_right_ones(self):
        without = [line for line in script([], SLIDES).split("\n") if "coefficientFriction" in line]
        self.assertEqual(len(without), 1)
        for models, move in ((OFF, "fix move all nve"), (SLIDES, "fix move all nve/sphere"),
                             (SLIDES, "fix move all nve\nfix still all freeze"),
                             (SLIDES, "fix move all nve/noforce"),
                             (SLIDES, without[0].replace("0.3", "0.0") + "\nfix move all nve")):
            with self.subTest(models=models, move=move):
                self.assertNotIn("does not turn", self.run_moved(models, move))


if __name__ == "__main__":
    unittest.main()
