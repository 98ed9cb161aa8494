# SPDX-License-Identifier: BSD-3-Clause
"""Event-driven motion of hard spheres or discs with square wells, one event after the other, without
time steps: what the hard square well of the package is compared with. It knows nothing of it.

Laws: square well W 3 and hard collision with friction H 2.3, as they stand in the literature.
Between events particles fly straight. Each row of the table of pair times is one particle against
all others; an event renews two rows.
"""
import math
from collections import namedtuple

import numpy

KINDS = ("collision", "approach", "escape", "capture")

# Plane at `position` on `axis` with the particles on its upper (side 1) or lower (side -1) side.
Plane = namedtuple("Plane", "axis position side restitution friction depth ratio",
                   defaults=(1.0, 0.0, 0.0, 1.0))
# time [s]; partner: index, or -1 - number of the plane; energy: change of kinetic energy [J];
# impulse: along the line of centres, > 0 repels [N s]; virial: impulse times distance [J].
Event = namedtuple("Event", "time kind particle partner energy impulse virial")


class Reference:
    """State of `n` particles: x, v, spin (n, 3), at times `own` (n); place() gives them at any time
    up to the next event.

    x, v, spin: (n, 3) [m], [m/s], [1/s]; radius, mass: (n) [m], [kg]; box: three lengths, inf where
    it is not periodic; restitution, friction, depth [J], ratio: number or (n, n); edge: (n, n) where
    it is not ratio (r_i + r_j); inertia: 2/5 for spheres, 1/2 for discs, times m r^2.
    """

    def __init__(self, x, v, radius, mass, box, restitution=1.0, friction=0.0, depth=0.0, ratio=1.0,
                 edge=None, spin=None, inertia=0.4, planes=()):
        self.x, self.v = numpy.array(x, float), numpy.array(v, float)
        n = len(self.x)
        self.spin = numpy.zeros((n, 3)) if spin is None else numpy.array(spin, float)
        self.radius = numpy.broadcast_to(numpy.asarray(radius, float), n)
        self.mass = numpy.broadcast_to(numpy.asarray(mass, float), n)
        self.box, self.planes = numpy.array(box, float), tuple(planes)
        self.restitution, self.friction, self.depth = (
            numpy.broadcast_to(numpy.asarray(value, float), (n, n))
            for value in (restitution, friction, depth))
        self.core = self.radius[:, None] + self.radius
        self.edge = ratio * self.core if edge is None else numpy.asarray(edge, float)
        self.moment = inertia * self.mass * self.radius**2
        self.now, self.own, self.events = 0.0, numpy.zeros(n), []
        apart = self.apart(self.x[:, None] - self.x)
        self.inside = (self.depth > 0) & (numpy.einsum("ijk,ijk->ij", apart, apart) < self.edge**2)
        numpy.fill_diagonal(self.inside, False)
        self.held = numpy.array([[plane.depth > 0 and self.height(plane, i) < plane.ratio * r
                                  for plane in self.planes] for i, r in enumerate(self.radius)],
                                bool).reshape(n, len(self.planes))
        if (2 * self.edge.max() >= self.box).any():
            raise ValueError(f"box {self.box} is smaller than twice the largest edge")
        self.predict_all()

    def apart(self, difference):
        """The nearest image."""
        periodic = numpy.isfinite(self.box)
        difference[..., periodic] -= self.box[periodic] * numpy.rint(
            difference[..., periodic] / self.box[periodic])
        return difference

    def place(self, time):
        return self.x + self.v * (time - self.own)[:, None]

    def energy(self):
        """Of motion, rotation included."""
        return (0.5 * self.mass @ (self.v**2).sum(axis=1)
                + 0.5 * self.moment @ (self.spin**2).sum(axis=1))

    def potential(self):
        return (-0.5 * (self.depth * self.inside).sum()
                - sum(plane.depth * self.held[:, w].sum() for w, plane in enumerate(self.planes)))

    def height(self, plane, i):
        return plane.side * (self.x[i, plane.axis] - plane.position)

    # -- what comes next

    def predict_all(self):
        self.x, self.own = self.place(self.now), numpy.full(len(self.x), self.now)
        self.times = numpy.array([self.pair_times(i) for i in range(len(self.x))])
        # Either row of a pair is the other's round-off away: one of them.
        self.times = numpy.triu(self.times) + numpy.triu(self.times, 1).T
        self.plane_times = numpy.array([self.times_of_planes(i) for i in range(len(self.x))])
        self.first = self.times.min(axis=1)
        self.partner = self.times.argmin(axis=1)
        # The nearest image stays the only one that can be met for so long.
        self.fastest = 1.5 * math.sqrt((self.v**2).sum(axis=1).max())
        room = (self.box / 2 - self.edge.max()).min()
        self.until = self.now + (room / (2 * self.fastest) if self.fastest > 0 else math.inf)

    def pair_times(self, i):
        """Time of the next crossing of each other particle with particle i, inf if none. Which
        surface comes next is known from being inside or outside and from approaching or not, so
        that round-off in the distance cannot make an event happen twice."""
        place = self.place(self.now)
        r = self.apart(place - place[i])
        v = self.v - self.v[i]
        b = numpy.einsum("ij,ij->i", r, v)
        rr, vv = numpy.einsum("ij,ij->i", r, r), numpy.einsum("ij,ij->i", v, v)
        inside = self.inside[i]
        surface = numpy.where(inside | (self.depth[i] == 0), self.core[i], self.edge[i])
        beyond = rr - surface**2
        root = b * b - vv * beyond
        meets = (b < 0) & (root > 0)
        within = self.edge[i]**2 - rr
        leave = numpy.sqrt(numpy.maximum(b * b + vv * within, 0.0))
        with numpy.errstate(divide="ignore", invalid="ignore"):
            inward = numpy.maximum(beyond, 0.0) / (numpy.sqrt(numpy.maximum(root, 0.0)) - b)
            outward = numpy.where(b > 0, numpy.maximum(within, 0.0) / (b + leave), (leave - b) / vv)
        outward = numpy.where(inside & (vv > 0), outward, math.inf)
        times = numpy.where(meets, inward, outward)
        times[i] = math.inf
        return self.now + times

    def times_of_planes(self, i):
        times = []
        for w, plane in enumerate(self.planes):
            rate = plane.side * self.v[i, plane.axis]
            height = self.height(plane, i) + rate * (self.now - self.own[i])
            well = plane.depth > 0
            if rate < 0:
                to = self.radius[i] * (plane.ratio if well and not self.held[i, w] else 1.0)
                times.append(self.now + max(height - to, 0.0) / -rate)
            elif rate > 0 and self.held[i, w]:
                times.append(self.now + max(plane.ratio * self.radius[i] - height, 0.0) / rate)
            else:
                times.append(math.inf)
        return numpy.array(times)

    def renew(self, changed):
        for i in changed:
            self.times[i] = self.times[:, i] = self.pair_times(i)
            if self.planes:
                self.plane_times[i] = self.times_of_planes(i)
        for i in changed:
            sooner = self.times[:, i] < self.first
            self.first[sooner], self.partner[sooner] = self.times[sooner, i], i
        stale = numpy.isin(self.partner, changed) & (
            self.times[numpy.arange(len(self.x)), self.partner] != self.first)
        for k in {*numpy.flatnonzero(stale), *changed}:
            self.partner[k] = self.times[k].argmin()
            self.first[k] = self.times[k, self.partner[k]]

    def next_event(self):
        """Time, particle, partner."""
        i = int(self.first.argmin())
        best = self.first[i], i, int(self.partner[i])
        if self.planes:
            k, w = numpy.unravel_index(self.plane_times.argmin(), self.plane_times.shape)
            if self.plane_times[k, w] < best[0]:
                best = self.plane_times[k, w], int(k), -1 - int(w)
        return best

    # -- what happens

    def run(self, until, most=10**9):
        """Events up to the time `until`, `most` of them at most."""
        done = len(self.events) + most
        while len(self.events) < done:
            time, i, j = self.next_event()
            if min(time, until) > self.until:
                self.now = self.until
                self.predict_all()
                continue
            if time > until:
                self.now = until
                return
            self.now = max(time, self.now)
            changed = [i] if j < 0 else [i, j]
            for k in changed:
                self.x[k] += self.v[k] * (self.now - self.own[k])
                self.own[k] = self.now
            before = self.energy_of(changed)
            kind, impulse, distance = self.strike_plane(i, -1 - j) if j < 0 else self.strike(i, j)
            self.events.append(Event(self.now, kind, i, j, self.energy_of(changed) - before,
                                     impulse, impulse * distance))
            if max((self.v[k]**2).sum() for k in changed) > self.fastest**2:
                self.predict_all()
            else:
                self.renew(changed)

    def energy_of(self, particles):
        return sum(0.5 * self.mass[k] * (self.v[k] @ self.v[k])
                   + 0.5 * self.moment[k] * (self.spin[k] @ self.spin[k]) for k in particles)

    @staticmethod
    def well_impulse(mu, approach, depth):
        """Kind and impulse at the edge."""
        if approach > 0:
            return "approach", mu * (approach - math.sqrt(approach**2 + 2 * depth / mu))
        if approach**2 > 2 * depth / mu:
            return "escape", mu * (approach + math.sqrt(approach**2 - 2 * depth / mu))
        return "capture", 2 * mu * approach

    def strike(self, i, j):
        apart = self.apart(self.x[j] - self.x[i])
        distance = math.sqrt(apart @ apart)
        k = apart / distance
        approach = (self.v[i] - self.v[j]) @ k
        mu = self.mass[i] * self.mass[j] / (self.mass[i] + self.mass[j])
        if self.depth[i, j] == 0 or (self.inside[i, j] and approach > 0):
            slip = (self.v[i] - self.v[j] - approach * k
                    + numpy.cross(self.radius[i] * self.spin[i] + self.radius[j] * self.spin[j], k))
            mobility = (1 / mu + self.radius[i]**2 / self.moment[i]
                        + self.radius[j]**2 / self.moment[j])
            kind, impulse = "collision", mu * (1 + self.restitution[i, j]) * approach
            tangential = self.along(slip, mobility, self.friction[i, j] * impulse)
            self.turn(i, k, tangential)
            self.turn(j, k, tangential)
        else:
            kind, impulse = self.well_impulse(mu, approach, self.depth[i, j])
            tangential = 0.0
            if kind != "capture":
                self.inside[i, j] = self.inside[j, i] = kind == "approach"
        self.v[i] -= (impulse * k + tangential) / self.mass[i]
        self.v[j] += (impulse * k + tangential) / self.mass[j]
        return kind, impulse, distance

    def strike_plane(self, i, w):
        plane, k = self.planes[w], numpy.zeros(3)
        k[plane.axis] = -plane.side
        approach = self.v[i] @ k
        if plane.depth == 0 or (self.held[i, w] and approach > 0):
            slip = self.v[i] - approach * k + numpy.cross(self.radius[i] * self.spin[i], k)
            kind, impulse = "collision", self.mass[i] * (1 + plane.restitution) * approach
            tangential = self.along(slip, 1 / self.mass[i] + self.radius[i]**2 / self.moment[i],
                                    plane.friction * impulse)
            self.turn(i, k, tangential)
        else:
            kind, impulse = self.well_impulse(self.mass[i], approach, plane.depth)
            tangential = 0.0
            if kind != "capture":
                self.held[i, w] = kind == "approach"
        self.v[i] -= (impulse * k + tangential) / self.mass[i]
        return kind, impulse, self.radius[i] * (1.0 if kind == "collision" else plane.ratio)

    @staticmethod
    def along(slip, mobility, most):
        """Tangential impulse: what stops the slip, or the Coulomb limit."""
        speed = math.sqrt(slip @ slip)
        return slip * min(1 / mobility, most / speed) if speed > 0 else slip

    def turn(self, i, k, tangential):
        self.spin[i] -= self.radius[i] / self.moment[i] * numpy.cross(k, tangential)
