# SPDX-License-Identifier: BSD-3-Clause
"""Points of the stability campaign: what each law is given, corners and random ones, and the spheres that meet.

A point has two cases. Without walls: `first`, a small sphere that meets a large one; `second`, a small sphere
that strikes two large ones at rest that touch. With walls: `first`, a sphere that meets one; `second`, one that
flies into the edge of two.
"""
import math

import numpy

DENSITY, RADIUS = 2650.0, 5e-4
PERIODS = 6  # contact times that a run lasts, besides the flight through a well

# steps: contact times over the time step; of hard particles, steps of the whole run. weight: how many times denser
# the smaller sphere is. depth: speed that the well adds, over `speed`; width: of the well, over the flight within it
# in a contact time; of hard ones over the sum of radii.
BASE = dict(K=800.0, e=0.9, ratio=1.0, weight=1.0, speed=0.05, steps=10.0, mu=0.0, angle=30.0, overlap=0.0)
HAMAKER = dict(BASE, cut=4e-10, A=7.5e-19)
WELL = dict(BASE, depth=0.4, width=0.3)
# E, gamma: modulus and surface energy of Hertz's and JKR's contacts; their contact time is that of an elastic impact at the
# largest speed of the point.
HERTZ = {"E": 5e7, **{name: value for name, value in HAMAKER.items() if name != "K"}}
JKR = {"E": 5e7, **{name: value for name, value in BASE.items() if name != "K"}, "gamma": 0.01}
UNITS = dict(K="N/m", E="Pa", cut="m", A="J", gamma="J/m2", speed="m/s", angle="deg")
NAMES = dict(ratio="radius ratio", weight="density ratio", cut="H_cut", steps="t_c/dt", mu="friction",
             overlap="overlap/(r_i+r_j)")


def log(random, low, high):
    return float(10 ** random.uniform(math.log10(low), math.log10(high)))


def common(random):
    return dict(K=log(random, 10, 1e7), e=float(random.choice([0.0, 1.0, *random.uniform(0, 1, 8)])),
                ratio=log(random, 1, 100), weight=log(random, 1e-3, 1e3), speed=log(random, 1e-9, 100),
                steps=log(random, 2, 20), mu=float(random.choice([0, 0, 0.3, 1.0])),
                angle=float(random.choice([0, *random.uniform(0, 89, 4)])), overlap=0.0)


def hamaker_point(random):
    return dict(common(random), cut=log(random, 1e-10, 1e-7),
                A=float(random.choice([0.0, *[log(random, 1e-21, 1e-16) for _ in range(7)]])))


def hertz_point(random):
    return with_modulus(hamaker_point(random), log(random, 1e6, 1e11), log(random, 3, 40))


def jkr_point(random):
    point = with_modulus(common(random), log(random, 1e6, 1e11), log(random, 3, 40))
    return dict(point, gamma=log(random, 1e-5, 1))


def with_modulus(point, modulus, steps):
    return {**{name: value for name, value in point.items() if name != "K"}, "E": modulus, "steps": steps}


def well_point(random):
    return dict(common(random), depth=float(random.choice([0.0, *[log(random, 1e-3, 1e3) for _ in range(7)]])),
                width=float(random.choice([0.0, *[log(random, 1e-3, 10) for _ in range(7)]])))


def hard_point(random):
    point = well_point(random)
    return dict(point, speed=log(random, 1e-6, 100), steps=float(round(log(random, 1, 1000))),
                depth=float(random.choice([0.0, *[log(random, 1e-3, 10) for _ in range(7)]])),
                width=log(random, 1e-6, 0.5))


COMMON_CORNERS = (
    [dict(K=k) for k in (10.0, 1e7)] + [dict(e=e) for e in (0.0, 1e-3, 0.5, 1.0)] +
    [dict(ratio=r) for r in (10.0, 100.0)] + [dict(weight=w) for w in (1e-6, 1e6)] +
    [dict(ratio=100.0, weight=1e6)] + [dict(speed=s) for s in (0.0, 1e-9, 1e-6, 1e-3, 1.0, 10.0, 100.0)] +
    [dict(speed=100.0, K=1e7)] + [dict(steps=s) for s in (0.9, 1.9, 2.0, 3.0, 4.0, 20.0)] +
    [dict(steps=s, e=0.0) for s in (2.0, 4.0)] + [dict(steps=2.0, e=0.0, speed=1e-3)] +
    [dict(mu=m) for m in (0.3, 10.0)] + [dict(mu=0.3, angle=80.0), dict(mu=0.3, steps=4.0)] +
    [dict(angle=a) for a in (0.0, 60.0, 89.0, 89.99)] + [dict(angle=89.99, speed=1.0, e=1.0)])
HAMAKER_CORNERS = (
    COMMON_CORNERS + [dict(cut=c, A=a) for c in (1e-10, 1e-7) for a in (1e-21, 7.5e-19, 1e-16)] +
    [dict(A=a) for a in (0.0, 1e-21, 1e-17, 1e-16)] +
    [dict(overlap=o, speed=0.0, A=a) for o in (1e-6, 0.1) for a in (0.0, 7.5e-19)] +
    [dict(overlap=0.1, speed=0.0, K=10.0), dict(overlap=0.1, speed=0.0, K=1e7)] +
    [dict(speed=1e-9, A=0.0), dict(speed=1e-9, A=1e-16)])
STIFFNESS_TO_MODULUS = {10.0: 1e6, 1e7: 1e11}


def of_modulus(corners):
    """The corner points of a linear spring, of a modulus; without steps that stop a run of any contact."""
    return [{("E" if name == "K" else name): STIFFNESS_TO_MODULUS[value] if name == "K" else value
             for name, value in corner.items()} for corner in corners if corner.get("steps", 4.0) >= 4.0]


HERTZ_CORNERS = [dict(steps=2.0), dict(steps=6.0), *of_modulus(HAMAKER_CORNERS)]
JKR_CORNERS = ([dict(steps=2.0), dict(steps=6.0), *of_modulus(COMMON_CORNERS)]
               + [dict(gamma=g) for g in (1e-6, 1e-3, 0.05, 1.0)] + [dict(gamma=0.05, E=e) for e in (1e6, 1e11)]
               + [dict(overlap=o, speed=0.0) for o in (1e-6, 0.1)]
               + [dict(speed=1e-9, gamma=g) for g in (1e-6, 1.0)])
WELL_CORNERS = (
    COMMON_CORNERS + [dict(depth=d, width=w) for d in (0.0, 1e-3, 1e3) for w in (0.0, 1e-3, 10.0)] +
    [dict(overlap=o, speed=1e-9) for o in (1e-6, 0.1)] + [dict(width=w, angle=89.9) for w in (0.0, 1e-3, 10.0)])
HARD_CORNERS = (
    [dict(e=e) for e in (0.0, 1e-3, 0.5, 1.0)] + [dict(ratio=r) for r in (10.0, 100.0)] +
    [dict(weight=w) for w in (1e-6, 1e6)] + [dict(speed=s) for s in (0.0, 1e-9, 100.0)] +
    [dict(steps=s) for s in (1.0, 2.0, 1e4)] + [dict(mu=m) for m in (0.3, 10.0)] +
    [dict(angle=a) for a in (0.0, 60.0, 89.0, 89.99)] +
    [dict(depth=d, width=w) for d in (0.0, 1e-3, 1.0, 10.0) for w in (1e-9, 1e-3, 0.5)])


def text(law, values):
    """Values that the law knows."""
    names = {**NAMES, "steps": "steps"} if law.hard else NAMES
    return ", ".join(f"{names.get(k, k)} {v:.4g}{' ' + UNITS[k] if k in UNITS else ''}"
                     for k, v in values.items() if not (law.hard and k in ("K", "overlap")))


class Point:
    """Values of one point and what follows from them."""

    def __init__(self, law, values, random):
        self.law, self.values = law, {**law.base, **values}
        p = self.values
        self.radius = (RADIUS, RADIUS if law.wall else RADIUS / p["ratio"])
        self.density = (DENSITY, DENSITY * p["weight"])
        self.mass = [4 / 3 * math.pi * r**3 * d for r, d in zip(self.radius, self.density)]
        self.mu = self.mass[1] if law.wall else self.mass[0] * self.mass[1] / sum(self.mass)
        self.reach = self.radius[1] if law.wall else sum(self.radius)
        self.contact = math.pi / math.sqrt(p["K"] / self.mu) if "K" in p else math.nan
        self.start = random.uniform(0.2, 1.2)  # steps from the edge
        law.derive(self)

    def flight(self, gap):
        """Where the sphere is that meets another of radius sum `reach`, and its velocity."""
        p = self.values
        angle = math.radians(p["angle"])
        way = numpy.array([math.cos(angle), math.sin(angle), 0.0])
        touch = self.reach * (1 - p["overlap"]) * numpy.array([1.0, 0.0, 0.0])
        back = way if self.law.hard else numpy.array([1.0, 0.0, 0.0])
        return touch + (0.0 if p["overlap"] else gap) * back, -p["speed"] * way

    def spheres(self):
        """(kind, place, velocity) of all; kind 0 the large, 1 the small."""
        return self.before_walls() if self.law.wall else self.free()

    def cases(self):
        """Name, spheres and contacts (pairs of spheres, or sphere and axis of its wall) of what was set up."""
        if self.law.wall:
            first = {"first": ([0], [(0, 0)])}
            return first if self.values["overlap"] else {**first, "second": ([1], [(1, 0), (1, 1)])}
        cases = {"first": ([0, 1], [(0, 1)])}
        if self.three:
            cases["second"] = ([2, 3, 4], [(2, 3), (2, 4), (3, 4)])
        return cases

    @property
    def touching(self):
        """Contacts that occur, by types, as the styles name them."""
        if self.law.wall:
            return ("2 - wall",)
        return ("1 - 2", "1 - 1") if self.three else ("1 - 2",)

    @property
    def three(self):
        return not self.values["overlap"] and self.deep < 0.5 * RADIUS

    def free(self):
        none = numpy.zeros(3)
        place, velocity = self.flight(self.gap)
        found = [(0, none, none), (1, place, velocity)]
        if self.three:
            centre = numpy.array([0.0, 0.0, 40 * RADIUS])
            aside = numpy.array([0.0, 2 * RADIUS - self.deep, 0.0])
            found += [(0, centre, none), (0, centre - aside, none), (1, centre + place, velocity)]
        return found

    def before_walls(self):
        """Planes at x = 0 and y = 0; the first sphere flies by far from the second."""
        place, velocity = self.flight(self.gap)
        far = numpy.array([0.0, 40 * RADIUS + self.duration * self.values["speed"], 0.0])
        corner = numpy.array([place[0], self.radius[1] + 3 * self.gap, 60 * RADIUS])
        # Into the corner.
        return [(1, place + far, velocity), (1, corner, velocity - [0, 0.2 * self.values["speed"], 0])]

    def gap_of(self, places, contact):
        one, other = contact
        if self.law.wall:
            return places[one][other] - self.radius[1]
        kinds = [0, 1, 0, 0, 1]
        return (math.dist(places[one], places[other]) - self.radius[kinds[one]] - self.radius[kinds[other]])

    def rate_of(self, places, velocities, contact):
        """Of the gap."""
        one, other = contact
        if self.law.wall:
            return velocities[one][other]
        apart = places[one] - places[other]
        return (velocities[one] - velocities[other]) @ apart / math.sqrt(apart @ apart)

    def text(self):
        return text(self.law, self.values)
