# SPDX-License-Identifier: BSD-3-Clause
"""What cannot be right ends the run before its first step, with a message that helps."""

import re
import unittest

from cohesion_tests.liggghts import SCENES, Run, assert_refused, script_without
from cohesion_tests.liggghts_scenes.scene import hamaker, script, sphere

PAIR = dict(radius1=0.5e-3, radius2=0.5e-3, type1=1, type2=2, gap=1e-9, A=1e-18, cut=4e-10,
            out=1e-7, model="hertz", tangential="history")
WALL = dict(radius=0.5e-3, gap=1e-9, A=1e-18, cut=4e-10, out=1e-7, model="hertz",
            tangential="history", skin=1e-4, wall="primitive type 2 zplane 0")

LINEAR = "model hooke/stiffness tangential off cohesion hamaker"


class BadInput(unittest.TestCase):
    def refused(self, script, *messages, **variables):
        assert_refused(self, Run(script, **variables), *messages)

    def test_hamaker_constant(self):
        for bad, shown in (("-1e-18", "-1e-18"), ("1e999", "inf")):
            with self.subTest(bad=bad):
                script = (SCENES / "in.two_spheres").read_text().replace(
                    "$A ${A12} ${A12} ${A22}", f"1e-18 {bad} {bad} 1e-18")
                self.refused(script, "cohesion model hamaker, atom types 1 and 2",
                             "Hamaker constant A = " + shown,
                             "must be a finite number not below zero",
                             "fix property/global hamakerConstant = " + shown, **PAIR)

    def test_numbers_that_the_engine_itself_refuses(self):
        self.refused("in.two_spheres", "Expected floating point parameter", **{**PAIR, "cut": "nan"})

    def test_surface_cutoff(self):
        for bad, remedy in ((0.0, "must be a finite number greater than zero"),
                            (-4e-10, "must be a finite number greater than zero"),
                            (1e-7, "must be smaller than the outer cut-off"),
                            (2e-7, "must be smaller than the outer cut-off")):
            with self.subTest(bad=bad):
                self.refused("in.two_spheres", "surface cut-off H_cut = ", remedy,
                             f"hamakerSurfaceCutoff = {bad:g}", "hamakerOuterCutoff = 1e-07",
                             **{**PAIR, "cut": bad})

    def test_outer_cutoff(self):
        for bad, shown in (("0", "0"), ("-1e-7", "-1e-07"), ("1e999", "inf")):
            with self.subTest(bad=bad):
                self.refused("in.two_spheres", "must be a finite number greater than zero",
                             "hamakerOuterCutoff = " + shown, **{**PAIR, "out": bad})

    def test_cutoffs_that_are_not_far_below_the_radius(self):
        # Radii of 0.5 mm: R* = 0.25 mm.
        self.refused("in.two_spheres", "surface cut-off H_cut = 0.4: must not be above 2.5e-05",
                     "hamakerOuterCutoff = 100", **{**PAIR, "cut": 0.4, "out": 100.0})
        self.refused("in.two_spheres", "outer cut-off H_out = 0.0003: must not be above 0.00025",
                     "hamakerOuterCutoff = 0.0003", **{**PAIR, "out": 3e-4})
        self.assertEqual(Run("in.two_spheres", **{**PAIR, "out": 2.4e-4}).code, 0)

    def test_cutoffs_are_judged_by_the_radii_of_their_types(self):
        # Type 1, 1 mm: A > 0 and H_out = 3e-5 m, beyond the 2.5e-5 m of the 0.1 mm of type 2.
        def go(a22, radius2=0.05e-3, extra=""):
            text = script([sphere((0, 0, 0)), sphere((3e-3, 0, 0), radius=radius2)], LINEAR,
                          hamaker(1e-18, 0, 1e-9, 3e-5), dt=1e-7, steps=1, extra=extra)
            text = text.replace("set atom 2", "set atom 2 type 2\nset atom 2")
            return Run(text.replace("0.0 0.0 1e-18\nfix cut", f"0.0 0.0 {a22}\nfix cut"))
        done = go(0.0)
        self.assertEqual(done.code, 0, done.output[-2000:])
        assert_refused(self, go(1e-18), "atom types 2 and 2: outer cut-off H_out = 3e-05: must not be above 2.5")
        # Still to come: as small, of a type that attracts.
        template = ("fix pts all particletemplate/sphere 15485863 atom_type {} volume_limit 1e-14 density "
                    "constant 2650 radius constant 0.05e-3\n"
                    "fix pdd all particledistribution/discrete 15485867 1 pts 1.0\n")
        assert_refused(self, go(0.0, 0.5e-3, template.format(1)), "atom types 1 and 1: outer cut-off H_out = 3e-05")
        done = go(0.0, 0.5e-3, template.format(2))
        self.assertEqual(done.code, 0, done.output[-2000:])

    def test_scaled_cutoff_in_which_pairs_would_turn_wrongly(self):
        """H_cut of 2e-5 m of a material four times as stiff becomes 4.2e-5 m, above a thirtieth of the distance of two
        of 1 mm; scheme sampled evaluates the force where the pair is."""
        def go(scheme, cut):
            properties = hamaker(1e-18, 0, cut, 2.4e-4) + (
                "fix km all property/global materialStiffness peratomtypepair 2 3200 3200 3200 3200\n")
            return Run(script([sphere((0, 0, 0)), sphere((1.0001e-3, 0, 0))],
                              f"{LINEAR} scheme {scheme} absolute_damping on material_stiffness on", properties,
                              dt=1e-7, steps=1, skin=3e-4))
        assert_refused(self, go("exact", 2e-5), "surface cut-off H_cut of the contact = 4.",
                       "must not be above 3.33", "scheme exact turns pairs as if they touched")
        for scheme, cut in (("sampled", 2e-5), ("exact", 1e-5)):
            done = go(scheme, cut)
            self.assertEqual(done.code, 0, done.output[-2000:])

    def test_beside_a_wall_the_radius_counts(self):
        # Wall of type 2, radius 0.08 mm: H_out = 6e-5 m is beyond R* of two, 4e-5 m, and below that with the wall.
        def go(out, pairs=0.0):
            properties = hamaker(pairs, 1e-18, 1e-9, out)
            return Run(script([sphere((0, 0, 0), radius=0.08e-3)], LINEAR, properties, dt=1e-7, steps=1, skin=3e-4,
                              walls=["primitive type 2 zplane -5e-3"]))
        done = go(6e-5)
        self.assertEqual(done.code, 0, done.output[-2000:])
        assert_refused(self, go(6e-5, 1e-18), "outer cut-off H_out = 6e-05: must not be above 4e-05")
        assert_refused(self, go(9e-5), "outer cut-off H_out = 9e-05: must not be above 8e-05")

    def test_spheres_of_the_size_they_were_created_with(self):
        created = "create_atoms 1 single 0.002 0.002 0.002 units box\npair_style"
        script = (SCENES / "in.two_spheres").read_text().replace("pair_style", created, 1)
        self.refused(script, "cohesion model hamaker: particle 4 has the diameter 1, others as little as 0.001",
                     "lengths are those of 'units si', m", "until 'set ... diameter'", **PAIR)

    def test_particles_larger_than_the_box(self):
        self.refused("in.two_spheres", "radius of a particle = ", "must not be above the longest side of the box",
                     **{**PAIR, "radius1": 5.0, "radius2": 5.0})

    def test_missing_property(self):
        for name in ("hamakerConstant", "hamakerSurfaceCutoff", "hamakerOuterCutoff"):
            with self.subTest(name=name):
                self.refused(script_without("in.two_spheres", name), name, "cohesion model hamaker",
                             **PAIR)

    def test_combination_that_does_not_exist(self):
        two = (SCENES / "in.two_spheres").read_text()
        self.refused(two, "cohesion model hamaker is not combined with 'model luding', but with 'model' hertz, "
                     "hertz/stiffness, hooke, hooke/stiffness", **{**PAIR, "model": "luding"})
        self.refused(two.replace("cohesion hamaker", "cohesion hamaker rolling_friction luding"),
                     "not combined with 'rolling_friction luding', but with 'rolling_friction' off, cdt, epsd2", **PAIR)

    def test_a_model_that_the_engine_does_not_have_is_named(self):
        two = (SCENES / "in.two_spheres").read_text()
        for model in ("rolling_friction nonsense", "surface nonsense"):
            self.refused(two.replace("cohesion hamaker", "cohesion hamaker " + model), f"there is no '{model}'", **PAIR)
        self.refused(two, "there is no 'model nonsense'", **{**PAIR, "model": "nonsense"})
        self.refused(two, "there is no 'tangential nonsense'", "off, history, no_history", **{**PAIR, "tangential": "nonsense"})
        self.refused(two.replace("cohesion hamaker", "cohesion hamakr"), "there is no 'cohesion hamakr'",
                     "cohesion hamaker, jkr, liquid_bridge, square_well", **PAIR)
        wall = (SCENES / "in.sphere_and_wall").read_text()
        i = wall.index("cohesion hamaker", wall.index("wall/gran"))
        self.refused(wall[:i] + wall[i:].replace("cohesion hamaker", "cohesion hamaker rolling_friction nonsense", 1),
                     "there is no 'rolling_friction nonsense'", **WALL)

    def test_a_keyword_of_a_wall_belongs_to_the_end(self):
        """The line that the message gives is right."""
        head = script([sphere((0, 0, 1e-3))], LINEAR + " scheme exact", hamaker(1e-19, cut=4e-10, out=1e-7), run="")
        for misplaced in (" scheme exact primitive type 1 zplane 0", " scheme exact rolling_friction off primitive type 1 zplane 0"):
            wall = f"fix floor all wall/gran {LINEAR}{misplaced}\n"
            said = "behind 'primitive ...' or 'mesh ...', as in 'fix ID all wall/gran "
            run = Run(head + wall + "run 0\n")
            assert_refused(self, run, f"'{misplaced.split()[2]}' stands behind a keyword", said)
        line = re.search(r"as in '(fix ID [^']*)'", run.output)[1]
        done = Run(head.replace(LINEAR, "model hooke/stiffness tangential history cohesion hamaker") + line + "\nrun 1\n")
        self.assertEqual(done.code, 0, done.output[-2000:])

    def test_a_keyword_that_is_the_last_word_lacks_its_value(self):
        """Those of this package and of the engine, in pair_style and wall; the engine reads beyond the line."""
        wall = f"fix floor all wall/gran {LINEAR} primitive type 2 zplane -5e-3"
        for words in ("scheme", "material_keep", "material_stiffness", "scheme exact absolute_damping"):
            last = words.split()[-1]
            said = f"keyword '{last}' needs a value behind it" + (", exact or sampled" if last == "scheme" else "")
            for pairs, walls in ((f"{LINEAR} {words}", ()), (f"{LINEAR} scheme exact", [f"{wall} {words}"])):
                with self.subTest(pairs, walls=walls):
                    text = script([sphere((0, 0, 0))], f"{LINEAR} scheme exact", hamaker(1e-19, cut=4e-10, out=1e-7),
                                  walls, run="run 0\n")
                    run = Run(text.replace(f"pair_style gran {LINEAR} scheme exact", f"pair_style gran {pairs}"))
                    assert_refused(self, run, f"cohesion model hamaker: {said}")

    def test_an_error_of_one_rank_reaches_a_file(self):
        """One that the engine reports by the rank alone, which ends at once; a pipe is buffered as a file is."""
        text = script([sphere((k * 1.1e-3, 0, 0)) for k in range(4)], LINEAR, hamaker(1e-19, cut=4e-10, out=1e-7), skin=2e-3)
        text = text.replace("neigh_modify delay 0", "neigh_modify delay 0 one 1 page 10")
        for ranks in (0, 2):
            run = Run(text, ranks=ranks)
            self.assertEqual(run.code, 1, run.output[-2000:])
            self.assertRegex(run.output, r"ERROR on proc \d: Neighbor list overflow")

    def test_primitive_wall_sees_half_the_skin(self):
        self.refused("in.sphere_and_wall", "cohesion model hamaker, fix wall/gran floor",
                     "hamakerOuterCutoff = 1e-07", "half the neighbor skin of 1.9e-07",
                     "use 'neighbor 2e-07 bin' or more", **{**WALL, "skin": 1.9e-7})
        self.assertEqual(Run("in.sphere_and_wall", **{**WALL, "skin": 2.1e-7}).code, 0)


if __name__ == "__main__":
    unittest.main()
