# SPDX-License-Identifier: BSD-3-Clause
"""Every way of `dense` runs and takes processor time: scenes_test.py BUILD LAMMPS_ENGINE."""
import argparse
import sys
import unittest

import account
import dense
import scenes
from build_folder import Programs

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

    def test_parts_of_the_account_are_of_the_whole(self):
        """A part that is read wrong is more than the whole, and the rest below 0."""
        words = argparse.Namespace(sizes=[PARTICLES], way="", steps=STEPS, turns=1)
        lines = [line.strip("| ").split(" | ") for line in account.rows(PROGRAMS, words)]
        self.assertGreater(len(lines), 2)
        for name, number, whole, *parts in lines[2:]:
            with self.subTest(name):
                told = [float(part) for part in parts if part.strip()]
                self.assertGreaterEqual(len(told), len(account.PARTS))  # LIGGGHTS has no row of the integration
                self.assertGreater(min(told[:3]), 0)
                self.assertGreaterEqual(told[-1], 0)


# What the engines print at the end of a run.
LAMMPS_END = """Loop time of 0.00195 on 1 procs for 20 steps with 500 atoms

99.6% CPU use with 1 MPI tasks x 1 OpenMP threads

MPI task timing breakdown:
Section |  min time  |  avg time  |  max time  |%varavg| %total
---------------------------------------------------------------
Pair    | 0.00081    | 0.00082    | 0.00083    |   0.0 | 42.05
Neigh   | 0.0005     | 0.0005     | 0.0005     |   0.0 | 25.64
Comm    | 9e-05      | 9e-05      | 9e-05      |   0.0 |  4.62
Output  | 1e-05      | 1e-05      | 1e-05      |   0.0 |  0.51
Modify  | 0.0004     | 0.0004     | 0.0004     |   0.0 | 20.51
Other   |            | 0.00013    |            |       |  6.67

Nlocal:            500 ave         500 max         500 min
"""
LIGGGHTS_END = """Loop time of 0.004 on 1 procs for 20 steps with 500 atoms, finish time Sun Nov 22 16:31:07 2026


Pair  time (%) = 0.0025 (62.5)
Neigh time (%) = 0.0009 (22.5)
Comm  time (%) = 0.0001 (2.5)
Outpt time (%) = 0.0002 (5)
Other time (%) = 0.0003 (7.5)
"""


class Account(unittest.TestCase):
    def test_seconds_of_lammps_are_the_means_of_the_ranks(self):
        parts, whole = account.seconds(LAMMPS_END)
        self.assertEqual((dict(zip(account.PARTS, parts)), whole),
                         ({"Pair": 0.00082, "Neigh": 0.0005, "Comm": 9e-05, "Modify": 0.0004}, 0.00195))

    def test_seconds_of_liggghts_have_no_integration(self):
        parts, whole = account.seconds(LIGGGHTS_END)
        self.assertEqual((dict(zip(account.PARTS, parts)), whole),
                         ({"Pair": 0.0025, "Neigh": 0.0009, "Comm": 0.0001, "Modify": None}, 0.004))

    def test_of_several_loops_the_last_one_is_the_whole(self):
        self.assertEqual(account.seconds("Loop time of 3 on 1 procs\n" + LAMMPS_END)[1], 0.00195)


    def test_rest_is_what_the_engine_tells_of_nothing_else(self):
        """Of LAMMPS output and other, 0.14 ms, of LIGGGHTS these and no integration, 0.5 ms; each in 20 steps of the
        500 particles, in ns."""
        for end, rest in ((LAMMPS_END, 0.14e-3), (LIGGGHTS_END, 0.5e-3)):
            programs = argparse.Namespace(has=lambda name: name == "lammps",
                                          run=lambda *_, end=end: argparse.Namespace(output=end))
            words = argparse.Namespace(sizes=[PARTICLES], way="", steps=STEPS, turns=1)
            rows = [line.strip("| ").split(" | ") for line in account.rows(programs, words)][2:]
            self.assertGreater(len(rows), 0)
            for _, number, *_, told in rows:
                # One decimal is printed.
                self.assertAlmostEqual(float(told), rest * 1e9 / STEPS / int(number), delta=0.051)


class Gases(unittest.TestCase):
    def test_each_way_that_is_built_and_asked_for_at_each_size(self):
        words = argparse.Namespace(way="hamaker", sizes=[500, 4000])
        only_lammps = argparse.Namespace(has=lambda name: name.startswith("lammps"))
        runs = list(scenes.gases(only_lammps, words))
        self.assertEqual([(run.name, run.way, run.wished, run.particles) for run in runs],
                         [(f"LAMMPS, gran/hamaker *{scheme}*", "lammps+", wished, wished)
                          for scheme in ("exact", "sampled") for wished in (500, 4000)])
        self.assertTrue(all(run.text.startswith("plugin load") for run in runs))


class Verdict(unittest.TestCase):
    def test_each_style_of_ours_stands_on_its_side(self):
        ways = {"stock (cohesive)": ("lammps", ""), "a": ("lammps+", ""), "b, c": ("lammps+", "")}
        counts = {"stock (cohesive)": 100.0, "a": 115.0, "b, c": 116.0}
        turns = {"stock (cohesive)": [10.0, 20.0, 30.0], "a": [20.0, 22.0, 30.0], "b, c": [12.0, 24.0, 30.0]}
        found = dense.over_cohesive(ways, counts, turns, "stock (cohesive)")
        self.assertEqual(list(dense.verdict({"A, gas": found}))[2:],
                         ["| A, gas | instructions | a 1.1500 | b, c 1.16 |", "| A, gas | time | a 1.10 | b, c 1.20 |"])
        none = dict.fromkeys(counts)
        self.assertEqual(list(dense.verdict({"A": dense.over_cohesive(ways, none, turns, "stock (cohesive)")}))[2:],
                         ["| A | time | a 1.10 | b, c 1.20 |"])
        counts["a"] = 115.02
        near = dense.over_cohesive(ways, counts, {name: [] for name in counts}, "stock (cohesive)")
        self.assertEqual(list(dense.verdict({"A": near}))[2:], ["| A | instructions | none | a 1.1502; b, c 1.16 |"])
        counts["a"] = 200.0
        counted = dense.over_cohesive(ways, counts, {name: [] for name in counts}, "stock (cohesive)")
        self.assertEqual(list(dense.verdict({"A": counted}))[2:], ["| A | instructions | none | a 2.00; b, c 1.16 |"])


class Spread(unittest.TestCase):
    def test_one_turn_has_no_range(self):
        self.assertEqual((scenes.spread([3.0, 1.0, 2.0]), scenes.spread_words(3)),
                         ("2.00 (1.00 to 3.00)", ": median (least to most)"))
        self.assertEqual((scenes.spread([2.0], 1), scenes.spread_words(1)), ("2.0", ""))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
