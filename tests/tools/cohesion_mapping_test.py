# SPDX-License-Identifier: BSD-3-Clause
"""cohesion-mapping: the thesis's table, both ways, and what it refuses."""
import math
import sys
import unittest

from scipy.optimize import brentq

from cohesion_tests import mapping as program
from cohesion_tests.theory import pair_motion
from cohesion_tests.theory.pair_motion import MU, Pair

CONTACT = ("--radius", 5e-4, "--density", 2650, "--stiffness", 800, "--cutoff", 4e-10, 1e-7)
BED = (*CONTACT, "--damping", 0.79e-3)
DEPTHS = (1e-11, 5e-11, 1e-10)


class ThesisTable(unittest.TestCase):
    def test_against_an_integration_of_the_motion(self):
        # The integration is good to 1e-9 of the energy, of which the search for A keeps half.
        restitution = math.exp(-pair_motion.ALPHA * pair_motion.CONTACT_TIME)
        for row in program.table("to-hamaker", *BED, "--depth", *DEPTHS):
            speed = math.sqrt(2 * row["depth"] / MU * (1 / restitution**2 - 1))
            constant = 1e-19 * brentq(lambda a: Pair(a * 1e-19).energy_after_contact(speed), 1, 20,
                                      rtol=1e-12)
            print(f"D {row['depth']:g} J: A {row['hamaker_constant']:.10g} J, by integration "
                  f"{constant:.10g} J", file=sys.stderr)
            self.assertAlmostEqual(row["hamaker_constant"] / constant, 1, delta=1e-8)
            self.assertAlmostEqual(row["hamaker_mean"] / speed, 1, delta=1e-12)
            self.assertAlmostEqual(row["well_mean"] / speed, 1, delta=1e-12)

    def test_there_and_back(self):
        for kind in ((), ("--wall",), ("--form", "exact", "--asperity", 1e-8), ("--roughness", 5e-9, 5e-7)):
            there = program.table("to-hamaker", *BED, *kind, "--depth", *DEPTHS)
            back = program.table("to-well", *BED, *kind, "--hamaker",
                                 *(repr(row["hamaker_constant"]) for row in there))
            for depth, row in zip(DEPTHS, back):
                # Roundings of v_esc, as in equal_escape_test.cpp.
                self.assertAlmostEqual(row["depth"] / depth, 1, delta=1e-11)

    def test_damping_and_mass_as_restitution_and_density(self):
        restitution = math.exp(-pair_motion.ALPHA * pair_motion.CONTACT_TIME)
        one, = program.table("to-well", *BED, "--hamaker", 7.49e-19)
        other, = program.table("to-well", "--radius", 5e-4, "--mass", repr(pair_motion.MASS),
                               "--stiffness", 800, "--cutoff", 4e-10, 1e-7, "--restitution",
                               repr(restitution), "--hamaker", 7.49e-19)
        for name in one:
            self.assertAlmostEqual(one[name] / other[name], 1, delta=1e-12, msg=name)

    def test_unlike_spheres_reach_the_wall(self):
        # A second sphere a million times larger is a wall: R* and mu are off by 1e-6.
        wall, = program.table("to-well", *BED, "--wall", "--hamaker", 7.49e-19)
        large, = program.table("to-well", "--radius", 5e-4, 500, *BED[2:], "--hamaker", 7.49e-19)
        self.assertAlmostEqual(wall["depth"] / large["depth"], 1, delta=1e-5)
        alike, = program.table("to-well", *BED, "--hamaker", 7.49e-19)
        self.assertNotAlmostEqual(wall["depth"] / alike["depth"], 1, delta=0.1)


class Sampled(unittest.TestCase):
    def test_each_law_through_its_scheme(self):
        step = 2.25e-5
        exact, = program.table("to-hamaker", *BED, "--depth", 5e-11)
        for schemes in (("--hamaker-scheme", "sampled"), ("--well-scheme", "sampled"),
                        ("--hamaker-scheme", "sampled", "--well-scheme", "sampled")):
            row, = program.table("to-hamaker", *BED, *schemes, "--step", step, "--depth", 5e-11)
            # The search ends within twice the sampling error of a thousandth.
            self.assertAlmostEqual(row["hamaker_mean"] / row["well_mean"], 1, delta=2.1e-3)
            sampled = "--hamaker-scheme" in schemes
            self.assertEqual(row["hamaker_slowest_parted"] < row["hamaker_mean"], sampled)
            self.assertEqual(row["hamaker_constant"] > 1.05 * exact["hamaker_constant"], sampled)


class FormerWords(unittest.TestCase):
    def test_scheme_event(self):
        words = ("to-hamaker", *BED, "--depth", 5e-11)
        _, expected, silent = program.call(*words, "--hamaker-scheme", "exact", "--well-scheme", "exact")
        self.assertEqual(silent, "")
        self.assertEqual(program.text(*words), expected)  # the default
        self.assertIn("scheme exact", expected)
        for schemes in (("--hamaker-scheme", "event"), ("--hamaker-scheme", "event", "--well-scheme", "event")):
            code, output, error = program.call(*words, *schemes)
            self.assertEqual((code, output), (0, expected), error)
            self.assertEqual(error, "cohesion-mapping: scheme 'event' is now called 'exact'; write 'exact', since from "
                                    "version 0.4.0 on the old word stops the run\n")


class Refusals(unittest.TestCase):
    def refused(self, *words, says, usage=False):
        code, output, error = program.call(*words)
        self.assertNotEqual(code, 0)
        self.assertGreater(code, 0, "ended by a signal")
        self.assertEqual(output, "")
        for part in says:
            self.assertIn(part, error)
        self.assertEqual("--help" in error, usage, error)

    def test_command_lines(self):
        hamaker = ("--hamaker", 1e-19)
        self.refused(says=["subcommand"], usage=True)
        self.refused("to-well", *BED, says=["--hamaker", "required"], usage=True)
        self.refused("to-well", *CONTACT, *hamaker, says=["restitution", "damping"], usage=True)
        self.refused("to-well", *BED, *hamaker, "--restitution", 0.9, says=["damping"], usage=True)
        self.refused("to-well", *BED, "--hamaker", "1e-19J", says=["--hamaker", "1e-19J"], usage=True)
        self.refused("to-well", *BED, *hamaker, "--form", "round", says=["round", "small_gap"],
                     usage=True)
        self.refused("to-well", *BED, *hamaker, "--wel-scheme", "exact", says=["--wel-scheme"],
                     usage=True)

    def test_given_twice(self):
        self.refused("to-well", *BED, "--hamaker", 1e-19, "--hamaker", 2e-19, says=["--hamaker", "twice"], usage=True)
        self.refused("to-hamaker", *BED, "--depth", 1e-11, "--depth=2e-11", says=["--depth", "twice"], usage=True)
        for name, value in (("--radius", 1e-3), ("--density", 1000)):
            self.refused("to-well", *BED, "--hamaker", 1e-19, name, value, says=[name, "twice"], usage=True)
        self.refused("to-well", *BED[:2], "--mass", 1e-6, "--mass", 2e-6, *BED[4:], "--hamaker", 1e-19,
                     says=["--mass", "twice"], usage=True)

    def test_values(self):
        hamaker = ("--hamaker", 1e-19)
        at_step = ("--hamaker-scheme", "sampled", "--step")
        self.refused("to-well", *BED, "--hamaker", -1, says=["Hamaker constant", "-1"])
        self.refused("to-well", *BED, "--hamaker", "nan", says=["Hamaker constant", "nan"])
        self.refused("to-hamaker", *BED, "--depth", 0, says=["depth"])
        self.refused("to-well", *CONTACT, "--restitution", 1, *hamaker, says=["restitution", "1"])
        self.refused("to-well", *CONTACT, "--restitution", 1.5, *hamaker, says=["restitution", "1.5"])
        self.refused("to-well", *CONTACT, "--damping", -1, *hamaker, says=["damping"])
        self.refused("to-well", *CONTACT, "--damping", 1, *hamaker, says=["restitution e = 0"])
        self.refused("to-well", *BED, *hamaker, *at_step, 1, says=["time step", "half a contact time"])
        self.refused("to-well", *BED, *hamaker, *at_step[:2], says=["time step", "--step"])
        self.refused("to-well", *BED, *hamaker, "--step", 1e-6, says=["time step", "exact"])
        self.refused("to-well", *BED, *hamaker, "--ratio", 0.9, says=["ratio", "0.9"])
        self.refused("to-well", *BED, *hamaker, "--ratio", 1.00001, "--well-scheme", "sampled",
                     "--step", 2.25e-5, says=["width of the well"])
        self.refused("to-well", "--radius", 5e-4, 1e-3, *BED[2:], *hamaker, "--wall",
                     says=["second particle"])
        self.refused("to-well", "--radius", 0, *BED[2:], *hamaker, says=["radius = 0"])


if __name__ == "__main__":
    unittest.main()
