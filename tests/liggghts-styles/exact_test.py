# SPDX-License-Identifier: BSD-3-Clause
"""Cohesion hamaker and square_well with scheme exact among many spheres: ranks, runs and restarts, meshes, energy,
rest, friction; what it cannot follow is refused. Escape velocities are in escape_test.py."""
import math
import random
import unittest

from cohesion_tests.liggghts import EPSILON, Run, assert_refused
from cohesion_tests.liggghts_scenes.elastic_gas import (DIAMETER, elastic, energy, gaps, gas, kinetic_energy,
                                                        spring_energy)
from cohesion_tests.liggghts_scenes.mesh import rectangle, stl
from cohesion_tests.liggghts_scenes.scene import (MASS, RADIUS, STIFFNESS, contact, frames, hamaker, script, sphere,
                                                  square_well)
from cohesion_tests.theory.pair_motion import CUT, OUT, Pair

CONTACT_TIME = math.pi * math.sqrt(0.5 * MASS / STIFFNESS)
EXACT = " absolute_damping on tangential_damping off scheme exact"
COLUMNS = ("x", "y", "z", "vx", "vy", "vz", "omegax", "omegay", "omegaz")
END = f"""
dump end all custom 1 end.txt id {' '.join(COLUMNS)}
dump_modify end format "%d{' %.17g' * len(COLUMNS)}" sort id
run 0
"""


def models(tangential="off"):
    return f"model hooke/stiffness tangential {tangential} cohesion hamaker"


def gas_script(run, tangential="off", edge=6, fraction=0.45, constant=2e-18, speed=0.1, part=10,
               contacts=contact(), **options):
    """run: with DT for the step."""
    spheres, side = gas(edge, fraction, speed=speed)
    dt = CONTACT_TIME / part
    return script(spheres, models(tangential) + EXACT, hamaker(constant, cut=CUT, out=OUT), dt=dt, every=10**8,
                  contacts=contacts, boundary="p p p", box=f"0 {side} 0 {side} 0 {side}",
                  run=run.replace("DT", repr(dt)), **options), side


def end_of(run, tangential="off", ranks=0):
    done = Run(gas_script(run + END, tangential)[0], ranks=ranks)
    return done.frames("end.txt")[-1]


class Many(unittest.TestCase):
    def assert_same(self, one, other, steps):
        """But for rounding: in each step half an epsilon of the speed of 0.3 m/s and of a place of 7 mm over the
        step, which a collision may amplify by diameter over overlap, about 100; each sphere has about one in a run."""
        self.assertEqual(one.keys(), other.keys())
        room = 100 * steps * EPSILON * (0.3 + 7e-3 / (CONTACT_TIME / 10) * EPSILON)
        for k in one:
            for mine, theirs in zip(one[k][3:6], other[k][3:6]):
                self.assertAlmostEqual(mine, theirs, delta=room)

    def test_ranks_and_runs_do_not_matter(self):
        # A run goes on with the forces that the last one ended with.
        for tangential in ("off", "history"):
            whole = end_of("run 120", tangential)
            for what, how in {"2 ranks": ("run 120", 2), "parts": ("run 37\nrun 0\nrun 83", 0),
                              "a restart file written": ("run 60\nwrite_restart a.rest\nrun 60", 0),
                              "steps counted anew": ("run 60\nreset_timestep 5000\nrun 60", 0)}.items():
                with self.subTest(what, tangential=tangential):
                    self.assert_same(whole, end_of(how[0], tangential, how[1]), 120)

    def test_a_restart_file_goes_on(self):
        begin, side = gas_script("run 60\nwrite_restart a.rest\nrun 60" + END)
        whole = Run(begin).frames("end.txt")[-1]
        again = begin[begin.index("fix E all"):begin.index("run 60")]
        head = ("units si\natom_style granular\natom_modify map array\nboundary p p p\nnewton off\n"
                "communicate single vel yes\n")
        text = (begin[:begin.index("run 60\nwrite")] + "run 60\nwrite_restart a.rest\nclear\n" + head +
                "read_restart a.rest\nneighbor 1e-4 bin\nneigh_modify delay 0\n" +
                again.replace("dump out all custom 100000000 out.txt", "dump out all custom 100000000 more.txt") +
                "run 60" + END)
        self.assert_same(whole, Run(text).frames("end.txt")[-1], 120)

    def test_a_changed_step(self):
        # Spheres that touch with 1.1 and 0.9 of the escape velocity, the step changed while they fly and twice in a
        # contact that lasts: a run that takes another step begins with the state there, so that a contact is off by a
        # fraction of (w0 dt)^2/12 of the speed at t_c/16 and less: 0.3 %.
        constant = 7.49e-19
        for tangent in ("run 10\ntimestep TWICE\nrun 400\n", "run 16\ntimestep HALF\nrun 8\ntimestep TWICE\nrun 400\n"):
            for factor in (0.9, 1.1):
                dt = CONTACT_TIME / 16
                speed = factor * 4.00121e-3  # of tests/src/contact_solver: the closed form
                gap = OUT + 8.3 * speed * dt
                spheres = [sphere((0, 0, 0), (speed / 2, 0, 0)),
                           sphere((2 * RADIUS + gap, 0, 0), (-speed / 2, 0, 0))]
                text = tangent.replace("TWICE", repr(2 * dt)).replace("HALF", repr(dt / 2))
                end = Run(script(spheres, models() + EXACT, hamaker(constant, cut=CUT, out=1e-4), dt=dt, every=10**8,
                                 run=text + END, skin=2e-4)).frames("end.txt")[-1]
                apart = end[2][0] - end[1][0] > 2 * RADIUS + 1e-7
                with self.subTest(text=text, factor=factor):
                    self.assertEqual(apart, factor > 1)


class Wells(unittest.TestCase):
    """A cluster in wells of twice the radius of the particles, and of a thin one, cut into ranks, runs and files."""
    assert_same = Many.assert_same

    @staticmethod
    def end_of(run, ratio, ranks=0, inputs=None):
        spheres, side = gas(5, 0.3)
        dt = CONTACT_TIME / 10
        text = script(spheres, "model hooke/stiffness tangential off cohesion square_well" + EXACT,
                      square_well(5e-9, ratio=ratio), dt=dt, every=10**8, boundary="p p p",
                      box=f"0 {side} 0 {side} 0 {side}", run=run + END)
        done = Run(text, ranks=ranks)
        assert "from beyond what is seen" not in done.output, done.output
        return done.frames("end.txt")[-1]

    def test_another_step_keeps_the_impulse_of_an_edge(self):
        ratio, speed, dt = 1.1, 0.05, CONTACT_TIME / 20
        half = ratio * RADIUS + 4.5 * dt * speed
        spheres = [sphere((side * half, 0, 0), (-side * speed, 0, 0)) for side in (-1, 1)]
        ways = [(f"run {split}\ntimestep {part * dt!r}\n{zero}run 10", "") for split in (3, 4, 5, 6)
                for part in (0.5, 2) for zero in ("", "run 0\n")]
        # A step is as long as the speed says, and shorter as soon as the well accelerates both.
        ways.append(("run 16", f"fix reset all dt/reset 1 {dt / 10!r} {dt!r} {speed * dt!r}\n"))
        for run, extra in ways:
            end = Run(script(spheres, "model hooke/stiffness tangential off cohesion square_well" + EXACT,
                             square_well(MASS * speed**2, ratio=ratio), dt=dt, every=10**8, skin=2e-4, extra=extra,
                             run=run + END)).frames("end.txt")[-1]
            with self.subTest(run, extra=extra):
                # Places of 1 mm, rounded, in some twenty steps.
                for sphere_at_end in end.values():
                    self.assertAlmostEqual(abs(sphere_at_end[3]), math.sqrt(2) * speed, delta=20 * EPSILON * 1e-3 / dt)

    def test_ranks_and_runs_do_not_matter(self):
        for ratio in (1.05, 2.0):
            whole = self.end_of("run 120", ratio)
            for what, how in {"2 ranks": ("run 120", 2), "parts": ("run 37\nrun 0\nrun 83", 0),
                              "a restart file written": ("run 60\nwrite_restart a.rest\nrun 60", 0),
                              "steps counted anew": ("run 60\nreset_timestep 5000\nrun 60", 0)}.items():
                with self.subTest(what, ratio=ratio):
                    self.assert_same(whole, self.end_of(how[0], ratio, how[1]), 120)

    def test_a_restart_file_goes_on(self):
        spheres, side = gas(5, 0.3)
        words = "model hooke/stiffness tangential off cohesion square_well" + EXACT
        begin = script(spheres, words, square_well(5e-9, ratio=2.0), dt=CONTACT_TIME / 10, every=10**8,
                       boundary="p p p", box=f"0 {side} 0 {side} 0 {side}", run="")
        again = begin[begin.index("fix E all"):].replace("out.txt", "more.txt")
        head = ("clear\nunits si\natom_style granular\natom_modify map array\nboundary p p p\nnewton off\n"
                "communicate single vel yes\nread_restart a.rest\nneighbor 1e-4 bin\nneigh_modify delay 0\n")
        text = begin + "run 60\nwrite_restart a.rest\n" + head + again + "run 60" + END
        self.assert_same(self.end_of("run 120", 2.0), Run(text).frames("end.txt")[-1], 120)

    def test_a_plane_of_triangles_is_a_plane(self):
        """One sphere that is bound and bounces in its well, and one that leaves, over borders and nodes."""
        words, dt = "model hooke/stiffness tangential off cohesion square_well", CONTACT_TIME / 8

        def slid(walls, inputs):
            spheres = [sphere((-4e-3, -4e-3, 1.005 * RADIUS), (0.5, 0.3, -0.004)),
                       sphere((-4e-3, 0, 1.02 * RADIUS), (0.5, 0.3, -0.05))]
            return frames(spheres, words + EXACT, square_well(5e-11, ratio=1.01), dt=dt, steps=int(8e-3 / dt), every=20,
                          walls=walls, inputs=inputs, skin=2e-4)

        plane = slid([f"fix plate all wall/gran {words} primitive type 2 zplane 0 {EXACT}"], {})
        self.assertLess(plane[-1][1][2], 1.01 * RADIUS)
        self.assertGreater(plane[-1][2][2], 1.1 * RADIUS)
        for cells in (1, 10):
            walls = ["fix plate all mesh/surface file plate.stl type 2",
                     f"fix plates all wall/gran {words} mesh n_meshes 1 meshes plate {EXACT}"]
            corner, sides = (-9e-3, -9e-3, 0), ((18e-3, 0, 0), (0, 18e-3, 0))
            mesh = slid(walls, {"plate.stl": stl(rectangle(corner, *sides, cells))})
            with self.subTest(triangles=2 * cells**2):
                for found, right in zip(mesh, plane):
                    for k in right:
                        for one, other in zip(found[k][3:6], right[k][3:6]):
                            self.assertAlmostEqual(one, other, delta=100 * 8 * EPSILON * 0.03 / dt)

    def test_a_dense_elastic_gas_gains_none(self):
        """216 spheres at a volume fraction of 0.3, 40 collisions each. The velocities of a grid point are off by up to
        half of what an impulse at an edge does in its step, up to a depth for a pair. By Enskog's rate a sphere meets
        others a thousand times in a second, each time with two edges: four pairs in a step of t_c/5, so that what is
        seen scatters by two depths."""
        depth, ratio, part = 5e-9, 1.05, 5
        spheres, side = gas(6, 0.3)
        steps = int(0.04 / CONTACT_TIME * part)
        text = script(spheres, "model hooke/stiffness tangential off cohesion square_well" + EXACT,
                      square_well(depth, ratio=ratio), dt=CONTACT_TIME / part, every=steps // 8, contacts=elastic(),
                      boundary="p p p", box=f"0 {side} 0 {side} 0 {side}", run=f"run {steps}\n")
        energies = []
        for frame in Run(text).frames("out.txt"):
            near = gaps(frame, side, (ratio - 1) * DIAMETER)
            wells = len(near)
            energies.append(kinetic_energy(frame) + spring_energy(near) - wells * depth)
        self.assertGreater(wells, 50)
        change = (energies[-1] - energies[0]) / depth
        print(f"wells, t_c/{part}: {change:.1f} depths")
        self.assertLess(change, 3 * 2)


class Mesh(unittest.TestCase):
    def test_a_plane_of_triangles_is_a_plane(self):
        """Spheres that stick to a plate, and one that bounces, slide over borders and nodes. The engine takes the
        plane from nodes, rounded at the size of the mesh; a contact amplifies by the velocity over the step."""
        corner, sides = (-9e-3, -9e-3, 0), ((18e-3, 0, 0), (0, 18e-3, 0))
        dt = 0.53 * CONTACT_TIME / 8
        for tangential in ("off", "history"):
            words = models(tangential)

            def slid(walls, inputs):
                spheres = [sphere((-4e-3, -4e-3, RADIUS + 1e-8), (0.5, 0.3, -0.004)),
                           sphere((-4e-3, 0, RADIUS + 3e-7), (0.5, 0.3, -0.05)),
                           sphere((-5.2e-3, 3.6e-3 + 1e-7, RADIUS + 1e-7), (0.5, 0.3, -0.003))]
                return frames(spheres, words + EXACT, hamaker(2e-18, cut=CUT, out=OUT), dt=dt, steps=int(8e-3 / dt),
                              every=20, walls=walls, inputs=inputs, skin=2e-4)

            plane = slid([f"fix plate all wall/gran {words} primitive type 2 zplane 0 {EXACT}"], {})
            self.assertLess(plane[-1][1][2], RADIUS)  # stuck
            self.assertGreater(plane[-1][2][2], RADIUS + 1e-4)
            for cells in (1, 10):
                walls = ["fix plate all mesh/surface file plate.stl type 2",
                         f"fix plates all wall/gran {words} mesh n_meshes 1 meshes plate {EXACT}"]
                mesh = slid(walls, {"plate.stl": stl(rectangle(corner, *sides, cells))})
                with self.subTest(tangential=tangential, triangles=2 * cells**2):
                    for found, right in zip(mesh, plane):
                        for k in right:
                            for one, other in zip(found[k][3:6], right[k][3:6]):
                                self.assertAlmostEqual(one, other, delta=100 * 8 * EPSILON * 0.03 / dt)


class Energy(unittest.TestCase):
    def test_elastic_gases_gain_none(self):
        """216 spheres at a volume fraction of 0.45 that collide some thirty times each. A grid shows speeds off by up
        to half of what a force does in a step: of the spheres in contact, a tenth, by (w0 dt)^2/8 of their energy. Lost
        is less than in 100 collisions at a fraction of 0.5, by a program that knew neither engine."""
        for constant, speed in ((0, 0.1), (2e-18, 0.02)):
            for part, most_lost in ((4, None), (10, 7.7e-3), (20, 2.9e-4)):
                with self.subTest(constant=constant, part=part):
                    steps = int(1e-3 / speed / CONTACT_TIME * part)
                    text, side = gas_script(f"run {steps}", constant=constant, speed=speed, part=part, contacts=elastic())
                    text = text.replace("custom 100000000", f"custom {steps // 8}")
                    course = Run(text).frames("out.txt")
                    first, last = (energy(frame, side, Pair(constant)) for frame in (course[0], course[-1]))
                    seen = 0.1 * (math.pi / part)**2 / 8
                    change = (last - first) / kinetic_energy(course[0])
                    print(f"A = {constant:g} J, t_c/{part}: {change:.1e} of the energy")
                    self.assertLess(change, seen)
                    if most_lost:
                        self.assertGreater(change, -most_lost - seen)

    def test_momentum_is_kept(self):
        end = end_of("run 200", "history")
        for d in (3, 4, 5):
            self.assertAlmostEqual(sum(row[d] for row in end.values()), 0.0, delta=200 * 216 * EPSILON * 0.3)

    def test_a_heap_comes_to_rest(self):
        """Spheres fall on a plate, with friction: at the end less than a millionth of the energy of one that falls by
        its own diameter is left to each. How soon depends on the pile that they happen to make, which rounding decides:
        it took 0.4 to 0.9 s. Of the energy that is left half goes in 0.1 s, about."""
        for weights, part in ((0, 10), (20, 4)):
            with self.subTest(weights=weights, part=part):
                numbers = random.Random(3)
                edge, cell = 4, 1.15e-3
                spheres = [sphere([cell * (n + 0.5) + numbers.uniform(-6e-5, 6e-5) for n in (i, j, k)],
                                  [numbers.uniform(-0.05, 0.05) for _ in range(3)])
                           for i in range(edge) for j in range(edge) for k in range(edge)]
                constant = weights * MASS * 9.81 * 12 * CUT**2 / RADIUS
                plate = f"fix plate all wall/gran {models('history')} primitive type 2 zplane 0.0 {EXACT}"
                dt = 0.53 * CONTACT_TIME / part  # the spring of friction makes contacts so much shorter
                end = frames(spheres, models("history") + EXACT, hamaker(constant, cut=CUT, out=OUT), dt=dt,
                             steps=int(1.2 / dt), every=int(1.2 / dt), boundary="p p f",
                             box=f"0 {edge * cell} 0 {edge * cell} -1e-3 2e-2", skin=2e-4, walls=[plate],
                             extra="fix g all gravity 9.81 vector 0 0 -1\n")[-1]
                left = kinetic_energy(end)
                self.assertLess(left, 1e-6 * len(end) * MASS * 9.81 * 2 * RADIUS)


class Friction(unittest.TestCase):
    """Oblique impacts with friction against a sampled run at t_c/2000."""

    @staticmethod
    def impact(part, scheme, late, friction, slip):
        """Velocity and speed of the surface by spinning, over the speed at which surfaces slip at touch."""
        dt, speed = CONTACT_TIME / part, 0.05
        flight = (CUT + speed * dt * (2 + late)) / speed
        x, y = RADIUS + speed * flight / 2, slip * flight / 2
        spheres = [sphere((-x, -y, 0), (speed / 2, slip / 2, 0)), sphere((x, y, 0), (-speed / 2, -slip / 2, 0))]
        steps = int((flight + 3 * CONTACT_TIME) / dt)
        rows = contact().splitlines()
        rows = [" ".join(line.split()[:7]) + f" {friction}" * 4 if "coefficientFriction" in line else line
                for line in rows]
        end = frames(spheres, f"{models('history')} absolute_damping on scheme {scheme}",
                     hamaker(0, cut=CUT, out=OUT), dt=dt, steps=steps, every=steps, contacts="\n".join(rows) + "\n")[-1]
        change = [(a - b) / slip for a, b in zip(end[2][3:5], end[1][3:5])]
        return [*change, end[1][8] * RADIUS / slip]

    def test_beside_a_small_step(self):
        # The force of friction begins and ends on the grid: each up to half a step too early or late. In the shorter of
        # its spring's and the contact's time it can change the slip as a whole; a spring of K_t = K that turns solid
        # spheres has the frequency sqrt(3.5) w0.
        for friction, slip in ((5.0, 0.03), (0.3, 0.03), (0.3, 0.2)):
            exact = self.impact(2000, "sampled", 0.3, friction, slip)
            for part in (20, 40):
                room = 0.5 * math.sqrt(3.5) * math.pi / part
                for late in (0.1, 0.35, 0.6, 0.85):
                    with self.subTest(friction=friction, slip=slip, part=part, late=late):
                        for found, right in zip(self.impact(part, "exact", late, friction, slip), exact):
                            self.assertAlmostEqual(found, right, delta=room)


class Default(unittest.TestCase):
    """The scheme of contacts without the keyword."""

    BY_DEFAULT = "cohesion model hamaker: scheme exact by default ('scheme sampled' up to version 0.2)"
    PLANE = "primitive type 2 zplane -0.009"

    def output(self, keywords="", before="", run="run 1\nrun 1\n", extra="", wall_keywords=""):
        """Of two spheres above a plate, without the keyword where `keywords` do not have it."""
        text = script([sphere((0, 0, 0)), sphere((2e-3, 0, 0))], models(), hamaker(1e-19, cut=CUT, out=OUT),
                      walls=[f"fix plate all wall/gran {models()} {self.PLANE}{wall_keywords}"], dt=1e-7, run=run, extra=extra)
        run = Run(text.replace(models() + " scheme sampled", models() + keywords))
        self.assertEqual(run.code, 0, run.output[-3000:])
        return run.output

    def test_is_exact_and_a_wall_has_that_of_the_pairs(self):
        output = self.output()
        self.assertEqual(output.count(self.BY_DEFAULT), 1, output)
        self.assertIn("cohesion model hamaker, scheme exact: what to expect", output)
        self.assertIn("cohesion model hamaker, fix wall/gran plate, scheme exact: what to expect", output)
        self.assertNotIn("sampled:", output)

    def test_a_wall_beside_sampled_pairs_is_sampled(self):
        output = self.output(" scheme sampled")
        self.assertNotIn("by default", output)
        self.assertIn("cohesion model hamaker, fix wall/gran plate, scheme sampled: what to expect", output)

    def test_is_sampled_where_exact_is_impossible(self):
        for keywords, reason in ((" limitForce on", "cuts the force off where the dashpot pulls (limitForce)"),):
            with self.subTest(keywords):
                output = self.output(keywords, wall_keywords=keywords)
                self.assertEqual(output.count("cohesion model hamaker: scheme sampled by default: "), 1, output)
                self.assertIn(reason, output)
                self.assertIn("cohesion model hamaker, scheme sampled: what to expect", output)
                self.assertIn("cohesion model hamaker, fix wall/gran plate, scheme sampled: what to expect", output)

    def test_is_the_motion_of_the_keyword(self):
        # Two that fly against each other: the same digits as with the keyword.
        ends = []
        for keyword in ("", " scheme exact"):
            spheres = [sphere((0, 0, 0), (0.05, 0, 0)), sphere((2 * RADIUS + 2e-6, 0, 0), (-0.05, 0, 0))]
            words = models() + " absolute_damping on tangential_damping off"
            text = script(spheres, words, hamaker(1e-18, cut=CUT, out=OUT), dt=CONTACT_TIME / 10, steps=30, every=30)
            ends.append(Run(text.replace(" scheme sampled", keyword)).frames("out.txt")[-1])
        self.assertEqual(*ends)

    def test_a_restart_file_has_no_keywords(self):
        text = script([sphere((0, 0, 0))], models(), hamaker(1e-19, cut=CUT, out=OUT), run="run 1\nwrite_restart at.restart\n")
        start = text.index("region" if "region" in text else "create_box")
        again = text[:start] + "read_restart at.restart\n" + hamaker(1e-19, cut=CUT, out=OUT) + contact() + (
            "fix move all nve/sphere\ntimestep 1e-6\nrun 1\n")
        run = Run(text.replace(" scheme sampled", "") + "clear\n" + again)
        self.assertEqual(run.code, 0, run.output[-3000:])
        self.assertIn("scheme sampled by default: a restart file stores no keywords of contact models; repeat", run.output)


    def test_a_restart_file_of_scheme_sampled_needs_the_keyword(self):
        text = script([sphere((0, 0, 0)), sphere((9.99e-4, 0, 0))], models("history"), hamaker(1e-19, cut=CUT, out=OUT),
                      dt=1e-7, run="run 10\nwrite_restart at.restart\n")
        again = (text[:text.index("region")] + "read_restart at.restart\n" + hamaker(1e-19, cut=CUT, out=OUT) + contact()
                 + f"pair_style gran {models('history')}\npair_coeff * *\nfix move all nve/sphere\ntimestep 1e-7\nrun 1\n")
        run = Run(text + "clear\n" + again)
        self.assertNotEqual(run.code, 0, run.output[-3000:])
        self.assertIn("use 'scheme sampled' if that wrote the file", run.output)
        run = Run(text + "clear\n" + again.replace(models("history"), models("history") + " scheme sampled"))
        self.assertEqual(run.code, 0, run.output[-3000:])


class Input(unittest.TestCase):
    def refused(self, models, *messages, extra="", walls=(), end=""):
        with self.subTest(messages[0]):
            run = Run(script([sphere((0, 0, 0))], models, hamaker(1e-19, cut=CUT, out=OUT), walls=walls, extra=extra,
                             run=f"{end}run 1\n"))
            assert_refused(self, run, *messages)

    def test_what_it_cannot_follow(self):
        start = "model {} tangential off cohesion hamaker{}"
        viscous = ("fix mu all property/global FluidViscosity peratomtypepair 2 1e-3 1e-3 1e-3 1e-3\n"
                   "fix st all property/global CriticalStokes peratomtypepair 2 10 10 10 10\n"
                   "fix em all property/global MaximumRestitution peratomtypepair 2 0.9 0.9 0.9 0.9\n")
        self.refused(start.format("hooke", " viscous on scheme exact"), "depends on the speed", extra=viscous)
        self.refused(start.format("hooke", " limitForce on scheme exact"), "cuts the force off", "use 'scheme sampled'")
        self.refused(start.format("hertz", " limitForce on scheme exact"), "cuts the force off")
        self.refused(start.format("hooke", " scheme sometimes"), "scheme sometimes: must be exact or sampled")
        self.refused(start.format("hooke", " scheme sampled"), "needs a pair_style gran of scheme exact, too",
                     walls=["fix plate all wall/gran " + start.format("hooke", "") +
                            " primitive type 2 zplane -0.009 scheme exact"])

    def test_a_pair_that_comes_from_out_of_sight(self):
        spheres = [sphere((0, 0, 0), (2.0, 0, 0)), sphere((2 * RADIUS + 1.2e-4, 0, 0), (-2.0, 0, 0))]
        run = Run(script(spheres, models() + EXACT, hamaker(0, cut=CUT, out=OUT), dt=1.1e-5, steps=20))
        self.assertEqual(run.code, 0, run.output)
        self.assertEqual(run.output.count("from beyond what is seen"), 1, run.output)


if __name__ == "__main__":
    unittest.main()
