# SPDX-License-Identifier: BSD-3-Clause
"""What compute gran/energy and compute gran/stress sum belongs to them: it ends with uncompute, and begins anew
with the next compute."""
import math
import unittest

import couples
import lammps_engine as engine
from couples import MU, STIFFNESS

RESTITUTION, SPEED = 0.8, 0.02
OVERLAP = SPEED * math.sqrt(MU / STIFFNESS)
DT = couples.CONTACT_TIME / 20
PART = 100  # steps in which one couple meets: 10 before and 20 of the contact
DEFINE = """
compute book all gran/energy
compute stress all gran/stress
thermo_style custom step c_book[6] c_stress[1][2]
thermo_modify norm no format float %.17g
"""
DELETE = """
thermo_style custom step
uncompute book
uncompute stress
"""


class Sums(unittest.TestCase):
    def test_a_new_one_begins_anew(self):
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
{DEFINE}run {PART}
{DELETE}run {PART}
{DEFINE}run {PART}
""", folder)
        self.assertEqual(code, 0, output[-2000:])
        lines = [line.split() for line in output.splitlines()]
        rows = [list(map(float, words)) for words in lines if len(words) == 3 and words[0].isdigit()]
        first, third = rows[:2], rows[2:]
        self.assertEqual(len(rows), 4)
        lost = 0.5 * (1 - RESTITUTION**2) * MU * SPEED**2
        for begin, end in (first, third):
            self.assertEqual(begin[1:], [0.0, 0.0])
            # A place is rounded by 2e-19 m in each of some 20 steps of contact, of an overlap of 6e-7 m.
            self.assertLess(abs(end[1] / lost - 1), 1e-10)
            # Along the distance, which is shorter by the overlap, up to that of the undamped spring.
            carried = couples.DIAMETER * (1 + RESTITUTION) * MU * SPEED
            self.assertLess(abs(end[2] / carried - 1), OVERLAP / couples.DIAMETER)


if __name__ == "__main__":
    unittest.main()
