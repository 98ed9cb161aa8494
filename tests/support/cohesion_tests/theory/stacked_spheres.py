# SPDX-License-Identifier: BSD-3-Clause
"""Contacts of linear springs and dashpots that last, in closed form: two equal spheres on each other between two plates
that press them, under gravity, and one sphere that a load presses on a plate. SI units."""
import math

import numpy as np
from scipy.linalg import expm

K, DIAMETER, DENSITY, GRAVITY = 800.0, 1e-3, 2650.0, 9.81
RADIUS = DIAMETER / 2
MASS = DENSITY * math.pi / 6 * DIAMETER**3
HEIGHT = 3.96 * RADIUS  # between the plates
START = (0.99 * RADIUS, 2.985 * RADIUS)  # heights of the centres, at rest


def damping_ratio(e):
    return 0.0 if e == 1 else -math.log(e) / math.hypot(math.pi, math.log(e))


def dashpot(e, mass):
    """Of the restitution e at this reduced mass, [kg/s]."""
    return 2 * damping_ratio(e) * math.sqrt(K * mass)


def contact_time(mass):
    return math.pi * math.sqrt(mass / K)


def stacked(e, times):
    """Heights of both centres, one row a time: m z'' is linear, with the constant as a fifth unknown."""
    wall, pair = dashpot(e, MASS), dashpot(e, MASS / 2)
    a = np.zeros((5, 5))
    a[0, 2] = a[1, 3] = 1
    a[2] = [-2 * K, K, -(wall + pair), pair, -K * RADIUS - MASS * GRAVITY]
    a[3] = [K, -2 * K, pair, -(wall + pair), K * (HEIGHT + RADIUS) - MASS * GRAVITY]
    a[2:4] /= MASS
    return np.array([(expm(a * t) @ np.array([*START, 0, 0, 1]))[:2] for t in times])


def amplitude():
    """The largest distance of a centre from its place at rest, [m]."""
    rest = np.linalg.solve([[2 * K, -K], [-K, 2 * K]],
                           [-K * RADIUS - MASS * GRAVITY, K * (HEIGHT + RADIUS) - MASS * GRAVITY])
    return np.abs(np.array(START) - rest).max()


def discrete_stiffness(e, mass, dt):
    """K' of the force with which the grid follows the damped oscillation exactly (docs of both engines), [N/m]."""
    w, z = math.sqrt(K / mass), damping_ratio(e)
    d = math.exp(-2 * z * w * dt)
    return mass / dt**2 * (1 - 2 * math.sqrt(d) * math.cos(w * math.sqrt(1 - z * z) * dt) + d)
