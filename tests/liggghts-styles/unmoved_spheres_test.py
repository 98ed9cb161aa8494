# SPDX-License-Identifier: BSD-3-Clause
"""A run in which no fix moves or holds any sphere gets a warning, once, before its first step; all others none. So does
a wall of scheme sampled where the pair style has scheme exact."""
import unittest

from cohesion_tests.liggghts import Run
from cohesion_tests.liggghts_scenes.scene import hamaker, liquid_bridge, script, sphere, square_well

LAWS = {"hamaker": hamaker(0), "square_well": square_well(0), "liquid_bridge": liquid_bridge(0, 0)}
SCHEMES = ("", " scheme exact")
RUN = "run 1\nrun 1\n"
UNMOVED = "no fix integrates the motion of any particle"
MIXED = "give both the same scheme (a wall without the keyword has that of the pairs)"
PLANE = "primitive type 2 zplane -5e-3"


def models(law):
    return f"model hooke/stiffness tangential history cohesion {law}"


def text(law, scheme="", move="fix move all nve/sphere\n", run=RUN, walls=()):
    made = script([sphere((x, 0, 0)) for x in (-4e-3, 4e-3)], models(law) + scheme, LAWS[law], run=run, walls=walls)
    return made.replace("fix move all nve/sphere\n", move)


class SetUp(unittest.TestCase):
    def printed(self, script_text, ranks=0):
        run = Run(script_text, ranks=ranks)
        self.assertEqual(run.code, 0, run.output[-2000:])
        return run.output

    def test_nothing_moves(self):
        for law in LAWS:
            for scheme in SCHEMES:
                for ranks in (0, 2) if law == "hamaker" else (0,):
                    with self.subTest(law, scheme=scheme, ranks=ranks):
                        output = self.printed(text(law, scheme, move=""), ranks)
                        self.assertEqual(output.count(f"WARNING: {UNMOVED}"), 1, output)
                        self.assertIn("add 'fix ID all nve/sphere'", output)

    def test_something_moves_or_holds(self):
        for move in ("fix move all nve/sphere\n", "fix move all nve/noforce\n", "fix hold all freeze\n",
                     "fix hold all setforce 0 0 0\n", "group one id 1\nfix move one nve/sphere\n"):
            with self.subTest(move):
                self.assertNotIn(UNMOVED, self.printed(text("hamaker", move=move)))
        self.assertNotIn(UNMOVED, self.printed(text("hamaker", move="", run="run 0\n")))

    def test_wall_of_another_scheme(self):
        for law in LAWS:
            wall = f"fix floor all wall/gran {models(law)} {PLANE} scheme sampled"
            with self.subTest(law):
                output = self.printed(text(law, " scheme exact", walls=[wall]))
                self.assertEqual(output.count(MIXED), 1, output)
                self.assertIn("WARNING: fix floor wall/gran has 'scheme sampled', and pair_style gran has 'scheme "
                              "exact'", output)

    def test_wall_of_the_same_scheme(self):
        wall = f"fix floor all wall/gran {models('hamaker')} {PLANE}"
        for scheme in SCHEMES:
            for of_wall in ("", scheme):
                self.assertNotIn(MIXED, self.printed(text("hamaker", scheme, walls=[wall + of_wall])))


if __name__ == "__main__":
    unittest.main()
