# SPDX-License-Identifier: BSD-3-Clause
"""What compute gran/energy and compute gran/stress sum belongs to them: it begins at 0 with each compute, in a
run after one without, right after another, and beside another that goes on."""
import math
import unittest

import numpy

from cohesion_tests import lammps as engine
from cohesion_tests.lammps_scenes import couples
from cohesion_tests.theory import pair_motion
from cohesion_tests.theory.pair_motion import MU, STIFFNESS

RESTITUTION, SPEED = 0.8, 0.02
OVERLAP = SPEED * math.sqrt(MU / STIFFNESS)
DT = pair_motion.CONTACT_TIME / 20
PART = 100  # steps in which one couple meets: 10 before and 20 of the contact
DEFINE = """
compute tally all gran/energy
compute stress all gran/stress
thermo_style custom step c_tally[6] c_stress[1][2]
thermo_modify norm no format float %.17g
"""
DELETE = """
thermo_style custom step
uncompute tally
uncompute stress
"""


class Sums(unittest.TestCase):
    def rows(self, text):
        """Numbers that the runs print, in one of which after the other a couple meets."""
        atoms = []
        for k in range(3):
            atoms += couples.couple(k, SPEED * DT * (10 + k * PART), (0.0, SPEED, 0.0))
        with engine.temporary_folder() as folder:
            engine.write_spheres(folder, atoms, [(0.0, 0.064), (0.0, 0.01), (0.0, 0.004)], 1)
            code, output = engine.run_text(f"""
plugin load ${{plugin}}
units si
atom_style sphere
newton off
comm_modify vel yes
read_data data.spheres
neighbor 4e-4 bin
pair_style gran/hamaker
pair_coeff * * stiffness {STIFFNESS} restitution {RESTITUTION}
fix move all nve/sphere
timestep {DT!r}
thermo {PART}
{text}""", folder)
        self.assertEqual(code, 0, output[-2000:])
        lines = [line.split() for line in output.splitlines()]
        return [list(map(float, words)) for words in lines if len(words) in (3, 7) and words[0].isdigit()]

    LOST = 0.5 * (1 - RESTITUTION**2) * MU * SPEED**2
    CARRIED = pair_motion.DIAMETER * (1 + RESTITUTION) * MU * SPEED

    def check(self, begin, end, couples_met=1):
        self.assertEqual(begin, [0.0, 0.0])
        # A place is rounded by 2e-19 m in each of some 20 steps of contact, of an overlap of 6e-7 m.
        self.assertLess(abs(end[0] / (couples_met * self.LOST) - 1), 1e-10)
        # Along the distance, which is shorter by the overlap, up to that of the undamped spring.
        self.assertLess(abs(end[1] / (couples_met * self.CARRIED) - 1), OVERLAP / pair_motion.DIAMETER)

    def test_a_run_without_one_between(self):
        rows = self.rows(f"{DEFINE}run {PART}\n{DELETE}run {PART}\n{DEFINE}run {PART}\n")
        self.assertEqual(len(rows), 4)
        self.check(rows[0][1:], rows[1][1:])
        self.check(rows[2][1:], rows[3][1:])

    def test_defined_again_between_two_runs(self):
        rows = self.rows(f"{DEFINE}run {PART}\n{DELETE}{DEFINE}run {PART}\n")
        self.assertEqual(len(rows), 4)
        self.check(rows[0][1:], rows[1][1:])
        self.check(rows[2][1:], rows[3][1:])

    def test_a_second_one_beside_the_first(self):
        rows = self.rows(f"""{DEFINE}run {PART}
compute tally2 all gran/energy
compute stress2 all gran/stress
thermo_style custom step c_tally[6] c_stress[1][2] c_tally2[6] c_stress2[1][2] c_tally[10] c_tally2[10]
thermo_modify norm no format float %.17g
run {PART}
uncompute tally
uncompute stress
thermo_style custom step c_tally2[6] c_stress2[1][2]
thermo_modify norm no format float %.17g
run {PART}
""")
        self.assertEqual([len(row) for row in rows], [3, 3, 7, 7, 3, 3])
        self.check(rows[0][1:], rows[1][1:])
        self.assertEqual(rows[2][1:3], rows[1][1:])
        self.check([0.0, 0.0], rows[3][1:3], 2)
        self.check(rows[2][3:5], rows[3][3:5])
        # Nothing is missing in either, as far as the balance is summed: to 1e-10 of what is lost.
        self.assertLess(numpy.abs(rows[3][5:]).max(), 1e-10 * self.LOST)
        self.assertEqual(rows[4][1:], rows[3][3:5])
        self.check([0.0, 0.0], rows[5][1:], 2)


if __name__ == "__main__":
    unittest.main()
