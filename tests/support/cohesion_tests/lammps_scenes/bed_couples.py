# SPDX-License-Identifier: BSD-3-Clause
"""Couples of spheres of the bed's kind that meet head-on (in.head_on), and an integration of their motion that knows
neither LAMMPS nor the package."""
import math

import numpy
from scipy.integrate import solve_ivp

DIAMETER, DENSITY = 1e-3, 2650.0
STIFFNESS, DAMPING = 800.0, 0.79e-3  # [N/m], [kg/s]
A, CUT, OUT = 7.49e-19, 4e-10, 1e-7
DT = 1e-8
MASS = math.pi / 6 * DENSITY * DIAMETER**3
MU = MASS / 2
REDUCED = DIAMETER / 4
ADHESION = A * REDUCED / (6 * CUT**2)
# Work of the attraction from the outer cut-off to contact.
TAIL = A * REDUCED / 6 * (1 / CUT - 1 / OUT) + ADHESION * CUT


def energy_after_contact(speed):
    """Kinetic energy of the relative motion left beyond the outer cut-off, < 0 when captured. The
    attraction outside contact conserves energy; inside, spring, dashpot and constant adhesion."""
    entry = math.sqrt(speed**2 + 2 * TAIL / MU)

    def motion(_, state):
        overlap, rate = state
        return [rate, (ADHESION - STIFFNESS * overlap - DAMPING * rate) / MU]

    def parted(_, state):
        return state[0]

    parted.terminal, parted.direction = True, -1
    # Tolerances two orders below what is asked of the result, 1e-6; half a millisecond is several
    # contact times.
    path = solve_ivp(motion, (0, 5e-4), [0.0, entry], method="DOP853", rtol=1e-11, atol=1e-18,
                     events=parted)
    if not len(path.t_events[0]):
        return -TAIL
    return 0.5 * MU * path.y_events[0][0][1] ** 2 - TAIL


def escape_velocity():
    low, high = 1e-4, 1e-1
    assert energy_after_contact(low) < 0 < energy_after_contact(high)
    while high - low > 1e-9 * high:
        middle = math.sqrt(low * high)
        low, high = (middle, high) if energy_after_contact(middle) < 0 else (low, middle)
    return high


def steps_needed(speed):
    """Approach, contact and flight out of the attraction, with a margin of a tenth."""
    gap = numpy.geomspace(1e-13, OUT, 20001)
    work = numpy.where(gap < CUT, ADHESION * gap,
                       ADHESION * CUT + A * REDUCED / 6 * (1 / CUT - 1 / numpy.maximum(gap, CUT)))
    rate_in = numpy.sqrt(speed**2 + 2 * (TAIL - work) / MU)
    rate_out = numpy.sqrt(2 * (energy_after_contact(speed) + TAIL - work) / MU)
    flight = sum(numpy.trapz(1 / rate, gap) for rate in (rate_in, rate_out))
    contact = 2 * math.pi * math.sqrt(MU / STIFFNESS)
    return int(1.1 * (flight + contact) / DT) + 1
