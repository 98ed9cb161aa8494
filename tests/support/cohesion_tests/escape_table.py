# SPDX-License-Identifier: BSD-3-Clause
"""Capture and escape of pairs of spheres and of spheres at walls: laws, bodies, steps, angles and phases of the step,
for both engines. One run has all bodies, strengths, angles, speeds and phases of one law and one step, in one box and
far from each other. A further law is one more row of LAWS.

A wall whose spring, dashpot and attraction are twice those of two spheres moves a sphere, of twice the reduced mass,
exactly as a pair: one escape velocity for both. Without friction no force acts across the normal of a wall."""
import functools
import math
from dataclasses import dataclass
from itertools import groupby

import numpy

from cohesion_tests.theory.liquid_bridge import Capillary
from cohesion_tests.theory.oblique_escape import NormalLaw
from cohesion_tests.theory.pair_motion import CONTACT_TIME, CUT, DAMPING, DENSITY, DIAMETER, OUT, STIFFNESS, Pair

RADIUS = DIAMETER / 2
PHASES = 8  # of the time step at the beginning of the attraction
# Head-on only rounding errs: of the gap, 3e-17 m at each edge and step in a box of 0.25 m at most, 5e-20 J of 1e-13 J
# at least in energy, half of that in speed. At an angle a step that turns errs, by what gran_hamaker_couple_test.py
# measures: below the grade.
FINE, GRADE = 1e-6, 1e-3
PAIR_ANGLES, WALL_ANGLES = (0, 20, 40, 60, 80), (0, 40, 80)  # [degrees]
CYLINDER = 0.02  # radius [m], about the z axis
PITCH, FIRST = 2.5 * DIAMETER, 0.03  # distance of spheres, in x of those outside the cylinder [m]
LAYER = 0.01  # height between the bodies outside the cylinder [m]


class LinearContact:
    """A row: normal motion, words of both engines, and lengths of the run. These are of a spring and a dashpot, twice
    as large at a wall, with an attraction that a subclass adds."""

    NAME = ""  # of the pair style gran/NAME and the cohesion model
    MODEL = "hooke/stiffness"  # normal model of LIGGGHTS
    SETTINGS = ""  # of the cohesion model of LIGGGHTS
    DIVISIONS = (4, 8, 16, 50)  # time steps per contact time
    STRENGTHS = ()
    LENGTH = 50  # of a run in contact times, a multiple of 5

    def start(self, strength, at_wall):
        """Gap at which a flight ends, just beyond the attraction [m]."""
        raise NotImplementedError

    def free(self, strength, at_wall):
        """Gap that those that escape pass, and those that are captured do not [m]."""
        raise NotImplementedError

    def normal_law(self, strength):
        """NormalLaw of a pair."""
        raise NotImplementedError

    @staticmethod
    def force(overlap, rate):
        return STIFFNESS * overlap + DAMPING * rate

    def lammps(self, strength, at_wall):
        share = 2 if at_wall else 1
        return (f"stiffness {share * STIFFNESS:.17g} damping {share * DAMPING:.17g} "
                + self.lammps_attraction(strength, share))

    def liggghts(self):
        """Global properties: name, shape, and a number, one for each strength, or these for pairs and beside a wall."""
        kinds = len(self.STRENGTHS)
        for name, value in (("kn", STIFFNESS), ("kt", STIFFNESS), ("gamman_abs", DAMPING), ("gammat_abs", DAMPING)):
            yield name, "peratomtypepair", [kinds * [value], kinds * [2 * value]]
        yield from self.liggghts_attraction(self.STRENGTHS)


class Hamaker(LinearContact):
    """At its slowest a pair leaves with sqrt(2 FINE) e v_esc, 1.4e-6 m/s, and is 0.01 H_cut beyond H_cut in 3e-6 s. One
    that is captured does not pass H_cut, where the tail ends for it."""

    NAME = "hamaker"
    STRENGTHS = (1e-19, 7.49e-19, 2e-18)  # A [J]
    LENGTH = 25

    def start(self, strength, at_wall):
        return 1.001 * OUT

    def free(self, strength, at_wall):
        return 1.01 * CUT

    def normal_law(self, strength):
        pair = Pair(strength)
        return NormalLaw(pair.adhesion_energy, pair.adhesion_energy,
                         lambda overlap, rate: self.force(overlap, rate) - pair.adhesion)

    def lammps_attraction(self, strength, share):
        # Of one A a plane attracts a sphere twice as much as another sphere does.
        return f"hamaker {strength:.17g} cutoff {CUT} {OUT}"

    def liggghts_attraction(self, strengths):
        yield "hamakerConstant", "peratomtypepair", [strengths, strengths]
        yield "hamakerSurfaceCutoff", "scalar", CUT
        yield "hamakerOuterCutoff", "scalar", OUT


class SquareWell(LinearContact):
    """Through the well and back it takes 1.7e-3 s at most, 19 contact times, and as long again when it is captured."""

    NAME = "square_well"
    STRENGTHS = ((1e-11, 1.002), (5e-11, 1.01), (1e-10, 1.01), (5e-11, 1.0))  # D [J], ratio; 1: at touch

    def width(self, strength, at_wall=False):
        return (strength[1] - 1) * (RADIUS if at_wall else DIAMETER)

    def start(self, strength, at_wall):
        return self.width(strength, at_wall) + 1e-7

    def free(self, strength, at_wall):
        return self.width(strength, at_wall) + 1e-9

    def normal_law(self, strength):
        depth, width = strength[0], self.width(strength)

        def energy(gap):
            return -depth if gap < width or gap == 0 else 0.0

        return NormalLaw(energy, energy, self.force, reach=width)

    def lammps_attraction(self, strength, share):
        return f"well {share * strength[0]:.17g} {strength[1]:.17g}"

    def liggghts_attraction(self, strengths):
        yield "wellDepth", "peratomtypepair", [[k * depth for depth, _ in strengths] for k in (1, 2)]
        yield "wellRatio", "peratomtype", [ratio for _, ratio in strengths]


class LiquidBridge(LinearContact):
    """To the rupture and back it takes 2 sqrt(2 mu h_r/F_b), 1.7e-3 s at most: 19 contact times."""

    NAME = "liquid_bridge"
    STRENGTHS = ((1e-5, 1e-5), (1e-4, 5e-5), (1e-3, 2e-6))  # F_b [N], h_r [m]

    def start(self, strength, at_wall):
        return 1e-7  # no attraction before the touch

    def free(self, strength, at_wall):
        return strength[1] + 1e-9

    def normal_law(self, strength):
        pull, rupture = strength
        return NormalLaw(lambda gap: 0.0, lambda gap: -pull * max(rupture - gap, 0.0),
                         lambda overlap, rate: self.force(overlap, rate) - pull, reach=rupture)

    def lammps_attraction(self, strength, share):
        return f"bridge {share * strength[0]:.17g} {strength[1]:.17g}"

    def liggghts_attraction(self, strengths):
        yield "bridgeForce", "peratomtypepair", [[k * pull for pull, _ in strengths] for k in (1, 2)]
        yield "bridgeRuptureGap", "peratomtypepair", 2 * [[rupture for _, rupture in strengths]]


class CapillaryBridge(LinearContact):
    """A bridge of a liquid, whose pull at the rupture is 1/33 to 1/106 of that in contact: a pair falls from there to
    touch in 100 contact times at most. Turning may nearly balance it, where a pair lingers.

    A wall has twice the force, and with twice the volume the pull falls over the same way; the rupture is at the same
    gap by another contact angle."""

    NAME, SETTINGS = "liquid_bridge", " capillary on"
    DIVISIONS = (4, 16, 50)
    STRENGTHS = ((0.05, 1e-14), (0.05, 1e-13), (0.02, 4e-13))  # gamma [N/m], V [m3]
    LENGTH = 250
    ANGLE, WALL_ANGLE = 0.6, 2 * (1.3 / 2**(1 / 3) - 1)  # [rad]

    def rupture(self, strength):
        return (1 + self.ANGLE / 2) * strength[1]**(1 / 3)

    def start(self, strength, at_wall):
        return 1e-7  # no attraction before the touch

    def free(self, strength, at_wall):
        return self.rupture(strength) + 1e-9

    def normal_law(self, strength):
        tension, volume = strength
        bridge = Capillary(tension, self.ANGLE, volume, RADIUS)
        return NormalLaw(lambda gap: 0.0, lambda gap: bridge.work(gap) - bridge.work(bridge.rupture),
                         lambda overlap, rate: self.force(overlap, rate) - bridge.force(0.0), reach=bridge.rupture)

    def liquid(self, strength, at_wall):
        tension, volume = strength
        if not at_wall:
            return tension, self.ANGLE, volume
        return tension * math.cos(self.ANGLE) / math.cos(self.WALL_ANGLE), self.WALL_ANGLE, 2 * volume

    def lammps_attraction(self, strength, share):
        return "capillary {:.17g} {:.17g} {:.17g}".format(*self.liquid(strength, share == 2))

    def liggghts_attraction(self, strengths):
        for k, name in enumerate(("bridgeSurfaceTension", "bridgeContactAngle", "bridgeVolume")):
            yield name, "peratomtypepair", [[self.liquid(strength, at_wall)[k] for strength in strengths]
                                            for at_wall in (False, True)]


LAWS = (Hamaker(), SquareWell(), LiquidBridge(), CapillaryBridge())


@functools.cache
def escape_velocity(law, strength, angle):
    return law.normal_law(strength).escape_velocity(math.radians(angle), law.start(strength, False))


@dataclass(frozen=True)
class Body:
    """Partner of a sphere. kind: pair, plane (also a mesh, a plane at another height) or cylinder."""

    name: str
    kind: str = "plane"

    @property
    def angles(self):
        return PAIR_ANGLES if self.kind == "pair" else WALL_ANGLES


PAIR, PLANE, CYLINDER_WALL = Body("pair", "pair"), Body("plane"), Body("cylinder", "cylinder")


@dataclass(frozen=True)
class Encounter:
    """Of a sphere with a body, or of two."""

    body: Body
    strength: int  # number in the law's STRENGTHS
    angle: float
    factor: float  # of the escape velocity
    phase: int

    @property
    def escapes(self):
        return self.factor > 1


class Table:
    """All encounters of a law at a step of the contact time over `division`. Planes lie above each other in the order
    of `bodies`, the first at z = 0; pairs have a layer of their own between them."""

    def __init__(self, law, bodies, division):
        self.law, self.bodies, self.division = law, bodies, division
        self.dt, self.steps = CONTACT_TIME / division, law.LENGTH * division
        self.every = 5 * division  # steps between snapshots
        self.encounters = [Encounter(body, strength, angle, 1 + sign * grade, phase)
                           for body in bodies for strength in range(len(law.STRENGTHS)) for angle in body.angles
                           for grade in ((FINE, GRADE) if angle == 0 else (GRADE,)) for sign in (-1, 1)
                           for phase in range(PHASES)]

    def height(self, body):
        return LAYER * self.bodies.index(body)

    def speed(self, encounter):
        """Escape velocity along the normal."""
        angle = encounter.angle if encounter.body.kind == "pair" else 0
        return escape_velocity(self.law, self.law.STRENGTHS[encounter.strength], angle)

    def rows(self):
        """Encounters of a body, a strength and an angle, which fly side by side."""
        return [list(row) for _, row in groupby(self.encounters, lambda e: (e.body, e.strength, e.angle))]

    def atoms(self):
        """Of all encounters in order, two of a pair and one at a wall; the type is the number of the strength. Rows are
        as far apart as their spheres fly: in y, and along the cylinder."""
        atoms, along, body = [], 0.0, None
        for row in self.rows():
            if row[0].body != body:
                body, along = row[0].body, 0.005
            for column, encounter in enumerate(row):
                atoms += [{"type": 1 + encounter.strength, "diameter": DIAMETER, "density": DENSITY, "x": x, "v": v}
                          for x, v in self.start(encounter, column / len(row), FIRST + PITCH * column, along)]
            along += PITCH + self.steps * self.dt * 1.001 * self.speed(row[0]) * math.tan(math.radians(row[0].angle))
        return atoms

    def start(self, encounter, turn, x, along):
        """Places and velocities."""
        law, body = self.law, encounter.body
        speed = encounter.factor * self.speed(encounter)
        across = speed * math.tan(math.radians(encounter.angle))
        gap = law.start(law.STRENGTHS[encounter.strength], body.kind != "pair")
        late = self.dt * encounter.phase / PHASES
        if body.kind == "pair":
            velocity = numpy.array([0.0, across, speed])
            first = numpy.array([x, along, self.height(body)])
            return (first, velocity / 2), (first + [0.0, 0.0, DIAMETER + gap] + velocity * late, -velocity / 2)
        gap += speed * late
        if body.kind == "plane":
            return ((x, along, self.height(body) + RADIUS + gap), (0.0, across, -speed)),
        out = numpy.array([math.cos(2 * math.pi * turn), math.sin(2 * math.pi * turn), 0.0])
        return ((CYLINDER - RADIUS - gap) * out + [0.0, 0.0, along], speed * out + [0.0, 0.0, across]),

    def numbers(self):
        """Of the atoms of each encounter, from 0 on."""
        last = 0
        for encounter in self.encounters:
            count = 2 if encounter.body.kind == "pair" else 1
            yield encounter, range(last, last + count)
            last += count

    def wrong(self, snapshots):
        """Lines on encounters that did not end as they should, of places (snapshot, atom, 3). The last three snapshots
        count: a captured pair may be found half a step beyond its edge, where it turns round, but not three times."""
        x = numpy.asarray(snapshots)[-3:]
        for encounter, numbers in self.numbers():
            place, body = x[:, numbers[0]], encounter.body
            if body.kind == "pair":
                gaps = numpy.linalg.norm(x[:, numbers[1]] - place, axis=1) - DIAMETER
            elif body.kind == "plane":
                gaps = place[:, 2] - self.height(body) - RADIUS
            else:
                gaps = CYLINDER - RADIUS - numpy.hypot(place[:, 0], place[:, 1])
            free = self.law.free(self.law.STRENGTHS[encounter.strength], body.kind != "pair")
            if (gaps > free).all() != encounter.escapes:
                yield (f"{body.name}, {self.law.STRENGTHS[encounter.strength]}, {encounter.angle} degrees, "
                       f"{encounter.factor:.6f} of the escape velocity, phase {encounter.phase}: {gaps[-1]:.3g} m")
