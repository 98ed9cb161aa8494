# SPDX-License-Identifier: BSD-3-Clause
"""fix drive in LIGGGHTS: the temperature that it keeps, momentum, what it books against what contacts lose, a sheared box,
ranks, and what it refuses. The laws and what else they do: tests/src/driving, tests/lammps-package/drive_test.py."""
import math
import unittest

import numpy

from cohesion_tests.liggghts import Run, assert_refused
from cohesion_tests.liggghts_scenes.scene import DAMPING, DENSITY, STIFFNESS, hamaker, script, sphere
from cohesion_tests.liggghts_scenes.sheared_scene import PLAIN, RATE, gas, sheared, sides
from cohesion_tests.thermo import thermo_lines

TEMPERATURE = 0.01  # [m2/s2]
WAYS = ("by rescale", "by random seed 4711")
SMOOTH = "model hooke/stiffness tangential off cohesion hamaker absolute_damping on"
EVERY = 20
MASS = DENSITY * 4 / 3 * math.pi * 0.45e-3**3
CONTACT = math.pi / math.sqrt(STIFFNESS / (MASS / 2) - (DAMPING / MASS)**2)
DT = CONTACT / 40
# Resolved by 25 steps; as deep as a third of a grain's m T
ADHESION = hamaker(4e-10, cut=5e-6, out=4e-5)
NONE = hamaker(0)


def drive(words, temperature=TEMPERATURE):
    return f"fix drive all drive {EVERY} temperature {temperature!r} {words}\n"


def printed(columns, every):
    words = columns.split()
    return (f"thermo_style custom step {columns}\nthermo {every}\nthermo_modify norm no lost error "
            + " ".join(f"format {k} %.17g" for k in range(2, len(words) + 2)) + "\n")


def table_of(test, run, columns):
    """Columns of its thermo output by the words that asked for them; the engine shortens its own."""
    test.assertEqual(run.code, 0, run.output[-2000:])
    return dict(zip(["step", *columns.split()], numpy.array(thermo_lines(run.files["log.liggghts"])[1]).T))


def go(test, words, cohesion=NONE, steps=8000, dt=DT, ranks=0):
    """240 spheres in a periodic box, a fifth of it solid; restitution 0.94."""
    columns = "f_drive f_drive[1] f_drive[2] f_drive[3] c_tally c_tally[6] c_tally[10]"
    run = Run(script(gas(), SMOOTH, cohesion, dt=dt, steps=steps, every=1000, boundary="p p p", box=sides(),
                     extra=drive(words) + "compute tally all gran/energy\n" + printed(columns, EVERY)), ranks=ranks)
    return run, table_of(test, run, columns)


class Gas(unittest.TestCase):
    def test_keeps_temperature_and_momentum_and_books_what_contacts_lose(self):
        """Energies: the velocities of the grid in a contact have an amplitude whose square is less than that of the true
        ones by (pi dt/t_c)^2/4, 1.5e-3 at a fortieth of the contact time, and what dashpots take goes with it; half the step
        leaves a quarter. That is the error of the contacts and of their tally, which gases that cool have as well. With the
        attraction 4e-3 more: where it sets in at H_cut its slope of 2 F/H_cut, 240 N/m, does, and with it what leapfrog
        takes for the energy, by 240 N/m (v dt)^2/12 = 4e-12 J at 0.23 m/s, twice for a collision that loses 2e-9 J.
        Temperature and momentum are those of the dumped velocities: rounding of 240 numbers, in 8000 steps and more."""
        for words in WAYS:
            for cohesion, finer, of_attraction in ((NONE, 1, 0), (NONE, 2, 0), (ADHESION, 1, 4e-3)):
                off = (math.pi * DT / finer / CONTACT)**2 / 4 + of_attraction
                with self.subTest(words, allowed=off):
                    run, table = go(self, words, cohesion, 8000 * finer, DT / finer)
                    velocities = [numpy.array([frame[i][3:6] for i in sorted(frame)]) for frame in run.frames("out.txt")]
                    # Random accelerations leave what is warmer, as springs give back what they hold.
                    before = table["f_drive[1]"]
                    after = numpy.maximum(before, TEMPERATURE) if "random" in words else TEMPERATURE + 0 * before
                    for v, theta in zip(velocities[1:], after[::1000 // EVERY][1:], strict=True):
                        own = v - v.mean(axis=0)
                        self.assertLess(abs((own**2).sum() / own.size / theta - 1), 1e-12)
                        self.assertLess(abs(v.mean(axis=0) - velocities[0].mean(axis=0)).max(), 1e-12)
                    put_in = table["f_drive"][-1]
                    kinetic = 1.5 * len(velocities[0]) * MASS * TEMPERATURE
                    self.assertGreater(put_in, 0.2 * kinetic)
                    grown = {name: column[-1] - column[0] for name, column in table.items()}
                    lost = grown["c_tally[6]"] + grown["c_tally"]
                    self.assertAlmostEqual(put_in / lost, 1, delta=off)
                    # The tally does not know of it: what the fix gives is what it misses.
                    self.assertAlmostEqual(grown["c_tally[10]"] / put_in, 1, delta=off)
                    # The straight line between what it leaves and what it finds
                    line = EVERY * DT / finer * (after[1:-1] + before[2:]) / 2
                    self.assertLess(abs(numpy.diff(table["f_drive[2]"])[1:] / line - 1).max(), 1e-10)

    def test_random_accelerations_only_heat(self):
        columns = "f_drive f_drive[1] f_drive[3]"
        run = Run(script(gas(), SMOOTH, NONE, dt=DT, steps=200, boundary="p p p", box=sides(), every=200,
                         extra=drive("by random seed 1", TEMPERATURE / 4) + printed(columns, 200)))
        table = table_of(self, run, columns)
        self.assertEqual(table["f_drive"][-1], 0)
        self.assertEqual(table["f_drive[3]"][-1], 200 / EVERY)
        self.assertGreater(table["f_drive[1]"][-1], TEMPERATURE / 4)

    def test_two_ranks(self):
        """Within a third of a collision of each rounding has not grown by much: 1e-16 of the speeds, of which a step's
        difference of 1e-3 of the temperature is taken, and 1000 of these."""
        for words in WAYS:
            with self.subTest(words):
                one, two = (go(self, words, ADHESION, steps=400, ranks=ranks)[1]["f_drive"] for ranks in (0, 2))
                self.assertGreater(abs(one[-1]), 0)
                self.assertLess(abs(two[1:] / one[1:] - 1).max(), 1e-10)

    def test_about_the_flow_of_a_sheared_box(self):
        """The mean flow has twice the energy of the motion about it. About the line that fits best there is less motion
        than about the flow that is imposed, by one of 360 parts. The slope of that line is known to sqrt(T/(N <y^2>)), six
        of which are allowed."""
        spheres = gas()
        slope = math.sqrt(TEMPERATURE / (len(spheres) * 8e-3**2 / 12))
        self.assertLess(6 * slope, 0.4 * RATE)
        for words in WAYS:
            with self.subTest(words):
                run = Run(sheared(spheres, SMOOTH, NONE, profile="yes", dt=DT, steps=2000, every=2000,
                                  extra=drive(words) + "compute flow all shear/profile\n"
                                  + printed("c_flow c_flow[1]", 1000)))
                table = table_of(self, run, "c_flow c_flow[1]")
                self.assertAlmostEqual(table["c_flow"][-1] / TEMPERATURE, 1, delta=0.01)
                self.assertAlmostEqual(table["c_flow[1]"][-1], RATE, delta=6 * slope)


class Refusals(unittest.TestCase):
    def stop(self, fixes, *words, spheres=None, begun=False):
        spheres = spheres or [sphere((2e-3, 4e-3, 3e-3), (0.1, 0, 0)), sphere((7e-3, 4e-3, 3e-3))]
        run = Run(script(spheres, PLAIN, box=sides(), boundary="p p p", steps=1, extra=fixes))
        with self.subTest(fixes):
            assert_refused(self, run, *words, begun=begun)

    def test_words(self):
        for words, expected in (
                ("0 temperature 1", "N is 0; it must be 1 or more"),
                ("1", "give 'temperature T', which it keeps"),
                ("1 temperature -2", "temperature -2; it must be a finite number above 0"),
                ("1 temperature 1 by heat", "by 'heat'; valid ones: rescale, random"),
                ("1 temperature 1 by random", "random accelerations need 'seed S'"),
                ("1 temperature 1 every 5", "unknown keyword 'every'; valid ones: temperature, by, seed")):
            self.stop(f"fix d all drive {words}\n", "fix d drive", expected)

    def test_nothing_to_drive(self):
        still = [sphere((2e-3, 4e-3, 3e-3)), sphere((7e-3, 4e-3, 3e-3))]
        self.stop("fix d all drive 1 temperature 1\n", "no motion about their mean velocity that could be scaled",
                  spheres=still, begun=True)
        self.stop("group one id 1\nfix d one drive 1 temperature 1\n", "its group 'one' has 1 particles")


if __name__ == "__main__":
    unittest.main()
