# SPDX-License-Identifier: BSD-3-Clause
"""Laws and schemes of the stability campaign: their scripts, their scales, and head-on impacts in closed form."""
import math

from cohesion_tests.lammps_scenes import stability_points as points


class Soft:
    """Spring and dashpot with an attraction."""

    hard, normal = False, ""

    def __init__(self, scheme, wall=False):
        self.scheme, self.wall = scheme, wall
        self.name = f"{'fix wall/' if wall else ''}{self.style}{self.normal}, {scheme}"

    def lines(self, point, scheme):
        contact = self.contact(point)
        pair = [f"pair_style {self.style} scheme {scheme}", f"pair_coeff * * {contact}"]
        if not self.wall:
            return pair
        # gran/hamaker's walls know one scheme.
        scheme = f" scheme {scheme}" if self.style == "gran/squarewell" else ""
        return [*pair, f"fix walls all wall/{self.style} {contact} xplane 0 NULL yplane 0 NULL{scheme}"]

    def base_contact(self, point):
        p = point.values
        return f"stiffness {p['K']:.17g} restitution {p['e']:.17g} friction {p['mu']:.17g}"

    # Each: outcome_gap(point): nearer than this is together. On the grid a pair may be a step's flight beyond the
    # edge, when it has just left or was turned round there.

    def place_room(self, point):
        """How far the place on the grid may be from that of the motion while together, over s/w: it is the mean
        of those half a step before and after."""
        return (math.pi / point.values["steps"])**2 / 8

    def derive_steps(self, point, inside):
        """Step, duration; `inside`: of the well, the flight within it."""
        p = point.values
        point.dt = point.contact / p["steps"]
        point.duration = points.PERIODS * point.contact + 3 * inside
        # The edge and, before it, up to a step of flight.
        point.ahead = point.start * point.dt * p["speed"] * math.cos(math.radians(p["angle"]))
        point.w0 = math.pi / point.contact


class Hamaker(Soft):
    style, base, corners = "gran/hamaker", points.HAMAKER, points.HAMAKER_CORNERS
    random = staticmethod(points.hamaker_point)

    def contact(self, point):
        p = point.values
        return f"{self.base_contact(point)} hamaker {p['A']:.17g} cutoff {p['cut']:.17g} {100 * p['cut']:.17g}"

    def derive(self, point):
        p = point.values
        reduced = points.RADIUS if self.wall else points.RADIUS / (1 + p["ratio"])
        self.derive_steps(point, 0.0)
        point.force = p["A"] * reduced / (6 * p["cut"]**2)
        point.well = p["A"] * reduced / 6 * (1 - 0.01) / p["cut"] + point.force * p["cut"]
        point.gap = p["cut"] + point.ahead
        point.deep = p["A"] * points.RADIUS / 2 / (6 * p["cut"]**2) / p["K"]
        point.scale = max(p["speed"], math.sqrt(2 * point.well / point.mu),
                          point.force / math.sqrt(point.mu * p["K"]), point.w0 * p["overlap"] * point.reach, 1e-300)

    def outcome_gap(self, point):
        return point.values["cut"] + point.scale * point.dt

    def head_on(self, point):
        """Kinetic energy left of that at first touch once parted, below 0 when captured; speed at touch [m/s]."""
        from scipy.optimize import brentq
        p = point.values
        u = math.sqrt(p["speed"]**2 + 2 * point.well / point.mu)
        zeta = 1.0 if p["e"] == 0 else -math.log(p["e"]) / math.hypot(math.pi, math.log(p["e"]))
        b = point.force / math.sqrt(point.mu * p["K"])
        if zeta >= 1.0:
            overlap = lambda t: b + math.exp(-t) * (-b + (u - b) * t)
            rate = lambda t: math.exp(-t) * (u - (u - b) * t)
            q = 1e-2
        else:
            q = math.sqrt(1 - zeta**2)
            overlap = lambda t: b + math.exp(-zeta * t) * (
                -b * math.cos(q * t) + (u - zeta * b) / q * math.sin(q * t))
            rate = lambda t: math.exp(-zeta * t) * (
                u * math.cos(q * t) + (b - zeta * u) / q * math.sin(q * t))
        peak = brentq(rate, 1e-9, math.pi / q) if rate(math.pi / q) < 0 else math.inf
        end = peak + math.pi / q
        if not math.isfinite(end) or overlap(end) > 0:
            return -1.0, u
        w = rate(brentq(overlap, peak, end, xtol=1e-15))
        return (w * w - 2 * point.well / point.mu) / u**2, u


class Integrated:
    """Contacts without a closed form, of a modulus; Poisson's ratio 0.3. Their contact time is that of an elastic impact at
    the largest speed."""

    def base_contact(self, point):
        p = point.values
        return f"normal hertz {p['E']:.17g} 0.3 restitution {p['e']:.17g} friction {p['mu']:.17g}"

    def reduced_radius(self, point):
        return points.RADIUS if self.wall else points.RADIUS / (1 + point.values["ratio"])

    def star(self, point):
        """E*."""
        return point.values["E"] / (2 * (1 - 0.3**2))

    def stiffness(self, point, radius):
        """k of F = k x^1.5."""
        return 4 / 3 * self.star(point) * math.sqrt(radius)

    def derive_contact(self, point, other_speed):
        """Scale and contact time; other_speed: that the attraction adds."""
        p, k = point.values, self.stiffness(point, self.reduced_radius(point))
        deep = p["overlap"] * point.reach
        point.scale = max(p["speed"], other_speed, math.sqrt(0.8 * k * deep**2.5 / point.mu), 1e-300)
        point.contact = 2.943275 * (1.25 * point.mu / k)**0.4 * point.scale**-0.2
        self.derive_steps(point, 0.0)


class Hertz(Integrated, Hamaker):
    base, corners, normal = points.HERTZ, points.HERTZ_CORNERS, " normal hertz"
    random = staticmethod(points.hertz_point)
    head_on = None

    def derive(self, point):
        p, reduced = point.values, self.reduced_radius(point)
        point.force = p["A"] * reduced / (6 * p["cut"]**2)
        point.well = p["A"] * reduced / 6 * (1 - 0.01) / p["cut"] + point.force * p["cut"]
        pull = p["A"] * points.RADIUS / 2 / (6 * p["cut"]**2)
        point.deep = (pull / self.stiffness(point, points.RADIUS / 2))**(2 / 3)
        # On the way to contact, and in it up to where the attraction is that of the spring.
        rest = (point.force / self.stiffness(point, reduced))**(2 / 3)
        self.derive_contact(point, math.sqrt(2 * (point.well + 0.6 * point.force * rest) / point.mu))
        point.gap = p["cut"] + point.ahead


class Jkr(Integrated, Soft):
    style, base, corners = "gran/jkr", points.JKR, points.JKR_CORNERS
    random = staticmethod(points.jkr_point)
    head_on = None

    def contact(self, point):
        return f"{self.base_contact(point)} surface_energy {point.values['gamma']:.17g}"

    def lines(self, point, scheme):
        return super().lines(point, "exact")

    def neck(self, point, radius):
        """Radius of contact and overlap at rest without a load, and the gap at which the neck tears."""
        work, star = 2 * point.values["gamma"], self.star(point)
        wide = (4.5 * math.pi * work * radius**2 / star)**(1 / 3)
        return wide, wide**2 / (3 * radius), 0.75 * (math.pi**2 * work**2 * radius / star**2)**(1 / 3)

    def derive(self, point):
        work, reduced = 2 * point.values["gamma"], self.reduced_radius(point)
        point.tearing = self.neck(point, reduced)[2]
        point.deep = self.neck(point, points.RADIUS / 2)[1]
        lost = 7.0922 * (work**5 * reduced**4 / self.star(point)**2)**(1 / 3)
        self.derive_contact(point, math.sqrt(2 * lost / point.mu))
        point.force = point.well = 0.0
        point.gap = point.ahead

    def outcome_gap(self, point):
        return point.tearing + point.scale * point.dt


class Well:
    """What soft and hard wells have in common."""

    random = staticmethod(points.well_point)

    def words(self, point):
        if point.well == 0:
            return ""
        # Of a wall the edge is (ratio - 1) r from the surface, of a pair (ratio - 1) (r_i + r_j).
        return f" well {point.well:.17g} {1 + point.wide / point.reach:.17g}"

    def derive_depth(self, point):
        """Depth [J] and speed within the well [m/s]."""
        p = point.values
        added = p["depth"] * p["speed"]
        point.well = 0.5 * point.mu * added**2
        return math.hypot(p["speed"], added)

    def head_on(self, point):
        """As Hamaker.head_on."""
        p = point.values
        u2 = p["speed"]**2 + 2 * point.well / point.mu
        return p["e"]**2 - 2 * point.well / point.mu / u2, math.sqrt(u2)


class SquareWell(Well, Soft):
    style, base, corners = "gran/squarewell", points.WELL, points.WELL_CORNERS

    def contact(self, point):
        return self.base_contact(point) + self.words(point)

    def derive(self, point):
        p = point.values
        speed = self.derive_depth(point)
        # Wider wells than half a radius sum are another scene.
        point.wide = min(p["width"] * speed * point.contact, 0.5 * point.reach) if point.well else 0.0
        self.derive_steps(point, point.wide / max(speed, 1e-300))
        point.gap = point.wide + point.ahead
        point.deep = 0.0
        point.scale = max(speed, point.w0 * p["overlap"] * point.reach, 1e-300)

    def outcome_gap(self, point):
        return point.wide + point.scale * point.dt

    def place_room(self, point):
        return math.pi / point.values["steps"]


class Hard(Well):
    """Hard cores with square wells, without the rule that makes slow collisions in wells elastic; `steps`: of the
    whole run."""

    style, corners, hard, scheme = "hard/squarewell", points.HARD_CORNERS, True, "hard"
    base = {**points.WELL, "width": 0.1, "steps": 30.0}
    random = staticmethod(points.hard_point)

    def __init__(self, wall=False):
        self.wall = wall
        self.name = f"fix wall/{self.style}" if wall else self.style

    def lines(self, point, _):
        p = point.values
        contact = f"restitution {p['e']:.17g} friction {p['mu']:.17g}"
        pair = [f"pair_style {self.style} rest off",
                f"pair_coeff * * {contact}{'' if self.wall else self.words(point)}"]
        if not self.wall:
            return pair
        well = self.words(point) or " well off"
        return [*pair, f"fix walls all wall/{self.style} {contact}{well} xplane 0 NULL yplane 0 NULL"]

    def derive(self, point):
        p = point.values
        speed = self.derive_depth(point)
        point.wide = p["width"] * point.reach if point.well else 0.0
        point.gap = point.wide + 0.3 * point.start * point.reach
        path = 2 * (point.gap + point.wide) + point.reach
        point.duration = path / max(p["speed"], 1e-300) if p["speed"] else 1.0
        point.dt = point.duration / p["steps"]
        point.deep, point.scale = 0.0, max(speed, 1e-300)
        point.w0 = 0.0

    def outcome_gap(self, point):
        # Collisions without rebound leave a pair at the sum of radii but for rounding.
        return point.wide + 1e-9 * point.reach


LAWS = (Hamaker("exact"), Hamaker("sampled"), SquareWell("exact"), SquareWell("sampled"), Hard(),
        Hamaker("exact", wall=True), SquareWell("exact", wall=True), SquareWell("sampled", wall=True), Hard(wall=True),
        Hertz("exact"), Jkr("exact"), Hertz("exact", wall=True), Jkr("exact", wall=True))
