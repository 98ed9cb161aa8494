# SPDX-License-Identifier: BSD-3-Clause
"""The contact of Hertz with a dashpot of constant restitution and a Hamaker attraction, as the manual page of gran/hamaker
states it, integrated by scipy; it knows nothing of the package and of no engine."""
import functools
import math

import numpy
from scipy.integrate import solve_ivp
from scipy.optimize import brentq


CUT, OUT = 4e-10, 1e-7  # [m]


class HertzPair:
    """Two equal spheres, or one and a plane of the same material: E [Pa], nu, restitution, diameter [m], density [kg/m3],
    A [J]."""

    def __init__(self, modulus, restitution, diameter, hamaker=0.0, poisson=0.25, density=2650.0, plane=False):
        self.modulus, self.poisson, self.restitution, self.hamaker = modulus, poisson, restitution, hamaker
        self.diameter, self.density, self.plane = diameter, density, plane
        mass = math.pi / 6 * density * diameter**3
        self.mu, self.radius = (mass, diameter / 2) if plane else (mass / 2, diameter / 4)
        self.distance = diameter / 2 if plane else diameter
        self.k = 4 / 3 * modulus / (2 * (1 - poisson**2)) * math.sqrt(self.radius)
        log = -math.log(restitution)
        self.c = math.sqrt(5 * self.mu * self.k) * log / math.hypot(math.pi, log)
        self.adhesion = hamaker * self.radius / (6 * CUT**2)

    def words(self, **more):
        """pair_coeff's keywords."""
        text = f"normal hertz {self.modulus:.17g} {self.poisson:.17g} restitution {self.restitution:.17g}"
        if self.hamaker:
            text += f" hamaker {self.hamaker:.17g} cutoff {CUT} {OUT}"
        return text + "".join(f" {name} {value:.17g}" for name, value in more.items())

    def energy(self, gap):
        """Of the attraction [J], far away 0."""
        if gap >= OUT:
            return 0.0
        f = self.adhesion
        if gap < CUT:
            return -f * CUT**2 * (1 / CUT - 1 / OUT) - f * (CUT - gap)
        return -f * CUT**2 * (1 / gap - 1 / OUT)

    def contact_time(self, speed):
        """Of an elastic impact that touches with it [s], without the attraction."""
        return 2.943275 * (1.25 * self.mu / self.k)**0.4 * speed**-0.2

    def touching_speed(self, speed):
        return math.sqrt(speed**2 - 2 * self.energy(0.0) / self.mu)

    def energy_left(self, speed, angle, start):
        """As oblique_escape.energy_left."""
        momentum = 0.0 if self.plane else (self.distance + start) * speed * math.tan(angle)

        def wall(gap):
            turning = 0.0 if self.plane else 0.5 * self.mu * (momentum / (self.distance + gap))**2
            return self.energy(gap) + turning

        way = [wall(gap) for gap in (0.0, *numpy.geomspace(1e-6 * start, start, 400))]
        total = 0.5 * self.mu * speed**2 + way[-1]
        entry = math.sqrt(2 * (total - way[0]) / self.mu)
        time = self.contact_time(entry)
        length = entry * time

        # The fourth root of the overlap in the dashpot is not smooth where contact begins: small steps there.
        def motion(_, state):
            x, v = max(state[0], 0.0) * length, state[1] * entry
            turning = 0.0 if self.plane else self.mu * momentum**2 / (self.distance - x)**3
            force = self.adhesion - self.k * x**1.5 - self.c * x**0.25 * v - turning
            return [v / length, force / self.mu / entry]

        def parted(_, state):
            return state[0]

        def turned_back(_, state):
            return state[1]

        parted.terminal, parted.direction = True, -1
        turned_back.terminal, turned_back.direction = True, 1
        path = solve_ivp(motion, (0, 6 * time), [1e-15, 1.0], method="DOP853", rtol=1e-10, atol=1e-13, max_step=0.02 * time,
                         events=(parted, turned_back))
        if not len(path.t_events[0]):
            return way[0] - max(way)
        return 0.5 * self.mu * (path.y_events[0][0][1] * entry)**2 + way[0] - max(way)

    def escape_velocity(self, angle=0.0, start=1.001 * OUT):
        """Along the normal [m/s], where the gap is `start`. Integrations; those of equal pairs are done once."""
        return _escape_velocity(self, angle, start)

    def _given(self):
        return (self.modulus, self.poisson, self.restitution, self.hamaker, self.diameter, self.density, self.plane)

    def __eq__(self, other):
        return self._given() == other._given()

    def __hash__(self):
        return hash(self._given())


@functools.cache
def _escape_velocity(pair, angle, start):
    return brentq(pair.energy_left, 1e-6, 10.0, args=(angle, start), xtol=1e-13, rtol=1e-8)
