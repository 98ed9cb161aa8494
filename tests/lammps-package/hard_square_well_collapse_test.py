# SPDX-License-Identifier: BSD-3-Clause
"""What breaks naive codes, under pair_style hard/squarewell: corners, inelastic collapse, input that cannot work."""
import math
import re
import unittest

import numpy

from cohesion_tests import lammps as engine
from cohesion_tests.lammps_scenes import hard_spheres as hard
from cohesion_tests.lammps_scenes.hard_extremes import BOX, follow, refused
from cohesion_tests.lammps_scenes.hard_gas import Gas
from cohesion_tests.theory.event_driven_reference import Plane, Reference
from cohesion_tests.thermo import thermo_columns


class Corner(unittest.TestCase):
    """Planes act along their own axes, so events that happen together may do so in any order. Places of
    up to 10 and 60 steps: 5e-14."""

    def into(self, x, v, words, plane, dimension=3):
        axes = range(dimension)
        planes = [Plane(axis, place, side, *plane) for axis in axes
                  for place, side in ((0.0, 1), (10.0, -1))]
        exact = Reference([x], [v], 0.5, 1.0, 3 * [math.inf], planes=planes)
        exact.run(3.0)
        more = [f"fix side{axis} all wall/hard/squarewell {words} {'xyz'[axis]}plane 0 10"
                for axis in axes]
        path, events, _, _ = follow([hard.atom(x, v)], ["* * restitution 1 well 0.1 1.2"], 0.05, 60,
                                    box=dimension * [(0.0, 10.0)] + (3 - dimension) * [(-0.5, 0.5)],
                                    boundary=" ".join(dimension * "f" + (3 - dimension) * "p"),
                                    dimension=dimension, more=more)
        self.assertEqual(sorted(event.kind for event in events),
                         sorted("wall_" + event.kind for event in exact.events))
        self.assertGreaterEqual(len(exact.events), dimension)
        numpy.testing.assert_allclose(path[-1, 0, 1:4], exact.place(3.0)[0], rtol=0, atol=1e-13)
        numpy.testing.assert_allclose(path[-1, 0, 4:7], exact.v[0], rtol=0, atol=1e-13)

    def test_straight_in(self):
        for v in (1.0, 0.4):
            self.into((1.5, 1.5, 1.5), (-v, -v, -v), "restitution 0.8", (0.8, 0.0, 0.2, 1.2))
            self.into((8.5, 1.5, 0.0), (v, -v, 0.0), "restitution 0.8", (0.8, 0.0, 0.2, 1.2), 2)

    def test_nearly_straight_in(self):
        self.into((1.5, 1.5 + 1e-13, 8.5), (-1.0, -1.0 - 1e-14, 1.0), "restitution 0.9",
                  (0.9, 0.0, 0.2, 1.2))

    def test_captured_by_two_hard_walls(self):
        self.into((0.55, 0.58, 5.0), (-0.2, 0.1, 0.0), "restitution 1 well 1 1.2",
                  (1.0, 0.0, 1.0, 1.2))


class Collapse(unittest.TestCase):
    """A row pressed on a wall with e = 0.1 has infinitely many collisions within a finite time."""

    def row(self, style, **options):
        atoms = [hard.atom((0.51 + 1.01 * n, 10, 10), (-1.0, 0, 0)) for n in range(10)]
        box = [(0.0, 20.0)] * 3
        more = ["fix down all gravity 1.0 vector -1 0 0",
                "fix floor all wall/hard/squarewell restitution 0.1 xplane 0 20"]
        return atoms, ["* * restitution 0.1"], {"box": box, "style": style, "more": more,
                                                "boundary": "f p p", **options}

    def settles(self, style):
        """Table and output of the row, which comes to rest under its weight."""
        atoms, pair, options = self.row(style)
        path, _, table, output = follow(atoms, pair, 0.01, 2000, every=10, **options)
        self.assertLessEqual(table["c_events[18]"].max(), 100000)
        x = path[:, :, 1]
        self.assertGreater(x[:, 0].min(), 0.5 - 1e-12)
        self.assertGreater(numpy.diff(x, axis=1).min(), 1 - 1e-12)
        # Settles: speeds of g dt are what the steps of gravity keep going.
        energy = (path[:, :, 4]**2).sum(axis=1) / 2 + x.sum(axis=1)
        self.assertLess(energy.max(), energy[0] + 1e-12)
        self.assertLess(abs(path[-1, :, 4]).max(), 0.1)
        return table, output

    def test_rule_of_elastic_collisions_acts_is_counted_and_the_run_goes_on(self):
        table, output = self.settles("rest off")
        self.assertGreater(table["c_events[17]"][-1], 0)
        self.assertEqual(table["c_events[35]"][-1], 0)
        self.assertEqual(len(re.findall("WARNING.*collapse", output)), 1, output[-2000:])

    def test_rule_of_rest_acts_is_counted_and_bounds_the_collisions(self):
        table, output = self.settles("")
        self.assertEqual(table["c_events[17]"][-1], 0)
        self.assertGreater(table["c_events[35]"][-1], 1000)
        self.assertGreater(table["c_events[36]"][-1], 0)
        self.assertNotIn("WARNING", output)
        # By the weight on the floor, 10 g dt in a step, a contact has at most 1 + (3 10/(2 1/2))^(2/3) = 11
        # collisions in a step, and a sphere has two; four times that while the row still falls on itself.
        self.assertLess(table["c_events[18]"][-1], 4 * 2 * 11)

    def test_creeping_along_a_cylinder(self):
        """Inside a cylinder a particle that loses normal speed at each hit has infinitely many within a
        finite time, though nothing presses it on: 2 R u_n/u_t^2 between two, which sums up. It then
        runs along the wall, with the speed it has, never farther out than the wall."""
        inner, turning = 2.6, 1.2 * 1.1 / 2.6
        atoms = [hard.atom((0.0, 1.2, 0.0), (1.1, 0.0, 0.25), 0.4)]
        path, _, table, output = follow(
            atoms, ["* * restitution 1"], 0.37, 400, box=3 * [(-10.0, 10.0)], style="", skin=2.0,
            boundary="f f p", every=1,
            more=["fix pipe all wall/hard/squarewell restitution 0.7 well off zcylinder 3.0"])
        across = path[:, 0, 4:6]
        energy = (across**2).sum(axis=1)
        self.assertLess(numpy.diff(energy).max(), 1e-14)
        radius = numpy.linalg.norm(path[:, 0, 1:3], axis=1)
        self.assertLess(radius.max(), inner + 1e-9)
        self.assertGreater(radius[200:].min(), inner - 1e-3)
        # Tangential: what it had, but for what the rule takes for a smallest normal speed.
        self.assertAlmostEqual(math.sqrt(energy[-1]), turning, delta=0.02 * turning)
        self.assertGreater(table["c_events[17]"][-1] + table["c_events[33]"][-1], 0)
        self.assertIn("collapse", output)

    def test_other_number_of_collisions(self):
        found = {}
        for style in ("rest off collapse 10", "rest off collapse 1000"):
            atoms, pair, options = self.row(style)
            _, _, table, _ = follow(atoms, pair, 0.01, 100, **options)
            found[style] = table["c_events[18]"][-1]
        self.assertLess(*found.values())
        self.assertGreater(found["rest off collapse 1000"], 1000)

    def test_limit_stops_with_the_pair_named(self):
        atoms, pair, options = self.row("rest off collapse off limit 1000")
        output = refused(self, atoms, pair, 0.01, 2000, **options)
        self.assertIn("1000", output)
        self.assertRegex(output, r"\b(10|[1-9])\b.*\b(10|[1-9])\b")
        self.assertIn("step", output)


class BoundClusters(unittest.TestCase):
    """A cluster that turns presses on some of its cores. Without a least speed of collisions that takes no energy the
    speeds within it tend to 0, and events have no end, at any step."""

    def conserves(self, table, bonds=None):
        """What events take is what motion loses; energy never grows. Sums of up to 1e6 changes of up to 1, with the
        round-off of each, 1e-16 of it, by chance: 1e-13; a hundred times that."""
        taken = sum(table[f"c_events[{n}]"] for n in (5, 6, 7, 8))
        numpy.testing.assert_allclose(table["KinEng"] - taken, table["KinEng"][0], rtol=1e-11)
        total = table["KinEng"] + table["PotEng"]
        self.assertLess(numpy.diff(total).max(), 1e-11 * abs(total[0]))
        self.assertGreater(table["c_events[35]"][-1], 0)
        self.assertGreater(table["c_events[36]"][-1], 0)
        if bonds:
            numpy.testing.assert_array_equal(table["PotEng"], -bonds)

    def test_triple(self):
        """Three that stay bound; on two processes, between which it lies, the same numbers."""
        places = ((4.4975, 4.70988148973221, 5), (5.5025, 4.70988148973221, 5), (5, 5.58023702053557, 5))
        velocities = ((-0.0998230172743, 0.0852188751405, 0.368268397984),
                      (0.193311832747, -0.242740743489, -0.0049150813103),
                      (-0.0934888154727, 0.157521868348, -0.363353316674))
        paths = []
        # Ranks exchange messages in every event: 200 steps have 265, of which 221 are those of the rule of rest.
        for ranks, steps in ((1, 2000), (2, 200)):
            path, _, table, _ = follow([hard.atom(*row) for row in zip(places, velocities)],
                                       ["* * restitution 0.5 well 1 1.01"], 0.05, steps, box=3 * [(0.0, 10.0)],
                                       style="", skin=1.0, every=100, ranks=ranks)
            self.conserves(table, 3.0)
            paths.append(path)
        numpy.testing.assert_array_equal(paths[0][:len(paths[1])], paths[1])

    def test_cooling_gases(self):
        """Each of these stops at the limit in its first 500 steps where nothing ends the cascades."""
        for seed in (1, 2):
            with self.subTest(seed=seed), engine.temporary_folder() as folder:
                gas = Gas(100, 0.03, seed=seed)
                gas.write(folder)
                path, table, _ = gas.run(folder, ["* * restitution 0.8 well 1 1.01"], 0.1, 500, style="", skin=1.0,
                                         every=100)
                self.conserves(table)
                # The momentum is 0 at the start; a hundred roundings of it per event, by chance.
                self.assertLess(abs(path[-1, :, 4:7].sum(axis=0)).max(), 1e-11)
                self.assertLess(table["KinEng"][-1], 0.2 * table["KinEng"][0])

    def test_clusters_between_walls_under_gravity(self):
        """With friction, sizes that differ, and spin: the rule of rest by kicks and by wells together."""
        gas = Gas(27, 0.3, radii=(0.4, 0.5), seed=5)
        with engine.temporary_folder() as folder:
            gas.write(folder, gas.spin())
            high = f"{gas.length:.17g}"
            _, table, _ = gas.run(folder, ["* * restitution 0.5 friction 0.3 well 1000 1.01"], 0.02, 1000, style="",
                                  skin=1.0, boundary="p p f", every=100,
                                  more=["fix down all gravity 0.5 vector 0 0 -1",
                                        "fix ends all wall/hard/squarewell restitution 0.5 friction 0.3 "
                                        f"zplane 0 {high}"])
            self.assertGreater(table["c_events[35]"][-1], 100)
            self.assertLess(table["c_events[18]"][-1], 20000)
            self.assertLess(table["KinEng"][-1], 0.2 * table["KinEng"][0])


class Input(unittest.TestCase):
    ATOMS = [hard.atom((5, 10, 10), (1, 0, 0)), hard.atom((8, 10, 10), (-1, 0, 0))]

    def refuse(self, words, pattern, **options):
        self.assertRegex(refused(self, self.ATOMS, [words], **options), pattern)

    def test_well_as_wide_as_the_core(self):
        self.refuse("* * restitution 1 well 1 1", "(?i)ratio.*infinit")

    def test_without_depth_it_may_be(self):
        # A depth of 0 is no well: nothing at the edge.
        _, events, _, _ = follow(self.ATOMS, ["* * restitution 1 well 0 1.5"], 0.1, 20)
        self.assertEqual([event.kind for event in events], ["collision"])
        self.assertAlmostEqual(hard.times(events, 0.1)[0], 1.0, delta=2e-14)

    def test_well_within_the_core(self):
        self.refuse("* * restitution 1 well 1 0.9", "0.9")

    def test_numbers_that_make_no_sense(self):
        for words in ("restitution -0.1", "restitution 1.1", "restitution nan", "restitution inf",
                      "restitution 1 well -1 1.1", "restitution 1 well nan 1.1",
                      "restitution 1 well 1 inf", "restitution 1 friction -0.2", "well 1 1.1",
                      "restitution 1 sticky 2", "restitution"):
            with self.subTest(words=words):
                refused(self, self.ATOMS, ["* * " + words])

    def test_flight_farther_than_the_list_reaches(self):
        """Refused with the numbers, rather than missed: 30 in a step."""
        atoms = [hard.atom((5, 10, 10), (30, 0, 0)), hard.atom((8, 10, 10), (-1, 0, 0))]
        self.assertRegex(refused(self, atoms, ["* * restitution 1"], dt=1.0, skin=0.3), r"\b30\b")

    def test_flight_farther_than_the_box(self):
        atoms = [hard.atom((5, 10, 10), (30, 0, 0)), hard.atom((8, 10, 10), (-1, 0, 0))]
        self.assertRegex(refused(self, atoms, ["* * restitution 1"], dt=1.0, skin=60.0),
                         r"30\b.* 20\b")

    def test_overlapping_start(self):
        """A start within the core is an error, or is left to part: it does not gain energy."""
        atoms = [hard.atom((5, 10, 10), (0.1, 0, 0)), hard.atom((5.9, 10, 10), (-0.1, 0, 0))]
        with engine.temporary_folder() as folder:
            engine.write_spheres(folder, atoms, BOX, 1)
            code, output = hard.start(folder, ["* * restitution 1"], 0.01, 10)
            if code == 0:
                self.assertAlmostEqual(thermo_columns(output)["KinEng"][-1], 0.01, delta=1e-15)


if __name__ == "__main__":
    unittest.main()
