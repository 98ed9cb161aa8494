# SPDX-License-Identifier: BSD-3-Clause
"""JKR's contact with the dashpot of constant restitution, as the manual page of gran/jkr states it, integrated by scipy;
it knows nothing of the package and of no engine."""
import functools
import math

from scipy.integrate import solve_ivp
from scipy.optimize import brentq


class JkrPair:
    """Two equal spheres, or one and a plane of the same material: E [Pa], nu, surface energy gamma [J/m2], restitution,
    diameter [m], density [kg/m3]."""

    def __init__(self, modulus, surface_energy, restitution, diameter, poisson=0.25, density=2650.0, plane=False):
        self.modulus, self.poisson, self.restitution, self.gamma = modulus, poisson, restitution, surface_energy
        self.diameter, self.density, self.plane = diameter, density, plane
        mass = math.pi / 6 * density * diameter**3
        self.mu, self.radius = (mass, diameter / 2) if plane else (mass / 2, diameter / 4)
        self.distance = diameter / 2 if plane else diameter
        self.star = modulus / (2 * (1 - poisson**2))
        self.work = 2 * surface_energy
        self.pull_off = 1.5 * math.pi * self.work * self.radius
        self.smallest = (math.pi * self.work * self.radius**2 / (8 * self.star))**(1 / 3)
        self.tearing = -self.overlap(self.smallest)  # gap
        log = -math.log(restitution)
        self.c = math.sqrt(5 * self.mu * 4 * self.star / (3 * self.radius) * self.radius) * log / math.hypot(math.pi, log)

    def words(self, **more):
        """pair_coeff's keywords."""
        text = (f"normal hertz {self.modulus:.17g} {self.poisson:.17g} surface_energy {self.gamma:.17g} "
                f"restitution {self.restitution:.17g}")
        return text + "".join(f" {name} {value:.17g}" for name, value in more.items())

    def overlap(self, a):
        return a * a / self.radius - math.sqrt(2 * math.pi * self.work * a / self.star)

    def radius_of_contact(self, x):
        if x <= -self.tearing:
            return self.smallest
        high = 2 * self.smallest
        while self.overlap(high) < x:
            high *= 2
        return brentq(lambda a: self.overlap(a) - x, self.smallest, high, xtol=1e-13 * self.smallest, rtol=1e-14)

    def force(self, a):
        """Repels > 0 [N]."""
        return 4 * self.star * a**3 / (3 * self.radius) - math.sqrt(8 * math.pi * self.work * self.star) * a**1.5

    def contact_time(self, speed):
        """Of an elastic impact that touches with it [s], without adhesion."""
        return 2.943275 * (1.25 * self.mu / (4 / 3 * self.star * math.sqrt(self.radius)))**0.4 * speed**-0.2

    def parts(self, speed, angle=0.0):
        """Whether a pair that touches with `speed` along the normal parts after its first swing."""
        turning = 0.0 if self.plane else (self.distance * speed * math.tan(angle))**2 * self.mu
        time = self.contact_time(speed)

        # In the radius of contact a everything is smooth: a' = x'/(dx/da).
        def motion(_, state):
            a, v = max(state[0], 1.0) * self.smallest, state[1] * speed
            slope = 2 * a / self.radius - math.sqrt(math.pi * self.work / (2 * self.star * a))
            force = -self.force(a) - self.c * math.sqrt(a) * v - turning / (self.distance - self.overlap(a))**3
            return [v / max(slope, 1e-6 * a / self.radius) / self.smallest, force / self.mu / speed]

        def torn(_, state):
            return state[0] - 1.0001

        def turned_back(_, state):
            return state[1]

        torn.terminal, torn.direction = True, -1
        turned_back.terminal, turned_back.direction = True, 1
        start = self.radius_of_contact(0.0) / self.smallest
        path = solve_ivp(motion, (0, 20 * time), [start, 1.0], method="DOP853", rtol=1e-10, atol=1e-12,
                         max_step=0.02 * time, events=(torn, turned_back))
        return len(path.t_events[0]) > 0

    def sticking_speed(self, angle=0.0):
        """Along the normal [m/s]. Integrations; those of equal pairs are done once."""
        return _sticking_speed(self, angle)

    def _given(self):
        return (self.modulus, self.poisson, self.restitution, self.gamma, self.diameter, self.density, self.plane)

    def __eq__(self, other):
        return self._given() == other._given()

    def __hash__(self):
        return hash(self._given())


@functools.cache
def _sticking_speed(pair, angle):
    low, high = 0.0, 1e-4
    while not pair.parts(high, angle):
        low, high = high, 2 * high
    while high - low > 1e-5 * high:
        middle = 0.5 * (low + high)
        low, high = (low, middle) if pair.parts(middle, angle) else (middle, high)
    return high
