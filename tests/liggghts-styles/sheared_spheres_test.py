# SPDX-License-Identifier: BSD-3-Clause
"""Sheared smooth inelastic spheres through LIGGGHTS: balance of power, and kinetic theory (sheared_spheres.py)."""
import math
import sys
import unittest
from concurrent.futures import ThreadPoolExecutor

import numpy
from scipy.optimize import brentq

from cohesion_tests import csv_table
from cohesion_tests.liggghts_scenes import steady_spheres as spheres
from cohesion_tests.liggghts_scenes.steady_spheres import theory


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


class Softness(unittest.TestCase):
    """1 - d of the hard spheres that do to each other in one encounter what soft ones do."""
    STIFF = 1e4  # w over relative speed/diameter: the second order is some 1e-4 of the first

    def encounter(self, b):
        """Integral of the square of the radial speed over the contact, over that of a head-on one, and the angle that
        the line of centres turns, relative speed and diameter 1, impact parameter b."""
        def square(r):
            return 1 - self.STIFF**2 * (1 - r)**2 - b**2 / r**2
        nearest = brentq(square, 1 - 2 / self.STIFF, 1, xtol=1e-18, rtol=1e-15)
        x, weight = numpy.polynomial.legendre.leggauss(40)
        x, weight = (1 + x) / 2, weight / 2
        r = nearest + (1 - nearest) * x**2
        speed, dr = numpy.sqrt(square(r)), (1 - nearest) * 2 * x * weight
        return 2 * (speed * dr).sum() * 2 * self.STIFF / math.pi, 2 * (b / r**2 / speed * dr).sum()

    def test_shares_of_barker_and_hendersons_diameter(self):
        s, weight = numpy.polynomial.legendre.leggauss(60)
        b, weight = numpy.sqrt((1 + s) / 2), weight / 2
        lost, turned = numpy.array([self.encounter(x) for x in b]).T
        # Of hard spheres 1/2 and 2/3, which go as d^2: mean over b^2 of the loss, and of sin^2 of the deflection.
        smaller = [(1 - (weight * lost).sum() * 2) / 2,
                   (1 - (weight * numpy.sin(2 * numpy.arcsin(b) + turned)**2).sum() * 1.5) / 2]
        # In units of speed/w. Mean speeds, over sqrt(T), where dissipation weighs with u^5 and viscosity with u^7.
        speeds = [2 * math.gamma(3.5) / math.gamma(3), 2 * math.gamma(4.5) / math.gamma(4)]
        law = spheres.Contact(math.pi / self.STIFF, 1.0)
        for name, one, speed, share in zip(("dissipation", "viscosity"), smaller, speeds,
                                           (spheres.DISSIPATION_SHARE, spheres.VISCOSITY_SHARE)):
            print(name, one * speed / (1 - law.diameter(1.0)), share, file=sys.stderr)
            self.assertLess(abs(one * speed / (1 - law.diameter(1.0)) / share - 1), 1e-3)


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

    # Each contact is resolved on a grid of pi/15 of its swing: its energy is what leapfrog keeps, within (pi/15)^2/8
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

    # (fraction, overlap, strain): blocks of two memories of T and more.
    SCALED = {"viscosity": "viscosity / T^0.5", "contact stress": "contact stress / T",
              "dissipation": "dissipation / T^1.5"}
    CASES = [(0.1, 0.03, 90), (0.2, 0.015, 70), (0.3, 0.015, 60)]

    def test_kinetic_theory(self):
        def against_theory(fraction, overlap, strain, restitution=0.9, side=8, every=500):
            law, dt = spheres.hard_enough(fraction, restitution, overlap, steps=10)
            steps = round(strain / dt / every / spheres.BLOCKS) * every * spheres.BLOCKS
            T = theory.steady(fraction, restitution).temperature
            table, _ = spheres.run(side, fraction, law, T, dt, steps, before=6.0, sample=5, every=every)
            return spheres.against_theory(table, fraction, law, dt, every, spheres.length(side, fraction)**3)

        rooms = {}
        with ThreadPoolExecutor(2) as pool:
            for case, done in [(case, pool.submit(against_theory, *case)) for case in self.CASES]:
                for name, ratio, room, error in done.result():
                    print(f"{case[0]}: {name} over theory {ratio:.4f} +- {error:.4f}, room {room:.4f}", file=sys.stderr)
                    csv_table.enter_quantities(csv_table.of_test("sheared_spheres"), "smooth spheres over kinetic theory",
                                               f"{case[0]}", {self.SCALED.get(name, name): f"{ratio:.3f} +- {error:.3f}"})
                    rooms.setdefault(name, []).append(room)
                    with self.subTest(case=case, of=name):
                        self.assertLess(abs(ratio - 1), room)
        # T goes as the square of the rate: 15 % less is seen wherever in the room the truth lies. (Ten blocks know the
        # standard error to a quarter of it.)
        self.assertLess(2 * min(rooms["T"]), 1 - 0.85**2)


if __name__ == "__main__":
    unittest.main()
