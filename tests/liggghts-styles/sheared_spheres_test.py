# SPDX-License-Identifier: BSD-3-Clause
"""Sheared smooth inelastic spheres through LIGGGHTS: balance of power, and kinetic theory (sheared_spheres.py)."""
import sys
import unittest
from concurrent.futures import ThreadPoolExecutor

import steady_spheres as spheres
from steady_spheres import theory


class Theory(unittest.TestCase):
    def test_nearly_elastic_limit(self):
        """The viscosity of a dilute gas falls by (1 + c)^-2, c = cooling rate/rate of the decay of stress =
        5 (1 - e^2)/12, of a denser one by less."""
        for fraction in (0.01, 0.2, 0.4):
            ratio = theory.steady(fraction, 0.9999).temperature / theory.nearly_elastic(fraction, 0.9999)
            self.assertLess(ratio, 1)
            self.assertGreater(ratio, 1 - 1.01 * 5 / 6 * (1 - 0.9999**2))

    def test_power(self):
        for restitution in (0.5, 0.9):
            state = theory.steady(0.2, restitution)
            work = -(state.kinetic + state.impulsive)[0, 1]
            self.assertLess(abs(work / state.dissipation - 1), 1e-9)


class Spheres(unittest.TestCase):
    def power(self, restitution, steps=4000, side=6, fraction=0.2, every=100):
        law, dt = spheres.hard_enough(fraction, min(restitution, 0.9), 0.015)
        law = spheres.Contact(law.duration, restitution)
        T = theory.steady(fraction, min(restitution, 0.9)).temperature
        table, done = spheres.run(side, fraction, law, T, dt, steps, before=2.0, sample=1, every=every, contacts=True)
        touches = spheres.Touches(done, law, dt)
        self.assertGreater(touches.count, 500)
        power = spheres.Power(table, touches, spheres.length(side, fraction)**3, dt, every)
        shares = [share / power.work for share in (power.gained, power.taken, power.rest)]
        print("e {}: of the work {:.4f} gained, {:.4f} taken, {:.5f} left".format(restitution, *shares),
              file=sys.stderr)
        return power, touches, T, table["T"].max()

    # Each contact is followed on a grid of pi/15 of its swing: its energy is what leapfrog keeps, within (pi/15)^2/8
    # of what it exchanges. All one way that would be half of the 1 % that is asked for.
    def test_work_is_what_the_contacts_take(self):
        for restitution in (0.5, 0.9):
            with self.subTest(restitution=restitution):
                power, *_ = self.power(restitution)
                self.assertGreater(power.taken, 3 * abs(power.gained))
                self.assertLess(abs(power.rest), 0.005 * power.work)

    def test_elastic_spheres_heat_as_they_are_sheared(self):
        power, touches, T, hottest = self.power(1.0)
        self.assertGreater(power.gained, 0.5 * 1.5 * T * 6**3)
        self.assertLess(abs(power.rest), 0.005 * power.work)
        # Taken is only what pairs in contact hold at one end more than at the other: no more than the energy of their
        # approach, T in the mean and as much its scatter. Sums of such, of a number of pairs that scatters as its root:
        # variance 2 T^2 times the number.
        pairs = len(touches.step) / len(set(touches.step))
        self.assertLess(abs(power.taken), hottest * (pairs + 5 * (2 * pairs)**0.5))

    def test_kinetic_theory(self):
        """Strains of 30 after 6; T forgets itself in a strain of some 2."""
        def against_theory(fraction, restitution):
            law, dt = spheres.hard_enough(fraction, restitution, 0.015)
            steps = round(30 / dt / 500) * 500
            T = theory.steady(fraction, restitution).temperature
            table, _ = spheres.run(8, fraction, law, T, dt, steps, before=6.0, sample=10, every=500)
            return spheres.against_theory(table, fraction, law, dt)

        cases = [(0.1, 0.9), (0.2, 0.9), (0.3, 0.9)]
        with ThreadPoolExecutor(2) as pool:
            for case, done in [(case, pool.submit(against_theory, *case)) for case in cases]:
                for name, ratio, room, error in done.result():
                    print(f"{case}: {name} over theory {ratio:.4f} +- {error:.4f}, room {room:.4f}", file=sys.stderr)
                    with self.subTest(case=case, of=name):
                        # Ten blocks know it within a factor of 2. The room is then no more than a fifth.
                        self.assertLess(error, 0.03)
                        self.assertLess(room, 0.2)
                        self.assertLess(abs(ratio - 1), room)


if __name__ == "__main__":
    unittest.main()
