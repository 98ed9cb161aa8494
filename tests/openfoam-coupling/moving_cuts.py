# SPDX-License-Identifier: BSD-3-Clause
"""LAMMPS' `fix balance` moves the cut between two ranks while a cloud of cohesive, rubbing spheres falls through the
gas, pair_style gran/hamaker, scheme exact: contacts keep their history and spheres what they feel of the gas, so that
the end is that of one rank, nearer than that of a run whose velocities are off by 1e-9."""

import re
import unittest

import numpy as np

from cohesion_tests.coupling.cases import CONTROL, COUPLING, append, disturb, edit, exchange_lines, script_file
from cohesion_tests.coupling.swarm import DISTURBANCE, END, difference, make, state
from cohesion_tests.coupling.test_case import CoupledTestCase

FILE = script_file("cohesive", "lammps")
SPHERES = 1000
GAS_STEP, RESIDUAL = 4e-4, 1e-14  # of the round column, and of its p
# What that leaves of p, relative to the largest: times the condition of ten rows, 1/sin^2(pi/40) = 162, in each of two
# correctors of both runs. A heap that comes to rest makes less of a disturbance.
LEFT_OF_P = 4 * 162 * RESIDUAL
HYBRID = ("pair_style   hybrid/overlay gran/hooke 500 NULL 500 NULL 0 0 hamaker cutoff 1e-6 2e-5\n"
          "pair_coeff   * * gran/hooke\npair_coeff   * * hamaker hamaker ${A}\n")
# A contact of 2e-4 s, 20 steps; pull-off force twelve weights.
CONTACT = ("pair_style   gran/hamaker scheme exact\n"
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


def slump(column, name, cuts, disturbance=0.0):
    """State at the end and lines of the exchange, on two ranks: of the column's box with a round wall."""
    case = make(column, name, "slumping")
    append(case, COUPLING, "lammpsCoeffs { variables { dt 2e-5; } }")  # a tenth of a contact
    append(case, CONTROL, f"deltaT {GAS_STEP};")
    append(case, "system/fvSolution", f'solvers {{ "p.*" {{ tolerance {RESIDUAL}; }} }}')
    append(case, "0.orig/U", "boundaryField { bottom { type superficialVelocity; superficialVelocity (0 0 0.3); } }")
    balance = "50 1.0 shift x 10 1.0" if cuts else "1000000 1000 shift x 1 2"  # the latter counts at the start, no more
    edit(case, "slumping.lmp", "thermo       50\n",
         f"fix cuts all balance {balance}\nthermo_style custom step atoms f_cuts f_cuts[1]\nthermo 50\n")
    if disturbance:
        disturb(case, "slumping", disturbance, "lammps")
    log = case.solve(ranks=2)
    return state(case, log, 2), exchange_lines(log)


def imbalance(log):
    """The fuller rank's spheres over half of all, LAMMPS' imbalance factor, in each line of its log."""
    rows = re.findall(r"^\s*\d+\s+(\d+)\s+[\d.]+\s+(\d+)\s*$", log.read_text(), re.M)
    return [2 * int(fuller) / int(atoms) for atoms, fuller in rows]


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

    def test_round_column(self):
        at_rest, lines = slump(self.column, "column-at-rest", False)
        disturbed, _ = slump(self.column, "column-disturbed", False, DISTURBANCE)
        found, moving_lines = slump(self.column, "column-moving", True)
        for what, of in (("at rest", lines), ("moving", moving_lines)):
            self.expect_equal(f"cut {what}: gas steps", len(of), round(float(END) / GAS_STEP))
            self.expect_balance(f"cut {what}", of)
        self.expect_equal("spheres", len(found["particle velocity"]), len(at_rest["particle velocity"]))
        limits = difference(disturbed, at_rest)
        limits["p"] = max(limits["p"], LEFT_OF_P)
        for name, apart in difference(found, at_rest).items():
            self.expect_below(f"round column: {name}, largest difference / largest value", apart, limits[name])
        # LAMMPS ends its search on either side of the layer of the lattice that has the middle. Layers are as large as
        # chords of the column, the largest 0.14 of all: a rank has up to so many too many, until they mix.
        factors = {cut: imbalance(self.work / f"column-{cut}/log.lammps") for cut in ("at-rest", "moving")}
        self.expect_equal("imbalance factor at the start, cut at rest", factors["at-rest"][0], 2.0)
        self.expect_true("the log has the factors", len(factors["moving"]) > 10)
        self.expect_below("imbalance factor, largest, moving cut", max(factors["moving"]), 1.28)


if __name__ == "__main__":
    unittest.main()
