# SPDX-License-Identifier: BSD-3-Clause
"""The drag on equal spheres in agglomerates of N with a radius of gyration R_g, as the page of the law has it: the gas
goes around the agglomerate as around one sphere among others like it, or through it."""

import numpy as np

from cohesion_tests.theory.closure_formulas import DOUBLE


def scaled_total(closure, eps, superficial, radius, rho, mu):
    """F_total over 3 pi mu d U."""
    d = 2 * radius
    return closure(DOUBLE, eps, superficial / eps, d, rho, mu) * d**2 / (18 * mu * eps**2)


def total(closure, eps, superficial, radius, rho, mu):
    """The force on a sphere among equal ones [N], that of the mean pressure included."""
    return (6 * np.pi * mu * radius * superficial
            * scaled_total(closure, eps, superficial, radius, rho, mu))


def hydrodynamic_radius(radius, number, gyration, c=0.238):
    """Of an agglomerate [m]."""
    ball = (radius**2 + 5 / 3 * gyration**2) ** 0.5
    return ball * (number * radius**3 / ball**3) ** (c * (ball / (number * radius)) ** 0.5)


def around(closure, eps, superficial, radius, number, gyration, rho, mu):
    """The force on an agglomerate [N] that the gas goes around; none where there is no way around it."""
    hydrodynamic = hydrodynamic_radius(radius, number, gyration)
    solid = (1 - eps) * hydrodynamic**3 / (number * radius**3)
    if solid >= 1:
        return np.inf
    return total(closure, 1 - solid, superficial, hydrodynamic, rho, mu)


def on_sphere(closure, eps, superficial, radius, number, gyration, rho, mu):
    """The force on a sphere that is one of `number` [N]."""
    own = total(closure, eps, superficial, radius, rho, mu)
    if number == 1:
        return own
    return min(own, around(closure, eps, superficial, radius, number, gyration, rho, mu) / number)


def gyration(places):
    """Of centres [m]."""
    return np.sqrt(np.var(places, axis=0).sum())
