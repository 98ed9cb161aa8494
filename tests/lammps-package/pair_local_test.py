# SPDX-License-Identifier: BSD-3-Clause
"""compute pair/local of pairs with soft contacts: the contacts that it lists make up the forces and torques of their
spheres, friction included; on two ranks, in a run that continues another, and in hybrid styles."""
import math
import unittest
from pathlib import Path

import numpy

from cohesion_tests.test_cases import ScriptTestCase

RADIUS, STEP = 5e-4, 1e-6
MASS = 2650 * 4 / 3 * math.pi * RADIUS**3
LAWS = {
    "hamaker": "gran/hamaker stiffness 800 restitution 0.7 {} hamaker 1e-18 cutoff 4e-10 1e-7",
    "hamaker, hertz": "gran/hamaker normal hertz 5e6 0.3 restitution 0.7 {} hamaker 1e-18 cutoff 4e-10 1e-7",
    "well": "gran/squarewell stiffness 800 restitution 0.7 {} well 1e-11 1.01",
    "bridge": "gran/liquidbridge stiffness 800 restitution 0.7 {} bridge 1e-4 1e-5",
    "jkr": "gran/jkr normal hertz 5e6 0.3 surface_energy 0.01 restitution 0.7 {}",
}
FRICTION = "friction 0.4 rolling_friction 0.1"
HEAD = """
plugin load ${{plugin}}
units si
atom_style sphere
boundary p p p
newton off
comm_modify vel yes
lattice sc 1.05e-3
region box block 0 4 0 4 0 4
create_box 1 box
create_atoms 1 box
set group all diameter 1e-3 density 2650
displace_atoms all random 2e-5 2e-5 2e-5 4711 units box
velocity all create 1 4711 loop geom
velocity all scale 3e15
neighbor 2e-4 bin
timestep {step}
pair_style {style} {scheme}
pair_coeff * * {words}
fix move all nve/sphere
{more}
"""
SHOW = """
compute contacts all pair/local dist force p1 p2 p3 p4 p5 p6 p7 p8 p9 p10
compute pairs all property/local patom1 patom2
"""
DUMPS = """dump contacts all local 40 {local} index c_pairs[1] c_pairs[2] c_contacts[*]
dump_modify contacts format float %.16g
dump spheres all custom 40 {spheres} id xu yu zu fx fy fz tqx tqy tqz
dump_modify spheres sort id format float %.16g
"""
# Sums of two computes that use neighbour lists of their own: p1 over pairs, and touches over spheres.
COUNTS = """
atom_modify sort 1000 1e-3
neigh_modify every 250 delay 0 check no
compute place all pair/local p1
compute touch all contact/atom
variable local string ""
if "$(version) > 20220800" then "variable local string 'inputs local'"
compute places all reduce sum c_place ${local}
compute touches all reduce sum c_touch
thermo_style custom step c_places c_touches
"""
PRINT = 'print "COUNTS $(c_places) $(c_touches)"\n'
SIDE = 4 * 1.05e-3
CLOSE = 1e-3  # spacing of the dense packing


def frames(file):
    """The numbers of each time step of a dump."""
    found = []
    for text in Path(file).read_text().split("ITEM: TIMESTEP")[1:]:
        rows = text.split("ITEM: ATOMS" if "ITEM: ATOMS" in text else "ITEM: ENTRIES")[1].splitlines()[1:]
        found.append(numpy.array([[float(x) for x in row.split()] for row in rows]))
    return found


def sums(contacts, spheres):
    """Forces and torques of the contacts on each sphere, [N] and [N m]; the normals point from the first to the
    second."""
    force, torque = numpy.zeros((len(spheres), 3)), numpy.zeros((len(spheres), 3))
    for row in contacts:
        i, j = int(row[1]) - 1, int(row[2]) - 1
        apart = spheres[j, 1:4] - spheres[i, 1:4]
        apart -= SIDE * numpy.round(apart / SIDE)
        normal, friction, rolling = apart / row[3], row[9:12], row[12:15]
        on_i = -row[4] * normal + friction
        force[i] += on_i
        force[j] -= on_i
        for sphere, sign in ((i, 1), (j, -1)):
            torque[sphere] += 0.5 * row[3] * numpy.cross(normal, friction) + sign * rolling
    return force, torque


def ordered(contacts):
    """Those in range by the IDs of their spheres, the smaller one first."""
    rows = []
    for row in contacts[contacts[:, 5] > 0]:
        sign = 1.0 if row[1] < row[2] else -1.0
        rows.append([*sorted(row[1:3]), *row[3:9], *(sign * row[9:15])])
    return numpy.array(sorted(rows))


class PairLocal(ScriptTestCase):
    def run_of(self, law, friction="", scheme="", more="", steps="run 400\n", **options):
        """Contacts and spheres at each 40 steps."""
        style, words = LAWS[law].format(friction).split(" ", 1)
        local, spheres = Path(self.folder) / "local.txt", Path(self.folder) / "spheres.txt"
        self.goes(HEAD.format(step=STEP, style=style, scheme=scheme, words=words, more=more) +
                  SHOW + DUMPS.format(local=local, spheres=spheres) + steps, **options)
        return list(zip(frames(local), frames(spheres)))

    def assert_sums(self, found):
        most = max(numpy.abs(spheres[:, 4:7]).max() for _, spheres in found)
        self.assertGreater(most, 0.0)
        for contacts, spheres in found:
            force, torque = sums(contacts, spheres)
            # Both copies of a pair across a face round its distance, and the force of a resolved step has that
            # times mu/dt^2.
            rounding = 4 * numpy.finfo(float).eps * SIDE * 0.5 * MASS / STEP**2
            numpy.testing.assert_allclose(force, spheres[:, 4:7], rtol=0, atol=1e-12 * most + rounding)

    def test_forces_of_colliding_spheres(self):
        for law in LAWS:
            for scheme in ("", "scheme sampled") if law != "jkr" else ("",):
                with self.subTest(law, scheme=scheme):
                    found = self.run_of(law, scheme=scheme)
                    self.assert_sums(found)
                    places = numpy.concatenate([contacts[:, 5] for contacts, _ in found])
                    self.assertEqual(set(places) - {0.0, 1.0, 2.0}, set())
                    self.assertIn(2.0, places)
                    for contacts, _ in found:
                        overlaps = 2 * RADIUS - contacts[:, 3]
                        numpy.testing.assert_allclose(contacts[:, 6], overlaps, rtol=0, atol=1e-15 * SIDE)

    def test_two_ranks(self):
        one, two = (self.run_of("hamaker", ranks=ranks)[-1] for ranks in (1, 2))
        self.assert_sums([two])
        numpy.testing.assert_allclose(ordered(one[0]), ordered(two[0]), rtol=1e-9, atol=1e-15)

    def test_friction_at_rest(self):
        # Drag brings the spheres to rest, stuck together; all of their contacts are persistent then.
        for law, scheme in (("hamaker", ""), ("hamaker, hertz", ""), ("jkr", ""), ("hamaker", "scheme sampled")):
            with self.subTest(law, scheme=scheme):
                contacts, spheres = self.run_of(law, FRICTION, scheme, more="fix drag all viscous 2e-4\n",
                                                steps="run 4000\n")[-1]
                force, torque = sums(contacts, spheres)
                self.assertGreater(numpy.abs(contacts[:, 9:12]).max(), 0.0)
                self.assertGreater(numpy.abs(contacts[:, 12:15]).max(), 0.0)
                for row in contacts:
                    self.assertAlmostEqual(row[8], numpy.linalg.norm(row[9:12]), delta=1e-15)
                    self.assertLessEqual(row[8], 0.4 * row[7] * (1 + 1e-9))
                numpy.testing.assert_allclose(torque, spheres[:, 7:10], rtol=0,
                                              atol=1e-9 * RADIUS * numpy.abs(contacts[:, 7]).max())

    def test_a_run_that_continues_another_lists_the_same(self):
        again = Path(self.folder) / "again.txt"
        more = DUMPS.format(local=again, spheres=Path(self.folder) / "spheres_again.txt")
        before = self.run_of("hamaker", FRICTION, steps="run 80\nundump contacts\nundump spheres\n" + more +
                             "run 0\n")[-1][0]
        (after,) = frames(again)
        self.assertGreater(numpy.abs(before[:, 8]).max(), 0.0)
        # Setting up wraps spheres into the box, and orders them anew.
        numpy.testing.assert_allclose(ordered(after), ordered(before), rtol=1e-9, atol=1e-15)

    def counts(self, steps, **options):
        """The sums that `steps` print, of a dense packing that is set in motion."""
        style, words = LAWS["hamaker"].format(FRICTION).split(" ", 1)
        head = HEAD.format(step=STEP, style=style, scheme="", words=words, more="").replace("1.05e-3", f"{CLOSE}")
        output = self.goes(head + COUNTS + steps, **options)
        return [[float(word) for word in line.split()[1:]] for line in output.splitlines()
                if line.startswith("COUNTS")]

    def test_lists_at_the_set_up_of_a_second_run(self):
        # A run begins with a new order of the spheres, in which the lists of the last run are obsolete.
        steps = "run 300\n" + PRINT + "run 0\n" + PRINT + "run 0\n" + PRINT
        for ranks in (1, 2):
            with self.subTest(ranks=ranks):
                first, again, at_once = self.counts(steps, ranks=ranks)
                self.assertGreater(first[1], 60.0)
                self.assertEqual(again, first)
                self.assertEqual(at_once, first)

    def test_loose_spheres_are_deleted_in_several_passes(self):
        passes = 4
        each = ("write_dump all custom here.{} id x y z modify sort id format float %.17g\n" + PRINT +
                "variable loose atom c_touch<3\ngroup loose variable loose\n"
                "delete_atoms group loose compress no\ngroup loose delete\nrun 0\n")
        found = self.counts("run 300\n" + "".join(each.format(n) for n in range(passes)))
        expected = []
        for n in range(passes):
            x = frames(Path(self.folder) / f"here.{n}")[0][:, 1:4]
            apart = x[:, None] - x[None]
            apart -= 4 * CLOSE * numpy.round(apart / (4 * CLOSE))
            gaps = numpy.sqrt((apart**2).sum(axis=2))[numpy.triu_indices(len(x), 1)] - 2 * RADIUS
            expected.append(2 * (gaps < 0.0).sum())
        self.assertEqual([touches for _, touches in found], expected)
        # p1 is the state at the end of the step, which a collision within the step may have left.
        numpy.testing.assert_allclose([places for places, _ in found], expected, rtol=0, atol=4)
        self.assertGreater(expected[0], expected[-1])
        self.assertGreater(expected[-1], 0)

    def test_hybrid(self):
        style, words = LAWS["hamaker"].format("").split(" ", 1)
        script = HEAD.format(step=STEP, style="hybrid", scheme=style, words=f"{style} {words}", more="")
        self.goes(script + "compute c all pair/local dist force\ndump d all local 40 local.txt c_c[*]\nrun 40\n")
        self.stops(script + "compute c all pair/local p1\nrun 0\n", "extra field")


if __name__ == "__main__":
    unittest.main()
