# SPDX-License-Identifier: BSD-3-Clause
"""Spheres of which fix setforce, lineforce or planeforce sets the whole force count as held, as those of fix freeze.
Where such fixes hold spheres in part, contacts are right in a layer, and scheme exact stops elsewhere."""
import unittest

from cohesion_tests import refusals
from cohesion_tests.liggghts import Run
from cohesion_tests.liggghts_scenes.scene import hamaker, part, script, sphere, square_well

SPEED = 0.1
MODELS = {
    "hamaker exact": ("cohesion hamaker scheme exact", hamaker(1e-18, cut=4e-10, out=1e-7)),
    "well exact": ("cohesion square_well scheme exact", square_well(1e-12)),
    "hamaker sampled": ("cohesion hamaker", hamaker(0)),
}
MOVE, FREEZE = "fix move all nve/sphere\n", "fix move all nve/sphere\nfix hold held freeze\n"
WHOLLY = {
    "setforce": MOVE + "fix hold held setforce 0 0 0\n",
    "setforce first": "fix hold held setforce 0 0 0\n" + MOVE,
    "line and plane": MOVE + "fix a held lineforce 1 0 1\nfix b held planeforce 2 0 2\n",
}


class Held(unittest.TestCase):
    def run_held(self, model, fixes, y=2e-4, ranks=0, **options):
        words, properties = MODELS[model]
        spheres = [sphere((0, 0, 0)), sphere((1.05e-3, y, 0), (-SPEED, 0, 0))]
        text = script(spheres, f"model hooke/stiffness tangential history {words}", properties, every=3000, steps=3000,
                      **options)
        return Run(text.replace(MOVE, "group held id 1\n" + fixes), ranks=ranks)

    def end(self, model, fixes, **options):
        return self.run_held(model, fixes, **options).frames("out.txt")[-1]

    def test_as_frozen(self):
        for model in MODELS:
            frozen = self.end(model, FREEZE)
            for how, fixes in WHOLLY.items():
                if "sampled" in model and how == "line and plane":
                    continue  # the page says so
                with self.subTest(model, how=how):
                    held = self.end(model, fixes)
                    for what in ("x", "v", "omega"):
                        for number in (1, 2):
                            for mine, other in zip(part(held[number], what), part(frozen[number], what)):
                                self.assertAlmostEqual(mine, other, delta=1e-9 * max(1.0, abs(other)))

    def test_let_go_it_is_free(self):
        for model in MODELS:
            with self.subTest(model):
                end = self.end(model, WHOLLY["setforce"], run="run 100\nunfix hold\nrun 2900\n", y=0)
                momentum = part(end[1], "v")[0] + part(end[2], "v")[0]
                self.assertAlmostEqual(momentum / -SPEED, 1.0, delta=1e-9)
                # Not held up as in a first run of two free ones.
                free = self.end(model, MOVE, y=0)
                self.assertAlmostEqual(part(end[2], "v")[0], part(free[2], "v")[0], delta=1e-6)

    def test_ranks(self):
        one, two = (self.end("hamaker exact", WHOLLY["setforce"], ranks=ranks) for ranks in (0, 2))
        for mine, other in zip(part(one[2], "v"), part(two[2], "v")):
            self.assertAlmostEqual(mine, other, delta=1e-9)

    def test_spins_are_held_and_a_warning_says_so(self):
        for model in MODELS:
            printed = self.run_held(model, WHOLLY["setforce"], run="run 1500\nrun 1500\n").output
            self.assertEqual(printed.count("their spins are held"), 1, printed)
        self.assertNotIn("spins are held", self.run_held("hamaker exact", FREEZE).output)

    def test_held_in_part(self):
        for how in ("planeforce 1 0 0", "lineforce 0 1 0", "setforce 0 NULL NULL"):
            for model in MODELS:
                with self.subTest(model, how=how):
                    run = self.run_held(model, MOVE + f"fix part held {how}\n")
                    if "sampled" in model:
                        self.assertEqual(run.code, 0, run.output)
                        self.assertIn("have the dashpot of spheres that are free", run.output)
                    else:
                        refusals.assert_refused(self, run.code, run.output, f"fix part {how.split()[0]} holds 1 particles",
                                                "'fix setforce 0 0 0' or 'fix freeze'")

    def test_layers_are_right(self):
        for model in MODELS:
            free, layer = self.end(model, MOVE), self.end(model, MOVE + "fix flat all planeforce 0 0 1\n")
            for number in (1, 2):
                for mine, other in zip(part(layer[number], "v"), part(free[number], "v")):
                    self.assertAlmostEqual(mine, other, delta=1e-9)


if __name__ == "__main__":
    unittest.main()
