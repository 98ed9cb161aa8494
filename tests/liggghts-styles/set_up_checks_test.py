# SPDX-License-Identifier: BSD-3-Clause
"""What cannot be meant stops a run before its first step: two spheres in one
place, units that are not mechanical; a Hamaker constant that no material has is named before a stiffness that would
bear it."""
import unittest

from cohesion_tests import refusals
from cohesion_tests.liggghts import Run
from cohesion_tests.liggghts_scenes.scene import hamaker, script, sphere

MODELS = "model hooke/stiffness tangential off cohesion hamaker"
SCHEMES = ("", " scheme exact")


class SetUp(unittest.TestCase):
    def stops(self, text, *words, ranks=0):
        run = Run(text, ranks=ranks)
        refusals.assert_refused(self, run.code, run.output, *words)

    def two(self, scheme, place=(2e-3, 0, 0), constant=1e-19, **options):
        return script([sphere((0, 0, 0)), sphere(place)], MODELS + scheme, hamaker(constant, cut=4e-10, out=1e-7),
                      run="run 10\n", **options)

    def test_density_before_the_diameter(self):
        """This engine keeps the density, and the mass follows."""
        for scheme in SCHEMES:
            text = self.two(scheme, dt=1e-8)
            start = text.index("set atom 1")
            end = text.index("fix E all")
            late = "set group all density 1500\nset group all diameter 75e-6\n"
            run = Run(text[:start] + late + text[end:])
            self.assertEqual(run.code, 0, run.output)

    def test_two_in_one_place(self):
        for scheme in SCHEMES:
            for ranks in (0, 2):
                with self.subTest(scheme, ranks=ranks):
                    self.stops(self.two(scheme, place=(0, 0, 0)), "particles 1 and 2 are in one place, (0, 0, 0)",
                               ranks=ranks)
            run = Run(self.two(scheme, place=(0, 0, 0)).replace("fix move all nve/sphere\n", ""))
            self.assertEqual(run.code, 0, run.output)

    def test_units(self):
        """Some the engine itself refuses."""
        for units, says in (("real", "non-consistent unit system"), ("metal", "non-consistent unit system"),
                            ("electron", "in 'units electron' force is not mass times acceleration")):
            for scheme in SCHEMES:
                with self.subTest(scheme, units=units):
                    self.stops(self.two(scheme).replace("units si", f"units {units}"), says)

    def test_time_step(self):
        for scheme in SCHEMES:
            for step in (0, -1e-8):
                with self.subTest(scheme, step=step):
                    self.stops(self.two(scheme, dt=step), "cohesion model hamaker:", f"timestep {step:g}: give a time step"
                               " above 0")

    def test_constant_that_no_material_has(self):
        """F_ad = A R*/(6 H_cut^2): 2.6 N at 1e-14 J, four times the diameter in the spring."""
        for scheme in SCHEMES:
            self.stops(self.two(scheme, constant=1e-14), "the Hamaker constant A = 1e-14 J is above that of any material "
                       "(1e-21 to 1e-18 J): check its value and its unit; the overlap of a resting pair", "raise the stiffness")


if __name__ == "__main__":
    unittest.main()
