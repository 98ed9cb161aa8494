# SPDX-License-Identifier: BSD-3-Clause
"""Kinetic theory of smooth inelastic discs in steady simple shear, mass and diameter 1, rate 1.

Enskog's equation with an anisotropic Gaussian for the velocities, the closure of Jenkins and Richman
(J. Fluid Mech. 192, 1988, 313; for small anisotropy: Phys. Fluids 28, 1985, 3485): the balance of the
second moments K = <V V> about the flow,

  K_ik du_j/dx_k + K_jk du_i/dx_k = gain by collisions,

with collisional integrals over all directions k of impact, without expansion in 1 - e or the rate. The
partner is a diameter away along k, where the flow is faster by k_y: the normal approach speed has mean
-k_x k_y and variance 2 k.K k.
"""
import math
from collections import namedtuple

import numpy
from scipy.optimize import fsolve
from scipy.special import ndtr

# Granular temperature, K n and impulsive stress as matrices (pressure positive), dissipation per area.
State = namedtuple("State", "temperature kinetic impulsive dissipation")


def density(fraction):
    return 4 * fraction / math.pi


def contact_value(fraction):
    """Of the pair distribution: Henderson, Mol. Phys. 30 (1975) 971."""
    return (1 - 7 * fraction / 16) / (1 - fraction)**2


def free_path(fraction):
    return 1 / (2 * math.sqrt(2) * density(fraction) * contact_value(fraction))


def waves(fraction, state, length):
    """Share by which waves of the flow raise the viscosity of a State in a box of this length: waves
    across their direction, k from that of the box 2 pi/L to that of the free path 1/l, have energy T/2
    each and decay by nu k^2; sheared they carry on average -rate T/(16 pi nu) ln(L/(2 pi l)) of momentum
    (fluctuating hydrodynamics, as in Ernst, Hauge, van Leeuwen, Phys. Rev. A 4 (1971) 2055)."""
    viscosity = state.dissipation
    nu = viscosity / density(fraction)
    return (state.temperature / (16 * math.pi * nu) *
            math.log(length / (2 * math.pi * free_path(fraction)))) / viscosity


def memory(fraction, state):
    """Strain in which the temperature of a State forgets: heat goes as T^(1/2), dissipation as T^(3/2), so that what is
    too much relaxes at the rate dissipation/(n T)."""
    return density(fraction) * state.temperature / state.dissipation


def sampling(fraction, restitution, state, count, strain):
    """Standard deviation of the mean temperature of `count` discs over a strain, per T. Heat is stress, whose noise
    is 2 viscosity T per area and time (Green and Kubo), viscosity being dissipation D. Collisions, independent, take
    (1 - e^2) g^2/4 each, g the normal speed, <g^4>/<g^2> = 8 T of colliding pairs: a noise of 2 (1 - e^2) T D. With the
    first alone T fluctuates by T/sqrt(count), as in the elastic gas. Waves of the flow, which add to it, are left
    out."""
    return math.sqrt(2 * memory(fraction, state) * (2 - restitution**2) / (count * strain))


def scatter_of_blocks(length, blocks):
    """Mean square scatter of that many means over adjoining blocks, over that of independent ones: of noise that
    forgets exponentially (Ornstein and Uhlenbeck); length: strain of a block over the memory."""
    forgotten = 1 - math.exp(-length)
    shared = sum(2 * (blocks - k) / (blocks * (blocks - 1)) * math.exp(-(k - 1) * length) for k in range(1, blocks))
    return 1 - forgotten / length - shared * forgotten**2 / (2 * length)


def nearly_elastic(fraction, restitution):
    """Granular temperature with the viscosity of elastic discs, first Sonine approximation (Gass,
    J. Chem. Phys. 54 (1971) 1898): rate^2 times viscosity = dissipation; exact in 1 - e to leading
    order but for the approximation, whose viscosity of a dilute gas is 2.2 % too low."""
    n, chi = density(fraction), contact_value(fraction)
    close = 2 * fraction * chi
    viscosity = ((1 + close / 2)**2 + 2 / math.pi * close**2) / (2 * math.sqrt(math.pi) * chi)
    return viscosity / ((1 - restitution**2) * n**2 * chi * math.sqrt(math.pi))


def half_moments(mean, variance):
    """Integrals of c^p over c > 0 of a normal distribution, p = 2 and 3."""
    deviation = numpy.sqrt(variance)
    zeroth = ndtr(mean / deviation)
    first = (deviation * numpy.exp(-mean**2 / (2 * variance)) / math.sqrt(2 * math.pi) +
             mean * zeroth)
    second = mean * first + variance * zeroth
    return second, mean * second + 2 * variance * first


def collisions(K, fraction, restitution, angles=200):
    """Per area and time: change of the sum of V V, impulsive stress, dissipation."""
    angle = 2 * math.pi * numpy.arange(angles) / angles
    k = numpy.array([numpy.cos(angle), numpy.sin(angle)]).T
    across = numpy.array([-k[:, 1], k[:, 0]]).T
    along = k[:, :, None] * k[:, None, :]
    mixed = across[:, :, None] * k[:, None, :]
    mixed += mixed.transpose(0, 2, 1)
    variance = 2 * numpy.einsum("ai,ij,aj->a", k, K, k)
    # Mean own velocity across k per own velocity along it.
    slope = 2 * numpy.einsum("ai,ij,aj->a", across, K, k) / variance
    mean = -k[:, 0] * k[:, 1]
    second, third = half_moments(mean, variance)
    own = third - mean * second
    weight = 0.5 * density(fraction)**2 * contact_value(fraction) * 2 * math.pi / angles
    half = (1 + restitution) / 2
    change = (2 * (half**2 * third - half * own))[:, None, None] * along
    change -= (half * own * slope)[:, None, None] * mixed
    return (weight * change.sum(axis=0), weight * half * (second[:, None, None] * along).sum(axis=0),
            weight * (1 - restitution**2) / 4 * third.sum())


def steady(fraction, restitution):
    n = density(fraction)

    def matrix(q):
        return numpy.array([[q[0], q[2]], [q[2], q[1]]])

    def unbalanced(q):
        K = matrix(q)
        rest = collisions(K, fraction, restitution)[0] / n
        rest -= numpy.array([[2 * K[0, 1], K[1, 1]], [K[1, 1], 0]])
        return rest[0, 0], rest[1, 1], rest[0, 1]

    guess = nearly_elastic(fraction, restitution)
    K = matrix(fsolve(unbalanced, [guess, guess, -0.3 * guess], xtol=1e-12))
    _, impulsive, dissipation = collisions(K, fraction, restitution)
    return State(numpy.trace(K) / 2, n * K, impulsive, dissipation)
