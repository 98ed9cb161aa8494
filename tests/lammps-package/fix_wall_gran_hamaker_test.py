# SPDX-License-Identifier: BSD-3-Clause
"""Impacts of spheres on walls of the exact scheme, in LAMMPS, against closed forms and against
integrations of the same motion that know neither LAMMPS nor the package."""
import math
import unittest

import numpy
from scipy.integrate import solve_ivp

from cohesion_tests.lammps_scenes.exact_wall import (CUT, DIAMETER, MASS, OUT, RADIUS, ROUNDING, SPEED, STIFFNESS, W0,
                                                     ExactWall, alpha, contact_time, say)
from cohesion_tests.thermo import thermo_end


class Impact(ExactWall):
    def bounce(self, restitution, parts, wall, height, up):
        """Impacts that begin at sixteen places within the step; exit speeds."""
        dt = contact_time(restitution) / parts
        x = self.places(16)
        for k, place in enumerate(x):
            place[2] = height + up * (RADIUS + SPEED * dt * (3 + k / 16))
        self.write(x, [(0.0, 0.0, -up * SPEED)] * 16)
        end = self.run_wall(f"stiffness {STIFFNESS} restitution {restitution} {wall}", dt,
                            2 * parts + 6)
        return up * end[:, 6] / SPEED

    def test_restitution(self):
        worst = 0.0
        for restitution in (1.0, 0.9, 0.3):
            for parts in (2, 10):
                for wall, height, up in (("zplane 0.01 NULL", 0.01, 1),
                                         ("zplane NULL 0.03", 0.03, -1)):
                    ratio = self.bounce(restitution, parts, wall, height, up) / restitution
                    worst = max(worst, abs(ratio - 1).max())
        say(f"restitution: largest relative error {worst:.1e}")
        self.assertLessEqual(worst, ROUNDING)

    def test_restitution_in_a_cylinder(self):
        # Along the radius the tangent plane is the wall.
        dt = contact_time(0.8) / 2
        radius = 5e-3
        angles = numpy.arange(16) * 0.4
        out = numpy.array([numpy.cos(angles), numpy.sin(angles), 0 * angles]).T
        x = out * (radius - RADIUS - SPEED * dt * (3 + angles / 6.4))[:, None]
        x[:, 2] = 2e-3 * numpy.arange(1, 17)
        self.write(x, SPEED * out, box=[(-0.01, 0.01), (-0.01, 0.01), (0.0, 0.04)])
        end = self.run_wall(f"stiffness {STIFFNESS} restitution 0.8 zcylinder {radius}", dt, 10)
        worst = numpy.abs(end[:, 4:7] + 0.8 * SPEED * out).max() / SPEED
        say(f"restitution in a cylinder: largest relative error {worst:.1e}")
        self.assertLessEqual(worst, ROUNDING)

    def test_oblique_impact_in_a_cylinder(self):
        # The tangent plane turns from step to step only: the angular momentum about the axis is kept,
        # the energy at second order in the step.
        radius, slide, errors = 5e-3, 0.2, []
        start = radius - RADIUS - 5e-7
        for parts in (10, 20, 40):
            self.write([[start, 0.0, 2e-3]], [(SPEED, slide, 0.0)],
                       box=[(-0.01, 0.01), (-0.01, 0.01), (0.0, 0.04)])
            end = self.run_wall(f"stiffness {STIFFNESS} zcylinder {radius}",
                                contact_time() / parts, 3 * parts // 2)[0]
            self.assertLess(end[4], 0.0)
            momentum = (end[1] * end[5] - end[2] * end[4]) / (start * slide)
            energy = (end[4] ** 2 + end[5] ** 2) / (SPEED**2 + slide**2)
            errors.append((abs(energy - 1), abs(momentum - 1)))
        say("oblique in a cylinder: relative errors of energy and angular momentum at t_c/10, /20, "
            "/40: " + ", ".join(f"{e:.1e} {m:.1e}" for e, m in errors))
        # Within a step the contact does not see slide^2/start, the turning: where it begins and ends
        # the normal speed is off by up to that times dt, which cancels but for the square of it.
        for parts, (energy, momentum) in zip((10, 20, 40), errors):
            turned = slide**2 / start * contact_time() / parts / SPEED
            self.assertLessEqual(energy, 2 * turned**2)
            self.assertLessEqual(momentum, ROUNDING)

    def test_force_on_the_wall_is_the_momentum(self):
        dt = contact_time() / 10
        self.write([[2e-3, 2e-3, 0.01 + RADIUS + 1e-9]], [(0.0, 0.0, -SPEED)])
        self.run_wall(f"stiffness {STIFFNESS} zplane 0.01 0.03", dt, 5)
        values = thermo_end(self.output)
        # The force of a step leads from one place to the next, which are those of v/w0 sin(w0 t).
        places = [SPEED / W0 * math.sin(W0 * (n * dt - 1e-9 / SPEED)) for n in (4, 5, 6)]
        mean = -MASS * (places[0] - 2 * places[1] + places[2]) / dt**2
        self.assertAlmostEqual(-values["f_walls[3]"] / mean, 1.0, delta=1e-9)
        self.assertEqual(values["f_walls[3]"], values["f_walls[1][3]"])
        self.assertEqual(values["f_walls[1]"], 0.0)
        self.assertEqual(values["f_walls[6]"], 0.0)  # nothing attracts

    def test_adhesion_on_the_wall_is_that_of_touching_surfaces(self):
        """In the fifth step the sphere, which slides with friction too, is in contact all the time: A r/(6 H_cut^2)."""
        hamaker = 5e-19
        adhesion = hamaker * RADIUS / (6 * CUT**2)
        dt = contact_time() / 10
        for scheme in ("exact", "sampled"):
            self.write([[2e-3, 2e-3, 0.01 + RADIUS + 1e-9]], [(0.02, 0.0, -SPEED)])
            self.run_wall(f"stiffness {STIFFNESS} friction 0.3 hamaker {hamaker} cutoff {CUT} {OUT} "
                          f"zplane 0.01 0.03 scheme {scheme}", dt, 5)
            values = thermo_end(self.output)
            self.assertAlmostEqual(values["f_walls[6]"] / adhesion, 1.0, delta=ROUNDING)
            self.assertEqual(values["f_walls[6]"], values["f_walls[1][6]"])
            # Friction is no adhesion.
            self.assertGreater(values["f_walls[1]"], 0.0)
            self.assertLess(abs(values["f_walls[4]"]), ROUNDING * values["f_walls[1]"])


class Moving(ExactWall):
    WALL = (f"stiffness {STIFFNESS} restitution 0.8 friction 0.3 hamaker 5e-19 cutoff {CUT} {OUT} "
            "zplane 0.01 NULL")

    def test_moving_wall_is_a_still_one_seen_from_a_moving_frame(self):
        # No contact begins on a step's edge: on which side of it would be a matter of rounding.
        dt = contact_time() / 10
        v = numpy.array([(0.01 * k, 0.0, -SPEED) for k in range(16)])
        x = self.places(16)
        x[:, 2] = 0.01 + RADIUS + SPEED * dt * (3.02 + numpy.arange(16) / 16)
        self.write(x, v)
        still = self.run_wall(self.WALL, dt, 40)
        for dim, speed in (("z", 0.05), ("z", -0.3), ("x", 0.2)):
            frame = numpy.array([speed * (dim == axis) for axis in "xyz"])
            self.write(x, v + frame)
            moving = self.run_wall(f"{self.WALL} translate {dim} {speed}", dt, 40)
            place = numpy.abs(moving[:, 1:4] - 40 * dt * frame - still[:, 1:4]).max()
            velocity = numpy.abs(moving[:, 4:7] - frame - still[:, 4:7]).max()
            spin = numpy.abs(moving[:, 7:] - still[:, 7:]).max() * RADIUS
            say(f"translate {dim} {speed}: {place:.1e} m, {velocity:.1e} m/s, {spin:.1e} m/s")
            # Places of 0.03 m, rounded by 4e-18 m in each of 40 steps; times w0 = 2.4e4 1/s for
            # speeds, and the slope of the adhesion's edge on top.
            self.assertLessEqual(place, 1e-15)
            self.assertLessEqual(max(velocity, spin), 1e-11)
        # Along a plane, shear is the same.
        self.assertEqual(self.run_wall(f"{self.WALL} shear x 0.2", dt, 40).tolist(),
                         moving.tolist())

    def test_wiggle(self):
        # Amplitude and period such that the wall turns round during the contact.
        amplitude, period = 4e-6, 3 * contact_time()
        gap, errors = 2e-6, []
        omega = 2 * math.pi / period

        def motion(t, s):
            wall = amplitude * (1 - math.cos(omega * t))
            return [s[1], W0**2 * max(wall - s[0], 0.0)]

        stop = 2.5 * contact_time()
        scale = 1e-6
        path = solve_ivp(lambda t, s: numpy.array(motion(t, numpy.array(s) * scale)) / scale,
                         (0, stop), [gap / scale, -SPEED / scale], method="DOP853", rtol=1e-11,
                         atol=1e-11, max_step=contact_time() / 200)
        for parts in (10, 20, 40):
            self.write([[2e-3, 2e-3, 0.01 + RADIUS + gap]], [(0.0, 0.0, -SPEED)])
            end = self.run_wall(f"stiffness {STIFFNESS} zplane 0.01 NULL wiggle z {amplitude} "
                                f"{period:.17g}", contact_time() / parts, int(2.5 * parts))
            errors.append(abs(end[0, 6] / (path.y[1, -1] * scale) - 1))
        say("wiggle: relative errors of the exit speed at t_c/10, /20, /40: "
            + ", ".join(f"{e:.1e}" for e in errors))
        # A chord misses the wall's path by a w^2 dt^2/8: for t_c/10, w dt = 0.2: 0.005 of 4e-6 m
        # of 4e-6 m overlap; half that in the mean.
        for finer, error in zip((1, 2, 4), errors):
            self.assertLessEqual(error, 5e-3 / finer**2)

    def test_turning_cylinder_drags(self):
        # Full sliding: the tangential momentum is mu times the normal one, along the wall's way.
        dt, radius = contact_time() / 10, 5e-3
        self.write([[radius - RADIUS - 1e-6, 0.0, 2e-3]], [(SPEED, 0.0, 0.0)],
                   box=[(-0.01, 0.01), (-0.01, 0.01), (0.0, 0.04)])
        wall = f"stiffness {STIFFNESS} friction 0.1 tangential_damping 0 zcylinder {radius}"
        for words, axis, sign in (("shear z 5", 6, 1), ("shear x 5", 5, -1), ("shear y 5", 5, -1),
                                  ("translate z -5", 6, -1)):
            end = self.run_wall(f"{wall} {words}", dt, 15)
            # The normal turns by the way along the wall over its radius, 0.02 m/s in a contact,
            # 1.3e-6 m of 4.5e-3 m.
            self.assertAlmostEqual(end[0, axis], sign * 0.1 * 2 * SPEED, delta=3e-4 * SPEED,
                                   msg=words)


class TwoWalls(ExactWall):
    def test_to_and_fro(self):
        # Contacts and flights take known times; without damping nothing is lost.
        dt, gap = contact_time() / 10, 3e-5
        self.write([[2e-3, 2e-3, 0.01 + RADIUS + gap / 2]], [(0.0, 0.0, -SPEED)])
        steps = 2000
        self.run_wall(f"stiffness {STIFFNESS} zplane 0.01 {0.01 + DIAMETER + gap:.17g}", dt, steps,
                      every=1)
        course = self.course([3, 6])
        time = dt * numpy.arange(len(course))
        flight, touch = gap / SPEED, contact_time()
        half = flight + touch
        phase = (time - gap / 2 / SPEED + half) % (2 * half) - half  # 0: touches the lower wall
        flies = ((phase > touch + 2 * dt) & (phase < half - 2 * dt)) | (
            (phase < -2 * dt) & (phase > touch - half + 2 * dt))
        height = numpy.where(phase > 0, SPEED * (phase - touch), SPEED * -phase)
        error = numpy.abs(course[:, 0] - 0.01 - RADIUS - height)[flies].max()
        say(f"between two walls, {steps} steps, {int(time[-1] / half)} impacts: error {error:.1e} m")
        self.assertGreater(flies.sum(), 200)
        self.assertLessEqual(error, 1e-13)

    def squeezed(self, restitution, parts):
        """Between two walls, in contact with both, from 2e-6 m beside the middle: heights over that at the grid
        points of a contact time, and the times."""
        squeeze, offset = 4e-6, 2e-6
        dt = contact_time(restitution) / parts
        self.write([[2e-3, 2e-3, 0.01 + RADIUS - squeeze + offset]], [(0.0, 0.0, 0.0)])
        self.run_wall(f"stiffness {STIFFNESS} restitution {restitution} zplane 0.01 "
                      f"{0.01 + DIAMETER - 2 * squeeze:.17g}", dt, parts, every=1)
        height = (self.course([3, 6])[:, 0] - 0.01 - RADIUS + squeeze) / offset
        return height, dt * numpy.arange(len(height))

    def test_squeezed(self):
        # A spring of twice the stiffness and damping, 2 alpha. Each contact knows the other by its force of the step
        # before, and takes the velocity of its dashpot half a step before: elastic ones are of second order in the step.
        # The two dashpots together take 2 alpha (1 + alpha dt), which a course that decays with 2 alpha sees as
        # 2 alpha^2 dt t exp(-2 alpha t), alpha dt/e at most.
        for restitution in (1.0, 0.3):
            a = 2 * alpha(restitution)
            q = math.sqrt(2 * W0**2 - a**2)
            errors = []
            for parts in (10, 20, 40):
                height, t = self.squeezed(restitution, parts)
                # Free motion of a damped oscillator; the grid's position is half a step of flight off
                # at second order, the mean of its speeds too.
                exact = numpy.exp(-a * t) * (numpy.cos(q * t) + a / q * numpy.sin(q * t))
                errors.append(numpy.abs(height - exact).max())
            say(f"squeezed between two walls, e = {restitution}: errors of the course at t_c/10, /20, /40 over the "
                "amplitude: " + ", ".join(f"{e:.1e}" for e in errors))
            dashpots = alpha(restitution) * contact_time(restitution) / 40 / math.e
            self.assertLessEqual(errors[2], errors[0] / 8 + dashpots)

    def test_squeezed_and_damped(self):
        # From the second step on both contacts are persistent, and together a leapfrog with twice the force of one.
        restitution, parts = 0.8, 20
        height, t = self.squeezed(restitution, parts)
        step = t[1]
        a = alpha(restitution)
        kept = math.exp(-2 * a * step)
        curvature = 1 + kept - 2 * math.exp(-a * step) * math.cos(math.sqrt(W0**2 - a**2) * step)
        for n in range(1, parts):
            next_height = height[n] + (2 * kept - 1) * (height[n] - height[n - 1]) - 2 * curvature * height[n]
            # Places near 0.01 m are written with their rounding, and weighed four times.
            self.assertAlmostEqual(height[n + 1], next_height, delta=4 * 2.0**-53 * 0.01 / 2e-6)


class Corner(ExactWall):
    def test_walls_without_friction_know_nothing_of_each_other(self):
        # Into the edge of two walls, and beside it into one of them alone: the same along its normal.
        # Captured, so that the walls are met many times, and with speeds of the same order along the other.
        for parts in (2.5, 10):
            dt = contact_time(0.9) / parts
            for speed in (1e-4, 0.003, 1.0):
                x, v = [], []
                for k in range(16):
                    height = 0.01 + RADIUS + CUT + speed * dt * (0.2 + k / 16)
                    for side in (0.01 + RADIUS + CUT + 0.5 * speed * dt, 0.03):
                        x.append([side, height, 2e-3 * (k + 1)])
                        v.append([-speed, -0.3 * speed, 0.0])
                self.write(x, v)
                steps = int(8 * parts)
                end = self.run_wall(f"stiffness {STIFFNESS} restitution 0.9 hamaker 7.5e-19 cutoff {CUT} {OUT} "
                                    "xplane 0.01 NULL yplane 0.01 NULL", dt, steps)
                self.assertGreater((end[::2, 5] != v[0][1]).sum(), 8)
                # A single contact has the discrete force, one of two is resolved: the same but for the
                # rounding of a place in each step, which is an error of the speed by dt.
                rounding = steps * numpy.finfo(float).eps * numpy.abs(end[:, 1:4]).max()
                place, speed_error = numpy.abs(end[::2, [2, 5]] - end[1::2, [2, 5]]).max(axis=0)
                self.assertLess(place, rounding)
                self.assertLess(speed_error, rounding / dt)


class Friction(ExactWall):
    """Oblique impacts."""

    def reference(self, speed, restitution, mu, ratio=2 / 7, damping_ratio=0.5):
        """Tangential velocity and spin after an impact, by small steps of the spring, dashpot and
        slider of Cundall and Strack."""
        k_t = ratio * STIFFNESS
        eta = 2 * MASS * alpha(restitution) if restitution < 1 else 0.0
        eta_t = damping_ratio * eta
        x, v, u, spin, s = 0.0, SPEED, speed, 0.0, 0.0
        inertia = 0.4 * MASS * RADIUS**2
        dt = contact_time(restitution) / 40000
        while x >= 0.0:
            force = STIFFNESS * x + eta * v
            slip = u - RADIUS * spin
            s += dt * slip
            pull = -(k_t * s + eta_t * slip)
            limit = mu * max(force, 0.0)
            if abs(pull) > limit:
                pull = math.copysign(limit, pull)
                s = -(pull + eta_t * slip) / k_t
            u += dt * pull / MASS
            spin -= dt * pull * RADIUS / inertia
            v -= dt * force / MASS
            x += dt * v
        return u, spin

    def impact(self, speed, restitution, mu, parts):
        dt = contact_time(restitution) / parts
        x = self.places(8)
        x[:, 2] = 0.01 + RADIUS + SPEED * dt * (2 + numpy.arange(8) / 8)
        self.write(x, [(speed, 0.0, -SPEED)] * 8)
        end = self.run_wall(f"stiffness {STIFFNESS} restitution {restitution} friction {mu} "
                            "zplane 0.01 NULL", dt, 2 * parts + 4)
        self.assertEqual(numpy.abs(end[:, [5, 7, 9]]).max(), 0.0)
        return end[:, 4], end[:, 8]

    def test_sliding_takes_mu_times_the_normal_momentum(self):
        for parts in (2, 10, 50):
            u, _ = self.impact(1.0, 1.0, 0.1, parts)
            self.assertLessEqual(numpy.abs(u / (1.0 - 0.1 * 2 * SPEED) - 1).max(), ROUNDING)

    def test_sliding_and_sticking(self):
        for name, speed, restitution, mu in (("sliding", 0.5, 0.9, 0.1), ("sticking", 0.02, 0.9, 2.0),
                                             ("both", 0.1, 0.9, 0.3)):
            reference = self.reference(speed, restitution, mu)
            errors = []
            for parts in (10, 50, 200):
                u, spin = self.impact(speed, restitution, mu, parts)
                errors.append(max(numpy.abs(u - reference[0]).max(),
                                  0.4 * RADIUS * numpy.abs(spin - reference[1]).max()) / speed)
            say(f"friction, {name}: errors at t_c/10, /50, /200 over the tangential speed: "
                + ", ".join(f"{e:.1e}" for e in errors))
            self.assertLessEqual(errors[1], 5e-3)
            self.assertLessEqual(errors[2], 1e-3)


if __name__ == "__main__":
    unittest.main()
