# SPDX-License-Identifier: BSD-3-Clause
"""The cohesion model square_well: energies at the edge, and memory."""

import math
import unittest

from cohesion_tests.liggghts import EPSILON, Run
from cohesion_tests.liggghts_scenes.mesh import rectangle, stl, wall
from cohesion_tests.liggghts_scenes.scene import (MASS, RADIUS, RATIO, contact, frames, part, script, sphere,
                                                  square_well)
from cohesion_tests.liggghts_scenes.sheared_scene import three_in_a_row

DIAMETER, MU = 2 * RADIUS, MASS / 2
DEPTH = 5e-11
WIDTH = (RATIO - 1) * DIAMETER
MODELS = "model hooke/stiffness tangential off cohesion square_well"


def relative(frame, first, what):
    return [b - a for a, b in zip(part(frame[first], what), part(frame[first + 1], what))]


def energy(frame, first, mass=MU):
    """Of the relative motion of spheres first and first + 1."""
    return 0.5 * mass * sum(v * v for v in relative(frame, first, "v"))


def gap(frame, first):
    return math.hypot(*relative(frame, first, "x")) - DIAMETER


def couples(starts, origin=(-8e-3, -9e-3, -9e-3)):
    """Spheres of couples with gap and relative velocity (along, across the line of centres, x)."""
    for n, (distance, along, across) in enumerate(starts):
        place = [origin[0], origin[1] + 1.6e-3 * (n % 11), origin[2] + 1.6e-3 * (n // 11)]
        yield sphere(place, (-along / 2, -across / 2, 0))
        yield sphere([place[0] + DIAMETER + distance, *place[1:]], (along / 2, across / 2, 0))


def well_speed(depth, mass=MU):
    return math.sqrt(2 * depth / mass)


def continued(text, file="middle.restart"):
    """The script with particles from a restart file."""
    return text[:text.index("region box")] + f"read_restart {file}\n" + text[text.index("neighbor "):]


class Edge(unittest.TestCase):
    """Passages without contact. Energies are those of squares of speeds up to 0.4 m/s; a few hundred
    steps round velocities."""

    ROUNDING = 1000 * EPSILON

    def test_passing_by_changes_the_energy_by_the_depth_and_back(self):
        # 1.005 mm apart at the nearest: through the well, beside the core.
        speed, aside, way = 0.4, 1.005e-3, 0.8e-3
        spheres = [sphere((-way / 2, 0, 0), (speed / 2, 0, 0)),
                   sphere((way / 2, aside, 0), (-speed / 2, 0, 0))]
        path = frames(spheres, MODELS, square_well(DEPTH), dt=1e-6, steps=4000, every=10)
        start = energy(path[0], 1)
        within = [f for f in path if gap(f, 1) < WIDTH - 2e-6]
        self.assertGreater(len(within), 10)
        for frame in within:
            self.assertAlmostEqual(energy(frame, 1), start + DEPTH, delta=self.ROUNDING * start)
        self.assertGreater(gap(path[-1], 1), WIDTH)
        self.assertAlmostEqual(energy(path[-1], 1), start, delta=self.ROUNDING * start)

    def test_escape_and_capture(self):
        # Begin in the well, parting; above and below the speed that leads out.
        edge = well_speed(DEPTH)
        starts = [(8e-6, factor * edge, 0.0) for factor in (0.5, 0.999999, 1.000001, 2.0)]
        path = frames(list(couples(starts)), MODELS, square_well(DEPTH), dt=1e-6, steps=600)
        for n, (_, speed, _) in enumerate(starts):
            end, start = energy(path[-1], 1 + 2 * n), 0.5 * MU * speed**2
            along = relative(path[-1], 1 + 2 * n, "v")[0]
            with self.subTest(speed=speed):
                if speed > edge:
                    self.assertAlmostEqual(end, start - DEPTH, delta=self.ROUNDING * start)
                    self.assertGreater(along, 0.0)
                else:
                    self.assertAlmostEqual(end, start, delta=self.ROUNDING * start)
                    self.assertLess(along, 0.0)

    def test_a_pair_that_flies_too_far_in_a_step_is_warned_of(self):
        # Found next 0.01 of the radii beyond the edge at most, and its D is paid; or farther, and it keeps it.
        for way, paid in ((1.1e-5, DEPTH), (1.3e-5, 0.0)):
            with self.subTest(way=way):
                dt = 1e-6
                speed = way / dt
                run = Run(script(list(couples([(8e-6, speed, 0.0)])), MODELS, square_well(DEPTH), dt=dt, steps=4))
                end, start = energy(run.frames("out.txt")[-1], 1), 0.5 * MU * speed**2
                self.assertAlmostEqual(end, start - paid, delta=self.ROUNDING * start)
                self.assertEqual(run.output.count("leaves its well by more than 0.01"), int(paid == 0.0))

    def test_it_is_warned_of_once(self):
        # Pairs, and spheres beside a wall, on both ranks; then on the second alone.
        dt = 1e-5
        speed = (WIDTH / 2 + 0.03 * DIAMETER) / dt
        for ranks, sides in ((1, (-1, 1)), (2, (-1, 1)), (2, (1,))):
            spheres = [s for side in sides for s in couples([(8e-6, speed, 0.0)], (6e-3 * side, -9e-3, 0))]
            spheres += [sphere((5e-3 * side, 0, -1e-2 + RADIUS + 1e-6), (0, 0, speed)) for side in sides]
            run = Run(script(spheres, MODELS, square_well(DEPTH), walls=["primitive type 2 zplane -1e-2"], dt=dt,
                             run="run 4\nrun 4\n"), ranks=ranks)
            with self.subTest(ranks=ranks, sides=sides):
                self.assertEqual(run.code, 0)
                self.assertEqual(run.output.count("leaves its well by more than"), 1)

    def test_pairs_of_unequal_spheres_have_their_own_edge(self):
        # The edge where the centres are ratio r_i + ratio r_j apart.
        large, small, speed = 0.8e-3, 0.3e-3, 0.1
        spheres = [sphere((0, 0, 0), radius=large),
                   sphere((large + small + 14e-6, 0, 0), (-speed, 0, 0), radius=small)]
        path = frames(spheres, MODELS, square_well(DEPTH), dt=1e-6, steps=80)
        # A kick is put on where the pair is first found inside; half of it shows in that frame.
        kicked = [gap_of for gap_of, f in ((math.hypot(*relative(f, 1, "x")) - large - small, f)
                                           for f in path) if f[2][3] != -speed]
        width = (RATIO - 1) * (large + small)
        self.assertLess(kicked[0], width)
        self.assertGreater(kicked[0], width - speed * 1e-6 * 1.01)

    def test_extreme_sizes_and_depths(self):
        # Energies of the depth over that of the approach from 1e-6 to 1e6, up to where the way of a step is
        # a tenth of the well after the impulse.
        for radius in (2e-6, 1e-2):  # the engine refuses 1e-6
            mass = MASS * (radius / RADIUS)**3
            for ratio in (1.0001, 1.5):
                width = 2 * (ratio - 1) * radius
                for over in (1e-6, 1.0, 1e6):
                    speed, depth = 0.01, over * 0.25 * mass * 0.01**2
                    fastest = speed * math.sqrt(1 + over)
                    dt = 0.1 * width / fastest
                    steps = int(0.2 * width / (speed * dt)) + 4
                    away = radius + 0.5 * (width + 0.2 * width)
                    # They do not get as far as to touch; a spring that the step resolves, all the same.
                    soft = contact(stiffness=0.125 * mass / dt**2, gamman=0)
                    box = " ".join(f"{-20 * radius!r} {20 * radius!r}" for _ in range(3))
                    path = frames([sphere((-away, 0, 0), (speed / 2, 0, 0), radius=radius),
                                   sphere((away, 0, 0), (-speed / 2, 0, 0), radius=radius)], MODELS,
                                  square_well(depth, ratio=ratio), dt=dt, steps=steps, box=box,
                                  skin=radius, every=steps, contacts=soft)
                    with self.subTest(radius=radius, ratio=ratio, over=over):
                        start = 0.25 * mass * speed**2
                        self.assertGreater(math.hypot(*relative(path[-1], 1, "x")), 2 * radius)
                        # Rounding of two speeds, each good to a few epsilon of the larger one.
                        self.assertAlmostEqual(energy(path[-1], 1, mass / 2), start + depth,
                                               delta=64 * EPSILON * (start + depth))

    def test_a_frozen_sphere_has_infinite_mass(self):
        spheres = [sphere((0, 0, 0)), sphere((DIAMETER + 2 * WIDTH, 0, 0), (-0.1, 0, 0))]
        text = script(spheres, MODELS, square_well(DEPTH), dt=1e-6, steps=150,
                      extra="group still id 1\nfix still still freeze\n")
        path = Run(text).frames("out.txt")
        change = 0.5 * MASS * (path[-1][2][3]**2 - 0.01)
        self.assertAlmostEqual(change, DEPTH, delta=self.ROUNDING * 0.5 * MASS * 0.01)
        self.assertEqual(path[-1][1][3], 0.0)


class Walls(unittest.TestCase):
    def test_approach_and_capture_at_walls_of_either_kind(self):
        # Without contact: parting from inside, and a flight inwards that ends before the wall.
        depth, width = 2 * DEPTH, (RATIO - 1) * RADIUS
        edge = well_speed(depth, MASS)
        spheres = [sphere((1e-3, 0, RADIUS + 2e-6), (0, 0, 0.999999 * edge)),
                   sphere((3e-3, 0, RADIUS + 2e-6), (0, 0, 1.000001 * edge)),
                   sphere((-3e-3, 0, RADIUS + 1.2 * width), (0, 0, -1e-2))]
        mesh = stl(rectangle((-9e-3, -9e-3, 0), (18e-3, 0, 0), (0, 18e-3, 0), 3))
        for walls in (["primitive type 2 zplane 0"], wall(MODELS)):
            with self.subTest(wall=walls[-1]):
                path = frames(spheres, MODELS, square_well(DEPTH), walls=walls, steps=350, dt=1e-6,
                              inputs={"plate.stl": mesh})
                end = [part(path[-1][n], "v")[2] for n in (1, 2, 3)]
                few = 1000 * EPSILON
                self.assertAlmostEqual(end[0], -0.999999 * edge, delta=few * edge)
                # The difference of two squares, one part in 1e6 apart.
                self.assertAlmostEqual(end[1]**2, (1.000001**2 - 1) * edge**2, delta=few * edge**2)
                self.assertGreater(end[1], 0.0)
                self.assertAlmostEqual(0.5 * MASS * (end[2]**2 - 1e-4), depth, delta=few * depth)

    def test_a_moving_wall_counts_in_the_approach(self):
        # A sphere at rest, caught up by a plane that moves: in its frame, energy +D.
        speed, depth = 0.02, 2 * DEPTH
        mesh = stl(rectangle((-9e-3, -9e-3, 0), (18e-3, 0, 0), (0, 18e-3, 0), 3))
        walls = wall(MODELS) + [f"fix up all move/mesh mesh plate linear 0 0 {speed:.17g}"]
        path = frames([sphere((0, 0, RADIUS + 6e-6))], MODELS, square_well(DEPTH), walls=walls,
                      dt=1e-6, steps=120, inputs={"plate.stl": mesh})
        end = part(path[-1][1], "v")[2]
        self.assertAlmostEqual(0.5 * MASS * ((end - speed)**2 - speed**2), depth,
                               delta=1000 * EPSILON * MASS * speed**2)


class Memory(unittest.TestCase):
    """What a well remembers: whether a pair is inside, and the impulse of the last step."""

    def setUp(self):
        # Passing by in different directions, and captured without contact for a while.
        self.spheres = [sphere((-0.4e-3, 0, 0), (0.2, 0, 0)),
                        sphere((0.4e-3, 1.005e-3, 0), (-0.2, 0, 0))]
        self.spheres += list(couples([(3e-6, 5e-3, 0.0), (9e-6, 4e-3, 0.0)], (-5e-3, -5e-3, -5e-3)))
        # Across the border x = 0 of two ranks, above a wall.
        self.spheres += [sphere((-0.2e-3, 5e-3, -10e-3 + RADIUS + 4e-6), (0.2, 0, 1e-3))]
        self.options = dict(dt=1e-6, walls=["primitive type 2 zplane -10e-3"],
                            box="-0.01 0.01 -0.01 0.01 -0.0101 0.01")

    def ends(self, run, models=MODELS, **more):
        text = script(self.spheres, models, square_well(DEPTH), run=run, every=1000,
                      **{**self.options, **more})
        return Run(text).frames("out.txt")[-1]

    @staticmethod
    def loop(runs, steps, name):
        return f"variable {name} loop {runs}\nlabel {name}\nrun {steps}\nnext {name}\njump SELF {name}\n"

    def test_runs_in_parts_continue_to_the_last_bit(self):
        # Of the normal models hertz/stiffness alone lets go of contacts that have come apart.
        for models in (MODELS, MODELS.replace("hooke", "hertz")):
            text = script(self.spheres, models, square_well(DEPTH), run="run 2000\n", every=10, **self.options)
            path = Run(text).frames("out.txt")
            for n, step in ((1, 1760), (3, 1400), (5, 260), (7, 1020)):
                changes = [10 * k for k in range(1, len(path)) if part(path[k][n], "v") != part(path[k - 1][n], "v")]
                self.assertTrue(changes and abs(changes[0] - step) <= 10, f"sphere {n} has its event at {changes}")
            # Runs of one step about each event; of seven all along.
            single, end = "", 0
            for number, step in enumerate((260, 1020, 1400, 1760)):
                single += f"run {step - 20 - end}\n" + self.loop(40, 1, f"about{number}")
                end = step + 20
            single += f"run {2000 - end}\n"
            for name, parts in (("one step", single), ("seven", self.loop(285, 7, "again") + "run 5\n")):
                with self.subTest(name, models=models):
                    self.assertEqual(self.ends(parts, models), path[-1])

    def test_restart_continues_to_the_last_bit(self):
        for walls, inputs in ((self.options["walls"], {}),
                              (wall(MODELS), {"plate.stl": stl(rectangle(
                                  (-9e-3, -9e-3, -10e-3), (18e-3, 0, 0), (0, 18e-3, 0), 3))})):
            options = {**self.options, "walls": walls}
            first = script(self.spheres, MODELS, square_well(DEPTH), every=1000, **options,
                           run="run 1\nrun 2000\nclear\n")
            # One in the well of the wall, one between its edge and the couple's.
            middle = 300
            again = script(self.spheres, MODELS, square_well(DEPTH), every=1000, **options,
                           run=f"run 1\nrun {middle}\nwrite_restart middle.restart\nclear\n")
            second = continued(script([], MODELS, square_well(DEPTH), every=1000, dump="second.txt", **options,
                                      run=f"run {2000 - middle}\n"))
            whole = Run(first, inputs=inputs).frames("out.txt")[-1]
            restarted = Run(again + second, inputs=inputs).frames("second.txt")[-1]
            with self.subTest(walls=walls):
                self.assertEqual(restarted, whole)

    def test_an_impulse_under_way_is_taken_back_when_the_wells_are_gone(self):
        # Whole in the step after the restart file, which has half of it in the velocities.
        floor, speed, ways = -10e-3, 0.2, {"plate.stl": stl(rectangle(
            (-9e-3, -9e-3, -10e-3), (18e-3, 0, 0), (0, 18e-3, 0), 3))}
        pair = list(couples([(WIDTH + 0.5e-6, -speed, 0.0)]))
        above = [sphere((0, 0, floor + RADIUS + WIDTH / 2 + 0.5e-6), (0, 0, -speed))]
        for spheres, walls, mass, depth in ((pair, [], MU, DEPTH),
                                            (above, ["primitive type 2 zplane -10e-3"], MASS, 2 * DEPTH),
                                            (above, wall(MODELS), MASS, 2 * DEPTH)):
            def text(spheres, depth, **more):
                return script(spheres, MODELS, square_well(depth), dt=1e-6, walls=walls,
                              box=self.options["box"], **more)

            def speeds(frame):
                return relative(frame, 1, "v") if len(frame) > 1 else part(frame[1], "v")

            for ranks in (0, 2) if not walls else (0,):
                first = text(spheres, DEPTH, run="run 3\nwrite_restart middle.restart\nclear\n")
                # Too few steps to reach the core.
                second = continued(text([], 0.0, dump="second.txt", run="run 20\n"))
                run = Run(first + second, inputs=ways, ranks=ranks)
                before, after = run.frames("out.txt"), run.frames("second.txt")
                with self.subTest(walls=walls, ranks=ranks):
                    start = 0.5 * mass * speed**2
                    few = 1000 * EPSILON * start
                    size = math.hypot(*speeds(before[-2]))
                    self.assertAlmostEqual(size, speed, delta=4 * EPSILON * speed)
                    size = math.hypot(*speeds(before[-1]))
                    self.assertGreater(0.5 * mass * size**2, start + 0.1 * depth, "half an impulse")
                    size = math.hypot(*speeds(after[-1]))
                    self.assertAlmostEqual(0.5 * mass * size**2, start + depth, delta=few)

    def test_pairs_that_are_passed_over_change_nothing(self):
        """Those known to be outside are, but not while a tally is active."""
        plain, watched = (Run(script(self.spheres, MODELS, square_well(DEPTH), every=20, steps=2000, extra=tally,
                                     **self.options)).frames("out.txt")
                          for tally in ("", "compute tally all gran/energy\n"))
        self.assertEqual(plain, watched)

    def test_two_ranks_equal_one(self):
        results = [Run(script(self.spheres, MODELS, square_well(DEPTH), every=2000, steps=2000,
                              **{**self.options, "walls": []}), ranks=ranks).frames("out.txt")[-1]
                   for ranks in (1, 2)]
        by_place = [sorted(result.values()) for result in results]
        for one, two in zip(*by_place):
            for a, b in zip(one[:6], two[:6]):
                self.assertAlmostEqual(a, b, delta=1e-12 * max(abs(a), 1e-3))


class NoDepth(unittest.TestCase):
    """With D = 0 a run is the engine's own to the last bit, at whatever step it begins and from a restart file."""

    FLOOR = -9e-3
    OWN = "model hooke/stiffness tangential history"
    WALLS = {"none": lambda models: [],
             "primitive": lambda models: ["primitive type 2 zplane -9e-3"],
             "mesh": wall}

    def scene(self):
        """Two that touch and touch again before a new list is made, in whose friction it shows how far the engine
        looks; two that rub on each other; two on the floor."""
        yield from three_in_a_row()
        yield sphere((-5e-3, -5e-3, 0), (0, 0.05, 0))
        yield sphere((-5e-3 + DIAMETER - 4e-6, -5e-3, 0), (0, 0, 0.05))
        yield sphere((-5e-3, 5e-3, self.FLOOR + RADIUS - 2e-6), (0.05, 0.02, 0))
        yield sphere((5e-3, -5e-3, self.FLOOR + RADIUS - 2e-6), (0, 0.05, 0), (100, 0, 0))

    def end(self, walls, parts, depth=None, extra="", ranks=0):
        """Of a run in one part, or in two with a restart file between."""
        models, properties = self.OWN, ""
        if depth is not None:
            models, properties = f"{models} cohesion square_well", square_well(depth)
        options = dict(dt=1e-6, every=50, skin=3e-4, walls=self.WALLS[walls](models), extra=extra)
        text = script(list(self.scene()), models, properties, run=parts[0], **options)
        for number, run in enumerate(parts[1:]):
            text += "write_restart middle.restart\nclear\n" + continued(
                script([], models, properties, dump=f"out{number}.txt", run=run, **options))
        plate = stl(rectangle((-9e-3, -9e-3, self.FLOOR), (18e-3, 0, 0), (0, 18e-3, 0), 3))
        run = Run(text, "stock" if depth is None else "launcher", inputs={"plate.stl": plate}, ranks=ranks)
        return run.frames("out.txt" if len(parts) == 1 else f"out{len(parts) - 2}.txt")

    def test_is_the_engines_own_to_the_last_bit(self):
        # The first two touch in steps 1 to 33 and 277 to 309.
        for name, parts in {"a later first step": ["reset_timestep 5000\nrun 400\n"],
                            "a restart file": ["run 20\n", "run 380\n"],
                            "two": ["run 20\n", "run 10\n", "run 370\n"]}.items():
            for walls, ranks in (("primitive", 0), ("mesh", 0)) + ((("none", 2),) if name == "two" else ()):
                with self.subTest(name, walls=walls, ranks=ranks):
                    own = self.end(walls, parts, ranks=ranks)
                    self.assertTrue(self.end(walls, parts, 0.0, ranks=ranks) == own)
                    if name != "two":
                        seen_apart = self.end(walls, parts, extra="neigh_modify contact_distance_factor 1.01\n")
                        self.assertFalse(seen_apart == own, "this scene would not show it")

    def test_a_wall_that_is_added_later_changes_nothing_either(self):
        later = "run 20\n{}run 380\n"
        def path(models, *more):
            floor = f"fix floor all wall/gran {models} primitive type 2 zplane -9e-3\n"
            return self.end("none", [later.format(floor)], *more)
        self.assertTrue(path(f"{self.OWN} cohesion square_well", 0.0) == path(self.OWN))


if __name__ == "__main__":
    unittest.main()
