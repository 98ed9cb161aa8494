# SPDX-License-Identifier: BSD-3-Clause
"""The impulse of two rough hard spheres that collide, as [H] of the manual page of hard/squarewell writes it."""
import numpy


def struck(couple, masses, radii, x, v, spins, restitution, friction, inertia):
    """Velocities and spins after a collision as H 2.3 writes it, and the energy lost; x at contact."""
    k = (x[1] - x[0]) / numpy.linalg.norm(x[1] - x[0])
    moments = [inertia * m * r * r for m, r in zip(masses, radii)]
    b2 = 1 / masses[0] + 1 / masses[1]
    b1 = b2 + sum(r * r / moment for r, moment in zip(radii, moments))
    # Of the contact point, the first seen from the second; H's normal points from b to a.
    slip = v[0] - v[1] + numpy.cross(radii[0] * spins[0] + radii[1] * spins[1], k)
    c0 = slip @ k
    along = slip - c0 * k
    s0 = numpy.linalg.norm(along)
    t = along / s0
    normal = (1 + restitution) * c0 / b2
    sticks = s0 < friction * b1 * normal
    tangential = s0 / b1 if sticks else friction * normal
    lost = c0**2 * (1 - restitution**2) / (2 * b2) + (
        s0**2 / (2 * b1) if sticks else tangential * (s0 - 0.5 * b1 * tangential))
    push = normal * k + tangential * t
    after = numpy.array([v[0] - push / masses[0], v[1] + push / masses[1]])
    turn = numpy.cross(k, tangential * t)
    return after, numpy.array([w - r / moment * turn for w, r, moment in zip(spins, radii, moments)]
                              ), lost, sticks
