# SPDX-License-Identifier: BSD-3-Clause
"""Two spheres of the thesis, or one and a wall, that meet head-on and have a liquid bridge from then on: closed
forms, beside those of the package."""
import functools
import math

from scipy.integrate import quad
from scipy.optimize import brentq

from cohesion_tests.theory.pair_motion import DAMPING, MU, STIFFNESS

FORCE, GAP = 1e-4, 5e-5  # F_b [N], h_r [m]


def parting_speed(speed, force, mass, damping):
    """Speed at which a contact under a constant pull ends that began at `speed`; 0: it never does.

    About its equilibrium, F/K, the overlap is a damped oscillation of known frequency: the end is the
    first return to 0, bracketed by its largest overlap and half a period later."""
    alpha = damping / (2 * mass)
    q = math.sqrt(STIFFNESS / mass - alpha**2)
    rest = force / STIFFNESS

    def overlap(t):
        return rest + math.exp(-alpha * t) * ((speed - alpha * rest) / q * math.sin(q * t)
                                              - rest * math.cos(q * t))

    def rate(t):
        w0_squared = STIFFNESS / mass
        return math.exp(-alpha * t) * (speed * math.cos(q * t) + (w0_squared * rest - alpha * speed) / q
                                       * math.sin(q * t))

    largest = math.atan2(speed * q, alpha * speed - STIFFNESS / mass * rest) / q
    if overlap(largest + math.pi / q) > 0:
        return 0.0
    return -rate(brentq(overlap, largest, largest + math.pi / q, xtol=1e-22, rtol=1e-15))


def escape_velocity(force=FORCE, gap=GAP, mass=MU, damping=DAMPING):
    """That leaves F h_r when the contact ends."""
    needed = math.sqrt(2 * force * gap / mass)
    return brentq(lambda u: parting_speed(u, force, mass, damping) - needed, needed, 30 * needed,
                  xtol=1e-17, rtol=1e-15)


class Capillary:
    """The bridge of a liquid between two spheres as Willett et al. print it, of half of the gap; radius2 infinite: a
    wall."""

    def __init__(self, tension, angle, volume, radius, radius2=None):
        self.radius = 2 / (1 / radius + 1 / (radius2 or radius))
        self.touch = 2 * math.pi * self.radius * tension * math.cos(angle)
        self.volume = volume
        self.rupture = (1 + angle / 2) * volume**(1 / 3)

    def force(self, gap):
        half = max(gap, 0.0) / 2 / math.sqrt(self.volume / self.radius)
        return self.touch / (1 + 2.1 * half + 10 * half**2)

    @functools.cache
    def work(self, gap):
        """From touch to a gap, up to the rupture [J]."""
        return quad(self.force, 0, min(gap, self.rupture), epsabs=0, epsrel=1e-12)[0]
