# SPDX-License-Identifier: BSD-3-Clause
"""What a particle script may do: have the gas's gravity in every way that there is, have none for particles that are
held, have fixes behind fix gas/coupling that add no forces. What it may not: bad_input.py."""

import unittest

from cohesion_tests.coupling.cases import COUPLING, ENGINE, append, edit, script_file
from cohesion_tests.coupling.test_case import CoupledTestCase

SCRIPT = script_file("particles")
GRAVITY = "fix weight   all gravity 9.81 vector 0 0 -1"
GAS = "fix gas      all gas/coupling"


def gravity(case, lines, g="(0 0 -9.81)"):
    edit(case, SCRIPT, GRAVITY, lines)
    edit(case, "constant/g", "(0 0 -9.81)", g)


def plane(case):
    """One layer of cells across y: what there is of gravity along y is nobody's."""
    edit(case, "system/blockMeshDict", "(3 3 10)", "(3 1 10)")
    edit(case, "system/blockMeshDict", "((0 1 5 4) (1 2 6 5) (2 3 7 6) (3 0 4 7)); }",
         "((1 2 6 5) (3 0 4 7)); }\n    frontAndBack { type empty; faces ((0 1 5 4) (2 3 7 6)); }")
    for name in ("U", "p", "voidFraction"):
        edit(case, f"0.orig/{name}", "    top ", "    frontAndBack { type empty; }\n    top ")
    gravity(case, GRAVITY, "(0 -5 -9.81)")


RUN = {
    "two fixes gravity": lambda c: gravity(
        c, "fix one all gravity 8 vector 0 0 -3\nfix two all gravity 1.81 vector 0 0 -1"),
    # To four digits
    "chute": lambda c: gravity(c, "fix weight all gravity 9.81 chute 30", "(4.905 0 -8.496)"),
    "spherical": lambda c: gravity(c, "fix weight all gravity 9.81 spherical 90 120", "(0 8.4957 -4.905)"),
    "none for both": lambda c: gravity(c, "", "(0 0 0)"),
    "none, as the case says": lambda c: (gravity(c, ""), append(c, COUPLING, "particleGravity any;")),
    "none for a held particle": lambda c: (gravity(c, ""), edit(c, SCRIPT, "fix move     all nve/sphere", "")),
    "none for a frozen particle, frozen behind": lambda c: (
        gravity(c, ""), edit(c, SCRIPT, GAS, GAS + "\nfix hold all freeze")),
    "another for a particle whose force is set behind": lambda c: (
        gravity(c, ""), edit(c, SCRIPT, GAS, GAS + "\nfix hold all setforce 0 0 0")),
    "another along the one axis whose force is set behind": lambda c: (
        gravity(c, ""), edit(c, SCRIPT, GAS, GAS + "\nfix hold all setforce NULL NULL 0")),
    "none for a particle that nve/noforce leads": lambda c: (
        gravity(c, ""), edit(c, SCRIPT, "nve/sphere", "nve/noforce")),
    "not where the mesh ends": plane,
    # The walls of a snapped mesh end at other places than their STL, and a box may be smaller than the mesh or larger.
    "a box of nearly the size of the mesh": lambda c: edit(c, SCRIPT, "0 0.06 0 0.06 0 0.2",
                                                           "-0.009 0.0600001 1e-3 0.06 0 0.2"),
    "kept in a plane behind": lambda c: edit(c, SCRIPT, GAS, GAS + "\nfix flat all planeforce 0 1 0"),
}
if ENGINE == "liggghts":
    RUN["heat between particles behind"] = lambda c: edit(c, SCRIPT, GAS, f"""{GAS}
fix conduct all property/global thermalConductivity peratomtype 0.3
fix capacity all property/global thermalCapacity peratomtype 800
fix heat all heat/gran initial_temperature 300""")
if ENGINE == "lammps":
    RUN["a variable"] = lambda c: gravity(c, "variable g equal 9+0.81\nfix weight all gravity v_g vector 0 0 -1")


class ParticleScript(CoupledTestCase):
    def check(self, case, name, prepare):
        prepare(case)
        case.mesh()
        append(case, "system/controlDict", "endTime 1e-4; writeInterval 1e-4;")
        with self.subTest(name):
            case.solve()
            self.expect_true(f"{name}: runs", (case.folder / "0.0001/uniform/completeState").exists())

    @unittest.skipUnless(ENGINE == "lammps", "what the solver does by itself, with every engine")
    def test_one_rank_has_another(self):
        """Two particles, one without gravity, on the other rank."""
        case = self.column("ranks")
        edit(case, SCRIPT, "create_atoms 1 single 0.031 0.029 0.19",
             "create_atoms 1 single 0.031 0.029 0.19\ncreate_atoms 1 single 0.011 0.029 0.05")
        gravity(case, "region low block 0 0.02 0 0.06 0 0.1 units box\ngroup light region low\n"
                      "group heavy subtract all light\nfix weight heavy gravity 9.81 vector 0 0 -1")
        case.mesh()
        self.refused("particles of two gravities on two ranks", case,
                     "and (0 0 -9.81) to (0 0 0) m/s2 for the particles", ranks=2)

    def test_runs(self):
        for number, (name, prepare) in enumerate(RUN.items()):
            self.check(self.column(str(number)), name, prepare)


if __name__ == "__main__":
    unittest.main()
