# SPDX-License-Identifier: BSD-3-Clause
"""Each combination of contact models with each cohesion: the engine's own model plus the law."""

import itertools
import math
import unittest

from cohesion_tests.liggghts import EPSILON, Run
from cohesion_tests.liggghts_scenes.mesh import rectangle, stl, wall
from cohesion_tests.liggghts_scenes.scene import MASS, OUT, RADIUS, frames, hamaker, part, script, sphere, square_well
from cohesion_tests.liggghts_scenes.sheared_scene import three_in_a_row

NORMAL = ["hooke", "hooke/stiffness", "hertz", "hertz/stiffness"]
TANGENTIAL = ["off", "no_history", "history"]
ROLLING = ["off", "cdt", "epsd2"]
MODELS = [f"model {n} tangential {t} rolling_friction {r}"
          for n, t, r in itertools.product(NORMAL, TANGENTIAL, ROLLING)]
A, DEPTH = 1e-14, 5e-11
COHESION = {"none": ("", ""),
            "hamaker off": (" cohesion hamaker", hamaker(0)),
            "hamaker": (" cohesion hamaker", hamaker(A)),
            "square_well off": (" cohesion square_well", square_well(0)),
            "square_well": (" cohesion square_well", square_well(DEPTH))}
SPEED, GAP, WALL_GAP, OVERLAP = 0.1, 12e-6, 7e-6, 4e-6
STEPS = 60  # the two flights cross the edges of their wells, at 1e-5 and 5e-6 m

# The wall made of 200 triangles: sphere 5 slides over a border in its way.
PLATE_BORDER = 1e-6
PLATE = rectangle((-9e-3 + PLATE_BORDER, -9.5e-3, -5e-3), (18e-3, 0, 0), (0, 18e-3, 0), 10)


def scene():
    floor, spin = -5e-3, (300.0, -200.0, 100.0)
    yield sphere((0, 0, 0), (0.01, 0.02, 0), spin)  # 1, 2: in contact, sliding, rolling
    yield sphere((2 * RADIUS - OVERLAP, 0, 0), (-0.02, 0.01, 0.03))
    yield sphere((0, 4e-3, 0), (SPEED / 2, 0, 0))  # 3, 4: across a gap
    yield sphere((2 * RADIUS + GAP, 4e-3, 0), (-SPEED / 2, 0, 0))
    yield sphere((0, 0, floor + RADIUS - OVERLAP), (0.03, 0.02, 0.01), spin)  # 5: on the wall
    yield sphere((4e-3, 0, floor + RADIUS + WALL_GAP), (0, 0, -SPEED))  # 6: above it


class Combinations(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.frames = cls.run_all(list(COHESION), lambda models: ["primitive type 2 zplane -5e-3"])

    @staticmethod
    def run_all(names, walls):
        """All in one process per cohesion, the engine's own models in the stock program."""
        frames = {}
        for name in names:
            words, properties = COHESION[name]
            text = ""
            for number, models in enumerate(MODELS):
                # The engine wants cohesion before rolling friction.
                full = models.replace(" rolling_friction", words + " rolling_friction")
                text += script(list(scene()), full, properties, dt=1e-6, steps=STEPS, walls=walls(full),
                               dump=f"{number}.txt")
                text += "clear\n"
            run = Run(text, "stock" if name == "none" else "launcher", inputs={"plate.stl": stl(PLATE)})
            for number, models in enumerate(MODELS):
                frames[name, models] = run.frames(f"{number}.txt")
        return frames

    def test_without_strength_each_is_the_engines_own_to_the_last_bit(self):
        for name, models in itertools.product(("hamaker off", "square_well off"), MODELS):
            with self.subTest(cohesion=name, models=models):
                self.assertEqual(self.frames[name, models], self.frames["none", models])

    def test_nor_do_its_contacts_end_otherwise(self):
        """Two touch, part and touch again between two lists: the engine goes on with their friction."""
        def path(words="", properties="", how="launcher", extra=""):
            models = f"model hooke/stiffness tangential history{words}"
            return frames(three_in_a_row(), models, properties, how=how, dt=1e-6, steps=1200, every=100, skin=3e-4,
                          extra=extra)
        own = path(how="stock")
        for name in ("hamaker off", "square_well off"):
            self.assertEqual(path(*COHESION[name]), own, name)
        seen_apart = path(extra="neigh_modify contact_distance_factor 1.01\n")
        self.assertNotEqual(seen_apart, own, "this scene would not show it")

    def test_the_contacts_of_this_scene_do_what_their_models_say(self):
        # That the last test compares something: all combinations differ in force or torque.
        ends = {str(self.frames["none", models][-1]) for models in MODELS}
        self.assertEqual(len(ends), len(MODELS))

    def test_hamaker_adds_its_force(self):
        def law(reduced, gap):
            return A * reduced / (6 * max(gap, 1e-6)**2) if gap < OUT else 0.0

        # Gap and overlap are differences of lengths of 1 mm and 5 mm; F goes as H^-2.
        def error(force, gap):
            return force * (8 * EPSILON * 5e-3 / max(gap, 1e-6) + 16 * EPSILON)

        for models in MODELS:
            with self.subTest(models=models):
                own, ours = (self.frames[n, models][0] for n in ("none", "hamaker"))
                for number, axis, expected, gap in (
                        (1, 0, law(RADIUS / 2, 0), 0), (2, 0, -law(RADIUS / 2, 0), 0),
                        (3, 0, law(RADIUS / 2, GAP), GAP), (4, 0, -law(RADIUS / 2, GAP), GAP),
                        (5, 2, -law(RADIUS, 0), 0), (6, 2, -law(RADIUS, WALL_GAP), WALL_GAP)):
                    before, after = part(own[number], "f"), part(ours[number], "f")
                    tolerance = error(abs(expected), gap) + 4 * EPSILON * max(map(abs, before))
                    self.assertNotEqual(expected, 0.0)
                    for k in range(3):
                        self.assertAlmostEqual(after[k] - before[k], expected * (k == axis),
                                               delta=tolerance)
                    self.assertEqual(part(ours[number], "tq"), part(own[number], "tq"))

    def test_square_well_adds_its_energy_at_the_edge(self):
        # Sums of a few squares, then two times 60 roundings of velocities.
        for models in MODELS:
            with self.subTest(models=models):
                frames = self.frames["square_well", models]
                for numbers, depth in (((3, 4), DEPTH), ((6,), 2 * DEPTH)):
                    energy = [sum(0.5 * MASS * sum(v * v for v in part(f[n], "v")) for n in numbers)
                              for f in frames]
                    # By the last frame only half of an impulse may have come.
                    self.assertAlmostEqual(energy[-1] - energy[0], depth,
                                           delta=200 * EPSILON * energy[-1])
                # In the well and in contact nothing is added.
                own = self.frames["none", models]
                for number in (1, 2, 5):
                    self.assertEqual([f[number] for f in frames], [f[number] for f in own])

    def test_a_wall_of_triangles_is_the_plane(self):
        """Force and torque on the spheres at the wall, within 1e-6 of the largest, and so velocity and spin."""
        frames = self.run_all(["none", "hamaker", "square_well"], wall)
        for (name, models), mesh in frames.items():
            with self.subTest(cohesion=name, models=models):
                plane = self.frames[name, models]
                self.assertLess(mesh[0][5][0], PLATE_BORDER)
                self.assertGreater(mesh[-1][5][0], PLATE_BORDER)
                for number in (5, 6):
                    for what in ("f", "tq", "v", "omega"):
                        a, b = ([part(frame[number], what) for frame in run] for run in (mesh, plane))
                        largest = max(max(map(abs, row)) for row in b)
                        self.assertLessEqual(max(math.dist(*rows) for rows in zip(a, b)), 1e-6 * largest, what)


if __name__ == "__main__":
    unittest.main()
