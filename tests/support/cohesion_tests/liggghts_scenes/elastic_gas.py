# SPDX-License-Identifier: BSD-3-Clause
"""A gas of elastic spheres in a periodic box, in LIGGGHTS, and its energy."""
import math
import random

import numpy
from scipy.spatial import cKDTree

from cohesion_tests.liggghts_scenes.scene import MASS, RADIUS, STIFFNESS, contact, sphere

DIAMETER = 2 * RADIUS


def elastic(restitution=1.0):
    """Contacts of this restitution between two spheres: with no dashpot along the normal."""
    text = contact()
    line = next(line for line in text.splitlines() if " gamman_abs " in line)
    part = -math.log(restitution)
    damping = 2 * part / math.hypot(math.pi, part) * math.sqrt(STIFFNESS * MASS / 2)
    return text.replace(line, f"fix gamman_abs all property/global gamman_abs peratomtypepair 2{f' {damping!r}' * 4}")


def gas(edge, fraction, seed=1, speed=0.1):
    """edge^3 spheres that fly at `speed` [m/s] (each component), and the side of their periodic box."""
    numbers = random.Random(seed)
    cell = DIAMETER * (numpy.pi / 6 / fraction)**(1 / 3)
    room = 0.4 * (cell - DIAMETER)
    sites = [(i, j, k) for i in range(edge) for j in range(edge) for k in range(edge)]
    speeds = [[numbers.gauss(0, speed) for _ in range(3)] for _ in sites]
    mean = [sum(v[d] for v in speeds) / len(speeds) for d in range(3)]
    return [sphere([cell * (n + 0.5) + numbers.uniform(-room, room) for n in site],
                   [v - m for v, m in zip(velocity, mean)])
            for site, velocity in zip(sites, speeds)], cell * edge


def kinetic_energy(frame):
    """Of a dumped frame: {id: row}, velocities in columns 3 to 5."""
    rows = numpy.array(list(frame.values()))
    return 0.5 * MASS * (rows[:, 3:6]**2).sum()


def gaps(frame, side, reach=0.0):
    """Between the surfaces of all pairs that are not further apart than `reach`; overlaps are < 0."""
    places = numpy.array(list(frame.values()))[:, :3] % side
    pairs = cKDTree(places, boxsize=side).query_pairs(DIAMETER + reach, output_type="ndarray")
    apart = places[pairs[:, 0]] - places[pairs[:, 1]]
    return numpy.linalg.norm(apart - side * numpy.round(apart / side), axis=1) - DIAMETER


def spring_energy(overlaps):
    return 0.5 * STIFFNESS * (numpy.minimum(overlaps, 0)**2).sum()


def energy(frame, side, pair):
    """Of a dumped frame, pair: theory.pair_motion.Pair. The tail counts at H_cut, where scheme exact crosses it."""
    near = gaps(frame, side, pair.cut)
    attraction = numpy.where(near < 0, pair.adhesion_energy(0.0) + pair.adhesion * near, 0.0)
    between = near[(near >= 0) & (pair.A > 0)]
    return kinetic_energy(frame) + spring_energy(near) + attraction.sum() + sum(map(pair.adhesion_energy, between))
