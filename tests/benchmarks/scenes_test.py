# SPDX-License-Identifier: BSD-3-Clause
"""Every way of `dense` runs and takes processor time: scenes_test.py BUILD LAMMPS_ENGINE."""
import argparse
import sys
import unittest

from programs import Programs  # first: it knows where the others are
import account
import dense
import scenes

PROGRAMS = Programs(sys.argv[1], sys.argv[2])
PARTICLES, STEPS = 500, 20


class Ways(unittest.TestCase):
    def test_each_runs_the_steps_that_it_is_asked_for(self):
        cells = scenes.cells_for("gas", PARTICLES)
        number = scenes.particles("gas", cells)
        ran = 0
        for engine, ways in dense.WAYS.items():
            for name, (way, pair) in ways.items():
                if not PROGRAMS.has(way):
                    continue
                with self.subTest(engine=engine, way=name):
                    text = scenes.text(engine == "LIGGGHTS", "gas", cells, pair, load=way == "lammps+")
                    used = PROGRAMS.run(way, text, STEPS)
                    self.assertRegex(used.output, rf"Loop time of .* for {STEPS} steps with {number} atoms")
                    self.assertGreater(used.seconds, 0)
                    ran += 1
        self.assertGreater(ran, 0)

    def test_parts_of_the_account_are_the_whole(self):
        """Each number is written with one digit, off by 0.05 at most."""
        words = argparse.Namespace(sizes=[PARTICLES], way="", steps=STEPS, turns=1)
        lines = [line.strip("| ").split(" | ") for line in account.rows(PROGRAMS, words)]
        self.assertGreater(len(lines), 2)
        for name, number, whole, *parts in lines[2:]:
            told = [float(part) for part in parts if part.strip()]
            self.assertGreaterEqual(len(told), len(account.PARTS), name)  # LIGGGHTS has no row of the integration
            self.assertGreater(min(told[:3]), 0)
            self.assertAlmostEqual(sum(told), float(whole), delta=0.05 * (1 + len(told)))


class Verdict(unittest.TestCase):
    def test_each_style_of_ours_stands_on_its_side(self):
        ways = {"stock (cohesive)": ("lammps", ""), "a": ("lammps+", ""), "b, c": ("lammps+", "")}
        counts = {"stock (cohesive)": 100.0, "a": 115.0, "b, c": 116.0}
        turns = {"stock (cohesive)": [10.0, 20.0, 30.0], "a": [20.0, 22.0, 30.0], "b, c": [12.0, 24.0, 30.0]}
        found = dense.over_cohesive(ways, counts, turns, "stock (cohesive)")
        self.assertEqual(list(dense.verdict({"A, gas": found}))[2:],
                         ["| A, gas | instructions | a 1.15 | b, c 1.16 |", "| A, gas | time | a 1.10 | b, c 1.20 |"])
        none = dict.fromkeys(counts)
        self.assertEqual(list(dense.verdict({"A": dense.over_cohesive(ways, none, turns, "stock (cohesive)")}))[2:],
                         ["| A | time | a 1.10 | b, c 1.20 |"])
        counts["a"] = 200.0
        counted = dense.over_cohesive(ways, counts, {name: [] for name in counts}, "stock (cohesive)")
        self.assertEqual(list(dense.verdict({"A": counted}))[2:], ["| A | instructions | none | a 2.00; b, c 1.16 |"])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
