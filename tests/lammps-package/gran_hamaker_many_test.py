# SPDX-License-Identifier: BSD-3-Clause
"""Many particles in the exact scheme: energy of elastic gases and of damped ones, a sticking pair struck by a third
sphere, momentum, ranks and restarts, spheres that come to rest."""
import math
import sys
import unittest

import numpy

from cohesion_tests import lammps as engine
from cohesion_tests.lammps_scenes import cohesive_gas as gas, settling_spheres as settling, triples, turning_ball

D, T_C = gas.DIAMETER, gas.CONTACT_TIME


class ElasticGas(unittest.TestCase):
    """512 spheres, 20 collisions each by Enskog's rate. Drift: total energy minus that of the start,
    over the kinetic energy of the start; A in J, speed of each component in m/s.

    A contact by itself keeps its energy; what is left is the error of second order of particles with
    several contacts. A scheme of second order for an oscillator of frequency w0 keeps an energy that
    differs from the true one by (w0 dt)^2/24 of it or some such part; w0 dt = pi/20: 1.0e-3, which is
    also what is asked of the scheme."""

    def drifts(self, fraction, constant, speed, division, seeds):
        """Rows: seeds; columns: 50 samples."""
        rows = []
        duration = 20 / gas.collision_rate(fraction, speed)
        for seed in range(seeds):
            with engine.temporary_folder() as folder:
                gas.write(folder, 8, fraction, speed, seed)
                # The fastest of them, too, stays within the list.
                table, _ = gas.follow(folder, division, duration, A=constant, skin=0.3 * D)
            self.assertEqual(len(table), 51)
            self.assertLess(abs(table[:, 2] - (table[:, 1] - table[0, 1])).max(),
                            1e-9 * table[0, 3], "residual is not the change of the total")
            rows.append((table[1:, 1] - table[0, 1]) / table[0, 3])
        return numpy.array(rows)

    def energy_is_kept(self, fraction, constant, speed, seeds, order=2):
        coarse = self.drifts(fraction, constant, speed, 5, seeds)
        fine = self.drifts(fraction, constant, speed, 20, seeds)
        self.assertLess(numpy.abs(fine).max(), 1e-3)
        # What does not depend on the step: within a contact the centrifugal force is taken at the
        # distance d, and 3/2 (x/d)^2 of the energy of turning is missing until the pair has parted.
        # Mean over the pairs in contact, with <x^2> = 2 speed^2/w0^2: rate t_c 2 speed^2/(w0 d)^2.
        rate = gas.collision_rate(fraction, speed)
        floor = rate * T_C * 2 * (speed * T_C / math.pi / D)**2
        level = [numpy.sqrt((drift**2).mean(axis=1)) for drift in (coarse, fine)]
        if order:
            # At least: a factor 4^order, within twice the standard error of the seeds.
            excess = numpy.log(level[1] / (level[0] / 4**order + floor))
            self.assertLess(excess.mean() - 2 * excess.std(ddof=1) / math.sqrt(seeds), 0.0)
        else:
            # (w0 dt)^2/24 of the energy of what is in contact, rate t_c of all.
            for division, drift in zip((5, 20), level):
                self.assertLess(drift.max(), (math.pi / division)**2 / 24 * rate * T_C + floor)

    def no_heating(self, fraction, constant, speed, division, seeds):
        """From the third to the last fifth of the run (the lattice has melted and the energy that
        the scheme keeps has found its offset): what is lost or gained by chance has a mean of zero,
        within three standard errors. 1e-4 of the kinetic energy per collision would be 8e-4 here."""
        fifths = self.drifts(fraction, constant, speed, division, seeds).reshape(seeds, 5, 10)
        change = fifths[:, 4].mean(axis=1) - fifths[:, 2].mean(axis=1)
        noise = change.std(ddof=1) / math.sqrt(seeds)
        self.assertLess(noise, 2e-4)
        self.assertLess(change.mean(), 3 * noise)

    def test_sparse(self):
        self.energy_is_kept(0.1, 0.0, 0.2, seeds=2)

    def test_sparse_adhesive(self):
        self.energy_is_kept(0.1, 2e-18, 0.2, seeds=2)

    def test_dense(self):
        # An offset of first order shows below t_c/10 (docs/verification/contact_energies.md).
        self.energy_is_kept(0.5, 0.0, 0.1, seeds=3, order=None)

    def test_dense_adhesive(self):
        # F_ad/sqrt(mu K) = 0.022 m/s: adhesion rules. Contacts under tension are taut, and where one becomes so within
        # a step the error is of first order.
        self.energy_is_kept(0.5, 2e-18, 0.02, seeds=3, order=1)

    def test_no_heating_at_a_quarter_of_the_contact_time(self):
        self.no_heating(0.5, 0.0, 0.1, division=4, seeds=4)

    def test_no_heating_with_adhesion_at_a_tenth(self):
        # At t_c/4 there is: 4e-5 of the kinetic energy per collision
        # (docs/verification/contact_energies.md).
        self.no_heating(0.5, 2e-18, 0.02, division=10, seeds=3)


class StruckPair(unittest.TestCase):
    """Two spheres that stick, at rest, and a third that strikes them: 100 such triples, against the
    run at t_c/400, whose error is 1/400 of that at t_c/20. Also where adhesion decides: F_ad/sqrt(mu K) = b = 0.022 m/s.

    Tolerance: the cluster rings with w = sqrt(3/2) w0 at most (three spheres in line) and decays with
    alpha = (3/2) zeta w0. A scheme of second order gets w wrong by (w dt)^2/24 of itself, the
    leapfrog's error; the speed, of amplitude V = sqrt(v^2 + b^2), is then wrong by that times the
    phase, at most

      delta V, delta = (w dt)^2/24 w/(alpha exp(1))       0.11 at t_c/10, 0.028 at t_c/20

    Spheres that part at a speed s have paid for it with energy: delta V^2/s where s < V. Spheres
    that part or stick with less than delta V^2 mu/2 to spare may do either."""

    @classmethod
    def setUpClass(cls):
        keeper = engine.temporary_folder()
        cls.addClassCleanup(keeper.cleanup)
        cls.folder = keeper.name
        triples.write(cls.folder)

    def compare(self, friction):
        exact, stuck, parting = triples.outcome(self.folder, 400, friction)
        # All outcomes that matter are there: caught, parted, the pair broken, the partner changed.
        self.assertGreaterEqual(len(numpy.unique(stuck, axis=1).T), 5)
        zeta = -math.log(triples.RESTITUTION) / math.hypot(math.pi,
                                                               math.log(triples.RESTITUTION))
        scale = numpy.hypot(triples.SPEEDS,
                            triples.ADHESION / math.sqrt(gas.MASS / 2 * gas.STIFFNESS))
        for division in (10, 20):
            delta = (1.5 * (math.pi / division)**2 / 24 / (math.sqrt(1.5) * zeta * math.e))
            velocities, sticks, parts = triples.outcome(self.folder, division, friction)
            same = (sticks == stuck).all(axis=0)
            slowest = numpy.minimum(parting, parts)
            self.assertTrue((same | (slowest**2 < delta * scale**2)).all(), division)
            self.assertGreaterEqual(same.sum(), 98)
            error = numpy.linalg.norm(velocities - exact, axis=2).max(axis=1)
            allowed = delta * scale * numpy.maximum(1.0, scale / slowest)
            self.assertLess((error[same] / allowed[same]).max(), 1.0, division)

    def test_without_friction(self):
        self.compare(friction=0.0)

    def test_with_friction(self):
        self.compare(friction=0.3)


class DampedGas(unittest.TestCase):
    def test_what_is_left_out_is_little(self):
        # What is left of the energy after 14 collisions differs from that at t_c/80 by less than a fiftieth of what is
        # lost, within three standard errors of four gases.
        more = []
        for seed in range(4):
            with engine.temporary_folder() as folder:
                gas.write(folder, 8, 0.5, 0.1, seed)
                left, at_finest = (gas.kept(folder, n, 0.5, 0.1, e=0.9487) for n in (6.17, gas.FINEST))
            self.assertGreater(1 - at_finest, 0.3)
            more.append((left - at_finest) / (1 - at_finest))
        self.assertLess(abs(numpy.mean(more)), 1 / 50 + 3 * numpy.std(more, ddof=1) / math.sqrt(len(more)))


class Momentum(unittest.TestCase):
    """A ball of 64 spheres with friction, restitution and adhesion that turns, falls on its middle and
    flies apart: linear and angular momentum (spin included) before and after.

    Actions equal reactions, and forces act at grid points, along the line of centres or in the plane of
    contact there: both are kept to the rounding of the sums. 2^-53 of what each of some 1e3 steps of
    contact adds to a sphere, by chance, for the linear one. Places and speeds are rounded in each step,
    2^-53 of a place at most four times as far out as at the start: that, alike in all steps, for the
    angular one."""
    def test_is_kept(self):
        for division in (10, 40):
            linear, angular = turning_ball.momentum_change(4, division, A=5e-19, mu=0.3, e=0.9)
            self.assertLess(linear, 1e-14)
            steps = 1.25 * 4 * D / turning_ball.SPEED / T_C * division
            self.assertLess(angular, 4 * 2.0**-53 * steps)


class Settling(unittest.TestCase):
    """80 spheres with damping and friction that fall on a layer of fixed ones. At rest: kinetic energy,
    rotation included, at t_c/10 below 1e-3 of what weight and adhesion store in a contact,
    (m g + F_ad)^2/(2 K) per sphere, so that speeds are 3 % of what opens one. There contacts rattle on
    without adhesion (docs/verification/contact_energies.md); at t_c/20 below 1e-9 of the start's.
    With 20 weights spheres hang in one contact or two, where they spin and roll on without loss unless something
    resists rolling; with a rolling friction nothing is left that moves without loss."""

    def kinetic_over_limit(self, ratio, division, of_start, seed, roll, duration):
        """After a run of `duration` [s]: over `of_start` of the kinetic energy at the start; 0: over the limit of what
        is stored."""
        with engine.temporary_folder() as folder:
            settling.write(folder, 4, 5, seed=seed)
            table, _ = settling.follow(folder, division, duration, A=settling.hamaker_constant(ratio), roll=roll)
        self.assertEqual(len(table), 51)
        load = (1 + ratio) * gas.MASS * settling.GRAVITY
        rest = of_start * table[0, 1] or 1e-3 * 80 * load**2 / (2 * gas.STIFFNESS)
        self.assertGreater(table[:10, 1].max(), 1.5 * table[0, 1])  # they fell
        return table[-10:, 1].max() / rest  # the last fifth: 400 contact times and more

    def most_come_to_rest(self, ratio, division=10, of_start=0.0, duration=0.3):
        # The median of nine: in one bed of seven a sphere rolls on in its place, or comes there late. Five are enough to
        # know it.
        values = []
        for seed in range(1, 10):
            values.append(self.kinetic_over_limit(ratio, division, of_start, seed, 0.0, duration))
            if sum(value < 1.0 for value in values) == 5:
                break
        print(f"{ratio} weights, t_c/{division}: " + ", ".join(f"{v:.1e}" for v in values), file=sys.stderr)
        self.assertEqual(sum(value < 1.0 for value in values), 5)

    def test_without_adhesion(self):
        self.most_come_to_rest(0)

    def test_without_adhesion_in_small_steps(self):
        self.most_come_to_rest(0, 20, 1e-9, 0.4)

    def test_adhesion_of_one_weight(self):
        self.most_come_to_rest(1)

    def test_adhesion_of_twenty_weights(self):
        for seed in (1, 2, 3):
            with self.subTest(seed=seed):
                self.assertLess(self.kinetic_over_limit(20, 10, 0.0, seed, 0.01, 0.2), 1.0)


if __name__ == "__main__":
    unittest.main()
