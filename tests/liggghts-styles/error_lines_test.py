# SPDX-License-Identifier: BSD-3-Clause
"""An error of the package ends the output with its message.

LIGGGHTS draws, with rand(), whether it adds a jest to an error, and prints it from memory that it has freed: bytes of
no character set. COHESION_JESTS, preloaded, makes it draw one at every error.
"""

import os
import unittest
from unittest import mock

from cohesion_tests.liggghts import Run, assert_refused
from cohesion_tests.liggghts_scenes.scene import hamaker, script, sphere, square_well

LINEAR = "model hooke/stiffness tangential off cohesion "
ATTRACTION = hamaker(1e-18, 0, 4e-10, 1e-7)


def lines_after_error(output):
    lines = output.split("\n")
    first = next(k for k, line in enumerate(lines) if line.startswith("ERROR"))
    return [line for line in lines[first + 1:] if line]


class ErrorLines(unittest.TestCase):
    def run_with_jests(self, models, properties=ATTRACTION, spheres=((0, 0, 0),), extra=""):
        text = script([sphere(place) for place in spheres], models, properties, run="run 1\n", extra=extra)
        with mock.patch.dict(os.environ, LD_PRELOAD=os.environ["COHESION_JESTS"]):
            return Run(text)

    def test_the_engine_itself_adds_a_line(self):
        """Else the other test proves nothing."""
        run = self.run_with_jests(LINEAR + "hamaker absolute_damping perhaps")
        self.assertNotEqual(run.code, 0)
        self.assertTrue(lines_after_error(run.output), run.output[-2000:])

    def test_errors_of_the_package(self):
        together = ((0, 0, 0), (0, 0, 0))
        for models, options, message in (
                ("hamaker scheme sometimes", {}, "must be exact or sampled"),
                ("hamaker scheme exact tangential history", {}, "keywords come last"),
                ("hamaker material_keep all", {}, "material_keep"),
                ("hamaker material_keep force", {}, "needs 'material_stiffness on'"),
                ("hamakr", {}, "hamaker"),
                ("jkr", {}, "needs 'model hertz'"),
                ("hamaker", dict(properties=hamaker(-1e-18, 0, 4e-10, 1e-7)), "must be a finite number"),
                ("square_well", dict(properties=square_well(1e-11, ratio=0.5)), "not below 1"),
                ("hamaker", dict(spheres=together), "are in one place"),
                ("hamaker", dict(extra="fix a all agglomerates 0\n"), "it must be 1 or more"),
                ("hamaker", dict(extra="compute e all gran/energy more\n"), "gran/energy")):
            with self.subTest(models, **options):
                run = self.run_with_jests(LINEAR + models, **options)
                assert_refused(self, run, message)
                self.assertEqual(lines_after_error(run.output), [])


if __name__ == "__main__":
    unittest.main()
