# SPDX-License-Identifier: BSD-3-Clause
"""Hard spheres with wells at planes, in a cylinder and between walls, in LAMMPS, against closed forms and an
event-driven reference."""
import math
import unittest
from collections import defaultdict

import numpy
from scipy.optimize import brentq

from cohesion_tests import lammps as engine
from cohesion_tests.lammps_scenes import hard_spheres as hard
from cohesion_tests.theory.event_driven_reference import Plane, Reference
from cohesion_tests.theory.rough_collision import struck


class Walls(unittest.TestCase):
    """Particles that fly at planes, one and its closed form each. Places of up to 40, 40 steps: 1e-13
    of 40 half units in the last place."""
    DEPTH, RATIO, E, MU = 0.2, 1.2, 0.8, 0.3

    def fly(self, wall, atoms, steps=60, dt=0.05, pair=None):
        with engine.temporary_folder() as folder:
            engine.write_spheres(folder, atoms, [(0.0, 10.0), (0.0, 100.0), (0.0, 100.0)], 1)
            path, table, _ = hard.run(
                folder, pair or [f"* * restitution 1 well {self.DEPTH} {self.RATIO}"], dt, steps,
                style="record events.txt", boundary="f p p",
                more=[f"fix sides all wall/hard/squarewell {wall}"])
            events = defaultdict(list)
            for event in hard.recorded(folder):
                self.assertTrue(event.kind.startswith("wall_"))
                self.assertLess(event.j, 0)
                events[event.i - 1].append(event)
        return path, events, table

    def atoms(self, speeds, radius=0.5):
        """To the lower and the upper plane in turn, half a length before the core's contact."""
        return [hard.atom((radius + 0.5 if n % 2 == 0 else 9.5 - radius, 2.0 + 4 * (n % 20),
                           2.0 + 4 * (n // 20)),
                          (-v if n % 2 == 0 else v, 0.3, -0.1), radius, 1.5 + 0.1 * n)
                for n, v in enumerate(speeds)]

    def through(self, depth, wall):
        speeds = numpy.linspace(0.3, 2.0, 30)
        atoms = self.atoms(speeds)
        path, events, table = self.fly(wall, atoms)
        seen = set()
        for n, speed in enumerate(speeds):
            mass = 1.5 + 0.1 * n
            well = 2 * depth / mass
            inner = math.sqrt(speed**2 + well)
            gap = (self.RATIO - 1) * 0.5
            times = [(0.5 - gap) / speed]
            times += [times[0] + gap / inner, times[0] + gap / inner + gap / (self.E * inner)]
            free = (self.E * inner)**2 > well
            kinds = ["approach", "collision", "escape" if free else "capture"]
            if not depth:
                times, kinds = [0.5 / speed], ["collision"]
                free = True
            self.assertEqual([event.kind for event in events[n][:3]],
                             ["wall_" + kind for kind in kinds])
            numpy.testing.assert_allclose(hard.times(events[n][:3], 0.05), times, rtol=0, atol=1e-12)
            if free:
                away = math.sqrt((self.E * inner)**2 - well)
                sign = 1 if n % 2 == 0 else -1
                numpy.testing.assert_allclose(path[-1, n, 4:7], [sign * away, 0.3, -0.1], rtol=0,
                                              atol=1e-13)
            seen.add(kinds[-1])
        return seen

    def test_depth_is_twice_the_pairs(self):
        self.assertEqual(self.through(2 * self.DEPTH, f"restitution {self.E} xplane 0 10"),
                         {"escape", "capture"})

    def test_own_well(self):
        self.through(0.7, f"restitution {self.E} well 0.7 {self.RATIO} xplane 0 10")

    def test_no_well(self):
        self.through(0.0, f"restitution {self.E} well off xplane 0 10")

    def test_friction(self):
        """As with a partner of infinite mass; slow spins stick, fast ones slide."""
        atoms = self.atoms(numpy.full(30, 1.0))
        spins = numpy.random.default_rng(2).normal(size=(30, 3)) * numpy.linspace(0.1, 6, 30)[:, None]
        for atom, spin in zip(atoms, spins):
            atom["omega"] = spin
        path, _, table = self.fly(f"restitution {self.E} friction {self.MU} well off xplane 0 10",
                                  atoms)
        stuck, lost = 0, 0.0
        for n, atom in enumerate(atoms):
            mass = 1.5 + 0.1 * n
            k = numpy.array([-1.0 if n % 2 == 0 else 1.0, 0.0, 0.0])
            v, spin, loss, sticks = struck(None, (mass, math.inf), (0.5, 0.5),
                                           (numpy.zeros(3), k), (atom["v"], numpy.zeros(3)),
                                           (spins[n], numpy.zeros(3)), self.E, self.MU, 0.4)
            numpy.testing.assert_allclose(path[-1, n, 4:7], v[0], rtol=0, atol=1e-13)
            numpy.testing.assert_allclose(path[-1, n, 7:10], spin[0], rtol=0, atol=1e-13)
            stuck, lost = stuck + sticks, lost + loss
        self.assertTrue(5 < stuck < 25)
        # Walls' own group: 18 columns, then the same again.
        self.assertEqual(table["c_events[19]"][-1], 30)
        self.assertAlmostEqual(table["c_events[23]"][-1], -lost, delta=1e-12)
        self.assertEqual(table["c_events[1]"][-1], 0)

    def test_wall_that_moves_towards(self):
        # Both planes move at 0.2: a lower that pushes, an upper that recedes.
        atoms = self.atoms(numpy.full(2, 1.0))
        path, events, _ = self.fly("restitution 0.8 well off xplane 0 10 translate x 0.2", atoms)
        for n, (v, wall) in enumerate(((-1.0, 0.2), (1.0, 0.2))):
            self.assertAlmostEqual(hard.times(events[n], 0.05)[0], 0.5 / (1.2 if n == 0 else 0.8),
                                   delta=1e-12)
            self.assertAlmostEqual(path[-1, n, 4], wall - 0.8 * (v - wall), delta=1e-13)

    def test_wall_that_swings(self):
        """x = A (1 - cos wt), as LAMMPS' walls swing: the elastic particle leaves with twice the wall's
        speed at the hit. Where a step takes the wall along a chord, its place is wrong by
        A w^2 dt^2/8 and its speed by A w^2 dt/2."""
        amplitude, period, dt = 0.1, 3.0, 0.01
        w = 2 * math.pi / period
        atoms = self.atoms(numpy.linspace(0.5, 2.0, 20))[::2]
        path, events, _ = self.fly(
            f"restitution 1 well off xplane 0 20 wiggle x {amplitude} {period}", atoms, 150, dt)
        for n, atom in enumerate(atoms):
            speed = -atom["v"][0]
            hit = brentq(lambda t, speed=speed: 0.5 - speed * t - amplitude * (1 - math.cos(w * t)),
                         0, 0.5 / speed)
            bend = amplitude * w * w
            self.assertAlmostEqual(hard.times(events[n][:1], dt)[0], hit, delta=bend * dt * dt / 8
                                   / (speed + amplitude * w * math.sin(w * hit)) * 1.1)
            self.assertAlmostEqual(path[-1, n, 4], speed + 2 * amplitude * w * math.sin(w * hit),
                                   delta=bend * dt * 1.1)

    def test_wall_that_slides(self):
        # At 1 along y, with friction that stops nothing at 0.05: tangential impulse 0.05 (1+e) m v.
        atoms = self.atoms(numpy.full(2, 1.0))
        path, _, _ = self.fly("restitution 0.8 friction 0.05 well off xplane 0 10 shear y 1.0", atoms)
        direction = numpy.array([0.7, 0.1]) / math.hypot(0.7, 0.1)
        for n in range(2):
            numpy.testing.assert_allclose(path[-1, n, 5:7], [0.3, -0.1] + 0.05 * 1.8 * direction,
                                          rtol=0, atol=1e-13)


class Cylinder(unittest.TestCase):
    """One particle in a cylinder along z: angular momentum and, elastic, energy are kept, so chords, ways
    through the well and angles between them repeat. Places of up to 10, 200 steps of half a unit in the
    last place, 2e-13 of a chord's offset; 40 turns add up its part in the angle, 2 over the sine of
    0.5: 4e-11."""
    RADIUS, RATIO, DEPTH = 3.0, 1.4, 0.2

    def turn(self, depth, restitution=1.0, steps=200):
        """Offset 1.2 of the first chord, from its middle; speed 1.1 across, 0.25 along."""
        atom = hard.atom((10.0, 11.2, 10.0), (1.1, 0.0, 0.25), 0.4, 1.3)
        words = f"well {depth} {self.RATIO}" if depth else "well off"
        with engine.temporary_folder() as folder:
            engine.write_spheres(folder, [atom], 3 * [(0.0, 20.0)], 1)
            path, _, _ = hard.run(
                folder, ["* * restitution 1"], 0.37, steps, boundary="f f p", skin=2.0, every=10,
                style="record events.txt",
                more=["displace_atoms all move -10 -10 0", "change_box all x final -10 10 y final "
                      "-10 10", f"fix pipe all wall/hard/squarewell restitution {restitution} "
                      f"{words} zcylinder {self.RADIUS}"])
            return path, hard.recorded(folder)

    def test_elastic(self):
        for depth in (0.0, self.DEPTH):
            with self.subTest(depth=depth):
                path, events = self.turn(depth)
                core, edge = self.RADIUS - 0.4, self.RADIUS - self.RATIO * 0.4
                speed, offset = 1.1, 1.2
                if not depth:
                    edge = core
                faster = math.sqrt(speed**2 + 2 * depth / 1.3)
                nearer = offset * speed / faster
                chord = math.sqrt(edge**2 - offset**2)
                well = (math.sqrt(core**2 - nearer**2) - math.sqrt(edge**2 - nearer**2)) / faster
                period = 2 * (chord / speed + well)
                starts = chord / speed + period * numpy.arange(math.ceil(74 / period))
                pattern = ([("approach", 0.0), ("collision", well), ("escape", 2 * well)] if depth
                           else [("collision", 0.0)])
                expected = [("wall_" + kind, start + late) for start in starts
                            for kind, late in pattern if start + late < 74]
                self.assertGreater(len(expected), 15)
                self.assertEqual([event.kind for event in events], [kind for kind, _ in expected])
                numpy.testing.assert_allclose(hard.times(events, 0.37), [t for _, t in expected],
                                              rtol=0, atol=4e-11)
                across = numpy.linalg.norm(path[:, 0, 4:6], axis=1)
                self.assertLess(numpy.minimum(abs(across - speed), abs(across - faster)).max(), 1e-13)
                spin = path[:, 0, 1] * path[:, 0, 5] - path[:, 0, 2] * path[:, 0, 4]
                numpy.testing.assert_allclose(spin, -1.2 * 1.1, rtol=0, atol=1e-12)
                numpy.testing.assert_array_equal(path[:, 0, 6], 0.25)

    def test_restitution(self):
        """Each collision leaves e of the normal and all of the tangential speed."""
        _, events = self.turn(0.0, 0.7, 70)
        core, turning = 2.6, 1.2 * 1.1 / 2.6
        normal = math.sqrt(1.1**2 - turning**2)
        time, times = math.sqrt(core**2 - 1.2**2) / 1.1, []
        while time < 70 * 0.37:
            times.append(time)
            normal *= 0.7
            time += 2 * core * normal / (normal**2 + turning**2)
        self.assertGreater(len(times), 5)
        numpy.testing.assert_allclose(hard.times(events, 0.37), times, rtol=0, atol=4e-11)


class BetweenWalls(unittest.TestCase):
    """Two particles on a line between elastic walls, r_out/r = 1.5, D = 1, e = 1, start to start: speed
    0.75 outside and 1.25 inside the well, 1.0 s from the edge to the wall and 0.2 s from the edge to
    the core, so a return every 2.4 s and five events. All speeds are dyadic and the roots exact:
    only the places gather round-off, 2e-16 for each of 7000 steps and 5000 events, 4e-14 by chance
    and 2e-12 if all went one way; the step itself, 2.4/7, is wrong by up to 5e-17 of it: 0.75 times
    1000 times 2.4e-16 = 2e-13."""
    EVENTS = ["approach", "collision", "escape", "wall_collision", "wall_collision"]

    def returns(self, dt, steps, times, depth_of_walls="off"):
        start = [[1.0, 0.0, 0.0], [3.0, 0.0, 0.0]]
        atoms = [hard.atom(start[0], (0.75, 0, 0)), hard.atom(start[1], (-0.75, 0, 0))]
        with engine.temporary_folder() as folder:
            engine.write_spheres(folder, atoms, [(0.0, 4.0), (-10.0, 10.0), (-10.0, 10.0)], 1)
            path, table, _ = hard.run(
                folder, ["* * restitution 1 well 1 1.5"], dt, steps, boundary="f p p", skin=20.0,
                style="record events.txt", every=max(1, steps // 50),
                more=["fix sides all wall/hard/squarewell restitution 1 well "
                      f"{depth_of_walls} xplane 0 4"])
            events = hard.recorded(folder)
        numpy.testing.assert_allclose(path[-1, :, 1:4], start, rtol=0, atol=1e-12)
        numpy.testing.assert_allclose(path[-1, :, 4], [0.75, -0.75], rtol=0, atol=1e-14)
        self.assertEqual([event.kind for event in events], times * self.EVENTS)
        total = table["KinEng"] + table["PotEng"]
        self.assertLess(abs(total - total[0]).max(), 1e-14)

    def test_seven_steps_a_return(self):
        self.returns(2.4 / 7, 7000, 1000)

    def test_two_returns_a_step(self):
        self.returns(4.8, 500, 1000)

    def test_against_the_reference(self):
        """Unequal masses, walls with wells of their own: 200 events of the reference. 1e-16 of
        speeds, over 60 s: 1e-14 a few times."""
        atoms = [hard.atom((1.0, 0, 0), (0.9, 0, 0), mass=1.0), hard.atom((3.0, 0, 0), (-0.4, 0, 0),
                                                                         mass=2.0)]
        with engine.temporary_folder() as folder:
            engine.write_spheres(folder, atoms, [(0.0, 4.0), (-10.0, 10.0), (-10.0, 10.0)], 1)
            path, _, _ = hard.run(folder, ["* * restitution 1 well 0.3 1.5"], 0.37, 200, skin=5.0,
                                  boundary="f p p", style="record events.txt",
                                  more=["fix sides all wall/hard/squarewell restitution 1 "
                                        "xplane 0 4"])
            events = hard.recorded(folder)
        planes = [Plane(0, 0.0, 1, 1.0, 0.0, 0.6, 1.5), Plane(0, 4.0, -1, 1.0, 0.0, 0.6, 1.5)]
        exact = Reference([[1.0, 0, 0], [3.0, 0, 0]], [[0.9, 0, 0], [-0.4, 0, 0]], 0.5, [1.0, 2.0],
                          3 * [math.inf], 1.0, 0.0, 0.3, 1.5, planes=planes)
        exact.run(0.37 * 200)
        self.assertGreater(len(exact.events), 200)
        self.assertEqual([event.kind.replace("wall_", "") for event in events],
                         [event.kind for event in exact.events])
        numpy.testing.assert_allclose(hard.times(events, 0.37), [event.time for event in exact.events],
                                      rtol=0, atol=1e-11)
        numpy.testing.assert_allclose(path[-1, :, 1:4], exact.place(exact.now), rtol=0, atol=1e-11)


class TiltedBox(unittest.TestCase):
    """A box tilted in all three ways, fixed along one axis: particles turn round at a plane within a step, by whose end
    free flight would have taken them out of the box, and go on as in closed form. Where they hit it the plane is at the
    box's boundary, which leans. Lengths are dyadic, so that what rounds is the engine's way to the box's own
    coordinates and back, some ten times 1.8e-15 in each step: 1e-13."""
    EDGE, DT, STEPS = 10.0, 0.4, 4
    XY, XZ, YZ = 2.5, 1.75, 2.0
    ALONG = ((0, -0.5, 1), (1, 0, 0), (1, 0, 0))  # in which direction the boundary of each axis is nowhere farther

    def lean(self, axis, place):
        """Of the boundary of an axis, by hand: the box's edges are (10, 0, 0), (2.5, 10, 0) and (1.75, 2, 10)."""
        up = place[2] / self.EDGE
        back = (place[1] - up * self.YZ) / self.EDGE
        return (back * self.XY + up * self.XZ, up * self.YZ, 0.0)[axis]

    def turn(self, axis, side):
        middle = numpy.full(3, 5.0)
        plane = float(self.EDGE * side + self.lean(axis, middle))
        out = 2 * side - 1
        speeds = numpy.linspace(0.5, 6, 5)
        atoms = []
        for n, speed in enumerate(speeds):
            place = middle + (n - 2) * numpy.array(self.ALONG[axis])
            self.assertAlmostEqual(self.lean(axis, place), self.lean(axis, middle), delta=1e-14)
            place[axis] = plane - 0.875 * out
            atoms.append(hard.atom(place, out * speed * numpy.eye(3)[axis], 0.125, 1.3))
        self.assertGreater(speeds[-1] * self.DT, 0.875)  # out of the box
        with engine.temporary_folder() as folder:
            engine.write_spheres(folder, atoms, 3 * [(0.0, self.EDGE)], 1, tilt=(self.XY, self.XZ, self.YZ))
            where = f"{plane!r} NULL" if side == 0 else f"NULL {plane!r}"
            path, _, _ = hard.run(
                folder, ["* * restitution 1"], self.DT, self.STEPS, skin=0.05, every=1,
                boundary=" ".join("f" if k == axis else "p" for k in range(3)),
                more=[f"fix side all wall/hard/squarewell restitution 1 well off {'xyz'[axis]}plane {where}"])
        time = self.DT * numpy.arange(self.STEPS + 1)[:, None]
        distance = 0.125 + abs(0.75 - speeds * time)
        self.assertLess(distance.max(), self.EDGE - 0.125)
        numpy.testing.assert_allclose(path[:, :, 1 + axis], plane - out * distance, rtol=0, atol=1e-13)

    def test_at_each_boundary(self):
        for axis in range(3):
            for side in (0, 1):
                with self.subTest(axis="xyz"[axis], side=side):
                    self.turn(axis, side)


if __name__ == "__main__":
    unittest.main()
