# SPDX-License-Identifier: BSD-3-Clause
"""Clusters of adhesive spheres in the closest packing: two that meet, and one that oscillates. Also two spheres that
stick, one of which a third sphere strikes. All in cells of one periodic box, and run by cohesive_gas.follow()."""
import math

import numpy

from cohesion_tests import lammps as engine
from cohesion_tests.lammps_scenes import cohesive_gas as gas, settling_spheres as settling

D, T_C, CUT = gas.DIAMETER, gas.CONTACT_TIME, settling.CUT
A = 2e-18  # [J]
ADHESION = A * D / (24 * CUT**2)  # [N]
SPACING = D - ADHESION / gas.STIFFNESS  # of two at rest


def cluster(count):
    """Centres of the `count` sites of a face-centred cubic lattice that are nearest to one of them: 13, 43, 79."""
    grid = numpy.arange(-5, 6)
    sites = numpy.array(numpy.meshgrid(grid, grid, grid)).reshape(3, -1).T
    sites = sites[sites.sum(axis=1) % 2 == 0]
    squares = (sites**2).sum(axis=1)
    order = numpy.argsort(squares, kind="stable")
    if squares[order[count - 1]] == squares[order[count]]:
        raise ValueError(f"{count} sites are not whole shells")
    return SPACING / math.sqrt(2) * sites[order[:count]]


def rotation(random):
    """Uniform, from the QR decomposition of normal deviates."""
    q, r = numpy.linalg.qr(random.normal(size=(3, 3)))
    q = q * numpy.sign(numpy.diag(r))
    return q * numpy.sign(numpy.linalg.det(q))


def write(folder, groups):
    """data.spheres; groups: centres and velocities of what shares a cell."""
    widths = [numpy.ptp(places, axis=0).max() for places, _ in groups]
    cell, side = max(widths) + 6 * D, math.ceil(len(groups)**(1 / 3))
    spheres = []
    for n, (places, velocities) in enumerate(groups):
        centre = cell * (numpy.array([n % side, n // side % side, n // side**2]) + 0.5)
        places = places - 0.5 * (places.min(axis=0) + places.max(axis=0))
        spheres += [{"type": 1, "diameter": D, "density": gas.DENSITY, "x": centre + x, "v": v}
                    for x, v in zip(places, velocities)]
    engine.write_spheres(folder, spheres, 3 * [(0.0, side * cell)], 1)


def first_touch(still, moving, way):
    """Path of `moving` along the unit vector `way` to the first touch."""
    to = (moving[:, None] - still[None]).reshape(-1, 3)
    root = (to @ way)**2 - (to**2).sum(axis=1) + D * D
    return (-(to @ way)[root > 0] - numpy.sqrt(root[root > 0])).min()


def impact(count, speed, offset, random):
    """Two clusters in random orientation, one to two contact times before they touch; `offset` in diameters of a
    sphere, across the way."""
    one, other = (cluster(count) @ rotation(random) for _ in range(2))
    way = numpy.array([1.0, 0.0, 0.0])
    other = other + numpy.array([-20 * D, offset * D, 0.0])
    other = other + (first_touch(one, other, way) - speed * random.uniform(1, 2) * T_C) * way
    velocities = numpy.repeat([[-speed / 2, 0, 0], [speed / 2, 0, 0]], count, axis=0)
    return numpy.concatenate([one, other]), velocities


def ringing(count, speed, random):
    """A cluster at rest lengths with random velocities, without momentum and angular momentum."""
    places = cluster(count)
    velocities = speed * random.normal(size=places.shape)
    velocities -= velocities.mean(axis=0)
    inertia = (places**2).sum() * numpy.eye(3) - places.T @ places
    spin = numpy.linalg.solve(inertia, numpy.cross(places, velocities).sum(axis=0))
    return places, velocities - numpy.cross(spin, places)


def struck(speed, angle, phase):
    """The first sphere of a bound pair is hit head-on, the second is at `angle` [degrees] from the way on; `phase`:
    steps of t_c/4 before the touch, beyond one contact time."""
    turn = math.radians(angle)
    places = [[0, 0, 0], [SPACING * math.cos(turn), SPACING * math.sin(turn), 0],
              [-D - speed * (1 + phase / 4) * T_C, 0, 0]]
    return numpy.array(places), numpy.array([[0, 0, 0], [0, 0, 0], [speed, 0, 0]])


def run(folder, division, duration, restitution, friction=0.0):
    """Ends of data.spheres at t_c/division: centres, velocities, spins; and thermo lines of gran_hamaker_gas."""
    table, _ = gas.follow(folder, division, duration, 2, A=A, e=restitution, mu=friction)
    end = engine.dump(folder, "end.txt")
    return end[:, 1:4], end[:, 4:7], end[:, 7:10], table


def bound(places, size):
    """For each cell of `size` spheres the pairs within `H_cut`, as a matrix of truth values."""
    groups = places.reshape(-1, size, 3)
    gaps = numpy.linalg.norm(groups[:, :, None] - groups[:, None], axis=-1) - D
    return (gaps < CUT) & ~numpy.eye(size, dtype=bool)
