# SPDX-License-Identifier: BSD-3-Clause
"""A ball of spheres that turns, falls on its middle and flies apart: what it does to momentum."""
import numpy

from cohesion_tests import lammps as engine
from cohesion_tests.lammps_scenes import cohesive_gas as gas

D, SPEED = gas.DIAMETER, 0.1  # [m], [m/s]: of the outermost
HALF = 40 * D                 # of the box


def momentum_change(side, division, seed=5, **contact):
    """side^3 spheres at t_c/division; from before the first contact to after the last, over the sum
    of the spheres' own: change of momentum, change of angular momentum (spin included)."""
    random = numpy.random.default_rng(seed)
    grid = numpy.arange(side) - (side - 1) / 2
    places = numpy.array(numpy.meshgrid(*3 * [grid])).reshape(3, -1).T * 1.15
    places = (places + random.uniform(-0.06, 0.06, places.shape)) * D
    velocities = SPEED / (side * D) * (0.5 * numpy.cross([0, 0, 1], places) - places)
    with engine.temporary_folder() as folder:
        engine.write_spheres(folder, [{"type": 1, "diameter": D, "density": gas.DENSITY, "x": x,
                                       "v": v} for x, v in zip(places, velocities)],
                             3 * [(-HALF, HALF)], 1)
        gas.follow(folder, division, 1.25 * side * D / SPEED, 1, **contact)
        end = engine.dump(folder, "end.txt")
    x, v, spin = end[:, 1:4], end[:, 4:7], end[:, 7:10]
    x = numpy.where(x > HALF, x - 2 * HALF, x)
    if numpy.abs(v - velocities).mean() < 0.1 * SPEED:
        raise RuntimeError("the spheres did not meet")
    turning = numpy.cross(places, velocities)
    change = (numpy.cross(x, v) + D**2 / 10 * spin - turning).sum(axis=0)
    return (numpy.abs((v - velocities).sum(axis=0)).max() / numpy.abs(velocities).sum(),
            numpy.linalg.norm(change) / numpy.linalg.norm(turning, axis=1).sum())
