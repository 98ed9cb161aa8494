# SPDX-License-Identifier: BSD-3-Clause
"""Escape velocity of two spheres of the thesis that meet at an angle without friction: energy and angular momentum
outside contact, an integration by scipy in contact. It knows nothing of the package and of no engine."""
import math

import numpy
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

from cohesion_tests.theory.pair_motion import CONTACT_TIME, DAMPING, DIAMETER, MU, STIFFNESS


def energy_left(speed, angle, start, energy, adhesion):
    """Of the relative motion along the normal [J], of which the most that escaping needs is taken off: < 0 when
    captured. Where the gap is `start`, the velocity is at `angle` to the normal, `speed` [m/s] along it.
    energy(gap): of the attraction [J], 0 at start; adhesion: its force in contact [N].

    Turning acts on the normal motion as an energy that grows inwards. Who does not come out at once has lost energy
    and none of its angular momentum: it never will."""
    momentum = (DIAMETER + start) * speed * math.tan(angle)  # over MU

    def wall(gap):
        """Energy that the normal motion does not have at a gap: of the attraction and of the turning."""
        return energy(gap) + 0.5 * MU * (momentum / (DIAMETER + gap))**2

    way = [wall(gap) for gap in (0.0, *numpy.geomspace(1e-6 * start, start, 400))]
    total = 0.5 * MU * speed**2 + way[-1]
    assert max(way) <= total, "turned round before it touched"
    entry = math.sqrt(2 * (total - way[0]) / MU)
    length = entry * CONTACT_TIME  # scales of the integration

    def motion(_, state):
        overlap, rate = state[0] * length, state[1] * entry
        force = adhesion - STIFFNESS * overlap - DAMPING * rate - MU * momentum**2 / (DIAMETER - overlap)**3
        return [rate / length, force / MU / entry]

    def parted(_, state):
        return state[0]

    def turned_back(_, state):
        return state[1]

    # Rising through zero, the overlap's rate begins the next swing inwards.
    parted.terminal, parted.direction = True, -1
    turned_back.terminal, turned_back.direction = True, 1
    path = solve_ivp(motion, (0, 6 * CONTACT_TIME), [0.0, 1.0], method="DOP853", rtol=1e-11, atol=1e-13,
                     max_step=0.05 * CONTACT_TIME, events=(parted, turned_back))
    if not len(path.t_events[0]):
        return way[0] - max(way)
    return 0.5 * MU * (path.y_events[0][0][1] * entry)**2 + way[0] - max(way)


def of_hamaker(pair, angle, start):
    """Along the normal [m/s], where the gap of a pair_motion.Pair is `start`. On the way through the tail of the
    attraction, H_cut to H_out, the turning helps the pair out: at 80 degrees a pair needs up to 1.7e-3 less speed than
    to cross the tail's energy at H_cut."""
    return brentq(energy_left, 1e-4, 1.0, args=(angle, start, pair.adhesion_energy, pair.adhesion), xtol=1e-13)


def of_well(depth, width, angle, start):
    """The same for a well of `width` beyond touch."""
    return brentq(energy_left, 1e-4, 1.0, args=(angle, start, lambda gap: -depth if gap < width else 0.0, 0.0),
                  xtol=1e-13)
