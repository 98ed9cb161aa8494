# SPDX-License-Identifier: BSD-3-Clause
"""Ergun's equation (Chem. Eng. Prog. 48 (1952) 89), for spheres."""

from math import sqrt


def coefficients(void_fraction, diameter, gas_density, viscosity):
    """a and b of the pressure gradient a U + b U^2 [Pa/m] at the superficial velocity U [m/s]: its viscous and its
    inertial part."""
    solid = 1 - void_fraction
    return (150 * solid**2 / void_fraction**3 * viscosity / diameter**2,
            1.75 * solid / void_fraction**3 * gas_density / diameter)


def minimum_fluidisation(void_fraction, diameter, density, gas_density, viscosity, gravity):
    """Superficial velocity [m/s] at which the gradient is the weight of the spheres in the gas; diameter [m], densities
    of spheres and gas [kg/m3], viscosity [Pa s]."""
    viscous, inertial = coefficients(void_fraction, diameter, gas_density, viscosity)
    weight = (1 - void_fraction) * (density - gas_density) * gravity
    return (sqrt(viscous**2 + 4 * inertial * weight) - viscous) / (2 * inertial)
