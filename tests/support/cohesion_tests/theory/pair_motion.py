# SPDX-License-Identifier: BSD-3-Clause
"""The motion of two spheres that meet head-on as the manual page of gran/hamaker states it,
integrated by scipy; it knows nothing of the package and of no engine."""
import math

from scipy.integrate import solve_ivp
from scipy.optimize import brentq

from cohesion_tests.theory import hamaker_reference

# The thesis's particle.
DIAMETER, DENSITY = 1e-3, 2650.0  # [m], [kg/m3]
STIFFNESS, DAMPING = 800.0, 0.79e-3  # [N/m], [kg/s]
CUT, OUT = 4e-10, 1e-7  # [m]
MASS = math.pi / 6 * DENSITY * DIAMETER**3
MU = MASS / 2
ALPHA = DAMPING / (2 * MU)
Q = math.sqrt(STIFFNESS / MU - ALPHA**2)
CONTACT_TIME = math.pi / Q


class Pair:
    """The law between two equal spheres of the thesis."""

    def __init__(self, A=0.0, cut=CUT, out=OUT, damping=DAMPING):
        self.A, self.cut, self.out, self.damping = A, cut, out, damping
        self.adhesion = self.attraction(0.0)

    def attraction(self, gap):
        return hamaker_reference.force("small_gap", gap, DIAMETER / 2, DIAMETER / 2, self.A,
                                       self.cut, self.out)

    def adhesion_energy(self, gap):
        return hamaker_reference.energy("small_gap", gap, DIAMETER / 2, DIAMETER / 2, self.A,
                                        self.cut, self.out)

    def words(self, **more):
        """pair_coeff's keywords."""
        text = f"stiffness {STIFFNESS:.17g} damping {self.damping:.17g}"
        if self.A:
            text += f" hamaker {self.A:.17g} cutoff {self.cut:.17g} {self.out:.17g}"
        return text + "".join(f" {name} {value:.17g}" for name, value in more.items())

    def energy_after_contact(self, speed):
        """Kinetic energy of the relative motion left far away after a head-on contact, < 0 when
        captured. What is outside contact conserves energy. Good to 1e-9 of the kinetic energy
        before: tolerances two orders below. Steps are small enough to see a pair that comes out
        of contact slowly and is soon pulled back."""
        depth = -self.adhesion_energy(0.0)
        entry = math.sqrt(speed**2 + 2 * depth / MU)

        def motion(_, state):
            overlap, rate = state
            return [rate, (self.adhesion - STIFFNESS * overlap - self.damping * rate) / MU]

        def parted(_, state):
            return state[0]

        parted.terminal, parted.direction = True, -1
        path = solve_ivp(motion, (0, 6 * CONTACT_TIME), [0.0, entry], method="DOP853", rtol=1e-11,
                         atol=1e-18, max_step=0.05 * CONTACT_TIME, events=parted)
        if not len(path.t_events[0]):
            return -depth
        return 0.5 * MU * path.y_events[0][0][1] ** 2 - depth

    def escape_velocity(self):
        return brentq(self.energy_after_contact, 1e-4, 1.0, xtol=1e-15, rtol=1e-11)
