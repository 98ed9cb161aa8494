# SPDX-License-Identifier: BSD-3-Clause
"""A gas of elastic spheres in a periodic box, in LIGGGHTS, and its energy."""
import random

import numpy
from scipy.spatial import cKDTree

from cohesion_tests.liggghts_scenes.scene import MASS, RADIUS, STIFFNESS, contact, sphere

DIAMETER = 2 * RADIUS


def elastic():
    """Contacts whose dashpot along the normal is none."""
    text = contact()
    line = next(line for line in text.splitlines() if " gamman_abs " in line)
    return text.replace(line, "fix gamman_abs all property/global gamman_abs peratomtypepair 2 0 0 0 0")


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
