# SPDX-License-Identifier: BSD-3-Clause
"""fix stationary: where it ends a run, on values that are functions of the step; what it says; restart;
what it refuses."""
import math
import re
import unittest
from concurrent.futures import ThreadPoolExecutor

from cohesion_tests import lammps as engine
from cohesion_tests.refusals import assert_refused
from cohesion_tests.thermo import thermo_lines

HEAD = """
plugin load ${plugin}
units lj
atom_style sphere
newton off
boundary p p p
region box block 0 8 0 8 0 8
create_box 1 box
create_atoms 1 single 2 3 4
create_atoms 1 single 6 3 4
set group all diameter 1.0 density 1.0
pair_style hard/squarewell
pair_coeff * * restitution 1
comm_modify vel yes
velocity all create 1 1
neighbor 1 bin
fix move all nve/sphere
timestep 0.01
variable t equal step
"""
THERMO = "thermo_style custom step f_end f_end[*]\nthermo 1\nthermo_modify format float %.17g\n"


def table(output):
    names, rows = thermo_lines(output)
    return [dict(zip(names, row)) for row in rows]


class Stationary(unittest.TestCase):
    def go(self, text, ranks=1, head=HEAD):
        with engine.temporary_folder() as folder:
            code, output = engine.run_text(head + text, folder, ranks=ranks)
        self.assertEqual(code, 0, output[-3000:])
        return output

    def test_drift_ends_where_it_has_become_small(self):
        """x = t: blocks of 32 steps after 10; the mean of block b is 10 + 32 (b - 1/2) + 1/2, so the change
        to the next is 32/(10.5 + 32 b), below 5 % first for b = 20."""
        for ranks in (1, 2):
            output = self.go("fix end all stationary 1 progress v_t start 10 block 32 "
                             "watch 0.05 mean v_t watch any rate v_t\n" + THERMO + "run 5000\n"
                             "print 'now $(step) $(f_end[1]) $(f_end[2])'\n"
                             "run 7\nprint 'then $(step)'\n", ranks)
            self.assertIn(f"now {10 + 21 * 32} 21 1", output)
            self.assertIn(f"then {10 + 21 * 32 + 7}", output)  # later runs are whole
            self.assertIn("fix end stationary: stationary after 21 blocks, step 682", output)
            self.assertNotIn("WARNING: fix end", output)
            last = table(output)[-1]
            n = 21 * 32
            self.assertAlmostEqual(last["f_end[6]"], 1 / 0.01, delta=1e-12 * 100)
            self.assertEqual(last["f_end[3]"], 10 + (n + 1) / 2)
            self.assertAlmostEqual(last["f_end[5]"], 32 / (10.5 + 32 * 20), delta=1e-15)
            # Coarsest level: 336 batches of two steps down to 10 values, of a line: its spread, n/sqrt(12),
            # over root of 9; the finest level that is within two errors, 2/sqrt(18), of that.
            spread = n / math.sqrt(12) / 3
            self.assertLess(last["f_end[4]"], spread * 1.02)
            self.assertGreater(last["f_end[4]"], spread * (1 - 2 / math.sqrt(18)) * 0.98)

    def test_terms(self):
        """Totals t^2 and 3 t^2: rate in time 2 t/dt, ratio 1/3; the mean of t beside them."""
        output = self.go("variable s equal step*step\nvariable u equal 3*step*step\n"
                         "fix end all stationary 2 progress v_t start 0 block 16 most 2 "
                         "watch 1e-9 ratio v_s v_u watch 1e-9 rate v_s watch 1e-9 mean v_t rate v_s "
                         "watch 1e-9 weighted v_t v_t\n"
                         "thermo_style custom step f_end f_end[*]\nthermo 2\nrun 500\n"
                         "print 'after $(f_end[3]:%.15g) $(f_end[6]:%.15g) $(f_end[9]:%.15g) "
                         "$(f_end[12]:%.15g)'\n")
        # Known from step 0 on: 32 steps, rate 32^2/(32 dt); samples of t at 2, 4, ... 32, mean 17,
        # sum of squares over sum 22.
        ratio, rate, both, weighted = map(float, re.search(r"after (.*)", output[output.index("Loop"):]
                                                 ).group(1).split())
        for found, expected in ((ratio, 1 / 3), (rate, 3200), (both, 3217), (weighted, 22)):
            self.assertAlmostEqual(found, expected, delta=1e-13 * expected)
        self.assertRegex(output, r"the rule was not met after 2 blocks, step 32\n"
                                 r"  ratio v_s v_u: mean 0.333333 .* 0 %")
        self.assertRegex(output, r"WARNING: fix end stationary: ended after most = 2 blocks")

    def test_per_particle_and_a_start_between_samples(self):
        output = self.go("fix end all stationary 5 progress v_t per_particle start 8.2 block 16 "
                         "watch 0.1 mean c_thermo_temp\nrun 1000\nprint 'now $(step)'\n")
        # Two particles: start at t > 16.4, sampled at 20; blocks end at 48.4 and 80.4.
        self.assertIn("now 85", output[output.index("Loop"):])

    def test_accumulated_outputs_of_the_package(self):
        """Two spheres that meet head on in a box of 8, again and again across the faces: 6 diameters of way
        at relative speed 2 from one collision to the next; each carries R J = m u = 2 m."""
        output = self.go("velocity all set 0 0 0\nset atom 1 vx 1\nset atom 2 vx -1\n"
                         "compute ev all hard/events\ncompute st all hard/stress\n"
                         "fix end all stationary 10 progress c_ev[1] start 3 block 32 "
                         "watch 0.02 rate c_st[1][1] watch 0.02 rate c_ev[1] "
                         "watch 1e-9 ratio c_st[1][1] c_ev[1]\nrun 100000\n"
                         "print 'mean $(f_end[1]) $(f_end[3]) $(f_end[6]) $(f_end[9]:%.12g)'\n")
        blocks, flux, rate, one = map(float, re.search(r"mean (.*)", output[output.index("Loop"):]
                                                       ).group(1).split())
        self.assertEqual(blocks, 2)
        # Samples are 0.1 apart: 64 collisions in 192 but for one sample at either end.
        self.assertAlmostEqual(rate, 1 / 3, delta=0.2 / 192 / 3)
        # Round-off of totals of 67 impulses, and the digits printed.
        mass = math.pi / 6
        self.assertAlmostEqual(one, 2 * mass, delta=1e-11)
        self.assertAlmostEqual(flux, 2 * mass * rate, delta=1e-4)

    def test_time_step_that_changes_between_samples(self):
        """33 steps of 0.01 and 287 of 0.02, sampled every 10."""
        output = self.go("fix end all stationary 10 progress v_t block 160 most 2 watch 1e-9 rate v_t\n"
                         "run 33\ntimestep 0.02\nrun 1000\nprint 'mean $(f_end[3]:%.15g) $(step)'\n")
        mean, step = re.findall(r"^mean (.*)", output, re.M)[-1].split()
        self.assertEqual(step, "320")
        expected = 320 / (33 * 0.01 + 287 * 0.02)
        self.assertAlmostEqual(float(mean), expected, delta=1e-13 * expected)

    def test_pressure_from_a_step_that_is_no_multiple(self):
        """The engine works out a virial only in steps that were asked for before; the first sample is taken
        at step 5."""
        for more in ("", "run 1\n"):
            output = self.go("thermo_style custom step\nthermo 1000000\nrun 3\n"
                             "fix end all stationary 5 progress v_t block 80 watch any mean c_thermo_press\n"
                             + more + "run 1000\nprint 'now $(step)'\n")
            self.assertIn("now 165", output[output.rindex("Loop"):])

    def test_more_blocks_after_a_restart(self):
        """A rule that was not met within `most` goes on when more blocks are allowed, as in one go; with the
        same `most` the fix does nothing more. Another start or block is refused."""
        def fix(most, words="start 20 block 100"):
            return ("variable x equal step*step\n"
                    f"fix end all stationary 5 progress v_t {words} most {most} watch 1e-9 mean v_x\n")
        ask = "print 'ended $(step) $(f_end[1]) $(f_end[3]:%.17g) $(f_end[4]:%.17g) $(f_end[5]:%.17g)'\n"
        again = "plugin load ${plugin}\nnewton off\nread_restart given_up.restart\n" + "".join(
            line + "\n" for line in HEAD.splitlines() if line.split()[:1] in (
                ["comm_modify"], ["neighbor"], ["fix"], ["timestep"], ["variable"]))
        with engine.temporary_folder() as folder:
            def ends(text):
                code, output = engine.run_text(text + ask, folder)
                self.assertEqual(code, 0, output[-3000:])
                return re.findall(r"^ended .*", output, re.M)[-1]
            whole = ends(HEAD + fix(5) + "run 1000\n")
            self.assertEqual(whole.split()[1:3], ["520", "5"])
            first = ends(HEAD + fix(3) + "run 1000\nwrite_restart given_up.restart\n")
            self.assertEqual(first.split()[1:3], ["320", "3"])
            self.assertEqual(ends(again + fix(5) + "run 1000\n"), whole)
            self.assertEqual(ends(again + fix(3) + "run 100\n").split()[1:3], ["420", "3"])
            for words, message in (("start 25 block 100", "same start"), ("start 20 block 96", "same block")):
                code, output = engine.run_text(again + fix(5, words) + "run 1000\n", folder)
                assert_refused(self, code, output, message)

    def test_restart_goes_on(self):
        """Written between blocks and read: the same end, mean and error as in one go. Totals that begin
        again at zero do no harm."""
        fix = ("variable x equal sin(step/5)+2\nvariable s equal step*2-v_from\n"
               "fix end all stationary 5 progress v_s start 20 block 100 most 5 "
               "watch 1e-12 mean v_x watch 1e-12 rate v_s\n")
        ask = ("print 'ended $(step) $(f_end[1]) $(f_end[3]:%.17g) $(f_end[4]:%.17g) $(f_end[5]:%.17g) "
               "$(f_end[6]:%.17g)'\n")
        with engine.temporary_folder() as folder:
            _, whole = engine.run_text(HEAD + "variable from equal 0\n" + fix + "run 1000\n" + ask, folder)
            code, first = engine.run_text(HEAD + "variable from equal 0\n" + fix +
                                          "run 135\nwrite_restart half.restart\n", folder)
            self.assertEqual(code, 0, first)
            self.assertIn("not met yet: 2 blocks", first)
            again = ("plugin load ${plugin}\nnewton off\nread_restart half.restart\nvariable from equal 270\n"
                     "fix move all nve/sphere\n" + fix + "run 1000\n" + ask)
            code, second = engine.run_text(again, folder)
            self.assertEqual(code, 0, second)
            ends = [re.findall(r"^ended .*", output, re.M)[-1] for output in (whole, second)]
            self.assertEqual(*ends)
            self.assertEqual(ends[0].split()[1:3], ["260", "5"])
            code, other = engine.run_text(again.replace("watch 1e-12 mean v_x", ""), folder)
            assert_refused(self, code, other, "watch the same values")


class Refusals(unittest.TestCase):
    def test_words(self):
        good = "progress v_t start 1 block 1 watch 0.1 mean v_t"
        cases = [
            ("0 " + good, "N is 0"),
            ("1 block 1 watch 0.1 mean v_t", "give 'progress VALUE'"),
            ("1 progress v_t block 1", "at least one 'watch"),
            ("1 " + good.replace("start", "begin"), "unknown keyword 'begin'", "per_particle"),
            ("1 " + good.replace("block 1", "block 0"), "block = 0", "greater than zero"),
            ("1 " + good.replace("start 1", "start -1"), "start = -1"),
            ("1 " + good.replace("0.1", "0"), "tolerance = 0"),
            ("1 " + good + " most 1", "most 1", "two blocks"),
            ("1 " + good + " most", "most takes a value"),
            ("1 " + good + " watch 0.1", "at least one of: mean VALUE", "rate TOTAL"),
            ("1 " + good + " watch 0.1 median v_t", "at least one of"),
            ("1 " + good + " watch 0.1 ratio v_t", "two values"),
            ("1 " + good.replace("mean v_t", "mean v_none"), "'v_none' must be"),
            ("1 " + good.replace("progress v_t", "progress c_none[1]"), "'c_none[1]' must be"),
            ("1 " + good.replace("mean v_t", "mean 3"), "'3' must be"),
            ("1 " + good.replace("mean v_t", "mean c_thermo_temp[9]"), "out-of-range"),
            ("1 " + good.replace("mean v_t", "mean v_wrong"), "wrong"),
        ]

        def one(case):
            with engine.temporary_folder() as folder:
                return engine.run_text(HEAD + "variable wrong equal 1e200*1e200\n"
                                       f"fix end all stationary {case[0]}\nrun 10\n", folder)
        with ThreadPoolExecutor(4) as pool:
            for case, (code, output) in zip(cases, pool.map(one, cases)):
                with self.subTest(case=case):
                    assert_refused(self, code, output, *case[1:])


if __name__ == "__main__":
    unittest.main()
