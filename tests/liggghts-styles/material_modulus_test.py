# SPDX-License-Identifier: BSD-3-Clause
"""`material_modulus on` of cohesion hamaker and jkr with model hertz: what the run keeps of the material and prints, and
what it refuses."""
import re
import unittest

from cohesion_tests.liggghts import Run, assert_refused
from cohesion_tests.liggghts_scenes.advice_table import A, CUT, FLOOR, LINEAR, OUT, SPEED, THREE, go, rows
from cohesion_tests.liggghts_scenes.scene import contact, hamaker, script, sphere, surface_energy


class ModulusScaling(unittest.TestCase):
    """Of Hertz's contact f = (E*/E*_m)^(2/5), and the dashpot of a restitution is that of any modulus."""
    RATIO = 1e-3
    LAWS = {"hamaker": hamaker(A, cut=CUT, out=OUT), "jkr": surface_energy(0.05)}
    SOFT, STIFF = 5e6, 5e9

    def run_of(self, law, modulus, words="", of_material=None):
        stiffer = contact().replace("youngsModulus peratomtype 5e6 5e6", f"youngsModulus peratomtype {modulus} {modulus}")
        material = "" if of_material is None else (
            f"fix Em all property/global materialYoungsModulus peratomtype {of_material} {of_material}\n")
        models = f"model hertz tangential off cohesion {law}"
        text = script([sphere((0, 0, 0), (SPEED, 0, 0)), sphere((3e-3, 0, 0))], f"{models} {words}",
                      self.LAWS[law] + material, contacts=stiffer, dt=1e-9,
                      walls=[f"fix w all wall/gran {models} {FLOOR} {words}"])
        return Run(text.replace("units si\n", "units si\nhard_particles yes\n"))

    def test_as_many_stick_as_of_the_material(self):
        modulus = self.STIFF / (2 * (1 - 0.3**2))
        for law in self.LAWS:
            with self.subTest(law):
                words = "scheme exact"
                stiff, soft = (self.run_of(law, e, words) for e in (self.STIFF, self.SOFT))
                scaled = self.run_of(law, self.SOFT, f"{words} material_modulus on", self.STIFF)
                for name in ("1 - 1", "1 - wall"):
                    material, found = rows(stiff)[name]["escape"], rows(scaled)[name]["escape"]
                    self.assertAlmostEqual(found, material, delta=THREE * material)
                    self.assertGreater(rows(soft)[name]["escape"], 2 * material)
                    self.assertIn(f"modulus E* {self.RATIO * modulus:.6g} for {modulus:.6g} of the material: escape "
                                  f"velocity 1, pull-off force 0.0631 times the material's ({name})", scaled.output)
                self.assertIn(f"cohesion model {law}, atom types 1 and 1: adhesion scaled from modulus E* {modulus:.6g} to "
                              f"{self.RATIO * modulus:.6g}, which keeps the escape velocity: ", scaled.output)
        self.assertIn("work of adhesion 0.1 -> 0.00630957", scaled.output)

    def test_the_force_can_be_kept_instead(self):
        for law in self.LAWS:
            with self.subTest(law):
                stiff, soft = (self.run_of(law, e, "scheme exact") for e in (self.STIFF, self.SOFT))
                kept = self.run_of(law, self.SOFT, "scheme exact material_modulus on material_keep force", self.STIFF)
                self.assertEqual(rows(kept), rows(soft))
                escape = rows(soft)["1 - 1"]["escape"] / rows(stiff)["1 - 1"]["escape"]
                found = re.search("escape velocity (\\S+), pull-off force 1 times the material's \\(1 - 1\\)", kept.output)
                self.assertAlmostEqual(float(found[1]), escape, delta=3 * THREE * escape)  # of three printed numbers
                self.assertIn("which keeps the pull-off force", kept.output)

    def test_nothing_to_scale(self):
        for law in self.LAWS:
            for of_material in (self.SOFT, 0.0):
                with self.subTest(law, of_material=of_material):
                    run = self.run_of(law, self.SOFT, "scheme exact material_modulus on", of_material)
                    self.assertEqual(run.code, 0, run.output[-1000:])
                    for words in ("adhesion scaled", "of the material"):
                        self.assertNotIn(words, run.output)

    def test_warned_and_refused(self):
        for law in self.LAWS:
            with self.subTest(law):
                self.assertIn("but material_modulus is off", self.run_of(law, self.SOFT, "scheme exact", self.STIFF).output)
                for words, of_material, message in (
                        ("material_modulus on", None, "materialYoungsModulus"),
                        ("material_modulus on", -1.0, "materialYoungsModulus = -1: must be"),
                        ("material_modulus on", 1e6, "a contact must not be stiffer than its material"),
                        ("material_keep force", self.STIFF, "material_keep force needs")):
                    assert_refused(self, self.run_of(law, self.SOFT, f"scheme exact {words}", of_material), message)
        assert_refused(self, self.run_of("jkr", self.SOFT, "scheme exact material_stiffness on", self.STIFF),
                       "material_stiffness")
        run = go(f"{LINEAR} material_modulus on", self.LAWS["hamaker"])
        assert_refused(self, run, "model hooke/stiffness has no such number for two types")


if __name__ == "__main__":
    unittest.main()
