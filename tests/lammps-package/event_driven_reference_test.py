# SPDX-License-Identifier: BSD-3-Clause
"""The event-driven reference by itself: encounters of two particles in closed form, what is kept."""
import math
import unittest

import numpy

from cohesion_tests.theory.event_driven_reference import Plane, Reference
from cohesion_tests.theory.hard_encounter import encounter

FREE = 3 * [math.inf]


class TwoParticles(unittest.TestCase):
    """Round-off: 1e-16 of lengths and speeds of order one, some ten operations a crossing; crossings
    at an angle theta to the tangent make it 1/theta times larger, here 10 at most: 1e-14."""

    def meet(self, speed, offset, ratio, well, restitution):
        r, m = numpy.array([0.3, 0.7]), numpy.array([2.0, 0.5])
        mu = 0.4
        start = numpy.array([-3.0, offset, 0.0])
        velocity = numpy.array([speed, 0.0, 0.0])
        # The first particle has a velocity of its own, and the plane of the encounter is turned.
        turn = numpy.linalg.qr(numpy.arange(1.0, 10.0).reshape(3, 3)**1.5)[0]
        drift = numpy.array([0.1, -0.2, 0.3])
        pair = Reference(numpy.array([0 * start, start]) @ turn,
                         numpy.array([0 * velocity, velocity]) @ turn + drift, r, m, FREE,
                         restitution, 0.0, well * mu / 2, ratio)
        meeting = encounter(speed, offset, 1.0, ratio, well, restitution)
        entry = (3.0 - math.sqrt(ratio**2 - offset**2)) / speed
        pair.run(math.inf, most=len(meeting.kinds))
        self.assertEqual([event.kind for event in pair.events], meeting.kinds)
        numpy.testing.assert_allclose([event.time for event in pair.events],
                                      entry + numpy.array(meeting.times), rtol=0, atol=1e-14)
        relative = (pair.place(pair.now) @ turn.T)[1] - (pair.place(pair.now) @ turn.T)[0]
        numpy.testing.assert_allclose(relative, [*meeting.place, 0.0], rtol=0, atol=2e-14)
        numpy.testing.assert_allclose((pair.v[1] - pair.v[0]) @ turn.T, [*meeting.velocity, 0.0],
                                      rtol=0, atol=2e-14)
        centre = m @ pair.v / m.sum()
        numpy.testing.assert_allclose(centre, (m[0] * drift + m[1] * (velocity @ turn + drift)) / 2.5,
                                      rtol=0, atol=2e-15)
        gains = {"approach": well * mu / 2, "escape": -well * mu / 2, "capture": 0.0,
                 "collision": 0.0 if meeting.core is None else
                 -0.5 * mu * (1 - restitution**2) * meeting.core[0]**2}
        for event in pair.events:
            self.assertAlmostEqual(event.energy, gains[event.kind], delta=3e-15)

    def test_encounters(self):
        for restitution in (1.0, 0.6):
            for ratio in (1.01, 1.5):
                for offset in (0.0, 0.3, 0.8, 0.98 * ratio):
                    for well in (0.3, 3.0):
                        with self.subTest(e=restitution, ratio=ratio, offset=offset, well=well):
                            self.meet(1.0, offset, ratio, well, restitution)

    def test_friction(self):
        # A disc (1/2 m r^2) strikes an equal one at rest, offset 0.6: approach 0.8, slip 0.6 and what
        # the spins add. Contact: m (1+e) 0.8/2; to stop the slip: slip/(2/m + 2 r^2/I) = slip m/6.
        for friction, stops in ((0.5, True), (0.05, False)):
            pair = Reference([[0, 0, 0], [-3, 0.6, 0]], [[0, 0, 0], [1, 0, 0]], 0.5, 1.0, FREE, 0.9,
                             friction, spin=[[0, 0, 0.4], [0, 0, 0.2]], inertia=0.5)
            pair.run(math.inf, most=1)
            normal = 0.95 * 0.8
            k, t = numpy.array([-0.8, 0.6, 0.0]), numpy.array([0.6, 0.8, 0.0])
            slip = -0.6 - 0.3  # v_i - v_j + (sum of r spin) x k, along t
            along = slip / 6 if stops else -friction * normal
            numpy.testing.assert_allclose(pair.v[1] - [1, 0, 0], normal * k + along * t, rtol=0,
                                          atol=1e-15)
            numpy.testing.assert_allclose(pair.v[0], -normal * k - along * t, rtol=0, atol=1e-15)
            # k x t = -z; both turn alike: -(r/I) k x (along t) = along/(m r/2) z.
            numpy.testing.assert_allclose(pair.spin[:, 2], numpy.array([0.4, 0.2]) + 4 * along,
                                          rtol=0, atol=1e-15)
            # Work of the impulse at the mean of the slips before and after.
            lost = (1 - 0.81) * 0.64 / 4 + along * (slip - 3 * along)
            self.assertAlmostEqual(pair.events[0].energy, -lost, delta=1e-15)


class Kept(unittest.TestCase):
    def gas(self, **options):
        random = numpy.random.default_rng(1)
        grid = 0.75 + 1.5 * numpy.arange(4)
        x = numpy.array(numpy.meshgrid(grid, grid, grid)).reshape(3, -1).T
        return Reference(x, random.normal(size=x.shape), random.choice([0.4, 0.6], 64),
                         random.choice([1.0, 3.0], 64), options.pop("box", 3 * [6.0]), **options)

    def test_total_energy_and_momentum(self):
        # 64 particles, 2000 events of 1e-16 each.
        gas = self.gas(depth=0.7, ratio=1.2)
        total, momentum = gas.energy() + gas.potential(), gas.mass @ gas.v
        gas.run(math.inf, most=2000)
        self.assertGreater(min(sum(event.kind == kind for event in gas.events) for kind in
                               ("collision", "approach", "escape", "capture")), 100)
        self.assertAlmostEqual(gas.energy() + gas.potential(), total, delta=1e-11)
        numpy.testing.assert_allclose(gas.mass @ gas.v, momentum, rtol=0, atol=1e-12)
        # None has been missed: nothing overlaps, and the states are those of the distances.
        apart = gas.apart(gas.place(gas.now)[:, None] - gas.place(gas.now))
        apart = numpy.sqrt((apart**2).sum(axis=2)) + 10 * numpy.eye(64)
        self.assertGreater((apart - gas.core).min(), -1e-12)
        clear = abs(apart - gas.edge) > 1e-12
        numpy.testing.assert_array_equal((apart < gas.edge)[clear], gas.inside[clear])

    def test_between_planes_with_friction(self):
        planes = [Plane(2, 0.0, 1, 0.9, 0.3, 1.0, 1.1), Plane(2, 6.0, -1, 0.9, 0.3, 1.0, 1.1)]
        gas = self.gas(depth=0.7, ratio=1.1, restitution=0.9, friction=0.3, planes=planes,
                       box=[6.0, 6.0, math.inf])
        total = gas.energy()
        gas.run(math.inf, most=2000)
        self.assertAlmostEqual(gas.energy(), total + sum(event.energy for event in gas.events),
                               delta=1e-11)
        self.assertLess(gas.energy() + gas.potential(), 0.7 * total)
        heights = gas.place(gas.now)[:, 2]
        self.assertGreater(min((heights - gas.radius).min(), (6 - heights - gas.radius).min()),
                           -1e-12)


if __name__ == "__main__":
    unittest.main()
