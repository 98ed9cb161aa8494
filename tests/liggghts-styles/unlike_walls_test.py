# SPDX-License-Identifier: BSD-3-Clause
"""A wall whose adhesion or softening is not that of the pairs gets a warning that names both, once; walls like the
pairs, and walls that the script declares without adhesion, none. A wall without scheme has that of the pairs."""
import math
import re
import unittest

from cohesion_tests.liggghts import Run
from cohesion_tests.liggghts_scenes import mesh
from cohesion_tests.liggghts_scenes.scene import (MASS, RADIUS, STIFFNESS, hamaker, liquid_bridge, script, sphere,
                                                  square_well, surface_energy)

LINEAR, HERTZ = "model hooke/stiffness tangential off", "model hertz tangential off"
STRENGTHS = {"hamaker": lambda on: hamaker(on * 1e-19, cut=4e-10, out=1e-7), "jkr": lambda on: surface_energy(on * 0.05),
             "square_well": lambda on: square_well(on * 1e-14), "liquid_bridge": lambda on: liquid_bridge(on * 1e-6, 1e-5)}
PLATE = "primitive type 2 zplane -5e-3"
# sjkr and a wall of Hertz's contact need these.
OF_SJKR = "fix ce all property/global cohesionEnergyDensity peratomtypepair 2 100 100 100 100\n"


def base(law):
    return HERTZ if law == "jkr" else LINEAR


class Unlike(unittest.TestCase):
    def printed(self, pairs, wall, properties, ranks=0, inputs=None):
        run = Run(script([sphere((0, 0, 0)), sphere((3e-3, 0, 0))], pairs, properties,
                         wall if isinstance(wall, list) else [f"fix w all wall/gran {wall}"], dt=1e-7,
                         run="run 2\nrun 2\n"), ranks=ranks, inputs=inputs)
        self.assertEqual(run.code, 0, run.output)
        return run.output

    def warned(self, said, *args, **options):
        output = self.printed(*args, **options)
        self.assertEqual(output.count(f"WARNING: {said}"), 1, output)
        self.assertLess(output.index(said), output.index("Step"), output)

    def silent(self, *args, **options):
        output = self.printed(*args, **options)
        for word in ("for the wall", "times the", "for both"):
            self.assertFalse([line for line in output.split("\n") if "WARNING" in line and word in line], output)


class Adhesion(Unlike):
    def none(self, law, wall):
        return (f"fix {wall} wall/gran has no adhesion, and pair_style gran has that of cohesion model {law}: particles "
                f"stick to each other, but not to the wall; use 'cohesion {law}' for the wall, or 'cohesion off' if "
                "nothing shall stick to it")

    def test_missing(self):
        for law, strength in STRENGTHS.items():
            for ranks in (0, 2) if law == "hamaker" else (0,):
                with self.subTest(law, ranks=ranks):
                    self.warned(self.none(law, "w"), f"{base(law)} cohesion {law}", f"{base(law)} {PLATE}", strength(1),
                                ranks=ranks)

    def test_missing_at_a_mesh(self):
        plate = {"plate.stl": mesh.stl(mesh.rectangle((-5e-3, -5e-3, -5e-3), (1e-2, 0, 0), (0, 1e-2, 0)))}
        for law, strength in STRENGTHS.items():
            with self.subTest(law):
                self.warned(self.none(law, "platewall"), f"{base(law)} cohesion {law}", mesh.wall(base(law)),
                            strength(1), inputs=plate)

    def test_another_law(self):
        both = STRENGTHS["hamaker"](1) + STRENGTHS["square_well"](1)
        self.warned("fix w wall/gran has the adhesion of cohesion model square_well, and pair_style gran that of cohesion "
                    "model hamaker: a particle sticks to the wall and to another particle by different criteria; use "
                    "'cohesion hamaker' for the wall", f"{LINEAR} cohesion hamaker",
                    f"{LINEAR} cohesion square_well {PLATE}", both)
        self.warned("fix w wall/gran has the adhesion of cohesion model sjkr, and pair_style gran that of cohesion model "
                    "jkr", f"{HERTZ} cohesion jkr", f"{HERTZ} cohesion sjkr {PLATE}", STRENGTHS["jkr"](1) + OF_SJKR)

    def test_right_ones(self):
        """Also a wall that attracts beside pairs that do not: a plate that catches grains."""
        for law, strength in STRENGTHS.items():
            models = f"{base(law)} cohesion {law}"
            with self.subTest(law):
                self.silent(models, f"{models} {PLATE}", strength(1))
                self.silent(models, f"{base(law)} cohesion off {PLATE}", strength(1))
                self.silent(models, f"{base(law)} {PLATE}", strength(0))
        self.silent(f"{LINEAR} cohesion hamaker", f"{LINEAR} cohesion hamaker {PLATE}",
                    hamaker(0, 1e-19, cut=4e-10, out=1e-7))


class Softening(Unlike):
    MODELS = f"{LINEAR} cohesion hamaker"

    def of(self, of_wall):
        """K is 800 N/m; that of the material is 8e5 N/m between spheres, and `of_wall` beside the wall, of type 2."""
        return STRENGTHS["hamaker"](1) + ("fix km all property/global materialStiffness peratomtypepair 2 "
                                          f"8e5 {of_wall} {of_wall} 8e5\n")

    def test_another_material(self):
        self.warned("fix w wall/gran has 0.1 times the stiffness of the material (f = 0.316), and pair_style gran has 0.001 "
                    "times the stiffness of the material (f = 0.0316)", f"{self.MODELS} material_stiffness on",
                    f"{self.MODELS} {PLATE} material_stiffness on", self.of(8e3))

    def test_another_modulus(self):
        """E is 5e6 Pa for all; of a wall of E_m2 the reduced modulus of the material is the harmonic mean of both."""
        for law in ("hamaker", "jkr"):
            models = f"{HERTZ} cohesion {law}"

            def properties(of_wall):
                return STRENGTHS[law](1) + f"fix Em all property/global materialYoungsModulus peratomtype 5e9 {of_wall}\n"
            with self.subTest(law):
                self.warned("fix w wall/gran has 0.01 times the modulus E* of the material (f = 0.158), and pair_style gran "
                            "has 0.001 times the modulus E* of the material (f = 0.0631)", f"{models} material_modulus on",
                            f"{models} {PLATE} material_modulus on", properties(5e9 / 19))
                self.warned("pair_style gran has 0.001 times the modulus E* of the material (f = 0.0631), by which its "
                            "adhesion is scaled, and fix w wall/gran has no material", f"{models} material_modulus on",
                            f"{models} {PLATE}", properties(5e9))
                self.silent(f"{models} material_modulus on", f"{models} {PLATE} material_modulus on", properties(5e9))

    def test_the_same_material(self):
        self.silent(f"{self.MODELS} material_stiffness on", f"{self.MODELS} {PLATE} material_stiffness on", self.of(8e5))
        self.silent(self.MODELS, f"{self.MODELS} {PLATE}", self.of(8e3))

    def test_one_without_material(self):
        self.warned("pair_style gran has 0.001 times the stiffness of the material (f = 0.0316), by which its adhesion is "
                    "scaled, and fix w wall/gran has no material: a particle sticks to the wall and to another particle "
                    "by different criteria; give 'material_stiffness on' with fix property/global materialStiffness "
                    "for both", f"{self.MODELS} material_stiffness on", f"{self.MODELS} {PLATE}", self.of(8e5))


class SchemeOfThePairs(unittest.TestCase):
    """A wall without the keyword has the scheme that the pairs have in each run."""
    STRENGTHS = {"hamaker": hamaker(1e-15, cut=1e-6, out=2e-5), "square_well": square_well(1e-11),
                 "liquid_bridge": liquid_bridge(1e-4, 2e-5)}
    PLATES = {"primitive": lambda models: [f"fix platewall all wall/gran {models} primitive type 2 zplane 0"],
              "mesh": mesh.wall}

    def printed_and_frames(self, models, schemes, law, place, velocity=(0, 0, 0), plate="primitive", new_wall=False,
                           steps=3000):
        wall = self.PLATES[plate](models)
        runs = f"run {steps}\n"
        for scheme in schemes[1:]:
            again = f"unfix platewall\n{wall[-1]}\n" if new_wall else ""
            runs += f"pair_style gran {models} scheme {scheme}\npair_coeff * *\n{again}run {steps}\n"
        text = script([sphere(place, velocity), sphere((3e-3, 0, 5e-3))], f"{models} scheme {schemes[0]}",
                      self.STRENGTHS[law], wall, run=runs, dt=1e-6, every=10)
        run = Run(text, inputs={"plate.stl": mesh.stl(mesh.rectangle((-5e-3, -5e-3, 0), (1e-2, 0, 0), (0, 1e-2, 0)))})
        self.assertEqual(run.code, 0, run.output)
        self.assertNotIn("give both the same scheme", run.output)
        printed = re.findall(r"fix wall/gran platewall, scheme (\w+): what to expect", run.output)
        self.assertEqual(printed, list(schemes))
        return [frame[1] for frame in run.frames("out.txt")]

    def test_impact_after_a_change(self):
        """As with a wall that is made behind the pair_style, bit by bit."""
        for law in self.STRENGTHS:
            for plate in self.PLATES if law == "hamaker" else ("primitive",):
                for schemes in (("exact", "sampled"), ("sampled", "exact")):
                    with self.subTest(law, schemes=schemes, plate=plate):
                        models = f"{LINEAR} cohesion {law}"
                        same, new = (self.printed_and_frames(models, schemes, law, (0, 0, 1.2e-3), (0.01, 0, -0.2), plate,
                                                             new_wall) for new_wall in (False, True))
                        self.assertEqual(same, new)
                        self.assertGreater(same[-1][5], 0.0)  # it has met the wall

    def test_grain_on_the_wall(self):
        """It swings about its resting overlap F/K as far as at the start, F/K, less the dashpot's; each change moves
        velocities by half a step, w dt/2 of that with w = sqrt(K/m)."""
        rest = 1e-15 * RADIUS / (6 * 1e-6**2) / STIFFNESS
        shift = 0.5e-6 * math.sqrt(STIFFNESS / MASS)
        frames = self.printed_and_frames(f"{LINEAR} cohesion hamaker", ("exact", "sampled", "exact"), "hamaker",
                                         (0, 0, RADIUS), steps=300)
        self.assertLess(max(abs(RADIUS - frame[2] - rest) for frame in frames), (1 + 2.5 * shift) * rest)
        self.assertGreater(max(RADIUS - frame[2] for frame in frames), rest)


if __name__ == "__main__":
    unittest.main()
