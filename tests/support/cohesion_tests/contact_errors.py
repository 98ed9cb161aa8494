# SPDX-License-Identifier: BSD-3-Clause
"""Error of persistent contacts over the step, measured in either engine with the same claims. A test gives two functions:

  stack(scheme, e, dt, every, steps)   rows of step and heights of both centres of theory.stacked_spheres
  overlap(scheme, e, dt, steps)        of a sphere that rests on a plate, the mean over the second half of the steps [m]
  bounces(height, dt, every, steps)    rows of the height of an elastic sphere that falls on a plate from `height`, and of
                                       the height that its energy corresponds to, scheme exact [m]
"""
import math

import numpy as np

from cohesion_tests.csv_table import power
from cohesion_tests.theory import stacked_spheres as theory

#: Contact times over the step.
RESOLUTIONS = (40, 80, 160)
#: What a load presses a resting contact more than F/K at t_c/10, by the restitution, as docs/verification/contact_motion.md lists it [%].
LISTED = {1: 0.8, 0.9: 1.9, 0.5: 7.8, 0.3: 12.6, 0.1: 20.7}


def stack_error(stack, scheme, e, per_contact):
    """The largest error of a height in six contact times, over the amplitude."""
    dt = theory.contact_time(theory.MASS / 2) / per_contact
    rows = np.array(stack(scheme, e, dt, per_contact // 10, 6 * per_contact))
    return np.abs(rows[:, 1:] - theory.stacked(e, rows[:, 0] * dt)).max() / theory.amplitude()


def bounced_height(bounces, height, number, per_contact):
    """Heights reached after `number` bounces, in the following twenty."""
    dt = theory.contact_time(theory.MASS) / per_contact
    period = 2 * math.sqrt(2 * height / theory.GRAVITY) + theory.contact_time(theory.MASS)
    rows = np.array(bounces(height, dt, 97, round((number + 20) * period / dt / 97) * 97))
    late = rows[-round(20 * period / dt / 97):]
    return late[late[:, 0] > 0.2 * height, 1]  # clear of the steps in which it leaves the plate


class Orders:
    """Mixed into a TestCase with `stack`, `overlap` and `schemes`."""

    def enter(self, quantity, step, value):
        """Into contact_motion.csv, in the engine whose rows it has."""

    def test_order_of_several_contacts_of_a_sphere(self):
        """Second without dashpots, first with: the engine's velocities are those of the half step before."""
        for scheme in self.schemes:
            for e, order in ((1, 2), (0.5, 1)):
                errors = [stack_error(self.stack, scheme, e, n) for n in RESOLUTIONS]
                found = math.log2(errors[0] / errors[-1]) / math.log2(RESOLUTIONS[-1] / RESOLUTIONS[0])
                print(f"{scheme}, e {e}: error over the amplitude",
                      ", ".join(f"t_c/{n} {error:.2g}" for n, error in zip(RESOLUTIONS, errors)), f"order {found:.2f}")
                quantity = f"error of a height over the amplitude, {scheme}, restitution {e}"
                for n, error in zip(RESOLUTIONS, errors):
                    self.enter(quantity, f"t_c/{n}", power(error))
                self.enter(quantity, "order", f"{found:.2f}")
                # The other order would be off by 1. With alpha dt = 0.05 at the longest step the next order adds a
                # twentieth to the first, and 0.05 to the fitted exponent; 0.3 is six times that.
                self.assertAlmostEqual(found, order, delta=0.3, msg=(scheme, e))

    def test_height_after_1000_elastic_bounces(self):
        """Elastic: rounding alone changes the height. At t_c/10 positions of 5e-4 m are rounded by 5.4e-20 m, over a
        step of 1.3e-5 s by 2.1e-13 of the speed of 0.02 m/s. In ten steps of 1020 impacts that is 2.15e-9 of the
        speed if all have one sign, 4.3e-9 of the height. 310 steps of each flight add 5.4e-20 m each, 0.9e-9 of the
        height of 2e-5 m."""
        limit = 5.2e-9
        height = 2e-5
        for per_contact in (4, 10):
            reached = bounced_height(self.bounces, height, 1000, per_contact)
            self.assertGreater(len(reached), 20)
            error = np.abs(reached / height - 1).max()
            print(f"height after 1000 bounces at t_c/{per_contact}: {error:.1e}")
            self.assertLess(error, limit)

    def test_a_load_on_a_resting_contact(self):
        """F/K' in the place of F/K with scheme exact, F/K with sampled."""
        dt = theory.contact_time(theory.MASS) / 10
        for scheme in self.schemes:
            more = {}
            for e, listed in LISTED.items():
                at_rest = theory.MASS * theory.GRAVITY / theory.K
                more[e] = 100 * (self.overlap(scheme, e, dt, 4000) / at_rest - 1)
                expected = 100 * (theory.K / theory.discrete_stiffness(e, theory.MASS, dt) - 1)
                # The mean over 200 oscillations of 1/40 the amplitude in whole and broken ones: below 1e-4.
                self.assertAlmostEqual(more[e], expected if scheme == "exact" else 0, delta=0.02, msg=(scheme, e))
                if scheme == "exact":
                    self.assertAlmostEqual(more[e], listed, delta=0.051, msg=e)
                    self.enter(f"overlap in excess of F/K [%], restitution {e}", "t_c/10", f"{more[e]:.2f}")
            print(f"{scheme}: a load presses more than F/K [%]", ", ".join(f"e {e} {x:.2f}" for e, x in more.items()))
