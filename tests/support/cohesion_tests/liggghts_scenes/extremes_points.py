# SPDX-License-Identifier: BSD-3-Clause
"""Points of extremes.py: what each law is given, at corners and at random, what follows from it for two that meet, and
the closed form of their impact."""
import math

RADIUS, DENSITY, PERIODS = 5e-4, 2650.0, 6
BASE = dict(K=800.0, e=0.9, ratio=1.0, weight=1.0, speed=0.05, steps=20.0, overlap=0.0)
LAWS = {"hamaker": dict(BASE, cut=4e-10, A=7.5e-19), "square_well": dict(BASE, depth=0.5, width=0.3)}
# Contacts of a modulus, exact only, whose contact time is that of an elastic impact at the largest speed of the point.
HERTZIAN = {name: value for name, value in BASE.items() if name != "K"}
INTEGRATED = {"hamaker hertz": dict(HERTZIAN, E=5e7, cut=4e-10, A=7.5e-19), "jkr": dict(HERTZIAN, E=5e7, gamma=0.01)}
ALL = {**LAWS, **INTEGRATED}
UNITS = dict(K="N/m", E="Pa", cut="m", A="J", gamma="J/m2", speed="m/s")
NAMES = dict(ratio="radius ratio", weight="density ratio", cut="H_cut", steps="t_c/dt", overlap="overlap/(r_i+r_j)")
COMMON = ([dict(K=k) for k in (10.0, 1e7)] + [dict(e=e) for e in (0.0, 1e-3, 0.5, 1.0)]
          + [dict(ratio=r) for r in (10.0, 100.0)] + [dict(weight=w) for w in (1e-6, 1e6)]
          + [dict(speed=s) for s in (1e-9, 1e-6, 1e-3, 1.0, 10.0, 100.0)] + [dict(speed=100.0, K=1e7)]
          + [dict(steps=s) for s in (1.5, 2.0, 4.0, 10.0, 15.0, 100.0, 1000.0, 10000.0)]
          + [dict(steps=s, e=0.0) for s in (1.5, 2.0, 4.0, 15.0)])
CORNERS = {
    "hamaker": COMMON + [dict(cut=c, A=a) for c in (1e-10, 1e-7) for a in (1e-21, 7.5e-19, 1e-16)]
    + [dict(A=a) for a in (0.0, 1e-21, 1e-17, 1e-16)] + [dict(cut=1e-7, A=1e-16, speed=1e-3, steps=1000.0)]
    + [dict(overlap=0.1, speed=0.0, A=a) for a in (0.0, 7.5e-19)],
    "square_well": COMMON + [dict(depth=d, width=w) for d in (0.0, 1e-3, 1e3) for w in (1e-3, 10.0)]}
OF_MODULUS = (
    [dict(E=e) for e in (5e6, 1e11)] + [dict(e=e) for e in (0.06, 0.5, 1.0)] + [dict(speed=100.0, E=1e11)]
    + [dict(steps=s, e=0.06) for s in (4.0, 15.0)]
    + [corner for corner in COMMON if not {"K", "e"} & set(corner) and 2.0 <= corner.get("steps", 2.0) <= 1000.0])
CORNERS["hamaker hertz"] = OF_MODULUS + [corner for corner in CORNERS["hamaker"] if "A" in corner]
CORNERS["jkr"] = (OF_MODULUS + [dict(gamma=g) for g in (1e-6, 1e-3, 0.05, 1.0)]
                  + [dict(gamma=0.05, E=e) for e in (5e6, 1e11)] + [dict(overlap=0.1, speed=0.0)])


def hertzian_point(law, random):
    point = random_point("hamaker", random)
    log = lambda low, high: float(10 ** random.uniform(math.log10(low), math.log10(high)))
    point = {**{name: value for name, value in point.items() if name != "K"}, "E": log(5e6, 1e11), "steps": log(3, 100),
             "e": float(random.choice([1.0, *random.uniform(0.06, 1, 9)]))}
    if law == "hamaker hertz":
        return point
    return {**{name: value for name, value in point.items() if name not in ("cut", "A")}, "gamma": log(1e-5, 1)}


def random_point(law, random):
    if law in INTEGRATED:
        return hertzian_point(law, random)
    log = lambda low, high: float(10 ** random.uniform(math.log10(low), math.log10(high)))
    point = dict(K=log(10, 1e7), e=float(random.choice([0.0, 1.0, *random.uniform(0, 1, 8)])), ratio=log(1, 100),
                 weight=log(1e-3, 1e3), speed=log(1e-9, 100), steps=log(1, 1000), overlap=0.0)
    if law == "hamaker":
        return dict(point, cut=log(1e-10, 1e-7), A=float(random.choice([0.0, *[log(1e-21, 1e-16) for _ in range(7)]])))
    return dict(point, depth=log(1e-3, 1e3), width=log(1e-3, 10))


class Partners:
    """Two spheres, or a sphere and a wall, with their law: masses, energies, and what comes of an impact."""

    def __init__(self, law, values, radii, masses, start):
        p = self.values = values
        self.law = law
        self.reach = sum(radii)
        self.mu = 1 / sum(1 / m for m in masses)
        self.w0 = math.sqrt(p["K"] / self.mu)
        self.zeta = 1.0 if p["e"] == 0 else -math.log(p["e"]) / math.hypot(math.pi, math.log(p["e"]))
        self.gamman = 2 * self.zeta * self.w0
        self.dt = math.pi / self.w0 / p["steps"]
        if law == "hamaker":
            # A wall: one radius.
            self.reduced = radii[0] * radii[1] / self.reach if len(radii) == 2 else radii[0]
            self.out = 100 * p["cut"]
            self.force = p["A"] * self.reduced / (6 * p["cut"]**2)
            self.edge = p["cut"]
            self.seen = self.out
        else:
            added = p["depth"] * p["speed"]
            self.force, self.depth = 0.0, 0.5 * self.mu * added**2
            inside = math.hypot(p["speed"], added)
            self.edge = self.seen = min(p["width"] * inside / self.w0 * math.pi, 0.4 * self.reach)
        # From the edge, or from where the attraction brings them together in a contact time.
        near = p["speed"] * math.pi / self.w0 + self.force / self.mu * (math.pi / self.w0)**2 / 2
        begin = self.edge * (1 + 1e-9) if law == "square_well" else min(self.edge * (1 + 1e-9), near)
        self.gap = -p["overlap"] * self.reach if p["overlap"] else begin + start * self.dt * p["speed"]
        self.well = -self.energy(0.0)
        self.scale = max(p["speed"], math.sqrt(2 * self.well / self.mu), self.force / math.sqrt(self.mu * p["K"]),
                         self.w0 * p["overlap"] * self.reach, 1e-300)
        flight = math.pi / self.w0 if law == "hamaker" else 3 * self.edge / max(math.hypot(p["speed"], added), 1e-300)
        self.duration = PERIODS * math.pi / self.w0 + flight

    def energy(self, gap):
        if self.law == "square_well":
            return -self.depth if gap < self.edge else 0.0
        cut, p = self.values["cut"], self.values
        if gap >= self.out:
            return 0.0
        tail = p["A"] * self.reduced / 6 * (1 / max(gap, cut) - 1 / self.out)
        return -tail - self.force * max(cut - gap, 0.0)

    def left_over(self):
        """Energy of the motion far apart after the impact, below 0 when they stick; closed form."""
        from scipy.optimize import brentq
        u = math.sqrt(self.values["speed"]**2 + 2 * (self.energy(self.gap) + self.well) / self.mu)
        b = self.force / math.sqrt(self.mu * self.values["K"])
        zeta = self.zeta
        if self.values["e"] == 0:
            overlap = lambda t: b + math.exp(-t) * (-b + (u - b) * t)
            rate = lambda t: math.exp(-t) * (u - (u - b) * t)
            return -1.0 if b or u >= 0 else rate(overlap(0.0))
        q = math.sqrt(1 - zeta**2)
        if u == 0.0:
            return -1.0
        overlap = lambda t: b + math.exp(-zeta * t) * (-b * math.cos(q * t) + (u - zeta * b) / q * math.sin(q * t))
        rate = lambda t: math.exp(-zeta * t) * (u * math.cos(q * t) + (b - zeta * u) / q * math.sin(q * t))
        peak = brentq(rate, 1e-12, math.pi / q)
        end = peak + math.pi / q
        if overlap(end) > 0:
            return -1.0
        w = rate(brentq(overlap, peak, end, xtol=1e-15))
        return 0.5 * self.mu * w * w - self.well


class HertzianPartners:
    """As Partners, of a modulus; Poisson's ratio 0.3. Their impacts have no closed form."""

    def __init__(self, law, values, radii, masses, start):
        p = self.values = values
        self.law, self.reach, self.mu, self.gamman = law, sum(radii), 1 / sum(1 / m for m in masses), 0.0
        radius = radii[0] * radii[1] / self.reach if len(radii) == 2 else radii[0]
        star = p["E"] / (2 * (1 - 0.3**2))
        k = 4 / 3 * star * math.sqrt(radius)
        if law == "jkr":
            work = 2 * p["gamma"]
            self.deep = (4.5 * math.pi * work * radius**2 / star)**(2 / 3) / (3 * radius)
            self.edge = 0.75 * (math.pi**2 * work**2 * radius / star**2)**(1 / 3)
            pulled = 7.0922 * (work**5 * radius**4 / star**2)**(1 / 3)
            self.seen, begin = self.edge, 0.0
        else:
            force = p["A"] * radius / (6 * p["cut"]**2)
            self.deep, self.edge, self.seen = (force / k)**(2 / 3), p["cut"], 100 * p["cut"]
            pulled = force * (1.99 * p["cut"] + 0.6 * self.deep)
            begin = p["cut"] * (1 + 1e-9)
        self.scale = max(p["speed"], math.sqrt(2 * pulled / self.mu),
                         math.sqrt(0.8 * k * (p["overlap"] * self.reach)**2.5 / self.mu), 1e-300)
        contact = 2.943275 * (1.25 * self.mu / k)**0.4 * self.scale**-0.2
        self.dt, self.duration = contact / p["steps"], PERIODS * contact
        self.gap = -p["overlap"] * self.reach if p["overlap"] else begin + start * self.dt * p["speed"]


def partners(law, *given):
    return (HertzianPartners if law in INTEGRATED else Partners)(law, *given)


def name_of(values):
    return ", ".join(f"{NAMES.get(k, k)} {v:.4g}{' ' + UNITS[k] if k in UNITS else ''}" for k, v in values.items())
