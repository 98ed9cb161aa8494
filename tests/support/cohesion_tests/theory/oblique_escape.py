# SPDX-License-Identifier: BSD-3-Clause
"""Escape velocity of two spheres of the thesis that meet at an angle without friction: energy and angular momentum
outside contact, an integration by scipy in contact. It knows nothing of the package and of no engine."""
import math
from dataclasses import dataclass
from typing import Callable

import numpy
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

from cohesion_tests.theory.pair_motion import CONTACT_TIME, DIAMETER, MU


@dataclass(frozen=True)
class NormalLaw:
    """Motion of a pair along its normal. way_in, way_out: potential energy [J] of the attraction at a gap [m] before
    and after contact, 0 where it does not act; force: by which a contact drives the surfaces apart [N], of its overlap
    [m] and the rate of that [m/s]; parting_gap: at which contact ends (a neck: > 0); reach: gap at which way_out ends
    in a step, or beyond the gap from which pairs start."""

    way_in: Callable
    way_out: Callable
    force: Callable
    parting_gap: float = 0.0
    reach: float = 0.0

    def energy_left(self, speed, angle, start):
        """Of the relative motion along the normal [J], of which the most that escaping needs is subtracted: < 0 when
        captured. Where the gap is `start`, the velocity is at `angle` to the normal, `speed` [m/s] along it.

        Turning acts on the normal motion as an energy that grows inwards. A pair that does not come out at once has
        lost energy and none of its angular momentum: it never will."""
        momentum = (DIAMETER + start) * speed * math.tan(angle)  # over MU

        def walls(energy, first, last):
            """Energy that the normal motion does not have, at gaps from the first to the last: of the attraction and of
            the turning."""
            gaps = [first, max(first, self.reach), *(first + numpy.geomspace(1e-6, 1, 400) * (last - first))]
            return [energy(gap) + 0.5 * MU * (momentum / (DIAMETER + gap))**2 for gap in gaps]

        inwards = walls(self.way_in, 0.0, start)
        outwards = walls(self.way_out, self.parting_gap, max(start, self.reach))
        total = 0.5 * MU * speed**2 + inwards[-1]
        assert max(inwards) <= total, "turned round before it touched"
        entry = math.sqrt(2 * (total - inwards[0]) / MU)
        length = entry * CONTACT_TIME  # scales of the integration

        def motion(_, state):
            overlap, rate = state[0] * length, state[1] * entry
            force = self.force(overlap, rate) + MU * momentum**2 / (DIAMETER - overlap)**3
            return [rate / length, -force / MU / entry]

        def parted(_, state):
            return state[0] + self.parting_gap / length

        def turned_back(_, state):
            return state[1]

        # Rising through zero, the overlap's rate begins the next swing inwards.
        parted.terminal, parted.direction = True, -1
        turned_back.terminal, turned_back.direction = True, 1
        path = solve_ivp(motion, (0, 6 * CONTACT_TIME), [0.0, 1.0], method="DOP853", rtol=1e-11, atol=1e-13,
                         max_step=0.05 * CONTACT_TIME, events=(parted, turned_back))
        if not len(path.t_events[0]):
            return outwards[0] - max(outwards)
        return 0.5 * MU * (path.y_events[0][0][1] * entry)**2 + outwards[0] - max(outwards)

    def escape_velocity(self, angle, start):
        """Along the normal [m/s]. On the way through the tail of a Hamaker attraction, H_cut to H_out, the turning
        helps the pair out: at 80 degrees a pair needs up to 1.7e-3 less speed than to cross the tail's energy at H_cut."""
        return brentq(self.energy_left, 1e-4, 1.0, args=(angle, start), xtol=1e-13)
