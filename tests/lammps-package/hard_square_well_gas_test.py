# SPDX-License-Identifier: BSD-3-Clause
"""Many hard particles with square wells: against the event-driven reference, energy over many events,
numbers of ranks, restarts."""
import math
import unittest
from collections import defaultdict

import numpy

from cohesion_tests import lammps as engine
from cohesion_tests.lammps_scenes import hard_spheres as hard
from cohesion_tests.lammps_scenes.hard_gas import Gas
from cohesion_tests.theory.event_driven_reference import KINDS

DEPTH, RATIO = 0.3, 1.1
COUNT = 300


def by_pair(events):
    """(kind, time) of each pair, in order: events of different pairs at the same time need not be in
    the same order."""
    pairs = defaultdict(list)
    for kind, i, j, time in sorted(events, key=lambda event: event[3]):
        pairs[min(i, j), max(i, j)].append((kind, time))
    return pairs


class Reference(unittest.TestCase):
    """300 particles of two sizes, until chaos takes over: a reference that starts as far away as the
    coordinates of LAMMPS get by rounding, by chance a unit in the last place times the root of the
    number of steps (600), stays within 1e-9, and so must LAMMPS. From there to 1e-9 it takes five (discs)
    to ten (spheres with damping) mean free times of the start; the tests follow five or six, six to
    eight collisions of each particle, 2300 to 3000 events."""
    def compare(self, dimension, fraction, restitution, friction=0.0, lengths=6,
                divisions=(100, 10, 1)):
        gas = Gas(COUNT, fraction, dimension, (0.4, 0.6))
        law = {"restitution": restitution, "friction": friction, "depth": DEPTH, "ratio": RATIO}
        spin = gas.spin() if friction else None
        # Mean free time: of the start, by a short run.
        exact = gas.reference(**law, spin=spin)
        exact.run(math.inf, most=1000)
        free = exact.now * COUNT / 2 / sum(event.kind == "collision" for event in exact.events)
        duration = lengths * free
        exact.run(duration)
        twin = gas.reference(numpy.spacing(gas.length) * math.sqrt(lengths * max(divisions)), **law,
                             spin=spin)
        twin.run(duration)
        end = exact.place(duration)
        self.assertLess(abs(exact.apart(end - twin.place(duration))).max(), 1e-9)
        expected = by_pair((event.kind, event.particle + 1, event.partner + 1, event.time)
                           for event in exact.events)
        words = f"* * restitution {restitution} friction {friction} well {DEPTH} {RATIO}"
        for division in divisions:
            with self.subTest(division=division), engine.temporary_folder() as folder:
                gas.write(folder, spin)
                dt, steps = free / division, lengths * division
                path, table, _ = gas.run(folder, [words], dt, steps, every=division,
                                         skin={100: 0.5, 10: 1.5, 1: 4.5}[division],
                                         style="record events.txt")
                seen = hard.recorded(folder)
                self.assertLess(abs(exact.apart(path[-1, :, 1:4] - end)).max(), 1e-9)
                # Speeds: a collision turns an error of place by 2 v/d of it, relative speeds of up
                # to 10 at an angle.
                self.assertLess(abs(path[-1, :, 4:7] - exact.v).max(), 3e-8)
                self.assertLess(abs(path[-1, :, 7:10] - exact.spin).max(), 3e-8)
                found = by_pair((event.kind, event.i, event.j, time) for event, time in
                                zip(seen, hard.times(seen, dt)))
                self.assertEqual(found.keys(), expected.keys())
                for pair, events in expected.items():
                    self.assertEqual([kind for kind, _ in found[pair]], [kind for kind, _ in events])
                    numpy.testing.assert_allclose([time for _, time in found[pair]],
                                                  [time for _, time in events], rtol=0, atol=1e-9)
                self.sums(exact, table, friction)
                if division == 1:
                    self.pressure(gas, exact, table, dt)

    def sums(self, exact, table, friction):
        """By kind, from compute hard/events: 3000 terms of order one, each good to 1e-9."""
        for n, kind in enumerate(KINDS):
            events = [event for event in exact.events if event.kind == kind]
            self.assertEqual(table[f"c_events[{n + 1}]"][-1], len(events), kind)
            sums = [sum(event.energy for event in events)]
            if not friction:
                sums += [sum(abs(event.impulse) for event in events)]
            sums += [sum(event.virial for event in events)]
            columns = [5, 9, 13] if not friction else [5, 13]
            for column, value in zip(columns, sums):
                self.assertAlmostEqual(table[f"c_events[{n + column}]"][-1], value,
                                       delta=1e-9 * len(events) + 1e-12, msg=f"{kind} {column}")
        self.assertAlmostEqual(table["PotEng"][-1], exact.potential(), delta=1e-9)
        self.assertEqual(table["c_events[17]"][-1], 0)

    def pressure(self, gas, exact, table, dt):
        """Each step's virial pressure is the mean over the step: times volume, dimension and step it is
        the sum of J R; the first line is before the first step."""
        volume = gas.length**gas.dimension
        total = gas.dimension * volume * dt * table["c_virial"][1:].sum()
        self.assertAlmostEqual(total, sum(event.virial for event in exact.events), delta=1e-5)

    def test_spheres(self):
        self.compare(3, 0.3, 1.0)

    def test_spheres_with_damping(self):
        self.compare(3, 0.3, 0.9, divisions=(10, 1))

    def test_discs(self):
        self.compare(2, 0.4, 1.0, lengths=5)

    def test_discs_with_damping_and_friction(self):
        self.compare(2, 0.4, 0.9, 0.3, lengths=5, divisions=(10, 1))

    def test_spheres_with_friction(self):
        self.compare(3, 0.2, 0.9, 0.3, divisions=(10,))


class Fluid(unittest.TestCase):
    """Elastic. Round-off: each event changes the energy of two particles by 1e-16 or so of an energy
    of order one, by chance; 1e5 of them: 3e-14, of a kinetic energy of 750."""
    STEPS, DT = 600, 0.02

    def test_energy_and_momentum(self):
        gas = Gas(512, 0.3, seed=4)
        with engine.temporary_folder() as folder:
            gas.write(folder)
            path, table, _ = gas.run(folder, ["* * restitution 1 well 1 1.5"], self.DT, self.STEPS,
                                     skin=1.0, every=self.STEPS // 20)
        events = sum(hard.counts(table).values())[-1]
        self.assertGreater(events, 1e5)
        total = table["KinEng"] + table["PotEng"]
        self.assertLess(abs(total - total[0]).max(), 1e-11 * table["KinEng"].min())
        momentum = gas.mass @ path[-1, :, 4:7]
        self.assertLess(abs(momentum).max(), 1e-11 * 512)
        # Nothing overlaps, and the energy is that of the pairs within the wells.
        x = path[-1, :, 1:4]
        apart = x[:, None] - x
        apart -= gas.length * numpy.rint(apart / gas.length)
        distance = numpy.sqrt((apart**2).sum(axis=2))[numpy.triu_indices(512, 1)]
        self.assertGreater(distance.min(), 1 - 1e-12)
        self.assertAlmostEqual(table["PotEng"][-1], -(distance < 1.5).sum(), delta=1e-9)


if __name__ == "__main__":
    unittest.main()
