# SPDX-License-Identifier: BSD-3-Clause
"""A load that grows slowly on an adhesive contact at rest, from 0 to 1.03 F_ad: when it parts it has F_ad, and what it
grows by while the contact opens.

Grains of 1500 kg/m3 with A = 1e-19 J, H_cut 0.4 nm and H_out 0.1 um. `division` is the number of steps in a contact time.
"""
import math

from scipy.optimize import brentq

from cohesion_tests.theory.jkr_contact import JkrPair

A, CUT, OUT, DENSITY = 1e-19, 4e-10, 1e-7, 1500.0
TOP = 1.03
DIVISIONS = (4, 10, 20, 50, 200)


def rate_of_lag(lag, force, mass):
    """[1/s], of the load over F_ad. Beyond F_ad a mass is pulled by what the load is more, k t, through H_cut and as far
    again, where the tail is left behind; that takes (6 H_cut mu/(k F_ad))^(1/3), by which the load has grown by
    (6 H_cut mu k^2/F_ad)^(1/3)."""
    return math.sqrt(lag**3 * force / (6 * CUT * mass))


class Grain:
    """stiffness [N/m], restitution of the contact with any partner; diameter [m]; partner: "pair" is another grain, all
    else a wall. lag: of the load, over F_ad."""

    def __init__(self, stiffness, restitution, diameter=75e-6, partner="plane", lag=1.5e-3):
        self.stiffness, self.restitution = stiffness, restitution
        self.set_grain(diameter, partner)
        log = math.log(restitution)
        self.damping = -2 * log * math.sqrt(self.reduced_mass * stiffness / (math.pi**2 + log**2))
        alpha = self.damping / (2 * self.reduced_mass)
        self.contact_time = math.pi / math.sqrt(stiffness / self.reduced_mass - alpha**2)
        self.overlap_at_rest = self.force / stiffness
        self.words = f"stiffness {stiffness!r} restitution {restitution!r}"
        self.set_duration(lag)

    def set_grain(self, diameter, partner):
        self.diameter, self.partner = diameter, partner
        self.mass = DENSITY * math.pi / 6 * diameter**3
        self.reduced_mass = self.mass / 2 if partner == "pair" else self.mass
        self.radius = diameter / 4 if partner == "pair" else diameter / 2
        self.force = A * self.radius / (6 * CUT**2)
        self.opens_by = CUT  # beyond touch, to where it has parted
        self.style, self.adhesion = "gran/hamaker", f"hamaker {A!r} cutoff {CUT!r} {OUT!r}"

    def set_duration(self, lag):
        # Slow beside the contact, too: what it begins to swing by has gone.
        self.duration = TOP / min(rate_of_lag(lag, self.force, self.reduced_mass), 1 / (150 * self.contact_time))

    def steps(self, division):
        """Of the ramp."""
        return round(self.duration / self.contact_time * division)


class HertzGrain(Grain):
    """The same with Hertz's contact: E [Pa], nu 0.25. Its contact time is half a period of small swings about rest."""

    def __init__(self, modulus, restitution, diameter=75e-6, partner="plane", lag=1.5e-3):
        self.restitution = restitution
        self.set_grain(diameter, partner)
        k = 4 / 3 * modulus / (2 * (1 - 0.25**2)) * math.sqrt(self.radius)
        self.overlap_at_rest = (self.force / k)**(2 / 3)
        self.contact_time = math.pi * math.sqrt(self.reduced_mass / (1.5 * k * math.sqrt(self.overlap_at_rest)))
        self.words = f"normal hertz {modulus!r} 0.25 restitution {restitution!r}"
        self.set_duration(lag)


class JkrGrain(Grain):
    """With JKR's contact: E [Pa], nu 0.25, surface energy gamma [J/m2]. force: the pull-off force; opens_by: the gap at which
    it tears."""

    def __init__(self, modulus, surface_energy, restitution, diameter=75e-6, partner="plane", lag=1.5e-3):
        self.restitution = restitution
        self.set_grain(diameter, partner)
        pair = JkrPair(modulus, surface_energy, restitution, diameter, density=DENSITY, plane=partner != "pair")
        self.force, self.radius = pair.pull_off, pair.radius
        at_rest = brentq(pair.force, 1.01 * pair.smallest, 100 * pair.smallest)
        self.overlap_at_rest = pair.overlap(at_rest)
        self.opens_by = pair.tearing
        self.contact_time = pair.contact_time(pair.sticking_speed())
        self.style, self.adhesion = "gran/jkr", ""
        self.words = pair.words()
        # The load grows by less than the lag while the contact opens by as much as it is pressed in, and slowly beside it.
        rate = math.sqrt(lag**3 * self.force / (6 * (self.overlap_at_rest + self.opens_by) * self.reduced_mass))
        self.duration = TOP / min(rate, 1 / (150 * self.contact_time))
