# SPDX-License-Identifier: BSD-3-Clause
"""Contacts of Hertz, of DMT (Hertz with a Hamaker attraction) and of JKR, the same in both engines, and the linear spring
by its name: scenes with many spheres of 1 mm and 2650 kg/m3 have one of them."""
import math

from scipy.optimize import brentq

from cohesion_tests.theory.hertz_contact import CUT, OUT, HertzPair
from cohesion_tests.theory.jkr_contact import JkrPair

LAWS = ("linear", "hertz", "dmt", "jkr")
MODULUS, POISSON, DIAMETER = 5e7, 0.3, 1e-3
HAMAKER, SURFACE_ENERGY = 2e-18, 0.05  # [J], [J/m2]
# Of gases whose energy is measured.
DIVISIONS = (10, 20)
CONTACTS = tuple((e, mu) for e in (1.0, 0.9, 0.5) for mu in (0.0, 0.3))  # restitution, friction

# By steps per contact, of second order. Elastic without jumps: largest error over the kinetic energy; all others: over what
# is lost. At 10 they are the numbers of dense gases of linear springs.
MOST = {"drift": {10: 2e-5, 20: 5e-6}, "balance": {10: 4e-4, 20: 1e-4}}


def error_cell(division, residual, lost):
    """Of a table: the error as MOST has it, with a star where it is larger; both over the kinetic energy of the start."""
    part, limit = (residual / lost, MOST["balance"]) if lost > 1e-2 else (residual, MOST["drift"])
    return f"{part:.1e}{'*' if abs(part) > limit[division] else ' '}"


def gases(law, fraction=None):
    """Solid fraction, A [J], component speed [m/s]; at the lower one cohesion decides."""
    return [(phi, HAMAKER if law == "dmt" else 0.0, 0.1 if law == "hertz" else 0.02)
            for phi in (0.1, 0.5) if fraction in (None, phi)]


def pair(law, restitution=1.0, plane=False):
    """Two spheres, or one and a plane, of law hertz, dmt or jkr."""
    if law == "jkr":
        return JkrPair(MODULUS, SURFACE_ENERGY, restitution, DIAMETER, POISSON, plane=plane)
    return HertzPair(MODULUS, restitution, DIAMETER, HAMAKER if law == "dmt" else 0.0, POISSON, plane=plane)


def contact_time(law, speed):
    """Of an elastic impact of two that approach with `speed` far apart [s]."""
    two = pair(law)
    return two.contact_time(two.touching_speed(speed) if law == "dmt" else speed)


def overlap(law, load=0.0, plane=False):
    """Of a contact at rest that a load presses together [m, N]."""
    two = pair(law, plane=plane)
    if law == "jkr":
        wide = brentq(lambda a: two.force(a) - load, 1.01 * two.smallest, 1000 * two.smallest, xtol=1e-16, rtol=1e-13)
        return two.overlap(wide)
    return ((two.adhesion + load) / two.k)**(2 / 3)


def touching_gap(law):
    """Two that are nearer are in contact, or in each other's reach [m]."""
    return {"hertz": 0.0, "dmt": CUT, "jkr": pair("jkr").tearing}[law]


def lammps(law, restitution=1.0):
    """Style, and keywords of pair_coeff without the restitution."""
    words = pair(law).words().replace(" restitution 1", "")
    return f"gran/{'jkr' if law == 'jkr' else 'hamaker'}", words


def mean_impact(speed):
    """Mean speed along the normal of the impacts in a gas with the component speed `speed`."""
    return math.sqrt(math.pi) * speed
