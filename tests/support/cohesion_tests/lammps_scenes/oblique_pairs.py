# SPDX-License-Identifier: BSD-3-Clause
"""Pairs that meet at angles, at speeds around their escape velocity, at eight phases of the step: which of them part."""
import math

import numpy

from cohesion_tests.lammps_scenes import couples
from cohesion_tests.lammps_scenes.square_well_scene import gaps

PHASES = 8


def limits(words, style, speeds, grade, dt, steps, reference_gap, flight, free_gap):
    """For each angle, the slowest factor of the escape velocity at which a pair parted and the fastest at which one was
    captured, of 0.99, 1 - grade, 1 + grade and 1.01.

    words: of pair_coeff; speeds: escape velocity along the normal [m/s] by angle [degrees], of a pair whose surfaces are
    reference_gap [m] apart; flight: length of the way up to there at the start [m]; free_gap: gap of those that parted.
    `steps` end before those that part meet other pairs."""
    factors, atoms = (0.99, 1 - grade, 1 + grade, 1.01), []
    distance = couples.DIAMETER + reference_gap
    for angle, speed in speeds.items():
        for factor in factors:
            for phase in range(PHASES):
                velocity = factor * speed * numpy.array([math.tan(math.radians(angle)), 1.0, 0.0])
                away = numpy.array([0.0, distance, 0.0]) + velocity * (flight / (factor * speed) + dt * phase / PHASES)
                start = numpy.linalg.norm(away)
                atoms += couples.couple(len(atoms) // 2, start - couples.DIAMETER, velocity, normal=away / start)
    end = couples.run(atoms, [f"1 1 {words}"], dt, steps, style=style, skin=4e-4)[0][-1]
    parted = (gaps(end) > free_gap).reshape(len(speeds), len(factors), PHASES)
    for angle, answers in zip(speeds, parted):
        yield (angle, min((f for f, out in zip(factors, answers) if out.any()), default=math.inf),
               max((f for f, out in zip(factors, answers) if not out.all()), default=0.0))
