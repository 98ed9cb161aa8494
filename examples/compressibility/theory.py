# SPDX-License-Identifier: BSD-3-Clause
"""What is known of gases of smooth spheres of diameter and mass 1 at a granular temperature of 1, phi the fraction of
their volume, y = p/(n T) - 1.

    y_ES  = 4 phi chi                                      elastic hard spheres, chi their contact value:
    chi   = (1 - phi/2)/(1 - phi)^3                        Carnahan, Starling 1969
            (1 + 2.5 phi + 4.5904 phi^2 + 4.515456 phi^3)/(1 - (phi/0.64356)^3)^0.67802     Ma, Ahmadi 1986
    y     = (1 + e)/2 y_ES                                 restitution e
    omega = 24 phi chi/sqrt(pi)                            Enskog: collisions of a sphere per time
    Z     = 3/(1 - z) - 0.5921 (z - 0.7072)/(z - 0.601)    Speedy 1998: p/(n T) of the face-centred cubic crystal,
                                                           z = phi/0.74048
    mu    = 5/(16 sqrt(pi)) ((1 + 8/5 phi chi)^2/chi + 768/(25 pi) phi^2 chi)
                                                           Enskog's viscosity, first Sonine polynomial
    b     = 1 - 3 int (exp(-U(r)) - 1) r^2 dr - ...        second virial coefficient over that of hard spheres: y is
                                                           4 phi b for few spheres of energy U; of wells
                                                           1 - (w^3 - 1)(exp(D) - 1)

Written apart from src/kinetic_theory, which tests/examples/compressibility.py compares with the same numbers."""

import math

import numpy as np

CLOSE_PACKED = math.pi * math.sqrt(2) / 6
FREEZING, MELTING = 0.494, 0.545  # Hoover, Ree 1968
FLUID = 0.63  # highest fraction that is called one


def carnahan_starling(phi):
    return (1 - phi / 2) / (1 - phi)**3


def ma_ahmadi(phi):
    return (1 + 2.5 * phi + 4.5904 * phi**2 + 4.515456 * phi**3) / (1 - (phi / 0.64356)**3)**0.67802


def y_of(chi, phi, e=1.0):
    return (1 + e) / 2 * 4 * phi * chi(phi)


def frequency(phi):
    """Of a fluid; beyond what Ma and Ahmadi have, that of the crystal is as often."""
    chi = ma_ahmadi(phi) if phi < FLUID else crystal(phi) / (4 * phi)
    return 24 * phi * chi / math.sqrt(math.pi)


def crystal(phi):
    """y of the crystal."""
    z = phi / CLOSE_PACKED
    return 3 / (1 - z) - 0.5921 * (z - 0.7072) / (z - 0.601) - 1


def enskog(phi):
    chi = carnahan_starling(phi)
    kinetic = (1 + 1.6 * phi * chi)**2 / chi
    return 5 / (16 * math.sqrt(math.pi)) * (kinetic + 768 / (25 * math.pi) * phi**2 * chi)


def well(w, D):
    """b of square wells."""
    return 1 - (w**3 - 1) * math.expm1(D)


def soft_diameter(K):
    """Of hard spheres that repel as springs of the stiffness K do at the temperature 1 (Barker, Henderson 1967)."""
    return 1 - math.sqrt(math.pi / (2 * K))


def hamaker(K, A, Hc, Ho, tail):
    """b of springs with the Hamaker attraction of small gaps, constant below Hc and none from Ho on. Without `tail` the
    energy between Hc and Ho is gained at once at Hc, as scheme exact has it."""
    k = A / 24  # A/6 times the reduced radius
    force, depth = k / Hc**2, k * (1 / Hc - 1 / Ho)

    def part(U, low, high, logarithm=False):
        """Simpson's rule over gaps, or over their logarithm."""
        n = 4000
        s = np.linspace(math.log(low), math.log(high), n + 1) if logarithm else np.linspace(low, high, n + 1)
        H = np.exp(s) if logarithm else s
        f = np.expm1(-U(H)) * (1 + H)**2 * (H if logarithm else 1)
        weights = np.ones(n + 1)
        weights[1:-1:2], weights[2:-1:2] = 4, 2
        return float(weights @ f) * (s[1] - s[0]) / 3

    deepest = min(1.0, (force + math.sqrt(force**2 + 80 * K)) / K)  # beyond this nothing is left of exp(-U)
    inner = part(lambda H: -depth - force * (Hc - H) + K * H**2 / 2, -deepest, 0) - ((1 - deepest)**3) / 3
    gap = part(lambda H: -depth - force * (Hc - H), 0, Hc)
    outer = part(lambda H: -k * (1 / H - 1 / Ho), Hc, Ho, logarithm=True) if tail else 0.0
    return -3 * (inner + gap + outer)
