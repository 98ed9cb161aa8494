# SPDX-License-Identifier: BSD-3-Clause
"""The share of the drag that src/drag/filtered_drag.h leaves in coarse cells, written out a second time."""

import numpy as np
from scipy.optimize import brentq

from cohesion_tests.theory.closure_formulas import DOUBLE, drag_coefficient

# (from, to, origin of x, coefficients of the powers of x, the lowest first) over the solid fraction
A = [(0, 0.016, 0, (21.51,)), (0.016, 0.1, 0, (1.96, 29.40, 164.91, -1923)),
     (0.1, 0.18, 0.1, (4.63, 4.68, -412.04, 2254)), (0.18, 0.25, 0.18, (3.52, -17.99, 128.80, -603)),
     (0.25, 0.4, 0.25, (2.68, -8.20, 2.18, 112.33)), (0.4, 1, 0, (1.79,))]
H = [(0, 0.03, 0, (0, 7.97)), (0.03, 0.08, 0.03, (0.239, 4.640, -4.410, 253.63)),
     (0.08, 0.12, 0.08, (0.492, 6.100, 33.63, -789.6)), (0.12, 0.18, 0.12, (0.739, 5.010, -61.1, 310.8)),
     (0.18, 0.34, 0.18, (0.887, 1.03, -5.17, 5.99)), (0.34, 0.48, 0.34, (0.943, -0.17, -2.29, -9.12)),
     (0.48, 0.55, 0.48, (0.850, -1.35, -6.13, -132.6)), (0.55, 0.6, 0.55, (0.680, -2.34, -225.2)), (0.6, 1, 0, (0,))]


def value(pieces, solid):
    for low, high, origin, coefficients in pieces:
        if low <= solid < high:
            return np.polynomial.polynomial.polyval(solid - origin, coefficients)
    raise ValueError(solid)


def terminal_speed(d, density, rho, mu, g):
    """Of a sphere [m/s], with the drag of Schiller and Naumann."""
    def excess(v):
        return (drag_coefficient(DOUBLE, rho * v * d / mu) * rho / 2 * v**2 * np.pi / 4 * d**2
                - (density - rho) * g * np.pi / 6 * d**3)

    return brentq(excess, 1e-9, 1e3, xtol=1e-14, rtol=1e-14)


def share(solid, cell, d, density, rho, mu, g):
    """Of the closure's drag, in cells of the edge `cell` [m]."""
    v = terminal_speed(d, density, rho, mu, g)
    length = v**2 / g * (v**2 / (g * d)) ** (-2 / 3)
    return 1 - value(H, solid) / (value(A, solid) * length / cell + 1)
