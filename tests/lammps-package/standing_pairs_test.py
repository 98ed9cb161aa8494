# SPDX-License-Identifier: BSD-3-Clause
"""Pairs, and spheres at walls, that stand in range without having flown there: however they came there, they
have the energy of where they are, as in a run that begins with them there, and keep it."""
import math
import unittest

import numpy

from cohesion_tests.test_cases import ScriptTestCase
from cohesion_tests.thermo import thermo_columns

D, K = 1e-3, 800.0
X, Y = 0.0095, (0.004, 0.008)  # of the spheres that are always there
GAP, OVERLAP = -2e-10, 1e-7  # both as overlaps
A, NEAR, FAR = 1e-18, 4e-10, 1e-7
DEPTH, RATIO = 1e-12, 1.2
BRIDGE, RUPTURE = 1e-6, 1e-5

HEAD = """
plugin load ${plugin}
units si
newton off
atom_style sphere
comm_modify vel yes
"""
BOX = """
boundary f f f
region b block 0 0.02 0 0.02 0 0.02
create_box 2 b
create_atoms 2 single 0.0145 0.015 0.01
"""
SIZE = "set group all diameter 1e-3 density 2650\n"
REST = """
timestep 1e-5
neighbor 2e-4 bin
neigh_modify delay 0 every 1 check yes
"""
SHOW = """
compute tally all gran/energy
thermo_style custom step c_tally
thermo_modify norm no format float %.15g
thermo 1
run 400
"""
MOVE = "fix m all nve/sphere\n"
SOME = "fix m spectator nve/sphere\n"
# It flies 5e-7 m in half a step: as far as pairs have to be seen.
FAST = "velocity spectator set 0.1 0 0\n"


SOME_WAYS = ("not integrated before", "displaced by little", "led there", "created")


class Law:
    """A style, its description, and the energy of its attraction at an overlap and an effective radius."""

    def __init__(self, style, words, energy):
        self.style, self.words, self.energy = style, f"stiffness {K} restitution 1 {words}", energy

    def stored(self, overlap, radius):
        return 0.5 * K * max(overlap, 0.0)**2 + self.energy(overlap, radius)


def of_hamaker(overlap, radius):
    # The tail, the integral of F (H_cut/H)^2 beyond H_cut, and the constant force up to there.
    force = A * radius / (6 * NEAR**2)
    return -force * (NEAR * (1 - NEAR / FAR) + NEAR + overlap)


HAMAKER = Law("gran/hamaker", f"hamaker {A} cutoff {NEAR} {FAR}", of_hamaker)
WELL = Law("gran/squarewell", f"well {DEPTH} {RATIO}", lambda overlap, radius: -DEPTH)
BRIDGES = Law("gran/liquidbridge", f"bridge {BRIDGE} {RUPTURE}", lambda overlap, radius: -BRIDGE * overlap)


def ways_of_all(law):
    """By name: lines before a run of ten steps, and behind it; of one sphere or two of type 1, of which the last
    one is in the group sphere. `law`: the lines that make the contact."""
    return {
        "from the start": (law + MOVE, ""),
        "not integrated before": (law + SOME, "unfix m\n" + MOVE),
        "frozen before": (law + MOVE + "fix f grains freeze\n", "unfix f\n"),
        "displaced": (law + MOVE + "displace_atoms sphere move 1e-3 0 0\n", "displace_atoms sphere move -1e-3 0 0\n"),
        "displaced by little": (law + MOVE + FAST + "displace_atoms sphere move 2e-7 0 0\n",
                                "displace_atoms sphere move -2e-7 0 0\n"),
        "grown": (law + MOVE + FAST + "set group grains diameter 0.9996e-3\n",
                  "set group grains diameter 1e-3 density 2650\n"),
        "led there": (law + SOME + "displace_atoms sphere move 1e-7 0 0\nfix lead sphere move linear -1e-3 0 0\n",
                      "unfix lead\nvelocity sphere set 0 0 0\nunfix m\n" + MOVE),
    }


class Standing(ScriptTestCase):
    def check(self, law, scheme, radius, overlaps, ways, names=None, ranks=1):
        """The kinetic and stored energy in each step of the second run: that of where the contacts are when it
        begins, of effective radius `radius`."""
        for name, (before, between) in ways.items():
            if names and name not in names:
                continue
            with self.subTest(name, law=law.style, scheme=scheme, ranks=ranks):
                output = self.goes(f"{HEAD}processors * 1 1\n{BOX}{before}run 10\n{between}{SHOW}", ranks=ranks)
                energy = thermo_columns(output)["c_tally"]
                if FAST in before:
                    energy -= 0.5 * 2650 * math.pi * D**3 / 6 * 0.1**2
                stored = sum(law.stored(overlap, radius) for overlap in overlaps)
                # The positions are rounded by 1e-18 m of 2e-10 m, at each bounce anew.
                numpy.testing.assert_allclose(energy[0], stored, rtol=1e-7)
                if scheme == "exact":
                    numpy.testing.assert_allclose(energy, stored, rtol=1e-6)

    def pairs(self, law, scheme, overlaps, names=None, ranks=1):
        first = "".join(f"create_atoms 1 single {X} {y} 0.01\n" for y in Y[:len(overlaps)])
        second = "".join(f"create_atoms 1 single {X + D - overlap!r} {y} 0.01\n" for y, overlap in zip(Y, overlaps))
        last = "group sphere id > {}\n".format(1 + len(overlaps))
        groups = SIZE + "group grains type 1\ngroup spectator type 2\n"
        head = first + second + groups + last + REST
        pair = f"pair_style {law.style} scheme {scheme}\npair_coeff * * {law.words}\n"
        other = f"pair_style {law.style} scheme {scheme}\npair_coeff * * stiffness {K} restitution 1\n"
        ways = {name: (head + before, between) for name, (before, between) in ways_of_all(pair).items()}
        ways["excluded before"] = (head + pair + MOVE + "neigh_modify exclude type 1 1\n",
                                   "neigh_modify exclude none\n")
        ways["of another pair style"] = (head + other + SOME, "unfix m\n" + pair + MOVE)
        ways["of another type"] = (head + "set group grains type 2\n" + other + f"pair_coeff 1 1 {law.words}\n" + SOME,
                                   "set group grains type 1\nunfix m\n" + MOVE)
        ways["created"] = (first + groups + REST + pair + MOVE, second + SIZE)
        self.check(law, scheme, D / 4, overlaps, ways, names, ranks)

    def test_hamaker(self):
        self.pairs(HAMAKER, "exact", (GAP, OVERLAP))

    def test_square_well(self):
        self.pairs(WELL, "exact", (-5e-8, OVERLAP))

    def test_liquid_bridge(self):
        self.pairs(BRIDGES, "exact", (OVERLAP,), SOME_WAYS)

    def test_sampled(self):
        self.pairs(HAMAKER, "sampled", (GAP,), SOME_WAYS)
        self.pairs(WELL, "sampled", (-5e-8,), SOME_WAYS)

    def test_two_ranks(self):
        # The border is at 0.01, where the spheres touch.
        self.pairs(HAMAKER, "exact", (GAP, OVERLAP), SOME_WAYS, ranks=2)

    def test_walls(self):
        for law, overlaps, names in ((HAMAKER, (GAP, OVERLAP), None), (WELL, (-5e-8, OVERLAP), SOME_WAYS),
                                     (BRIDGES, (OVERLAP,), SOME_WAYS)):
            spheres = "".join(f"create_atoms 1 single {X - overlap!r} {y} 0.01\n" for y, overlap in zip(Y, overlaps))
            head = (f"{spheres}{SIZE}group grains type 1\ngroup spectator type 2\ngroup sphere type 1\n{REST}"
                    f"pair_style {law.style}\npair_coeff * * stiffness {K} restitution 1\n")
            wall = f"fix w all wall/{law.style} {law.words} xplane {X - D / 2!r} NULL\n"
            ways = {name: (head + before, between) for name, (before, between) in ways_of_all(wall).items()}
            self.check(law, "exact", D / 2, overlaps, ways, names)

    def test_dynamic_group(self):
        # Nothing moves, and so no list of neighbours is made when the group gets its particles.
        for ranks in (1, 2):
            self.pairs_of_group(ranks)

    def pairs_of_group(self, ranks):
        spheres = f"create_atoms 1 single {X} {Y[0]} 0.01\ncreate_atoms 1 single {X + D - GAP!r} {Y[0]} 0.01\n"
        output = self.goes(f"{HEAD}processors * 1 1\n{BOX}{spheres}{SIZE}{REST}pair_style gran/hamaker\n"
                           f"pair_coeff * * {HAMAKER.words}\nvariable late atom step>20\n"
                           f"group some dynamic all every 1 var late\nfix m some nve/sphere\n{SHOW}", ranks=ranks)
        energy = thermo_columns(output)["c_tally"]
        self.assertEqual(abs(energy[:20]).max(), 0.0)
        numpy.testing.assert_allclose(energy[25:], HAMAKER.stored(GAP, D / 4), rtol=1e-6)


class Poured(ScriptTestCase):
    def test_into_wells(self):
        # Spheres appear within each other's wells. Each pair nearer than the edge is bound, and stays so.
        for style, coefficients in (("gran/squarewell", "* * stiffness 800 restitution 1 well 1e-10 1.5"),
                                    ("gran/squarewell scheme sampled", "* * stiffness 800 restitution 1 well 1e-10 1.5"),
                                    ("hybrid/overlay gran/hooke/history 800 NULL 0 NULL 0 0 squarewell",
                                     "* * gran/hooke/history\npair_coeff * * squarewell 1e-10 1.5")):
            with self.subTest(style):
                output = self.goes(f"{HEAD}boundary p p f\nregion b block 0 0.006 0 0.006 0 0.02\ncreate_box 1 b\n"
                                   f"create_atoms 1 single 0.003 0.003 0.019\n{SIZE}{REST}pair_style {style}\n"
                                   f"pair_coeff {coefficients}\n{MOVE}fix g all gravity 1e-9 vector 0 0 -1\n"
                                   "region r block 0 0.006 0 0.006 0.002 0.008\nfix p all pour 60 1 4711 region r diam "
                                   "one 1e-3 dens 2650 2650 vol 0.6 500 vel 0 0 0 0 0\ncompute near all coord/atom "
                                   "cutoff 1.5e-3\ncompute all all reduce sum c_near\nthermo_style custom step atoms pe "
                                   "c_all\nthermo_modify norm no\nthermo 1\nrun 15\n")
                of = thermo_columns(output)
                self.assertGreater(of["c_all"][-1], 100)
                numpy.testing.assert_allclose(of["PotEng"][3:], -1e-10 * of["c_all"][3:] / 2, rtol=1e-5)


if __name__ == "__main__":
    unittest.main()
