# SPDX-License-Identifier: BSD-3-Clause
"""Columns, rows, oblique impacts and gases of Hertz's, DMT's and JKR's contacts in scheme exact, for both engines.

A test case has
  column(law, dt, steps, heights)      the end of spheres above a plate at z = 0, under gravity: rows of height and speed
  row(law, restitution, dt, steps, starts, velocities)   velocities along x at the end, of spheres in a row
  oblique(dt, steps, start, velocity)   the end of an elastic Hertzian impact without slip or tangential dashpot, of a sphere
                                       from (start, 0, 0) on one at the origin: velocity of the surfaces along y
  gas(law, restitution, friction, division, collisions)   error of the energy balance of a gas and what is lost, both over
                                       the kinetic energy of the start
"""
import math
import sys

import numpy
from scipy.integrate import solve_ivp

from cohesion_tests.theory import hertzian_laws as laws

GRAVITY, RESTITUTION = 9.81, 0.5
MASS = math.pi / 6 * 2650.0 * laws.DIAMETER**3
SPHERES, SPEED = 4, 0.1


def converged_row(restitution, starts, velocities, duration):
    """Velocities of three equal spheres in a row with Hertz's contact, by an integration that knows no engine."""
    two = laws.pair("hertz", restitution)
    length, time = SPEED * two.contact_time(SPEED), two.contact_time(SPEED)

    def motion(_, state):
        x, v = state[:3] * length, state[3:] * SPEED
        forces = numpy.zeros(3)
        for i in range(2):
            overlap = laws.DIAMETER - (x[i + 1] - x[i])
            if overlap > 0:
                force = two.k * overlap**1.5 + two.c * overlap**0.25 * (v[i] - v[i + 1])
                forces[i] -= force
                forces[i + 1] += force
        return numpy.concatenate([v / length, forces / (2 * two.mu) / SPEED])

    path = solve_ivp(motion, (0, duration), [*(numpy.array(starts) / length), *(numpy.array(velocities) / SPEED)],
                     method="DOP853", rtol=1e-9, atol=1e-12, max_step=0.01 * time)
    return path.y[3:, -1] * SPEED


def converged_sticking(along, across):
    """Velocity of the surfaces along y after an oblique elastic impact without slip, by Mindlin's spring: K_t = r dF/dx, of
    which a growing overlap keeps the force and a falling one the stretch. The line of centres stays where it is."""
    two = laws.pair("hertz")
    ratio, mass = 2 * (1 - laws.POISSON) / (2 - laws.POISSON), 2 / 7 * two.mu
    time = two.contact_time(along)
    length, force = along * time, two.mu * along / time

    def stiffness(x):
        return ratio * 1.5 * two.k * math.sqrt(max(x * length, 0.0)) * length / force

    def motion(spring):
        def rates(_, state):
            x, v, s, u = state
            pushed, at = two.k * (max(x, 0.0) * length)**1.5 / force, stiffness(x)
            carried = s if spring == "grows" else at * s
            return [v, -pushed, at * u if spring == "grows" else u, -carried * two.mu / mass]
        return rates

    def deepest(_, state):
        return state[1]

    def apart(_, state):
        return state[0]

    deepest.terminal = apart.terminal = True
    apart.direction = -1
    accuracy = {"method": "DOP853", "rtol": 1e-10, "atol": 1e-13, "max_step": 0.002}
    state = solve_ivp(motion("grows"), (0, 2), [0.0, 1.0, 0.0, across / along], events=deepest, **accuracy).y[:, -1]
    state[2] /= stiffness(state[0])
    return along * solve_ivp(motion("falls"), (0, 2), state, events=apart, **accuracy).y[3, -1]


class Motion:
    def test_columns_come_to_rest_with_the_overlap_of_the_law(self):
        # A load presses as deep as the law has it at any step. They start with half of that; 0.1 s are 20 times the time in
        # which the slowest swing falls to 1/e.
        for law, divisions in (("hertz", (10, 20)), ("dmt", (10,)), ("jkr", (10,))):
            loads = [(SPHERES - n) * MASS * GRAVITY for n in range(SPHERES)]
            designed = numpy.array([laws.overlap(law, load, plane=n == 0) for n, load in enumerate(loads)])
            for division in divisions:
                dt = laws.contact_time(law, SPEED) / division
                heights = laws.DIAMETER * (0.5 + numpy.arange(SPHERES)) - numpy.cumsum(0.5 * designed)
                end = numpy.array(self.column(law, dt, round(0.1 / dt), heights))
                found = -numpy.diff(end[:, 0], prepend=-0.5 * laws.DIAMETER) + laws.DIAMETER
                error, speed = numpy.abs(found / designed - 1).max(), numpy.abs(end[:, 1]).max()
                print(f"column, {law}, t_c/{division}: overlaps off by {error:.1e}, largest speed {speed:.1e} m/s",
                      file=sys.stderr)
                self.assertLess(error, 1e-6)
                self.assertLess(speed, 1e-6 * math.sqrt(GRAVITY * designed.min()))

    def test_a_row_of_three_is_struck(self):
        # Largest errors over the speed of the projectile, of a converged prototype with one force a step, at four places in
        # the step: 1.7e-3 and 2.3e-3 at t_c/20.
        for restitution, within in ((1.0, 1.7e-3), (0.9, 2.3e-3)):
            time, worst = laws.contact_time("hertz", SPEED), 0.0
            dt = time / 20
            for phase in range(4):
                ahead = SPEED * (0.5 * time + dt * phase / 4)
                starts, velocities = [-laws.DIAMETER - ahead, 0.0, laws.DIAMETER], [SPEED, 0.0, 0.0]
                found = self.row("hertz", restitution, dt, 200, starts, velocities)
                known = converged_row(restitution, starts, velocities, 200 * dt)
                worst = max(worst, numpy.abs(numpy.array(found) - known).max() / SPEED)
            print(f"row, e {restitution}, t_c/20: {worst:.1e} of the speed", file=sys.stderr)
            self.assertLess(worst, within)

    def test_an_oblique_impact_sticks(self):
        # The mean stiffness of a step makes the phase of the swing that reverses the surfaces wrong by (w_t dt)^2/24, with
        # w_t t_c at most 7; where contact begins the stiffness grows as the root of the time, which adds 1.4 dt^(3/2). The
        # impact is slow: the line of centres turns by 4e-4. Stiffnesses of the end of the step are off by 1.2 dt.
        along, across = 3e-4, 7.7e-4
        time, known = laws.contact_time("hertz", along), converged_sticking(along, across)
        turned = across * time / laws.DIAMETER
        self.assertLess(turned, 4e-4)
        for part in (20, 80):
            dt, worst = time / part, 0.0
            for phase in (0.13, 0.38, 0.63, 0.88):
                found = self.oblique(dt, int(1.5 * part) + 6, laws.DIAMETER + along * dt * (2 + phase), (-along, across, 0.0))
                worst = max(worst, abs(found - known) / math.hypot(along, across))
            print(f"oblique impact, t_c/{part}: {worst:.1e} of the speed", file=sys.stderr)
            self.assertLess(worst, 7**3 / 24 / part**2 + 1.4 / part**1.5 + 4 * turned)

    def test_the_energy_of_gases(self):
        # Dense gases, 20 collisions of each sphere. Numbers: hertzian_laws.MOST.
        for law, restitution, friction in (("hertz", 1.0, 0.0), ("dmt", 1.0, 0.0), ("jkr", 1.0, 0.0), ("hertz", 0.9, 0.3),
                                           ("jkr", 0.9, 0.0)):
            error, lost = self.gas(law, restitution, friction, 20, 20.0)
            kept = lost < 1e-2
            print(f"gas, {law}, e {restitution}, friction {friction}: error {error:.1e}, lost {lost:.3f}", file=sys.stderr)
            self.assertEqual(kept, law != "jkr" and (restitution, friction) == (1.0, 0.0))
            self.assertLess(abs(error) / (1 if kept else lost), laws.MOST["drift" if kept else "balance"][20])
