# SPDX-License-Identifier: BSD-3-Clause
"""Two hard particles with a square well that meet, in closed form: energy and angular momentum are
kept at the edge, and at the core but for the restitution. Relative motion in the plane of the
encounter: the second particle comes to the first, at the origin, along x at height `offset`."""
import math
from collections import namedtuple

import numpy

# kinds: of the events up to the end; times: of these, from the approach on; place, velocity (2): at
# the last of them, after it; normals: (before, after) of the core, before the edge on the way out,
# each along the line of centres, away from each other > 0; None where there is no such event.
Encounter = namedtuple("Encounter", "kinds times place velocity core edge")


def polar(angle, normal, turning):
    """Vector with a component away from the centre and one that lowers the angle."""
    return (normal * numpy.array([math.cos(angle), math.sin(angle)])
            + turning * numpy.array([math.sin(angle), -math.cos(angle)]))


def encounter(speed, offset, core, edge, well, restitution):
    """speed [m/s] and offset [m] before; well = 2 D/mu [m^2/s^2]; offset < edge; ends when the pair
    has left or is captured."""
    angle = math.pi - math.asin(offset / edge)
    faster = math.sqrt(speed**2 + well)
    closest = offset * speed / faster
    kinds, times = ["approach"], [0.0]
    struck = None
    if closest < core:
        angle -= math.asin(closest / core) - math.asin(closest / edge)
        turning = offset * speed / core
        normal = math.sqrt(faster**2 - turning**2)
        kinds.append("collision")
        times.append((math.sqrt(edge**2 - closest**2) - math.sqrt(core**2 - closest**2)) / faster)
        struck = -normal, restitution * normal
        left = math.hypot(restitution * normal, turning)
        after = offset * speed / left
        angle -= math.asin(after / core) - math.asin(after / edge)
        flight = (math.sqrt(edge**2 - after**2) - math.sqrt(core**2 - after**2)) / left
    else:
        left = faster
        angle -= math.pi - 2 * math.asin(closest / edge)
        flight = 2 * math.sqrt(edge**2 - closest**2) / left
    times.append(times[-1] + flight)
    turning = offset * speed / edge
    normal = math.sqrt(left**2 - turning**2)
    kinds.append("escape" if normal**2 > well else "capture")
    after = math.sqrt(normal**2 - well) if kinds[-1] == "escape" else -normal
    return Encounter(kinds, times, polar(angle, edge, 0.0), polar(angle, after, turning), struck,
                     normal)
