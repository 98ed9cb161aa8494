# SPDX-License-Identifier: BSD-3-Clause
"""Gases and beds of hard particles with square wells, on several ranks and restarted."""
import unittest
from pathlib import Path

import numpy

from cohesion_tests import lammps as engine
from cohesion_tests.lammps_scenes.hard_gas import Gas, RowThatJustFits

DEPTH, RATIO = 0.3, 1.1


class RanksAndRestart(unittest.TestCase):
    """Each rank computes every number alike: files of events and ends are the same in all digits. A collision amplifies
    a difference by the free path over the radius, 2 or more: after the 60 events of each particle, which is what all
    scenes but the beds have at least, one of the last digit, 2^-53, has changed the order of events."""

    def same(self, gas, pair, dt, steps, least, ranks=(2,), restarted=(2,), spin=None, rules="", **options):
        with engine.temporary_folder() as folder:
            gas.write(folder, spin)

            def go(name, **more):
                path, table, _ = gas.run(folder, pair, dt, steps, style=f"record {name} {rules}", **options,
                                         **more)
                lines = (Path(folder) / name).read_text().splitlines()
                return path[-1], [line for line in lines if line[:1] != "#"], table

            # The next file would be due after the end.
            half = steps // 2 + 1
            whole, events, table = go("kept.txt", keep=half)
            self.assertGreater(len(events), least)
            for number in ranks:
                with self.subTest(ranks=number):
                    path, found, _ = go(f"ranks{number}.txt", ranks=number, keep=half)
                    self.assertEqual(found[:1000], events[:1000])
                    self.assertTrue(found == events)
                    numpy.testing.assert_array_equal(path, whole)
            for number in restarted:
                with self.subTest(restarted_on=number):
                    path, found, again = go("again.txt", keep=half, restart=True, ranks=number)
                    later = [line for line in events if int(line.split()[0]) > half]
                    self.assertEqual(found[:1000], later[:1000])
                    self.assertTrue(found == later)
                    numpy.testing.assert_array_equal(path, whole)
                    # A sum over pairs, in whatever order: 1e4 terms of up to 1, 1e-12 each.
                    self.assertAlmostEqual(table["PotEng"][-1], again["PotEng"][-1], delta=1e-8)
        return table

    def test_fluid(self):
        self.same(Gas(216, 0.3, seed=4), ["* * restitution 1 well 1 1.5"], 0.02, 100, 65e2, restarted=(1, 2), skin=1.0)

    def test_steps_of_a_mean_free_time(self):
        gas = Gas(200, 0.4, 2, (0.4, 0.6))
        self.same(gas, [f"* * restitution 1 well {DEPTH} {RATIO}"], 0.28, 20, 4e3, skin=4.5)

    def test_discs_between_walls_with_friction(self):
        gas = Gas(160, 0.5, 2, (0.4, 0.6), seed=3)
        self.same(gas, [f"* * restitution 0.9 friction 0.3 well {DEPTH} {RATIO}"], 0.05, 200, 48e2,
                  ranks=(2, 4), restarted=(4,), spin=gas.spin(), skin=1.0, boundary="p f p",
                  more=["fix sides all wall/hard/squarewell restitution 0.8 friction 0.3 "
                        f"yplane 0 {gas.length:.17g}"])

    def bed(self, rules, least):
        gas = Gas(100, 0.5, 2, (0.4, 0.6), seed=3)
        return self.same(gas, [f"* * restitution 0.3 friction 0.3 well {DEPTH} {RATIO}"], 0.02, 40, least,
                         rules=rules, skin=1.0, boundary="p f p",
                         more=["fix down all gravity 5.0 vector 0 -1 0",
                               "fix sides all wall/hard/squarewell restitution 0.3 friction 0.3 "
                               f"yplane 0 {gas.length:.17g}"])

    def test_bed_where_the_rule_against_collapse_acts(self):
        self.assertGreater(self.bed("rest off", 5e3)["c_events[17]"][-1], 0)

    def test_bed_where_the_rule_of_rest_acts(self):
        self.assertGreater(self.bed("", 1e3)["c_events[35]"][-1], 100)

    def test_clusters_bound_by_narrow_wells(self):
        """Deep wells: the rule of rest acts from the first cluster on."""
        gas = Gas(125, 0.1, 3, (0.4, 0.6), seed=3)
        table = self.same(gas, ["* * restitution 0.5 friction 0.3 well 100 1.01"], 0.05, 100, 1e4,
                          spin=gas.spin(), skin=2.0)
        self.assertGreater(table["c_events[35]"][-1], 100)

    def test_bed_that_is_pressed_on_a_row_which_just_fits(self):
        """The floor's row fills the width to round-off when it lies flat: most of all collisions."""
        gas = RowThatJustFits(10, 4)
        table = self.same(gas, ["* * restitution 0.9 friction 0.3"], 0.01, 200, 2e4, skin=0.3,
                          boundary="f f p",
                          more=["fix down all gravity 1.0 vector 0 -1 0",
                                "fix sides all wall/hard/squarewell restitution 0.9 friction 0.3 "
                                f"xplane 0 {gas.length} yplane 0 NULL"])
        self.assertGreater(table["c_events[35]"][-1], 1e4)
        self.assertGreater(table["c_events[36]"][-1], 0)
        self.assertLess(table["c_events[18]"][-1], 3000)


if __name__ == "__main__":
    unittest.main()
