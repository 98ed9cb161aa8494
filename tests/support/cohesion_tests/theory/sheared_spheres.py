# SPDX-License-Identifier: BSD-3-Clause
"""Kinetic theory of smooth inelastic spheres in steady simple shear, mass and diameter 1, rate 1: what
sheared_discs.py says of discs, in three dimensions.

Enskog's equation with an anisotropic Gaussian for the velocities (Chou and Richman, Physica A 259, 1998, 430;
dilute: Richman, J. Rheol. 33, 1989, 1293; for small anisotropy: Jenkins and Richman, Phys. Fluids 28, 1985, 3485):
the balance of the second moments, collisional integrals over all directions of impact, without expansion in 1 - e
or the rate.
"""
import math

import numpy
from scipy.optimize import fsolve

from cohesion_tests.theory.sheared_discs import State, half_moments


def density(fraction):
    return 6 * fraction / math.pi


def contact_value(fraction):
    """Of the pair distribution: Carnahan and Starling, J. Chem. Phys. 51 (1969) 635."""
    return (1 - fraction / 2) / (1 - fraction)**3


def nearly_elastic(fraction, restitution):
    """Granular temperature with Enskog's viscosity of elastic spheres, first Sonine approximation (Chapman and
    Cowling, 1970, ch. 16): rate^2 times viscosity = dissipation; exact in 1 - e to leading order but for the
    approximation, whose viscosity of a dilute gas is 1.6 % too low."""
    n, chi = density(fraction), contact_value(fraction)
    close = 4 * fraction * chi
    viscosity = 5 / (16 * math.sqrt(math.pi) * chi) * ((1 + 0.4 * close)**2 + 48 / (25 * math.pi) * close**2)
    return viscosity / ((1 - restitution**2) * 2 * math.sqrt(math.pi) * n**2 * chi)


def directions(polar=24, around=48):
    """Unit vectors and weights whose sum is the whole sphere: Gauss-Legendre along z, equal steps around it."""
    z, weight = numpy.polynomial.legendre.leggauss(polar)
    angle = 2 * math.pi * (numpy.arange(around) + 0.5) / around
    flat = numpy.sqrt(1 - z**2)
    k = numpy.stack([numpy.outer(flat, numpy.cos(angle)), numpy.outer(flat, numpy.sin(angle)),
                     numpy.outer(z, numpy.ones(around))], axis=-1).reshape(-1, 3)
    return k, numpy.repeat(weight, around) * 2 * math.pi / around


def collisions(K, fraction, restitution):
    """Per volume and time: change of the sum of V V, impulsive stress, dissipation."""
    k, weight = directions()
    along = k[:, :, None] * k[:, None, :]
    variance = 2 * numpy.einsum("ai,ij,aj->a", k, K, k)
    # Mean own velocity across k per own velocity along it.
    slope = 2 * (k @ K) / variance[:, None] - k
    mixed = slope[:, :, None] * k[:, None, :]
    mixed += mixed.transpose(0, 2, 1)
    mean = -k[:, 0] * k[:, 1]
    second, third = half_moments(mean, variance)
    own = third - mean * second
    weight = weight * 0.5 * density(fraction)**2 * contact_value(fraction)
    half = (1 + restitution) / 2
    change = numpy.einsum("a,aij->ij", weight * 2 * (half**2 * third - half * own), along)
    change -= numpy.einsum("a,aij->ij", weight * half * own, mixed)
    return (change, numpy.einsum("a,aij->ij", weight * half * second, along),
            (1 - restitution**2) / 4 * (weight @ third))


def steady(fraction, restitution):
    n = density(fraction)

    def matrix(q):
        return numpy.array([[q[0], q[3], 0], [q[3], q[1], 0], [0, 0, q[2]]])

    def unbalanced(q):
        K = matrix(q)
        rest = collisions(K, fraction, restitution)[0] / n
        rest -= numpy.array([[2 * K[0, 1], K[1, 1], 0], [K[1, 1], 0, 0], [0, 0, 0]])
        return rest[0, 0], rest[1, 1], rest[2, 2], rest[0, 1]

    guess = nearly_elastic(fraction, restitution)
    K = matrix(fsolve(unbalanced, [guess, guess, guess, -0.3 * guess], xtol=1e-12))
    _, impulsive, dissipation = collisions(K, fraction, restitution)
    return State(numpy.trace(K) / 3, n * K, impulsive, dissipation)
