# SPDX-License-Identifier: BSD-3-Clause
"""fix deform/shear and compute shear/profile in LIGGGHTS refuse what would lose particles or shear wrongly,
and say why; they are there after `clear`, and in the preloaded library."""

import unittest
from concurrent.futures import ThreadPoolExecutor

from cohesion_tests.liggghts import Run, assert_refused
from cohesion_tests.liggghts_scenes import mesh
from cohesion_tests.liggghts_scenes.scene import script, sphere

PRISM = "0 10 0 8 0 6 0 0 0"
PLAIN = "model hooke tangential off"
SHEAR = "fix shear all deform/shear rate 0.5\n"


def head(fixes, box=PRISM, boundary="p p p", run="run 1\n", dt=1e-3, walls=()):
    return script([sphere((2, 3, 4), radius=0.5), sphere((5, 3, 4), radius=0.5)], PLAIN, box=box,
                  boundary=boundary, skin=0.3, extra=fixes, run=run, dt=dt, walls=walls, columns=["x"])


class Refusals(unittest.TestCase):
    def stop(self, *cases, begun=False):
        """Cases: a script and the words of its error. Side by side: a start is mostly waiting."""
        with ThreadPoolExecutor(4) as pool:
            runs = list(pool.map(lambda case: Run(case[0]), cases))
        for run, (_, *words) in zip(runs, cases):
            with self.subTest(words=words):
                assert_refused(self, run, *words, begun=begun)

    def test_words(self):
        fix = "fix shear all deform/shear "
        self.stop(*((head(text), *words) for text, *words in (
                (fix + "rates 1\n", "fix shear deform/shear", "'rates'", "rate, profile, rebuild"),
                (fix + "profile yes\n", "rate R", "v_name"),
                (fix + "rate\n", "rate takes a value"),
                (fix + "rate 1 profile maybe\n", "'maybe'", "yes, no"),
                (fix + "rate 1 rebuild never\n", "'never'", "nonaffine, engine"),
                (fix + "rate v_none\n", "equal-style variable 'none'"),
                ("group one id 1\nfix shear one deform/shear rate 1\n", "fix shear deform/shear", "group must be all, not one"),
                ("compute flow all shear/profile bins 4\n", "layers N"),
                ("compute flow all shear/profile layers 2\n", "layers 2", "at least 3"))))

    def test_box(self):
        self.stop(*((head(SHEAR, box, boundary), *words) for box, boundary, *words in (
                ("0 10 0 8 0 6", "p p p", "prism", "change_box all triclinic"),
                (PRISM, "f p p", "x is not"), (PRISM, "p f p", "y is not"),
                ("0 10 0 8 0 6 0 0 2", "p p p", "tilt yz is 2", "make it 0"))),
            (head("compute flow all shear/profile\n", boundary="p f p"), "periodic"))

    def test_incompatible_fixes(self):
        self.stop(*((head(SHEAR + fix), *words) for fix, *words in (
                ("fix other all momentum 10 linear 1 1 1\n", "fix other momentum", "the profile has"),
                ("fix other all deform 1 xz erate 1\n", "fix other deform changes the box"),
                ("fix other all freeze\n", "fix other freeze", "whose images move"),
                ("fix other all move linear 1 0 0\n", "fix other move", "paths"),
                ("fix other all viscous 1\n", "fix other viscous", "another velocity"),
                ("fix other all deform/shear rate 1\n", "changes the box too"),
                ("fix other all rigid single\n", "fix other rigid", "velocity of a body"),
                ("fix other all couple/cfd couple_every 10 mpi\n", "fix other couple/cfd", "a gas that does not know"),
                ("run_style respa 2 2\n", "run_style verlet"),
                ("communicate single vel no\n", "velocit"))))

    def test_walls(self):
        allowed = " allow_special_domain_periodic yes"
        self.stop(*((head(SHEAR, boundary="p p f", walls=[f"primitive type 2 {wall}{allowed}"]),
                     "fix wall0 wall/gran", "only a zplane is")
                    for wall in ("yplane 0", "xplane 0", "zcylinder 3 5 4", "xcylinder 3 4 3")))
        run = Run(head(SHEAR, boundary="p p f", walls=[f"primitive type 2 zplane 0{allowed}"]))
        self.assertEqual(run.code, 0, run.output[-2000:])

    def test_a_box_changed_since(self):
        self.stop((head(SHEAR, run="run 0\nchange_box all x final 0 11 units box\nrun 1\n"),
                   "fix shear deform/shear", "the box has been changed", "give the fix again"), begun=True)

    def test_mesh(self):
        run = Run(head("fix mesh all mesh/surface file a.stl type 2\n" + SHEAR), inputs={
            "a.stl": mesh.stl(mesh.rectangle((4, 3, 1), (2, 0, 0), (0, 2, 0)))})
        assert_refused(self, run, "fix mesh mesh/surface keeps its triangles")

    def test_step_that_moves_the_images_half_a_box(self):
        self.stop((head(SHEAR, run="run 3\n", dt=2.0), "in a step", "smaller time step"), begun=True)


class Registered(unittest.TestCase):
    def test_after_clear_and_preloaded(self):
        text = head(SHEAR + "compute flow all shear/profile\n", run="run 2\nclear\n")
        for how in ("launcher", "preload"):
            with self.subTest(how):
                run = Run(text + text, how)
                self.assertEqual(run.code, 0, run.output[-2000:])
                self.assertEqual(run.output.count("added the profile"), 2)


if __name__ == "__main__":
    unittest.main()
