# SPDX-License-Identifier: BSD-3-Clause
"""What cannot be right about cohesion square_well ends the run before its first step."""

import unittest

from cohesion_tests.liggghts import Run, assert_refused
from cohesion_tests.liggghts_scenes.mesh import rectangle, stl, wall
from cohesion_tests.liggghts_scenes.scene import RADIUS, hamaker, script, sphere, square_well

MODELS = "model hertz tangential history cohesion square_well"
FLOOR = ["primitive type 2 zplane -5e-3"]


class BadInput(unittest.TestCase):
    def run_with(self, properties, **options):
        return Run(script([sphere((0, 0, 0))], MODELS, properties, **options))

    def refused(self, properties, *messages, **options):
        assert_refused(self, self.run_with(properties, **options), *messages)

    def refused_words(self, models, message):
        with self.subTest(message):
            run = Run(script([sphere((0, 0, 0))], models, square_well(1e-11), run="run 1\n"))
            assert_refused(self, run, message)

    def test_depth(self):
        for bad, shown in (("-1e-11", "-1e-11"), ("1e999", "inf")):
            with self.subTest(bad=bad):
                self.refused(square_well(1e-11).replace("2 1e-11 2e-11 2e-11", f"2 1e-11 {bad} {bad}"),
                             "cohesion model square_well, atom types 1 and 2",
                             "depth D of the well = " + shown,
                             "must be a finite number not below zero",
                             "fix property/global wellDepth = " + shown, walls=FLOOR)

    def test_ratio(self):
        for bad, shown in (("0.99", "0.99"), ("0", "0"), ("-1.01", "-1.01"), ("1e999", "inf")):
            with self.subTest(bad=bad):
                self.refused(square_well(1e-11, ratio=1.5).replace("1.5", bad), "ratio r_out/r of the well",
                             "must be a finite number not below 1: the well is outside the core",
                             "wellRatio = " + shown)
        self.refused(square_well(1e-11, ratio=3.5), "ratio r_out/r of the well = 3.5", "must not be above 3",
                     "wellRatio = 3.5")

    def test_scheme(self):
        self.refused_words(MODELS + " scheme sometimes",
                           "cohesion model square_well, scheme sometimes: must be exact or sampled")
        for models in (MODELS, MODELS.replace("hertz", "hooke")):
            self.refused_words(models + " scheme exact limitForce on", "cuts the force off where the dashpot pulls")
            for scheme in ("sampled", "exact"):
                text = script([sphere((0, 0, 0))], f"{models} scheme {scheme}", square_well(1e-11))
                self.assertEqual(Run(text).code, 0)

    def test_missing_property(self):
        for missing in ("wellDepth", "wellRatio"):
            with self.subTest(missing=missing):
                lines = [line for line in square_well(1e-11).splitlines() if missing not in line]
                self.assertEqual(len(lines), 1)
                self.refused("\n".join(lines) + "\n", missing, "cohesion model square_well")

    def test_properties_of_the_other_model_do_not_help(self):
        self.refused(hamaker(1e-18), "wellDepth", "cohesion model square_well")

    def test_primitive_wall_sees_half_the_skin(self):
        width = 0.2 * RADIUS
        self.refused(square_well(1e-11, ratio=1.2), "cohesion model square_well, fix wall/gran wall0",
                     "the width (wellRatio - 1) r of the well = 0.0001",
                     "half the neighbor skin of 0.00019", "use 'neighbor 0.0002 bin' or more",
                     walls=FLOOR, skin=1.9 * width)
        self.assertEqual(self.run_with(square_well(1e-11, ratio=1.2), walls=FLOOR,
                                       skin=2.1 * width).code, 0)

    def test_a_mesh_wall_sees_as_far_as_the_well(self):
        mesh = stl(rectangle((-9e-3, -9e-3, -5e-3), (18e-3, 0, 0), (0, 18e-3, 0)))
        models = MODELS
        run = Run(script([sphere((0, 0, 0))], models, square_well(1e-11, ratio=1.2),
                         walls=wall(models), skin=1e-5), inputs={"plate.stl": mesh})
        self.assertEqual(run.code, 0, run.output)


if __name__ == "__main__":
    unittest.main()
