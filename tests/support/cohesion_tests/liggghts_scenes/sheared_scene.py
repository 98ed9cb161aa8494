# SPDX-License-Identifier: BSD-3-Clause
"""Scripts of spheres in a sheared box: 10 by 8 by 6 mm, flow along x, gradient along y."""

import numpy

from cohesion_tests.liggghts_scenes.scene import RADIUS, hamaker, script, sphere, square_well

BOX = numpy.array([10e-3, 8e-3, 6e-3])
RATE = 50.0
COLUMNS = "x y z vx vy vz".split()
PLAIN = "model hooke tangential off"


def sides(dimension=3, tilt=0.0):
    x, y, z = BOX.tolist()
    low, high = (0.0, z) if dimension == 3 else (-RADIUS, RADIUS)
    return f"0 {x!r} 0 {y!r} {low!r} {high!r} {float(tilt)!r} 0 0"


def sheared(spheres, models, properties="", rate=RATE, profile="no", dimension=3, tilt=0.0,
            extra="", columns=COLUMNS, **options):
    extra = (f"fix shear all deform/shear rate {rate} profile {profile}\n" + extra +
             ("fix flat all enforce2d\n" if dimension == 2 else ""))
    return script(spheres, models, properties, boundary="p p p", box=sides(dimension, tilt),
                  extra=extra, columns=columns, dimension=dimension, **options)


LAWS = {
    "spring": ("model hooke/stiffness tangential history absolute_damping on", ""),
    "hertz": ("model hertz tangential history rolling_friction epsd2", ""),
    "hamaker": ("model hooke/stiffness tangential history cohesion hamaker absolute_damping on",
                hamaker(1e-11)),
    "square_well": ("model hooke/stiffness tangential history cohesion square_well "
                    "absolute_damping on", square_well(4e-9, ratio=1.05))}


def gas(speed=0.1):
    random = numpy.random.default_rng(5)
    grid = [numpy.arange(n) + 0.5 for n in (8, 6, 5)]
    places = numpy.array(numpy.meshgrid(*grid)).reshape(3, -1).T * BOX / [8, 6, 5]
    return [sphere(x, random.normal(0, speed, 3), radius=0.45e-3) for x in places]


SMALL, LARGE = 0.25e-3, 0.5e-3


def three_in_a_row():
    """The first hits, spinning, the second, which bounces off a third eight times as heavy and comes back to the
    first when that is less than 1e-5 m away."""
    places = (-2 * SMALL - 1e-7, 0.0, SMALL + 1e-5 + LARGE)
    return [sphere(BOX / 2 + [x, 0, 0], (v, 0, 0), (0, 0, spin), radius)
            for x, v, spin, radius in zip(places, (0.1, 0, 0), (60.0, 0, 0), (SMALL, SMALL, LARGE))]
