# SPDX-License-Identifier: BSD-3-Clause
"""fix drive: the temperature that it keeps, momentum, and what it books, of hard and of soft spheres; ranks and restarts;
what it refuses."""
import re
import unittest
from pathlib import Path

import numpy

from cohesion_tests import lammps as engine
from cohesion_tests.lammps_scenes import hard_spheres as hard
from cohesion_tests.lammps_scenes.hard_gas import Gas
from cohesion_tests.lammps_scenes.small_box import box, spheres
from cohesion_tests.test_cases import FolderTestCase, ScriptTestCase
from cohesion_tests.thermo import thermo_columns

DT, STEPS, EVERY = 0.02, 40, 4
WAYS = ("by rescale", "by random seed 4711")


def script_with(columns):
    """in.hard_square_well with more columns in its thermo output."""
    text = engine.script_file("in.hard_square_well").read_text()
    return re.sub(r"(thermo_style .*)", r"\1 " + columns, text)


class HardSpheres(FolderTestCase):
    """500 of two sizes; restitution 0.8, wells."""

    def run_driven(self, words, gas, name="path.txt", ranks=1, every=EVERY, steps=STEPS, restart=False, keep=0):
        gas.write(self.folder)
        hard.script(self.folder, ["* * restitution 0.8 well 0.2 1.1"], f"record {name}", gas.dimension,
                    [f"fix drive all drive {EVERY} temperature 1.5 {words}"])
        code, output = engine.run_text(script_with("f_drive f_drive[1] f_drive[2] f_drive[3]"), self.folder,
                                       ranks=ranks, dt=DT, steps=steps, every=every, dimension=gas.dimension,
                                       boundary="p p p", skin=1.0, start="restart" if restart else "data", keep=keep)
        self.assertEqual(code, 0, output[-3000:])
        lines = (Path(self.folder) / name).read_text().splitlines()
        return thermo_columns(output), engine.dumps(self.folder, "path.txt"), [x for x in lines if x[:1] != "#"]

    def test_keeps_temperature_and_momentum_and_books_what_it_gives(self):
        """Sums of 500 particles: rounding to 1e-12; energies of 3e4 events, 1e-15 of the whole each."""
        for dimension in (2, 3):
            gas = Gas(500, 0.3, dimension, (0.4, 0.6))
            for words in WAYS:
                with self.subTest(words, dimension=dimension):
                    table, path, _ = self.run_driven(words, gas)
                    mass = gas.mass.sum()
                    temperature = 2 * table["KinEng"] / mass / dimension
                    self.assertLess(abs(temperature[1:] - 1.5).max(), 1e-11)
                    for snapshot in path:
                        order = snapshot[:, 0].astype(int) - 1
                        self.assertLess(abs(gas.mass[order] @ snapshot[:, 4:7]).max(), 1e-10)
                    lost = -sum(table[f"c_events[{k}]"] for k in range(5, 9))
                    balance = table["KinEng"] + lost - table["f_drive"]
                    self.assertGreater(table["f_drive"][-1], 0.2 * table["KinEng"][0])
                    self.assertLess(numpy.ptp(balance), 1e-9)
                    self.assertLess(table["f_drive[1]"][-1], 1.5)  # what collisions had left of it
                    self.assertEqual(table["f_drive[3]"][-1], 0)
                    # The straight line between what it leaves and what it finds
                    grown = numpy.diff(table["f_drive[2]"])[1:]
                    self.assertLess(abs(grown - EVERY * DT * (1.5 + table["f_drive[1]"][2:]) / 2).max(), 1e-11)

    def test_random_accelerations_only_heat(self):
        """Elastic spheres, above the temperature that is asked for: nothing is done."""
        gas = Gas(100, 0.3)
        gas.v *= 2
        gas.write(self.folder)
        hard.script(self.folder, ["* * restitution 1"], "", 3, ["fix drive all drive 1 temperature 1 by random seed 1"])
        code, output = engine.run_text(script_with("f_drive f_drive[1] f_drive[3]"), self.folder, dt=DT, steps=20,
                                       every=20, dimension=3, boundary="p p p", skin=1.0, start="data", keep=0)
        self.assertEqual(code, 0, output[-3000:])
        table = thermo_columns(output)
        self.assertEqual(table["f_drive"][-1], 0)
        self.assertEqual(table["f_drive[3]"][-1], 20)
        self.assertAlmostEqual(table["f_drive[1]"][-1], 4, delta=1e-11)

    def test_ranks_and_restarts_are_the_same_to_the_last_digit(self):
        gas = Gas(200, 0.3, 3, (0.4, 0.6))
        for words in WAYS:
            table, path, events = self.run_driven(words, gas, "one")
            self.assertGreater(len(events), 1200)
            with self.subTest(words, ranks=2):
                again, other, found = self.run_driven(words, gas, "two", 2)
                self.assertTrue(found == events)
                numpy.testing.assert_array_equal(other[-1], path[-1])
                for column in ("f_drive", "f_drive[1]", "f_drive[2]"):
                    numpy.testing.assert_array_equal(again[column], table[column])
            # A file between two actions; the next would be due after the end.
            half = STEPS // 2 + 1
            table, path, events = self.run_driven(words, gas, "kept", keep=half, every=STEPS)
            with self.subTest(words, restarted_on=2):
                again, other, found = self.run_driven(words, gas, "again", 2, keep=half, every=STEPS,
                                                      restart=True)
                self.assertTrue(found == [line for line in events if int(line.split()[0]) > half])
                numpy.testing.assert_array_equal(other[-1], path[-1])
                for column in ("f_drive", "f_drive[1]", "f_drive[2]"):
                    self.assertEqual(again[column][-1], table[column][-1])


SOFT = """
plugin load ${plugin}
units lj
atom_style sphere
boundary p p p
newton off
comm_modify vel yes
region box %s 0 10 0 10 0 10%s units box
lattice sc 0.512
create_box 1 box
create_atoms 1 box
set group all diameter 1 density $(6/PI)
velocity all create 1 5 mom yes rot no dist gaussian loop all
pair_style gran/hamaker
pair_coeff * * stiffness 20000 restitution 0.9 %s
neighbor 0.3 bin
neigh_modify delay 0 every 1 check yes
%s
fix move all nve/sphere
%s
fix drive all drive 20 temperature 1 %s
timestep 3.925e-4
%s
compute flow all shear/profile
variable px equal vcm(all,x)
thermo_style custom step temp f_drive f_drive[1] f_drive[2] c_flow c_flow[1] v_px %s
thermo_modify norm no lost error format float %%.17g
thermo %d
run %d
"""
TALLY = "c_tally[*]"
# All velocities by some units of their last digit
NUDGE = "variable nudged atom vx*(1+1e-15*sin(id))\nvelocity all set v_nudged NULL NULL"


class SoftSpheres(FolderTestCase):
    """512 at a fortieth of the contact time, with and without the Hamaker attraction."""

    def go(self, words, adhesion="", steps=12000, shear="", columns=TALLY, nudge="", ranks=1, every=1000):
        tilt = " 0 0 0" if shear else ""
        tally = "" if shear else "compute tally all gran/energy"
        text = SOFT % ("prism" if shear else "block", tilt, adhesion, shear, nudge, words, tally, columns, every, steps)
        code, output = engine.run_text(text, self.folder, ranks=ranks)
        self.assertEqual(code, 0, output[-3000:])
        return thermo_columns(output)

    def test_power_put_in_is_power_lost(self):
        """To 1e-5, what the accounts of contacts leave open."""
        for words, adhesion in zip(WAYS, ("", "hamaker 0.02 cutoff 0.005 0.05")):
            with self.subTest(words, adhesion=adhesion):
                table = self.go(words, adhesion)
                put_in = numpy.ptp(table["f_drive"])
                stored = table["c_tally"] if "c_tally" in table else sum(table[f"c_tally[{k}]"] for k in range(1, 6))
                lost = numpy.ptp(table["c_tally[6]"]) + stored[-1] - stored[0]
                self.assertGreater(put_in, 1000)
                self.assertAlmostEqual(put_in / lost, 1, delta=1e-5)
                # The tally does not know of it: what the fix gives is what it misses.
                self.assertAlmostEqual(numpy.ptp(table["c_tally[10]"]) / put_in, 1, delta=1e-5)
                # A pair across a periodic face is computed from both sides, from places that differ by rounding, 2e-15 of
                # 10: over a step that is a speed of 5e-12, and what bounces ten times at an edge within a step makes it
                # a thousand times as much.
                self.assertLess(abs(table["v_px"]).max(), 1e-12 if not adhesion else 1e-8)
                self.assertAlmostEqual(table["c_flow"][-1], 1, delta=0.02)

    def test_ranks_part_as_rounding_does(self):
        """Forces are added up in the order of the ranks, and collisions make rounding grow. Two ranks round another way in
        every step, so that they part from one sooner than a run whose velocities were changed in the last digit once: by
        sqrt(2000 steps) = 45 at most, and as much again for the luck of either."""
        for words in WAYS:
            with self.subTest(words):
                one, two, nudged = (
                    self.go(words, "hamaker 0.02 cutoff 0.005 0.05", steps=2000, every=100, **how)["f_drive"][1:]
                    for how in ({}, {"ranks": 2}, {"nudge": NUDGE}))
                self.assertGreater(one[-1], 100)
                by_ranks, by_rounding = (numpy.maximum.accumulate(abs(other / one - 1)) for other in (two, nudged))
                self.assertLess((by_ranks / (by_rounding + 1e-15)).max(), 45**2)
                self.assertLess(by_ranks[0], 1e-12)

    def test_about_the_flow_of_a_sheared_box(self):
        """Sheared at the rate 0.3 across 10 diameters the mean flow has half the energy of the motion about it, and shear
        heats less than collisions take. About the line that fits best there is less motion than about the flow that is
        imposed, by one of 1500 parts. The slope of that line is known to sqrt(T/(N <y^2>)) = 0.015: six of these."""
        for words in WAYS:
            table = self.go(words, steps=2000, shear="fix shear all deform/shear rate 0.3", columns="")
            self.assertAlmostEqual(table["c_flow"][-1], 1, delta=0.01)
            self.assertAlmostEqual(table["c_flow[1]"][-1], 0.3, delta=0.1)


HEAD = box() + spheres((1, 0.002, 0.005, 0.005), (1, 0.006, 0.005, 0.005)) + """
pair_style hard/squarewell
pair_coeff * * restitution 1
fix move all nve/sphere
timestep 1e-4
"""


class Input(ScriptTestCase):
    def test_wrong_words(self):
        for words, expected in (
                ("", "fix d drive takes 'N', every so many steps, and 'temperature T'"),
                ("0 temperature 1", "fix d drive: N is 0; it must be 1 or more"),
                ("1", "give 'temperature T', which it keeps"),
                ("1 temperature", "temperature takes a value"),
                ("1 temperature 0", "temperature 0; it must be a finite number above 0"),
                ("1 temperature -2", "temperature -2; it must be a finite number above 0"),
                ("1 temperature 1 by heat", "by 'heat'; valid ones: rescale, random"),
                ("1 temperature 1 by random", "random accelerations need 'seed S'"),
                ("1 temperature 1 by random seed 0", "seed 0; it must be 1 or more"),
                ("1 temperature 1 seed 5", "seed 5 is for 'by random'"),
                ("1 temperature 1 every 5", "unknown keyword 'every'; valid ones: temperature, by, seed"),
                ("1 temperature 1 temperature 2", "keyword 'temperature' is there twice, with 1 and with 2")):
            with self.subTest(words):
                self.stops(f"{HEAD}fix d all drive {words}\n", expected)

    def test_nothing_to_drive(self):
        self.stops(HEAD + "fix d all drive 1 temperature 1\nrun 1\n",
                   "no motion about their mean velocity that could be scaled")
        self.stops(HEAD + "group one id 1\nfix d one drive 1 temperature 1\nrun 1\n",
                   "its group 'one' has 1 particles; motion about their mean velocity takes two or more")

    def test_random_accelerations_start_from_rest(self):
        output = self.goes(HEAD + "fix d all drive 1 temperature 0.01 by random seed 3\n"
                                  "thermo_style custom step f_d f_d[1]\nrun 3\n")
        self.assertGreater(thermo_columns(output)["f_d"][-1], 0)


if __name__ == "__main__":
    unittest.main()
