# SPDX-License-Identifier: BSD-3-Clause
"""compute gran/energy over runs: its tally begins with the first run, whoever asks and when, and has what a
change of the box between two runs puts in."""
import unittest

from cohesion_tests import lammps as engine
from cohesion_tests.test_cases import FolderTestCase

STIFFNESS, DIAMETER = 800.0, 1e-3
PASSER = (4e-3, 4e-3, 2e-3), (0.0, 0.0, 0.5)  # place and velocity of a sphere that meets nothing
HEAD = """
plugin load ${plugin}
units si
atom_style sphere
boundary %s
newton off
comm_modify vel yes
read_data data.spheres
neighbor 3e-4 bin
pair_style gran/hamaker
pair_coeff * * stiffness 800 restitution 0.9 %s
"""
TAIL = """
fix move all nve/sphere
timestep 5e-6
compute tally all gran/energy
thermo_modify norm no
"""


class Runs(FolderTestCase):
    def write(self, spheres, box):
        engine.write_spheres(self.folder, [
            {"type": 1, "diameter": DIAMETER, "density": 2650.0, "x": x, "v": v} for x, v in spheres],
            [(0.0, side) for side in box], 1)

    def run_script(self, text, ranks=1):
        code, output = engine.run_text(text, self.folder, ranks=ranks)
        self.assertEqual(code, 0, output[-3000:])
        return output

    def looked_at(self, text, ranks=1):
        """Entry 10 and the scalar, asked for when all is over."""
        output = self.run_script(text + "thermo_style custom step c_tally[10] c_tally\n"
                                 "thermo_modify norm no format float %.17g\nrun 0\n", ranks)
        rows = [line.split() for line in output.splitlines() if line.startswith("     ")]
        return [float(word) for word in [row for row in rows if len(row) == 3 and row[0] == "150"][-1][1:]]

    def test_what_is_missing_does_not_depend_on_who_looks(self):
        """Two spheres that rub each other while they fall: friction and gravity leave an error of the step."""
        self.write([((2e-3, 2e-3, 2e-3), (0.1, 0.0, 0.0)), ((3.02e-3, 2.2e-3, 2e-3), (-0.1, 0.0, 0.0))],
                   (5e-3, 5e-3, 5e-3))
        # The field grows, so that a tally begun a step too late or too early would have another beginning.
        script = (HEAD % ("p p p", "friction 0.3 hamaker 5e-19 cutoff 4e-10 1e-7") +
                  "variable g equal 9.81+step\nfix fall all gravity v_g vector 0 0 -1\n" + TAIL)
        looks = {
            "from the start": "thermo 1\nthermo_style custom step c_tally c_tally[10]\nrun 150\n",
            "at the end": "thermo_style custom step\nrun 150\n",
            "a mean": "thermo_style custom step\nfix mean all ave/time 150 1 150 c_tally[10]\nrun 150\n",
            "in the second run": "thermo_style custom step\nrun 60\nrun 90\n",
            "after a run of no step": "thermo_style custom step\nrun 0\nrun 150\n"}
        found = {name: self.looked_at(script + how) for name, how in looks.items()}
        first = found["from the start"]
        self.assertGreater(abs(first[0]), 1e-9 * first[1])
        for name, tally in found.items():
            with self.subTest(name):
                self.assertEqual(tally, first)
        on_two = self.looked_at(script + looks["at the end"], ranks=2)
        self.assertAlmostEqual(on_two[0] / first[0], 1, delta=1e-6)  # other sums, of much the same

    def entries(self, text, ranks=1, change="x final 0 ${side} remap"):
        """Entries 3, 9, 10 and 1 at the beginning and end of each run."""
        output = self.run_script(text + "thermo 1000\n"
                                 "thermo_style custom step c_tally[3] c_tally[9] c_tally[10] c_tally[1]\n"
                                 "thermo_modify norm no format float %.17g\nrun 10\n"
                                 f"change_box all {change} units box\nrun 200\n", ranks)
        rows = [[float(word) for word in line.split()] for line in output.splitlines()
                if len(line.split()) == 5 and line.split()[0].isdigit()]
        self.assertEqual(len(rows), 4, output[-2000:])
        return [row[1:] for row in rows], output

    def check(self, rows, output, work):
        """Apart, then pressed into each other, then thrown apart; a PASSER has energy before."""
        for row in rows[:2]:
            self.assertEqual(row[:3], [0.0] * 3)
            self.assertGreater(row[3], 0.01 * work)
        # A place is rounded by 1e-18 m, of an overlap of 1e-4 m; the rest is a few hundred sums.
        for row, spring in ((rows[2], work), (rows[3], 0.0)):
            self.assertAlmostEqual(row[0], spring, delta=1e-11 * work)
            self.assertAlmostEqual(row[1], work, delta=1e-11 * work)
            self.assertAlmostEqual(row[2], 0.0, delta=1e-11 * work)
        self.assertGreater(rows[3][3] - rows[1][3], 0.5 * work)
        self.assertEqual(output.count("the box was changed between two runs"), 1)

    def test_box_that_presses_two_spheres_into_each_other(self):
        side, shrunk, apart = 8e-3, 7e-3, 1.05e-3
        self.write([((2e-3, 2e-3, 2e-3), (0, 0, 0)), ((2e-3 + apart, 2e-3, 2e-3), (0, 0, 0)), PASSER],
                   (side, 5e-3, 5e-3))
        work = 0.5 * STIFFNESS * (DIAMETER - apart * shrunk / side)**2
        for ranks in (1, 2):
            with self.subTest(ranks=ranks):
                rows = self.entries(f"variable side string {shrunk!r}\n" + HEAD % ("p p p", "") + TAIL, ranks)
                self.check(*rows, work)

    def test_box_that_presses_a_sphere_into_a_wall(self):
        side, shrunk, height = 8e-3, 7e-3, 0.52e-3
        self.write([((height, 2e-3, 2e-3), (0, 0, 0)), PASSER], (side, 5e-3, 5e-3))
        work = 0.5 * STIFFNESS * (DIAMETER / 2 - height * shrunk / side)**2
        rows = self.entries(f"variable side string {shrunk!r}\n" + HEAD % ("f p p", "") +
                            "fix wall all wall/gran/hamaker stiffness 800 restitution 0.9 xplane 0 NULL\n" + TAIL)
        self.check(*rows, work)

    def test_box_that_changes_nothing_but_itself(self):
        self.write([((2e-3, 2e-3, 2e-3), (0, 0, 0)), PASSER], (8e-3, 5e-3, 5e-3))
        rows, output = self.entries(HEAD % ("p p p", "") + TAIL, change="x final 0 9e-3")
        self.assertEqual(rows, 4 * [rows[0]])
        self.assertNotIn("the box was changed", output)

    def test_one_that_begins_after_a_run_that_ended_early(self):
        self.write([((2e-3, 2e-3, 2e-3), (0.1, 0, 0)), ((2.99e-3, 2e-3, 2e-3), (-0.1, 0, 0))], (5e-3, 5e-3, 5e-3))
        head = HEAD % ("p p p", "friction 0.3") + TAIL.replace("compute tally all gran/energy\n", "")
        halt = "variable n equal step\nfix stop all halt 1 v_n >= 10 error continue\nrun 60\nunfix stop\n"
        compute = "compute tally all gran/energy\n"
        for early, runs in ((True, halt + compute), (False, compute + halt), (True, halt + "run 0\n" + compute), (False, "run 10\n" + compute),
                            (False, halt + "run 5\n" + compute)):
            with self.subTest(runs):
                output = self.run_script(head + runs + "run 20\nrun 20\n")
                self.assertEqual(output.count("the last run ended early"), early)


if __name__ == "__main__":
    unittest.main()
