# SPDX-License-Identifier: BSD-3-Clause
"""What gas does to spheres of several sizes that fill a place evenly, as van der Hoef, Beetstra and Kuipers print it:
the whole force on each, drag and pressure, over that on spheres of one size."""

import numpy as np

from cohesion_tests.theory.closure_formulas import DOUBLE

CUBIC = {"carmanKozeny": 0.0, "vanDerHoef": 0.064}


def forces(law, closure, eps, velocity, sizes, rho, mu):
    """The force on a sphere of each size [N] in a superficial `velocity` [m/s]; sizes: (number per volume, diameter
    [m])."""
    number, d = np.array(sizes, float).T
    mean = (number * d**3).sum() / (number * d**2).sum()
    slip = velocity / eps
    # Steady flow of model A: n F_drag = beta slip; F_total is F_drag over eps.
    of_equal = closure(DOUBLE, eps, slip, mean, rho, mu) * np.pi / 6 * mean**3 * slip / eps
    scaled = of_equal / (3 * np.pi * mu * mean * velocity)
    y = d / mean
    factor = eps * y + (1 - eps) * y**2 + CUBIC[law] * eps * y**3
    return 3 * np.pi * mu * d * velocity * factor * scaled
