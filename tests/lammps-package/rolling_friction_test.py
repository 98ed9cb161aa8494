# SPDX-License-Identifier: BSD-3-Clause
"""Rolling friction of gran/hamaker and wall/gran/hamaker in LAMMPS, against closed forms; and
gravity in the energy tally."""
import math
import unittest

import numpy

from cohesion_tests.lammps_scenes.rolling_balls import (CONTACT, G, INERTIA, RADIUS, ROUNDING, WALL_TIME, Rolling,
                                                        ball, report)
from cohesion_tests.lammps_scenes.unlike_couples import T_C, Box
from cohesion_tests.theory import pair_motion
from cohesion_tests.theory.pair_motion import CUT, DIAMETER, MASS, OUT, STIFFNESS


class OnAPlane(Rolling):
    def roll(self, parts, coefficient, slope, speed, time, scheme="exact"):
        """A ball that rolls down a plane of this slope along x from rest under its load; speeds at
        100 times in the second half of `time` [s]."""
        dt = WALL_TIME / parts
        angle = math.atan(slope)
        sunk = MASS * G * math.cos(angle) / STIFFNESS
        every = int(time / dt / 200) + 1
        path, thermo = self.run_spheres(
            [ball(RADIUS - sunk, (speed, 0.0, 0.0), (0.0, speed / RADIUS, 0.0))], dt, 200 * every,
            every, scheme=scheme, gx=G * math.sin(angle), gz=-G * math.cos(angle),
            wall=f"{CONTACT} friction 0.6 rolling_friction {coefficient} zplane 0 NULL")
        return every * dt * numpy.arange(100, 201), path[100:, 0], thermo

    def test_a_ball_is_slowed_at_5_7_mu_g(self):
        # m a = -T, I a/R = -(R mu_R m g - R T): a = mu_R g/(1 + 2/5). Springs have come to rest.
        for parts, scheme in ((3, "exact"), (10, "exact"), (50, "exact"), (20, "sampled")):
            t, path, _ = self.roll(parts, 0.02, 0.0, 0.05, 0.1, scheme)
            slowed = numpy.polyfit(t, path[:, 3], 1)[0] / (-5 / 7 * 0.02 * G)
            turned = numpy.polyfit(t, RADIUS * path[:, 7], 1)[0] / (-5 / 7 * 0.02 * G)
            report(f"on a plane, t_c/{parts}, {scheme}: slowed at 5/7 mu_R g x (1 {slowed - 1:+.1e}), "
                   f"spin {turned - 1:+.1e}")
            # The speed is rounded alike in many steps, each time by half its last digit.
            rounding = ROUNDING + 0.05 * 2.0**-53 / (5 / 7 * 0.02 * G * WALL_TIME / parts)
            self.assertAlmostEqual(slowed, 1.0, delta=rounding)
            self.assertAlmostEqual(turned, 1.0, delta=rounding)
            self.assertEqual(numpy.abs(path[:, [4, 6, 8]]).max(), 0.0)

    def test_a_ball_comes_to_rest_after_v2_over_2a(self):
        speed, coefficient = 0.02, 0.05
        slowing = 5 / 7 * coefficient * G
        _, path, thermo = self.roll(10, coefficient, 0.0, speed, 3 * speed / slowing)
        way = speed**2 / (2 * slowing)
        # The rolling spring, R theta = mu_R m g/K_r, and the sliding one, less than that, are to be
        # stretched first and let go at the end; K_r that of the grid, (1 - 2 c cos(q dt) + c^2) m_r/dt^2.
        mass, dt = INERTIA / RADIUS**2, WALL_TIME / 10
        square, ln_e = 2 / 7 * STIFFNESS / mass, math.log(0.3)
        rate = 0.5 * -ln_e / math.hypot(math.pi, ln_e) * math.sqrt(STIFFNESS * MASS) / mass
        kept = math.exp(-rate * dt)
        on_grid = (1 - 2 * kept * math.cos(math.sqrt(square - rate**2) * dt) + kept**2) * mass / dt**2
        spring = coefficient * MASS * G / on_grid
        report(f"way until at rest: {path[-1, 0] / way - 1:+.1e} off v^2/(2 a), springs stretch by "
               f"{spring / way:.1e} of it")
        self.assertAlmostEqual(path[-1, 0], way, delta=4 * spring)
        # Springs and dashpots are at rest: 0.05 s are 400 contact times, of which each takes 1/e.
        self.assertLess(max(abs(path[-1, 3]), RADIUS * abs(path[-1, 7])), 2.0**-53 * speed)
        # All of the energy is lost, to rolling nearly: the sliding spring takes part in the last swing.
        energy = thermo["c_tally[1]"][0] + thermo["c_tally[2]"][0]
        lost = thermo["c_tally[13]"][-1] - thermo["c_tally[13]"][0]
        self.assertAlmostEqual(lost / energy, 1.0, delta=4 * spring / way)

    def test_a_slope_holds_it_below_mu_r_and_not_above(self):
        coefficient = 0.1
        for slope in (0.05, 0.098, 0.102, 0.2):
            t, path, _ = self.roll(10, coefficient, slope, 0.0, 0.1)
            angle = math.atan(slope)
            excess = 5 / 7 * G * (math.sin(angle) - coefficient * math.cos(angle))
            fit = numpy.polyfit(t, path[:, 3], 1)[0]
            report(f"slope {slope} = {slope / coefficient:.2f} mu_R: acceleration {fit:.4g} m/s^2, "
                   f"5/7 g (sin - mu_R cos) = {excess:.4g}")
            if slope < coefficient:
                # The overshoot of the springs may have rolled it before; then it stays.
                self.assertLess(numpy.abs(path[:, 3]).max(), 1e-9)
            else:
                self.assertAlmostEqual(fit, excess, delta=ROUNDING * G)

    def test_a_plane_that_moves_is_one_at_rest_in_its_frame(self):
        dt, steps, speed, moves = WALL_TIME / 10, 2000, 0.05, 0.25
        found = []
        for wall_speed in (0.0, moves):
            path, _ = self.run_spheres(
                [ball(RADIUS - MASS * G / STIFFNESS, (speed + wall_speed, 0.0, 0.0),
                      (0.0, speed / RADIUS, 0.0))], dt, steps, steps // 100, gz=-G,
                wall=f"{CONTACT} friction 0.6 rolling_friction 0.02 zplane 0 NULL translate x {wall_speed}")
            found.append((path[:, 0, 3] - wall_speed, RADIUS * path[:, 0, 7]))
        self.assertLess(found[0][0][-1], speed - 0.9 * 5 / 7 * 0.02 * G * dt * steps)
        # Some ten operations with the speed of the ball in each step; springs hold what they add up to.
        for rest, moving in zip(*found):
            self.assertLess(numpy.abs(moving - rest).max(), 10 * steps * 2.0**-53 * (speed + moves))


class OnePair(Rolling):
    def test_a_pair_pressed_by_adhesion_loses_its_spin(self):
        # I w' = -R mu_R F_ad, R = r/2: equal spheres with opposite spins do not slide.
        A, coefficient, spin = 7.49e-19, 0.02, 40.0
        pull = pair_motion.Pair(A).adhesion
        for scheme in ("exact", "sampled"):
            dt = T_C / 20
            rate = 0.5 * RADIUS * coefficient * pull / INERTIA
            steps = int(0.9 * spin / rate / dt) // 100 * 100
            atoms = [ball(0.0, spin=(0.0, spin, 0.0)),
                     ball(0.0, spin=(0.0, -spin, 0.0), x=DIAMETER - pull / STIFFNESS)]
            path, thermo = self.run_spheres(
                atoms, dt, steps, steps // 100, scheme=scheme,
                pair=f"{CONTACT} friction 0.5 rolling_friction {coefficient} hamaker {A} "
                     f"cutoff {CUT} {OUT}")
            t = dt * steps / 100 * numpy.arange(101)
            for atom, sign in ((0, -1), (1, 1)):
                found = numpy.polyfit(t[10:], path[10:, atom, 7], 1)[0] / rate * sign
                report(f"pair, {scheme}: spin lost at R mu_R F_ad/I x (1 {found - 1:+.1e})")
                # The overlap is 2.4e-7 m of places of 1e-3 m.
                self.assertAlmostEqual(found, 1.0, delta=ROUNDING)
            numpy.testing.assert_allclose(path[:, 0, 7], -path[:, 1, 7], rtol=1e-12)
            energy = thermo["c_tally[2]"][0]
            self.assertGreater(thermo["c_tally[13]"][-1], 0.9 * energy)
            residual = numpy.abs(thermo["c_tally[10]"]).max() / energy
            report(f"pair, {scheme}: energy tally {residual:.1e}")
            self.assertLess(residual, 4 * 2.0**-53 * steps)

    def test_swings_at_the_closed_form(self):
        # R^2 (2/I) K_r = w^2, damped at eta_r/(2 m_r); the midpoint rule's phase is 2 atan(w dt/2)
        # per step, (w dt)^2/12 behind, its decay likewise.
        A, spin = 7.49e-19, 1e-3
        pull = pair_motion.Pair(A).adhesion
        inverse_mass = (RADIUS / 2)**2 * 2 / INERTIA
        alpha = 0.25 * pair_motion.DAMPING * inverse_mass
        frequency = math.sqrt(2 / 7 * STIFFNESS * inverse_mass)
        q = math.sqrt(frequency**2 - alpha**2)
        atoms = [ball(0.0, spin=(0.0, spin, 0.0)),
                 ball(0.0, spin=(0.0, -spin, 0.0), x=DIAMETER - pull / STIFFNESS)]
        errors = []
        for parts in (5, 10, 20, 40):
            dt = T_C / parts
            path, _ = self.run_spheres(
                atoms, dt, 4 * parts, 1,
                pair=f"stiffness {STIFFNESS} damping {pair_motion.DAMPING} rolling_friction 10 "
                     f"hamaker {A} cutoff {CUT} {OUT}")
            # The grid's spin at n is the mean of two half steps, of second order.
            t = dt * numpy.arange(4 * parts + 1)
            exact = numpy.exp(-alpha * t) * (numpy.cos(q * t) - alpha / q * numpy.sin(q * t))
            errors.append(numpy.abs(path[:, 0, 7] / spin - exact).max())
            # Phase behind by w t (w dt)^2/12, t = 4 t_c; the mean of half steps 1 - (w dt)^2/8; the
            # first step's half window is of second order, too.
            self.assertLess(errors[-1],
                            (frequency * dt)**2 * (frequency * 4 * T_C / 12 + 1 / 8 + 1 / 4))
        report("pair, swings: errors at t_c/5 ... /40: " + ", ".join(f"{e:.1e}" for e in errors))
        self.assertLess(errors[3], errors[1] / 12)


class Impacts(unittest.TestCase):
    """Oblique impacts of spheres of two sizes, spinning, with friction and rolling friction."""

    def test_momentum_and_angular_momentum(self):
        box, without = Box(0.3, 6, rolling=0.2), Box(0.3, 6)
        scale = box.MASSES[0] * box.SPEED
        momentum = (box.MASSES[:, None] * box.v).sum(axis=2)
        self.assertLess(numpy.abs(momentum - momentum[0]).max(), 60 * 4 * 2.0**-53 * scale)
        orbital = numpy.cross(box.x - box.centre, box.v) * box.MASSES[:, None]
        total = (orbital + box.spin).sum(axis=2)
        drift = numpy.abs(total - total[0]).max()
        report(f"rolling impacts: angular momentum {drift / scale / DIAMETER:.1e} of m v d")
        self.assertLess(drift, 60 * 4 * 2.0**-53 * 30 * scale * DIAMETER)
        self.assertGreater(numpy.abs(box.spin[-1] - without.spin[-1]).max(), 1e-2 * scale * DIAMETER)

    def test_energy_tally_is_of_first_order(self):
        # As with friction (gran_hamaker_couple_test): the angular impulse of rolling is below
        # R mu_R 2 mu (1 + e) v, and by n+1/2 a part v dt/(2 R) of it is along the normal. Friction
        # and rolling friction act on the same spins in turn: second order, and smaller here. Order 1 is
        # distinguished from 1/2 by what lies between the factors of a fourfold step, 4 and 2.
        reach, residuals = 0.5 * Box.DIAMETERS.sum(), []
        for division in (4, 8, 16, 32):
            box = Box(0.3, division, rolling=0.2)
            residual = numpy.abs(box.tally[10]).max()
            bound = 8 * (0.3 + 0.2) * Box.SPEED * T_C / division / (2 * reach) * box.energy
            report(f"rolling impacts, t_c/{division}: energy tally {residual / box.energy:.1e} of all, "
                   f"{residual / bound:.2f} of the bound; lost in rolling "
                   f"{box.tally[13][-1] / box.energy:.4f}")
            self.assertLess(residual, bound)
            self.assertGreaterEqual(numpy.diff(box.tally[13]).min(), -box.rounding)
            self.assertGreater(box.tally[13][-1], 1e-3 * box.energy)
            self.assertEqual(box.tally[12][-1], 0.0)
            residuals.append(residual)
        self.assertGreater(residuals[1] / residuals[3], 4**0.75)


class Gravity(Rolling):
    def test_a_ball_thrown_up_that_bounces(self):
        # In flight and in contact the tally closes to rounding, with weight and friction.
        residuals = []
        for parts in (5, 10, 20, 40):
            dt = WALL_TIME / parts
            steps = int(0.1 / dt)
            path, tally = self.run_spheres([ball(RADIUS + 1e-3, (0.01, 0.0, 0.05), (0.0, 3.0, 0.0))],
                                          dt, steps, 1, gz=-G,
                                          wall=f"stiffness {STIFFNESS} restitution 0.9 friction 0.3 "
                                               "zplane 0 NULL")
            # A few roundings of m g z.
            numpy.testing.assert_allclose(tally["c_tally[11]"], MASS * G * path[:, 0, 2], rtol=1e-14)
            mechanical = sum(tally[f"c_tally[{k}]"] for k in (1, 2, 3, 4, 5, 11, 12))
            numpy.testing.assert_allclose(tally["c_tally"], mechanical, rtol=1e-14)
            energy = tally["c_tally"][0]
            flies = tally["c_tally[6]"] == 0.0  # before the first bounce
            self.assertGreater(flies.sum(), 10 * parts)
            self.assertLess(numpy.abs(tally["c_tally[10]"][flies]).max(),
                            8 * 2.0**-53 * flies.sum() * energy)
            # All forces but those of the contact and the weight: roundings of the work they do,
            # in a bounce twice the energy.
            self.assertLess(numpy.abs(tally["c_tally[9]"]).max(), 10 * 4 * 2.0**-53 * energy)
            residuals.append(numpy.abs(tally["c_tally[10]"]).max() / energy)
            bounces = (numpy.diff(numpy.sign(path[:, 0, 5])) > 0).sum()
            self.assertGreater(bounces, 2)
            report(f"thrown up, {bounces} bounces at t_c/{parts}: energy tally {residuals[-1]:.1e}")
            impact = math.sqrt(0.05**2 + 2 * G * 1e-3)
            # A place is rounded in each step of each bounce, while the spring pulls with at most
            # impact sqrt(K m): over m impact^2/2.
            deepest = impact * math.sqrt(MASS / STIFFNESS)
            self.assertLess(residuals[-1], math.sqrt(4 * bounces * parts) * 2 * 2.0**-53 * 1e-3 / deepest)

    def test_through_a_periodic_side(self):
        # Down a periodic direction the potential goes on falling.
        dt = WALL_TIME / 10
        path, tally = self.run_spheres([ball(1e-3, (0.3, 0.0, 0.0))], dt, 4000, 100,
                                      box=((0.0, 0.004), (-0.02, 0.02), (-0.01, 0.02)),
                                      boundary="p p f", gx=G)
        t = dt * 100 * numpy.arange(41)
        fallen = 0.3 * t + 0.5 * G * t**2
        self.assertGreater(fallen[-1], 0.008)
        numpy.testing.assert_allclose(tally["c_tally[11]"], -MASS * G * fallen,
                                      rtol=1e-12, atol=1e-14 * MASS * G)
        # The speed is rounded alike in many steps.
        self.assertLess(numpy.abs(tally["c_tally[10]"]).max(),
                        4000 * 2 * 2.0**-53 * tally["c_tally[1]"][-1])


if __name__ == "__main__":
    unittest.main()
