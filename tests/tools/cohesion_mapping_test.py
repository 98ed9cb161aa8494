# SPDX-License-Identifier: BSD-3-Clause
"""cohesion-mapping: the thesis's table, both ways, the numbers of elastic contacts, and what it refuses."""
import csv
import math
import sys
import unittest

from scipy.optimize import brentq

from cohesion_tests import mapping as program
from cohesion_tests.theory import pair_motion
from cohesion_tests.theory.hertz_contact import HertzPair
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


class Contact(unittest.TestCase):
    """Hertz's and JKR's contact of two spheres of 1 mm, E 5 GPa, nu 0.25, against closed forms."""
    PAIR = ("contact", "--radius", 5e-4, "--density", 2650, "--young", 5e9, "--poisson", 0.25)
    RADIUS, MODULUS, REDUCED = 2.5e-4, 5e9 / (2 * (1 - 0.25**2)), 0.5 * 2650 * 4 / 3 * math.pi * 5e-4**3
    GAMMA = 0.05
    PLANNED = 0.999  # of the stable step: a thousandth is left to the rounding of printed numbers (advised_step.h)

    def near(self, found, expected, relative=1e-12):
        self.assertAlmostEqual(found / expected, 1, delta=relative)

    def values(self, *words):
        code, output, error = program.call(*self.PAIR, *words, "--csv")
        self.assertEqual(code, 0, error)
        return {row["name"]: float(row["value"]) for row in csv.DictReader(output.splitlines())}

    def stable_step(self, overlap, restitution, nu=0.25):
        """The largest step in which both inequalities of docs/theory/contact_steps.md hold for Hertz's contact with
        friction: 4 s < 4 and 40/7 s_t < 4, s = (K + 2 eta/dt) dt^2/m, that of sliding with m = 2/7 mu. Constants at
        this overlap: K = 2 E* a, eta = 2 sqrt(5/6) beta sqrt(K mu); K_t = c K and, as in LIGGGHTS, eta_t = sqrt(c) eta
        with c = 2 (1 - nu)/(2 - nu)."""
        stiffness = 2 * self.MODULUS * math.sqrt(self.RADIUS * overlap)
        beta = -math.log(restitution) / math.hypot(math.pi, math.log(restitution))
        damping = 2 * math.sqrt(5 / 6) * beta * math.sqrt(stiffness * self.REDUCED)
        ratio = 2 * (1 - nu) / (2 - nu)

        def end(k, eta, bound):
            """Of k dt^2 + 2 eta dt < bound."""
            return (math.sqrt(eta**2 + k * bound) - eta) / k
        return min(end(stiffness, damping, self.REDUCED),
                   end(ratio * stiffness, math.sqrt(ratio) * damping, 4 * 7 / 40 * 2 / 7 * self.REDUCED))

    def test_jkr(self):
        found = self.values("--surface-energy", self.GAMMA, "--restitution", 1)
        work = 2 * self.GAMMA
        self.near(found["reduced_modulus"], self.MODULUS)
        self.near(found["pull_off"], 1.5 * math.pi * work * self.RADIUS)
        self.near(found["tearing_gap"], 0.75 * (math.pi**2 * work**2 * self.RADIUS / self.MODULUS**2)**(1 / 3))
        # What Thornton and Ning's neck takes; the speed is bisected to 1e-5.
        lost = 7.0922 * (work**5 * self.RADIUS**4 / self.MODULUS**2)**(1 / 3)
        self.near(found["escape_velocity"], math.sqrt(2 * lost / self.REDUCED), 1e-4)
        # Of a sphere on a wall, in their form, three digits.
        wall = self.values("--wall", "--surface-energy", self.GAMMA, "--restitution", 1)
        self.near(wall["escape_velocity"], 1.84 * ((work / 5e-4)**5 / (2650**3 * self.MODULUS**2))**(1 / 6), 3e-3)
        self.assertNotIn("well_depth", found)

    def test_hertz(self):
        found = self.values("--hamaker", 7.49e-19, "--cutoff", 4e-10, 1e-7)
        force = 7.49e-19 * self.RADIUS / (6 * 4e-10**2)
        self.near(found["pull_off"], force)
        # The largest overlap takes what comes in and what the force does; Hertz's time is that of its radius of contact.
        overlap, coefficient = found["overlap"], 4 / 3 * self.MODULUS * math.sqrt(self.RADIUS)
        tail = force * (2 * 4e-10 - 4e-10**2 / 1e-7)
        energy = 0.5 * self.REDUCED * found["escape_velocity"]**2 + tail + force * overlap
        self.near(0.4 * coefficient * overlap**2.5, energy, 1e-9)
        self.near(found["contact_time"], 2.9432 * math.sqrt(1.25 * self.REDUCED / (coefficient * math.sqrt(overlap))), 1e-4)
        self.near(found["step"], found["contact_time"] / 20)
        # The largest step is a part of the contact time at three times the speed, t ~ overlap^(-1/4); t ~ speed^(-1/5)
        # without adhesion.
        self.near(found["fastest"], 3 * found["escape_velocity"])
        free = self.values("--speed", 0.1)
        fast = self.values("--hamaker", 7.49e-19, "--cutoff", 4e-10, 1e-7, "--speed", found["fastest"])
        self.near(found["largest_step"] / found["contact_time"] * (fast["overlap"] / overlap)**0.25,
                  free["largest_step"] / free["contact_time"] * 3**0.2, 1e-9)
        speed = math.sqrt(2 * found["well_depth"] / self.REDUCED * (1 / 0.9**2 - 1))
        self.near(found["escape_velocity"], speed)
        # By an integration of the eighth order, of 1e-8; bisected here to 1e-5.
        pair = HertzPair(5e9, 0.9, 1e-3, 7.49e-19)
        self.near(found["escape_velocity"], pair.escape_velocity(), 1e-4)

    def test_strong_damping_has_a_shorter_step(self):
        """Several contacts with friction, of which the fastest sphere has three times the speed."""
        overlap = (15 * self.REDUCED * 0.3**2 / (16 * self.MODULUS * math.sqrt(self.RADIUS)))**0.4
        for restitution in (0.5, 0.3):
            found = self.values("--speed", 0.1, "--restitution", restitution)
            self.near(found["step"], self.PLANNED * self.stable_step(overlap, restitution), 1e-9)
            self.assertEqual(found["largest_step"], found["step"])

    def test_without_adhesion(self):
        found = self.values("--speed", 0.1)
        overlap = (15 * self.REDUCED * 0.1**2 / (16 * self.MODULUS * math.sqrt(self.RADIUS)))**0.4
        self.near(found["overlap"], overlap)
        self.near(found["contact_time"], 2.9432 * overlap / 0.1, 1e-4)
        self.assertEqual((found["pull_off"], found["escape_velocity"]), (0, 0))

    def test_a_softer_modulus(self):
        f = 1e-3**0.4
        for words in (("--surface-energy", self.GAMMA), ("--hamaker", 7.49e-19, "--cutoff", 4e-10, 1e-7)):
            velocity, force = (self.values(*words, "--soft-young", 5e6, "--keep", keep) for keep in ("velocity", "force"))
            self.near(velocity["soft_escape_velocity"], velocity["escape_velocity"], 1e-3)
            self.near(velocity["soft_pull_off"], f * velocity["pull_off"])
            # At this speed lengths and times are 1/f.
            self.near(velocity["soft_overlap"], velocity["overlap"] / f, 1e-5)
            self.assertEqual(force["soft_pull_off"], force["pull_off"])
            self.assertGreater(force["soft_escape_velocity"], 3 * force["escape_velocity"])
        velocity = self.values("--surface-energy", self.GAMMA, "--soft-young", 5e6)
        self.near(velocity["soft_surface_energy"], f * self.GAMMA)

    def test_refusals(self):
        for words, *parts in ((("--hamaker", 1e-19), "--hamaker requires --cutoff"),
                              (("--hamaker", 1e-19, "--cutoff", 4e-10, 1e-7, "--surface-energy", 0.1), "excludes"),
                              ((), "speed of impacts = 0", "--speed"),
                              (("--speed", 1, "--keep", "force"), "--keep requires --soft-young"),
                              (("--speed", 1, "--restitution", 2), "restitution e = 2"),
                              (("--wall", "--radius", 1e-3), "--radius: given twice"),
                              (("--hamaker", 1e-19, "--cutoff", 4e-10, 1e-7, "--soft-young", 1e6, "--asperity", 1e-8),
                               "--keep force"),
                              (("--hamaker", 1e-19, "--cutoff", 4e-10, 1e-9, "--soft-young", 1e3), "outer cut-off")):
            code, output, error = program.call(*self.PAIR, *words)
            self.assertGreater(code, 0, words)
            self.assertEqual(output, "")
            for part in parts:
                self.assertIn(part, error)


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
