# SPDX-License-Identifier: BSD-3-Clause
"""What breaks naive codes, under pair_style hard/squarewell: many events in one step, thin wells, grazing passes,
captured pairs and triples."""
import math
import unittest

import numpy

from cohesion_tests.lammps_scenes import hard_spheres as hard
from cohesion_tests.lammps_scenes.hard_extremes import follow, like_reference
from cohesion_tests.theory.event_driven_reference import Reference
from cohesion_tests.theory.hard_encounter import encounter


class OneStep(unittest.TestCase):
    def test_cradle(self):
        """The first of five in a row strikes; the last leaves: four events within a step of 5, each
        particle's two within 0.1. Speeds and times are exact but for round-off."""
        places = [2.0, 4.0, 5.1, 6.2, 7.3]
        atoms = [hard.atom((x, 10, 10), (1.0 if x == 2 else 0.0, 0, 0)) for x in places]
        path, events, table, _ = follow(atoms, ["* * restitution 1"], 5.0, 1, skin=12.0)
        numpy.testing.assert_allclose(path[-1, :, 1], [3.0, 4.1, 5.2, 6.3, 7.3 + 5 - 1.3], rtol=0,
                                      atol=1e-14)
        numpy.testing.assert_array_equal(path[-1, :, 4], [0, 0, 0, 0, 1.0])
        numpy.testing.assert_allclose(hard.times(events, 5.0), [1.0, 1.1, 1.2, 1.3], rtol=0, atol=1e-14)
        # The second to the fourth: two each.
        self.assertEqual(table["c_events[18]"][-1], 2)

    def test_cradle_of_touching_particles(self):
        """As they hang in a toy: distances are the sum of radii to round-off, more or less of it. All
        four strikes at once, in the order of the row, and again when the row is struck back."""
        for first in (4.0, 4.1, 4.3, 4.7):
            for ranks in (1, 2):
                with self.subTest(first=first, ranks=ranks):
                    places = [2.0, *(first + n for n in range(4)), 15.0]
                    speeds = [1.0, 0, 0, 0, 0, -1.0]
                    atoms = [hard.atom((x, 10, 10), (v, 0, 0)) for x, v in zip(places, speeds)]
                    path, events, _, _ = follow(atoms, ["* * restitution 1"], 2.0, 4, skin=8.0,
                                                ranks=ranks)
                    pairs = [(event.i, event.j) for event in events]
                    self.assertEqual(sorted(pairs[:4]), [(1, 2), (2, 3), (3, 4), (4, 5)])
                    numpy.testing.assert_allclose(hard.times(events[:4], 2.0), first - 3, rtol=0,
                                                  atol=1e-14)
                    # The last of the row and the one that comes meet half-way and exchange speeds,
                    # then the row is struck from the right, and its first leaves.
                    self.assertEqual(pairs[4], (5, 6))
                    self.assertEqual(sorted(pairs[5:]), [(1, 2), (2, 3), (3, 4), (4, 5)])
                    numpy.testing.assert_allclose(path[-1, :, 4], [-1, 0, 0, 0, 0, 1], rtol=0,
                                                  atol=1e-15)

    def test_third_particle_comes_first(self):
        """A pair that would meet at 1.0 is parted by a third that strikes one of them at 0.5."""
        atoms = [hard.atom((5.0, 10, 10), (1.0, 0, 0)), hard.atom((8.0, 10, 10), (-1.0, 0, 0)),
                 hard.atom((8.3, 12.0, 10), (-1.0, -2.0, 0))]
        exact = Reference([atom["x"] for atom in atoms], [atom["v"] for atom in atoms], 0.5, 1.0,
                          3 * [20.0])
        like_reference(self, atoms, ["* * restitution 1"], exact, 2.0, 1, 1e-13, skin=12.0)
        self.assertEqual((exact.events[0].particle, exact.events[0].partner), (1, 2))
        self.assertNotIn((0, 1), [(event.particle, event.partner) for event in exact.events])

    def test_many_events_on_few(self):
        """Eight discs with wells in a small box, ten events in a step, in which they fly up to nine
        tenths of a box length. Paths part by factors of up to 10 a collision: the reference, moved
        by round-off, stays within 1e-10."""
        random = numpy.random.default_rng(3)
        grid = numpy.array(numpy.meshgrid([1.0, 3.0, 5.0], [1.0, 3.0, 5.0])).reshape(2, -1).T[:8]
        x = numpy.c_[grid, numpy.zeros(8)]
        v = numpy.c_[random.normal(size=(8, 2)), numpy.zeros(8)]
        atoms = [hard.atom(*row) for row in zip(x, v)]
        exact = Reference(x, v, 0.5, 1.0, [6.0, 6.0, math.inf], 0.9, 0.0, 0.2, 1.2)
        twin = Reference(x + 2e-15, v * (1 + 1e-15), 0.5, 1.0, [6.0, 6.0, math.inf], 0.9, 0.0, 0.2,
                         1.2)
        twin.run(3.2)
        table = like_reference(self, atoms, ["* * restitution 0.9 well 0.2 1.2"], exact, 1.6, 2, 1e-9,
                               box=[(0.0, 6.0), (0.0, 6.0), (-0.5, 0.5)], dimension=2, skin=30.0)
        self.assertLess(abs(twin.place(3.2) - exact.place(3.2) - 2e-15).max(), 1e-10)
        self.assertGreater(len(exact.events), 40)
        self.assertGreater(table["c_events[18]"][-1], 6)


class LongFlights(unittest.TestCase):
    """Steps in which free flights lead around most of the box, and an event turns them back: the engine wraps by one
    box."""
    BOX = numpy.array([20.0, 4.0, 4.0])
    STEPS = 40
    # Each of some 100 events adds the rounding of a place on the way of 760 (1.1e-13) and that of a time up to 40
    # at a speed up to 19 (1.3e-13).
    TOLERANCE = 100 * 2.4e-13

    def row(self, axis, part):
        """Three of a row along an axis, where equal masses exchange velocities and round-off does not grow."""
        sides = numpy.roll(self.BOX, axis)
        x, v = numpy.full((3, 3), 2.0), numpy.zeros((3, 3))
        x[:, axis] = [2.2, 9.0, 16.6]
        v[:, axis] = part * self.BOX[0] * numpy.array([1.0, -0.4, 0.3])
        exact = Reference(x, v, 0.5, 1.0, sides)
        with self.subTest(axis=axis, part=part):
            like_reference(self, [hard.atom(*row) for row in zip(x, v)], ["* * restitution 1"], exact, 1.0,
                           self.STEPS, self.TOLERANCE, box=[(0.0, side) for side in sides.tolist()], skin=0.5)

    def test_along_each_axis(self):
        for axis in range(3):
            for part in (0.45, 0.55, 0.95):
                self.row(axis, part)


class Order(unittest.TestCase):
    """What comes first is decided by chains of events that reach farther than any particle's neighbours,
    on any number of ranks."""
    # On the first's left, 0.833 s away, one that comes slowly; on its right a chain that strikes it at
    # 0.75: it begins beyond the reach of the neighbour list, 1 + 1.25 skin.
    PLACES = numpy.array([-1.1, 0.0, 1.1, 2.2, 3.3])
    SPEEDS = numpy.array([0.12, 0.0, 0.0, 0.0, -0.4])

    # All around where ranks meet, and across the periodic boundary.
    MIDDLES = (-1.7, 0.3, 7.9, 8.6, 9.4, 10.0, 10.9, 19.2)

    def chain(self, ranks):
        for axis in range(3):
            x, v = numpy.full((len(self.MIDDLES), 5, 3), 9.7), numpy.zeros((len(self.MIDDLES), 5, 3))
            for n, middle in enumerate(self.MIDDLES):
                x[n, :, axis] = (self.PLACES + middle) % 20
                x[n, :, axis - 1] = 1.0 + 2.4 * n
                v[n, :, axis] = self.SPEEDS
            x, v = x.reshape(-1, 3), v.reshape(-1, 3)
            exact = Reference(x, v, 0.5, 1.0, 3 * [20.0])
            with self.subTest(axis=axis):
                like_reference(self, [hard.atom(*row) for row in zip(x, v)], ["* * restitution 1"],
                               exact, 1.0, 2, 1e-13, skin=0.8, ranks=ranks)
                self.assertEqual([(event.particle, event.partner) for event in exact.events
                                  if event.particle < 5][:4], [(3, 4), (2, 3), (1, 2), (0, 1)])

    def test_chain(self):
        self.chain(1)

    def test_chain_on_four_ranks(self):
        self.chain(4)


class ThinWell(unittest.TestCase):
    def test_passes_through_in_one_step(self):
        """Wells of 1e-3 to 1e-9 of the size, crossed in a step of a flight of 0.7. The time within is
        known to the round-off of places up to 20, 4e-15, over speeds of order one."""
        for ratio in (1 + 1e-3, 1 + 1e-6, 1 + 1e-9):
            atoms = [hard.atom((5.0, 10, 10), (0, 0, 0)), hard.atom((6.3, 10, 10), (-1.4, 0, 0))]
            path, events, _, _ = follow(atoms, [f"* * restitution 0.9 well 0.05 {ratio:.17g}"], 0.5, 2,
                                        skin=6.0)
            meeting = encounter(1.4, 0.0, 1.0, ratio, 0.2, 0.9)
            self.assertEqual([event.kind for event in events], meeting.kinds)
            numpy.testing.assert_allclose(hard.times(events, 0.5), (1.3 - ratio) / 1.4
                                          + numpy.array(meeting.times), rtol=0, atol=1e-14)
            away = meeting.velocity[0]
            self.assertAlmostEqual(path[-1, 0, 4], -0.7 - 0.5 * abs(away), delta=1e-14)
            self.assertAlmostEqual(path[-1, 1, 4], -0.7 + 0.5 * abs(away), delta=1e-14)

    def test_captured(self):
        """An elastic pair within a well of 1e-4, relative speed 0.7 below 2: rattles 1750 times a step
        of 0.5, and neither parts nor loses energy: round-off of 1e-16 an event, 3.5e4 of them."""
        atoms = [hard.atom((5.0, 10, 10), (0.35, 0, 0)), hard.atom((6.00005, 10, 10), (-0.35, 0, 0))]
        path, _, table, _ = follow(atoms, ["* * restitution 1 well 1 1.0001"], 0.5, 20, skin=3.0,
                                   style="collapse off", every=1)
        distance = path[:, 1, 1] - path[:, 0, 1]
        self.assertTrue((distance > 1 - 1e-14).all() and (distance < 1.0001 + 1e-14).all())
        self.assertLess(abs(table["KinEng"] - 0.35**2).max(), 1e-12)
        self.assertEqual(hard.counts(table)["escape"][-1], 0)
        # 0.7*10/2e-4 returns.
        self.assertAlmostEqual(hard.counts(table)["capture"][-1], 35000, delta=1)


class Grazing(unittest.TestCase):
    """Passes that miss or touch a surface by 10^-n of its radius. The normal part of the speed there is
    sqrt(2 10^-n) of it, and is known to 1e-14/sqrt(2 10^-n), from places of up to 20 and 60 steps."""

    def passes(self, surface, core, edge, steps=60):
        """(relative distance from the surface, kinds, velocity) of each."""
        atoms, margins = [], [sign * 10.0**-n for n in range(3, 13) for sign in (-1, 1)]
        for n, margin in enumerate(margins):
            centre = numpy.array([2.0 + 4 * (n % 5), 2.0 + 4 * (n // 5), 2.0])
            atoms += [hard.atom(centre, (0, 0, 0), core / 2),
                      hard.atom(centre + [-1.9, surface * (1 + margin), 0], (1.0, 0, 0), core / 2)]
        well = f"well 0.1 {edge / core}" if edge > core else ""
        path, events, table, _ = follow(atoms, [f"* * restitution 1 {well}"], 0.06, steps)
        total = table["KinEng"] + table["PotEng"]
        self.assertLess(abs(total - total[0]).max(), 1e-13)
        for n, margin in enumerate(margins):
            yield (margin, [event.kind for event in events if event.i == 2 * n + 1],
                   path[-1, 2 * n + 1, 4:7] - path[-1, 2 * n, 4:7])

    def test_core(self):
        for margin, kinds, velocity in self.passes(1.0, 1.0, 1.0):
            self.assertEqual(kinds, ["collision"] if margin < 0 else [], margin)
            expected = numpy.array([1.0, 0.0, 0.0])
            if margin < 0:
                normal = math.sqrt(1 - (1 + margin)**2)
                expected += 2 * normal * numpy.array([-normal, 1 + margin, 0.0])
            numpy.testing.assert_allclose(velocity, expected, rtol=0,
                                          atol=3e-14 / math.sqrt(abs(margin)))

    def test_edge(self):
        """Just within, the pair is refracted by a finite angle and let go again; never captured."""
        for margin, kinds, velocity in self.passes(1.2, 0.6, 1.2):
            expected = [1.0, 0.0]
            if margin < 0:
                meeting = encounter(1.0, 1.2 * (1 + margin), 0.6, 1.2, 0.4, 1.0)
                self.assertEqual(kinds, meeting.kinds, margin)
                expected = meeting.velocity
            else:
                self.assertEqual(kinds, [], margin)
            numpy.testing.assert_allclose(velocity[:2], expected, rtol=0,
                                          atol=2e-13 / math.sqrt(abs(margin)))

    def test_core_within_a_well(self):
        # The offset that just touches the core after refraction: core sqrt(1 + well).
        for margin, kinds, _ in self.passes(0.6 * math.sqrt(1.4), 0.6, 1.2):
            self.assertEqual(kinds, ["approach", *(["collision"] if margin < 0 else []), "escape"])


class Captured(unittest.TestCase):
    STEPS = 1000000

    def test_falls_freely(self):
        """Under gravity along and across the line of centres, the motion of the pair within itself is
        what it is without: energy to the round-off of velocities of up to 5, 9e-16 a step by chance,
        times the relative speed: 2e-13 over all; with restitution it never grows."""
        for restitution in (1.0, 0.7):
            for way in ("1 0 0", "0 1 0"):
                with self.subTest(restitution=restitution, way=way):
                    fall = numpy.array([float(word) for word in way.split()])
                    v = -0.5 * self.STEPS * 1e-5 * fall
                    atoms = [hard.atom((10, 10, 10), v + [0.1, 0.05, 0]),
                             hard.atom((11.03, 10, 10), v - [0.1, 0.05, 0])]
                    path, _, table, _ = follow(
                        atoms, [f"* * restitution {restitution} well 1 1.05"], 0.01, self.STEPS,
                        style="", skin=1.0, every=self.STEPS // 100,
                        more=[f"fix down all gravity 0.001 vector {way}"])
                    inner = ((path[:, 1, 4:7] - path[:, 0, 4:7])**2).sum(axis=1) / 4
                    self.assertLess(numpy.diff(inner).max(), 1e-12)
                    if restitution == 1:
                        self.assertLess(abs(inner - inner[0]).max(), 1e-12)
                    else:
                        self.assertLess(inner[-1], 0.9 * inner[0])
                    counts = hard.counts(table)
                    self.assertEqual(counts["approach"][-1] + counts["escape"][-1], 0)
                    self.assertGreater(counts["capture"][-1], 100)
                    apart = path[:, 1, 1:4] - path[:, 0, 1:4]
                    apart -= 20 * numpy.rint(apart / 20)
                    distance = numpy.linalg.norm(apart, axis=1)
                    self.assertTrue((distance < 1.05 + 1e-12).all() and (distance > 1 - 1e-12).all())

    def test_hangs_on_a_fixed_particle(self):
        """Gravity pulls out of the well and across; the first particle does not move, as if of infinite
        mass. Between events a step keeps v^2/2 + g x; an event at the fraction s of a step changes it by
        (1/2 - s) g dt times the change of velocity: at most g dt v, either way by chance, so that of
        n events is left g dt v sqrt(n/3); four times that, with the largest speed."""
        gravity, dt, mass = 0.01, 0.01, 2.0
        for way in ((1, 0, 0), (0, 1, 0)):
            with self.subTest(way=way):
                atoms = [hard.atom((10, 10, 10), (0, 0, 0)),
                         hard.atom((11.02, 10, 10), (0.1, 0.05, 0), mass=mass)]
                path, _, table, _ = follow(
                    atoms, ["* * restitution 0.8 well 1 1.05"], dt, self.STEPS, style="", skin=1.0,
                    every=self.STEPS // 1000,
                    more=[f"fix down moving gravity {gravity} vector {way[0]} {way[1]} {way[2]}"],
                    group="moving", before=["group moving id 2"])
                numpy.testing.assert_array_equal(path[:, 0, 1:7],
                                                 numpy.tile([10, 10, 10, 0, 0, 0.0], (len(path), 1)))
                energy = mass * ((path[:, 1, 4:7]**2).sum(axis=1) / 2
                                 - gravity * path[:, 1, 1:4] @ numpy.array(way))
                counts = hard.counts(table)
                events = sum(counts.values())
                speed = numpy.linalg.norm(path[:, 1, 4:7], axis=1).max()
                allowed = 4 * mass * gravity * dt * speed * numpy.sqrt(events / 3) + 1e-13
                self.assertTrue((energy - energy[0] < allowed).all())
                self.assertEqual(counts["escape"][-1], 0)
                self.assertGreater(counts["collision"][-1], 10)
                self.assertLess(energy[-1], energy[0] - 1e-3)
                distance = numpy.linalg.norm(path[:, 1, 1:4] - path[:, 0, 1:4], axis=1)
                self.assertTrue((distance < 1.05 + 1e-12).all() and (distance > 1 - 1e-12).all())

    def three(self):
        """Inside each other's wells, with less energy than it takes to part two of them, D."""
        x = numpy.array([[9.5, 10, 10], [10.55, 10, 10], [10.0, 10.93, 10]])
        v = numpy.array([[0.3, 0.2, 0.1], [-0.4, 0.1, -0.2], [0.1, -0.3, 0.1]])
        return x, v, [hard.atom(*row) for row in zip(x, v)]

    def test_three_against_the_reference(self):
        """100 events or so, until the reference itself, moved by 1e-15, is off by 1e-9."""
        x, v, atoms = self.three()
        exact = Reference(x, v, 0.5, 1.0, 3 * [20.0], depth=1.0, ratio=1.2)
        away = 1e-15 * numpy.arange(9).reshape(3, 3)
        twin = Reference(x + away, v, 0.5, 1.0, 3 * [20.0], depth=1.0, ratio=1.2)
        time = 0.0
        while abs(twin.place(time) - exact.place(time)).max() < 1e-10:
            time += 0.5
            exact.run(time)
            twin.run(time)
        steps = int(2 * time) - 1
        exact = Reference(x, v, 0.5, 1.0, 3 * [20.0], depth=1.0, ratio=1.2)
        like_reference(self, atoms, ["* * restitution 1 well 1 1.2"], exact, 0.5, steps, 1e-9, skin=4.0)
        self.assertGreater(len(exact.events), 20)

    def test_three_stay(self):
        _, v, atoms = self.three()
        self.assertLess((v**2).sum() / 2, 1.0)
        path, _, table, _ = follow(atoms, ["* * restitution 1 well 1 1.2"], 0.02, self.STEPS, style="",
                                   skin=1.0, every=self.STEPS // 100)
        total = table["KinEng"] + table["PotEng"]
        self.assertLess(abs(total - total[0]).max(), 1e-11)
        self.assertEqual(hard.counts(table)["escape"][-1], 0)
        self.assertGreater(hard.counts(table)["capture"][-1], 500)


if __name__ == "__main__":
    unittest.main()
