# SPDX-License-Identifier: BSD-3-Clause
"""LAMMPS' `fix balance` moves the cut between two ranks while a cloud of cohesive, rubbing spheres falls through the
gas, pair_style gran/hamaker, scheme event: contacts keep their history and spheres what they feel of the gas, so that
the end is that of one rank, nearer than that of a run whose velocities are off by 1e-9."""

import re
import unittest

import numpy as np

from cohesion_tests.coupling.cases import disturb, edit, script_file
from cohesion_tests.coupling.swarm import DISTURBANCE, difference, make, state
from cohesion_tests.coupling.test_case import CoupledTestCase

FILE = script_file("cohesive", "lammps")
SPHERES = 1000
HYBRID = ("pair_style   hybrid/overlay gran/hooke 500 NULL 500 NULL 0 0 hamaker cutoff 1e-6 2e-5\n"
          "pair_coeff   * * gran/hooke\npair_coeff   * * hamaker hamaker ${A}\n")
# A contact of 2e-4 s, 20 steps; pull-off force twelve weights.
CONTACT = ("pair_style   gran/hamaker scheme event\n"
           "pair_coeff   * * stiffness 500 restitution 0.9 friction 0.3 hamaker 1e-18 cutoff 4e-10 1e-7\n")
# The cut is across the fall: all spheres are on one rank before it moves. 1.0: it moves whenever one has more.
BALANCE = """fix          cuts all balance 50 1.0 shift z 10 1.0
thermo_style custom step atoms f_cuts[1] f_cuts[2]
thermo       50
fix gas """


def run(column, name, ranks, cuts, disturbance=0.0):
    case = make(column, name, "cohesive")
    edit(case, FILE, HYBRID, CONTACT)
    if cuts:
        edit(case, FILE, "thermo       10000\nthermo_modify lost error\nfix gas ", BALANCE)
    if disturbance:
        disturb(case, "cohesive", disturbance, "lammps")
    return case, state(case, case.solve(ranks=ranks), ranks)


class MovingCuts(CoupledTestCase):
    def test_same_as_on_one_rank(self):
        _, whole = run(self.column, "one", 1, False)
        _, disturbed = run(self.column, "disturbed", 1, False, DISTURBANCE)
        case, found = run(self.column, "moving", 2, True)
        limits = difference(disturbed, whole)
        for name, apart in difference(found, whole).items():
            self.expect_below(f"{name}, largest difference / largest value", apart, limits[name])
        # Spheres meet, and history counts: of spheres that fly singly the drag lets no difference grow.
        self.expect_below("1e-9 over what became of it", DISTURBANCE / limits["particle velocity"], 1 / 3)
        said = (case.folder / "log.lammps").read_text()
        rows = np.array(re.findall(rf"^\s*(\d+)\s+{SPHERES}\s+(\d+)\s+\d+\s*$", said, re.M), dtype=int)
        late = rows[rows[:, 0] > 0]
        # A cut between layers of a lattice of ten leaves one rank a layer more; when they have mixed, a sphere or two.
        self.expect_true("the ranks' spheres are counted", len(late) > 10)
        self.expect_below("most spheres of a rank, in the mean after the first step", late[:, 1].mean(), 0.65 * SPHERES)


if __name__ == "__main__":
    unittest.main()
