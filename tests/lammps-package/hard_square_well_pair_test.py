# SPDX-License-Identifier: BSD-3-Clause
"""Two particles under pair_style hard/squarewell: every impulse law against
closed forms, many couples in one box."""
import math
import unittest
from collections import defaultdict

import numpy

from cohesion_tests import lammps as engine
from cohesion_tests.lammps_scenes import hard_spheres as hard
from cohesion_tests.theory.hard_encounter import encounter
from cohesion_tests.theory.rough_collision import struck

CELL, SIDE = 12.0, 6


class Couple:
    """Two particles that meet in a cell of their own. `toward`: the second moves along `way` relative
    to the first, `offset` beside it along `aside`, and reaches the edge after `entry` seconds."""

    def __init__(self, number, speed, offset, core, edge, masses=(1.0, 1.0), entry=0.123,
                 way=(1.0, 0.0, 0.0), aside=(0.0, 1.0, 0.0), kind=1, spins=((0, 0, 0), (0, 0, 0)),
                 drift=(0.0, 0.0, 0.0), share=0.5):
        self.speed, self.offset, self.core, self.edge = speed, offset, core, edge
        self.entry, self.masses = entry, masses
        self.mu = masses[0] * masses[1] / sum(masses)
        self.axes = numpy.array([way, aside, numpy.cross(way, aside)])
        self.radii = share * core, core - share * core
        centre = CELL * (numpy.array([number % SIDE, number // SIDE % SIDE, number // SIDE**2]) + 0.5)
        along = math.sqrt(edge**2 - offset**2) + speed * entry
        r = -along * self.axes[0] + offset * self.axes[1]
        u = speed * self.axes[0]
        parts = numpy.array([-masses[1], masses[0]])[:, None] / sum(masses)
        self.x, self.v = centre + parts * r, numpy.array(drift) + parts * u
        self.spins = numpy.array(spins, float)
        self.atoms = [hard.atom(x, v, radius, mass, kind, spin) for x, v, radius, mass, spin in
                      zip(self.x, self.v, self.radii, masses, self.spins)]

    def energy(self, v, spin, inertia=0.4):
        return sum(0.5 * m * (a @ a) + 0.5 * inertia * m * r * r * (w @ w)
                   for m, r, a, w in zip(self.masses, self.radii, v, spin))


def turned(random):
    """Two unit vectors at right angles."""
    return numpy.linalg.qr(random.normal(size=(3, 3)))[0][:2]


def follow(couples, pair, dt, steps, dimension=3, types=1, more=(), **options):
    """Path (snapshots, couples, 2, columns), recorded events by couple, thermo columns."""
    with engine.temporary_folder() as folder:
        atoms = [atom for couple in couples for atom in couple.atoms]
        depth = -(-len(couples) // SIDE**2)
        flat = [(-0.5, 0.5)] if dimension == 2 else [(0.0, CELL * depth)]
        engine.write_spheres(folder, atoms, 2 * [(0.0, CELL * SIDE)] + flat, types)
        path, table, _ = hard.run(folder, pair, dt, steps, style="record events.txt",
                                  dimension=dimension, more=more, **options)
        events = defaultdict(list)
        for event in hard.recorded(folder):
            events[(event.i - 1) // 2].append(event)
        return path.reshape(len(path), -1, 2, 13), events, table


def relative(couple, snapshot):
    """Place and velocity of the second to the first, in the couple's axes."""
    return [couple.axes @ (snapshot[1, columns] - snapshot[0, columns])
            for columns in (slice(1, 4), slice(4, 7))]


class Laws(unittest.TestCase):
    """200 couples of any masses, radii, directions; wells from 1.01 to 1.5 of the size.

    Tolerance: LAMMPS moves coordinates of up to 72, half a unit in the last place is 7e-15, 48 times:
    4e-13 at the worst in the offset and, over a time of order one, in the speed. What the closed
    form changes by for that, and twice that for the numbers themselves."""
    RATIOS, RESTITUTION, DEPTH = (1.01, 1.1, 1.5), 0.7, 0.4
    DT, STEPS, ERROR = 0.05, 48, 4e-13

    @classmethod
    def setUpClass(cls):
        random = numpy.random.default_rng(5)
        cls.couples, cls.meetings = [], []
        while len(cls.couples) < 200:
            kind = len(cls.couples) % 3
            core = random.uniform(0.8, 1.2)
            edge = cls.RATIOS[kind] * core
            way, aside = turned(random)
            couple = Couple(len(cls.couples), random.uniform(1.2, 1.8), edge * random.uniform(0, 0.98),
                            core, edge, random.uniform(0.5, 2.0, 2), random.uniform(0.02, 0.3), way,
                            aside, kind + 1, drift=random.uniform(-0.2, 0.2, 3),
                            share=random.uniform(0.35, 0.65))
            # Not those that just touch or just part: these are cases of their own.
            margins = [cls.meeting(couple, *part) for part in ((-0.03, 0), (0.03, 0), (0, 0.03),
                                                               (0, -0.03))]
            meeting = cls.meeting(couple)
            if (len({tuple(meeting.kinds) for meeting in margins}) == 1
                    and couple.entry + meeting.times[-1] < 0.95 * cls.DT * cls.STEPS):
                cls.couples.append(couple)
                cls.meetings.append(meeting)
        pair = [f"{kind} {kind} restitution {cls.RESTITUTION} well {cls.DEPTH} {ratio}"
                for kind, ratio in enumerate(cls.RATIOS, 1)]
        cls.path, cls.events, cls.table = follow(cls.couples, pair, cls.DT, cls.STEPS, types=3,
                                                 every=1)

    @classmethod
    def meeting(cls, couple, aside=0.0, faster=0.0):
        return encounter(couple.speed * (1 + faster),
                         min(abs(couple.offset + aside * couple.core), 0.9999 * couple.edge),
                         couple.core, couple.edge, 2 * cls.DEPTH / couple.mu, cls.RESTITUTION)

    def allowed(self, couple, quantity):
        """Error of a quantity of the closed form."""
        h = 1e-6
        aside = quantity(self.meeting(couple, h)) - quantity(self.meeting(couple, -h))
        faster = quantity(self.meeting(couple, 0, h)) - quantity(self.meeting(couple, 0, -h))
        return self.ERROR * (2 + (numpy.abs(aside) + numpy.abs(faster)).max() / (2 * h))

    def test_all_kinds_are_there(self):
        kinds = [tuple(meeting.kinds) for meeting in self.meetings]
        for path in (("approach", "escape"), ("approach", "collision", "escape"),
                     ("approach", "collision", "capture")):
            self.assertGreater(kinds.count(path), 5, path)

    def test_kinds_and_times(self):
        for number, (couple, meeting) in enumerate(zip(self.couples, self.meetings)):
            seen = self.events[number]
            self.assertEqual([event.kind for event in seen[:len(meeting.kinds)]], meeting.kinds)
            if meeting.kinds[-1] == "escape":
                self.assertEqual(len(seen), len(meeting.kinds))
            error = hard.times(seen[:len(meeting.times)], self.DT) - couple.entry - meeting.times
            allowed = self.allowed(couple, lambda meeting: numpy.array(meeting.times))
            self.assertLess(abs(error).max(), allowed + self.ERROR / couple.speed * couple.edge
                            / math.sqrt(couple.edge**2 - couple.offset**2))

    def test_where_they_go(self):
        duration = self.DT * self.STEPS
        for number, (couple, meeting) in enumerate(zip(self.couples, self.meetings)):
            if meeting.kinds[-1] != "escape":
                continue
            place, velocity = relative(couple, self.path[-1, number])

            def end(meeting, couple=couple):
                left = duration - couple.entry - meeting.times[-1]
                return numpy.array([*(meeting.place + left * meeting.velocity), 0.0])

            def speed(meeting):
                return numpy.array([*meeting.velocity, 0.0])

            self.assertLess(abs(velocity - speed(meeting)).max(), self.allowed(couple, speed))
            self.assertLess(abs(place - end(meeting)).max(), self.allowed(couple, end))

    def test_energy_of_each_event(self):
        """The change of each step is the sum of its events', +D, -D, 0 and -(1-e^2)/2 mu (k.v)^2, to
        the round-off of energies of up to 20: 10 operations of 2e-16 of it."""
        gains = {"approach": self.DEPTH, "escape": -self.DEPTH, "capture": 0.0}
        for number, (couple, meeting) in enumerate(zip(self.couples, self.meetings)):
            energy = numpy.array([couple.energy(atoms[:, 4:7], atoms[:, 7:10])
                                  for atoms in self.path[:, number]])
            change = numpy.diff(energy)
            known = self.events[number][:len(meeting.kinds)]
            later = {event.step for event in self.events[number][len(meeting.kinds):]}
            expected = numpy.zeros(self.STEPS)
            strike = 0.0
            for event in known:
                if event.kind == "collision":
                    strike = -0.5 * couple.mu * (1 - self.RESTITUTION**2) * meeting.core[0]**2
                expected[event.step - 1] += gains.get(event.kind, strike)
            # The energy of a collision is known as well as its place.
            round_off = 10 * 2.2e-16 * energy.max()
            place = self.allowed(couple, lambda meeting: numpy.array(
                [0.0 if meeting.core is None else meeting.core[0]**2 * couple.mu]))
            last = min(later, default=self.STEPS + 1)
            for step in range(last - 1):
                collides = any(event.step == step + 1 and event.kind == "collision"
                               for event in known)
                self.assertLess(abs(change[step] - expected[step]),
                                round_off + (place if collides else 0.0))

    def test_sums_by_kind(self):
        """Thermo's energy by kind; 1000 terms of order one."""
        last = {name: column[-1] for name, column in self.table.items()}
        counts = {kind: last[f"c_events[{n}]"] for n, kind in enumerate(hard.KINDS, 1)}
        for kind in hard.KINDS:
            self.assertEqual(counts[kind], sum(event.kind == kind for events in self.events.values()
                                               for event in events), kind)
        energy = {kind: last[f"c_events[{n}]"] for n, kind in enumerate(hard.KINDS, 5)}
        self.assertAlmostEqual(energy["approach"], self.DEPTH * counts["approach"], delta=1e-11)
        self.assertAlmostEqual(energy["escape"], -self.DEPTH * counts["escape"], delta=1e-11)
        self.assertAlmostEqual(energy["capture"], 0.0, delta=1e-11)
        self.assertAlmostEqual(sum(energy.values()), last["KinEng"] - self.table["KinEng"][0],
                               delta=1e-11)
        inside = counts["approach"] - counts["escape"]
        self.assertAlmostEqual(last["PotEng"], -self.DEPTH * inside, delta=1e-11)


class EscapeVelocity(unittest.TestCase):
    """v_esc = sqrt((2D/mu)(1/e^2-1)), head-on, along an axis, so that only the round-off of the
    speeds counts: (e v_c)^2 against 2D/mu, of which (1-e^2) is left: some 1e-15/(1-e^2), and
    half that of v_esc. Couples at v_esc (1 +- 10^-n)."""
    NEAREST = 13

    def parted(self, restitution, ratio, masses, dt):
        depth = 0.3
        mu = masses[0] * masses[1] / sum(masses)
        exact = math.sqrt(2 * depth / mu * (1 / restitution**2 - 1))
        margins = [sign * 10.0**-n for n in range(1, self.NEAREST + 1) for sign in (-1, 1)]
        couples = []
        for number, margin in enumerate(margins):
            way = numpy.eye(3)[number % 3]
            couples.append(Couple(number, exact * (1 + margin), 0.0, 1.0, ratio, masses,
                                  entry=(0.3 + 0.618 * number % 1) * dt, way=way,
                                  aside=numpy.eye(3)[number % 3 - 1], share=0.4))
        steps = math.ceil(1.5 / exact * ratio / dt) if dt < 0.1 else 6
        _, events, _ = follow(couples, [f"* * restitution {restitution} well {depth} {ratio}"], dt,
                              steps, skin=2.0)
        for number, margin in enumerate(margins):
            kinds = [event.kind for event in events[number][:3]]
            self.assertEqual(kinds, ["approach", "collision", "escape" if margin > 0 else "capture"],
                             margin)

    def test_thin_well(self):
        self.parted(0.9, 1.001, (1.0, 1.0), 0.01)

    def test_wide_well_unequal(self):
        self.parted(0.6, 1.5, (1.0, 4.0), 0.02)

    def test_well_thinner_than_the_flight_of_a_step(self):
        self.parted(0.8, 1.0001, (2.0, 1.0), 0.5)


class EffectiveRestitution(unittest.TestCase):
    """W fig. 4.2, D* = 5, e = 0.8, for equal particles. Read as: kinetic energy of the relative motion
    5 times the depth, 2D/mu = v^2/5; then the limit formula with the normal speed,
    e_eff^2 = e^2 - (1 - e^2)/(5 (1 - (b/d)^2)), ends by capture at b = 0.942 d, within the offsets
    of the figure."""
    RESTITUTION, STAR = 0.8, 5.0
    OFFSETS = [*numpy.arange(0, 0.95, 0.05), 0.95]

    def effective(self, ratio):
        """From LAMMPS, and in closed form; 0 where captured."""
        well = 1 / self.STAR
        couples = [Couple(n, 1.0, b, 1.0, ratio, entry=0.02 + 0.011 * n)
                   for n, b in enumerate(self.OFFSETS)]
        path, events, _ = follow(couples, [f"* * restitution {self.RESTITUTION} well {well / 4} "
                                           f"{ratio}"], 0.02, 150)
        measured, exact = [], []
        for number, couple in enumerate(couples):
            meeting = encounter(1.0, couple.offset, 1.0, ratio, well, self.RESTITUTION)
            self.assertEqual(events[number][2].kind, meeting.kinds[2])
            if meeting.kinds[2] == "capture":
                measured.append(0.0)
                exact.append(0.0)
                continue
            # Line of centres at the contact.
            closest = couple.offset / math.sqrt(1 + well)
            angle = (math.pi - math.asin(couple.offset / ratio) - math.asin(closest)
                     + math.asin(closest / ratio))
            k = numpy.array([math.cos(angle), math.sin(angle), 0.0])
            _, velocity = relative(couple, path[-1, number])
            measured.append(velocity @ k / -k[0])
            exact.append(meeting.velocity @ k[:2] / -k[0])
        # 3e-14 of a place, over the normal part of the velocity, 0.3 at least, a few times.
        numpy.testing.assert_allclose(measured, exact, rtol=0, atol=1e-11)
        return numpy.array(measured)

    def limit(self):
        b = numpy.array(self.OFFSETS)
        return numpy.sqrt(numpy.maximum(self.RESTITUTION**2 - (1 - self.RESTITUTION**2)
                                        / self.STAR / (1 - b * b), 0.0))

    def test_limit_formula_at_a_thin_well(self):
        # b v, the angular momentum, is kept: the square of the normal speed is larger at the edge than
        # at the core by 2 (b/d)^2 (ratio-1) v^2, of a normal part of 1-(b/d)^2; the line of centres
        # turns on the way by as much: together 4e-4 (b/d)^2/(1-(b/d)^2) at most in e_eff^2, which is
        # over 2 e_eff. Round-off: as in effective().
        b, limit = numpy.array(self.OFFSETS), self.limit()
        free = limit > 0
        error = abs(self.effective(1.0001) - limit)
        allowed = 1e-11 + 4e-4 * b[free]**2 / (1 - b[free]**2) / (2 * limit[free])
        self.assertTrue((error[free] < allowed).all(), error)
        self.assertTrue((error[~free] == 0).all())
        self.assertEqual(free.sum(), len(b) - 1)

    def test_departs_at_a_wide_well(self):
        # Head-on the formula holds for any width; farther out it does not.
        error = abs(self.effective(1.1) - self.limit())
        self.assertLess(error[0], 1e-13)
        self.assertGreater(error[-5:].max(), 0.1)


class Friction(unittest.TestCase):
    """Hard cores with friction, 100 couples that stick or slide. Places are good to 4e-13 (as in
    Laws); a collision turns that into directions over the cosine, 0.3 at least, and speeds of up to 5,
    with spins over radii of 0.35 and moments: 1e-10 is above all."""
    RESTITUTION, FRICTION = 0.8, 0.25

    def collide(self, dimension):
        random = numpy.random.default_rng(dimension)
        couples = []
        for number in range(36 if dimension == 2 else 100):
            if dimension == 2:
                angle = random.uniform(0, 2 * math.pi)
                way = numpy.array([math.cos(angle), math.sin(angle), 0])
                aside = numpy.array([-way[1], way[0], 0])
                spins = random.normal(size=(2, 3)) * [0, 0, 2]
            else:
                way, aside = turned(random)
                spins = 2 * random.normal(size=(2, 3))
            couples.append(Couple(number, random.uniform(0.5, 2), random.uniform(-0.9, 0.9), 1.0, 1.0,
                                  random.uniform(0.5, 3, 2), random.uniform(0.02, 0.3), way, aside,
                                  spins=spins, share=random.uniform(0.35, 0.65)))
            if dimension == 2:
                for atom, x in zip(couples[-1].atoms, couples[-1].x):
                    x[2] = 0.0
                    atom["x"] = x
        path, events, table = follow(couples, [f"* * restitution {self.RESTITUTION} friction "
                                               f"{self.FRICTION}"], 0.03, 40, dimension)
        inertia = 0.5 if dimension == 2 else 0.4
        lost, stuck = 0.0, 0
        for number, couple in enumerate(couples):
            self.assertEqual([event.kind for event in events[number]], ["collision"])
            self.assertAlmostEqual(hard.times(events[number], 0.03)[0], couple.entry, delta=1e-11)
            v, spin, loss, sticks = struck(couple, couple.masses, couple.radii,
                                           couple.x + couple.entry * couple.v, couple.v,
                                           couple.spins, self.RESTITUTION, self.FRICTION, inertia)
            numpy.testing.assert_allclose(path[-1, number, :, 4:7], v, rtol=0, atol=1e-10)
            numpy.testing.assert_allclose(path[-1, number, :, 7:10], spin, rtol=0, atol=1e-10)
            self.assertAlmostEqual(couple.energy(path[-1, number, :, 4:7], path[-1, number, :, 7:10],
                                                 inertia), couple.energy(couple.v, couple.spins,
                                                                         inertia) - loss, delta=1e-10)
            lost, stuck = lost + loss, stuck + sticks
        self.assertGreater(stuck, 10)
        self.assertGreater(len(couples) - stuck, 10)
        self.assertAlmostEqual(table["c_events[5]"][-1], -lost, delta=1e-9)

    def test_spheres(self):
        self.collide(3)

    def test_discs(self):
        self.collide(2)


class StandingInRange(unittest.TestCase):
    """Pairs that stand within their wells without having flown there are bound, with -D, from when they can move."""

    def test_released_by_a_dynamic_group(self):
        """Nothing is between two held spheres; no list is made anew while nothing moves."""
        for ranks in (1, 2):
            with self.subTest(ranks=ranks), engine.temporary_folder() as folder:
                engine.write_spheres(folder, [hard.atom((x, 10, 10), (0, 0, 0)) for x in (9.4, 10.6)],
                                     3 * [(0.0, 20.0)], 1)
                _, table, _ = hard.run(folder, ["* * restitution 1 well 0.7 1.5"], 0.01, 20, every=1, ranks=ranks,
                                       before=["variable late atom step>9", "group moving dynamic all every 1 var late"],
                                       group="moving")
                numpy.testing.assert_array_equal(table["PotEng"][:9], 0.0)
                numpy.testing.assert_array_equal(table["PotEng"][13:], -0.7)


class MixedTypes(unittest.TestCase):
    """Edge between types that were given alone: ratio_i r_i + ratio_j r_j; depth: geometric mean."""

    def test_edge_and_depth(self):
        core, share = 1.0, 0.3
        edge = 1.2 * share + 1.6 * (1 - share)
        couple = Couple(0, 1.0, 0.4, core, edge, share=share)
        couple.atoms[1]["type"] = 2
        depth = math.sqrt(0.1 * 0.4)
        meeting = encounter(1.0, 0.4, core, edge, 2 * depth / couple.mu, 1.0)
        path, events, _ = follow([couple], ["1 1 restitution 1 well 0.1 1.2",
                                            "2 2 restitution 1 well 0.4 1.6"], 0.05, 80, types=2)
        self.assertEqual([event.kind for event in events[0]], meeting.kinds)
        numpy.testing.assert_allclose(hard.times(events[0], 0.05) - couple.entry, meeting.times,
                                      rtol=0, atol=1e-12)
        numpy.testing.assert_allclose(relative(couple, path[-1, 0])[1][:2], meeting.velocity, rtol=0,
                                      atol=1e-12)


if __name__ == "__main__":
    unittest.main()
