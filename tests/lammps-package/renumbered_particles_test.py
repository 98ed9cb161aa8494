# SPDX-License-Identifier: BSD-3-Clause
"""delete_atoms, which gives particles other IDs unless told not to, and the command that renumbers them alone:
what contacts remember of each other stays, to the last digit, on one rank and on two."""
import unittest

import numpy

from cohesion_tests import lammps as engine
from cohesion_tests.test_cases import FolderTestCase

# Two couples, pulled apart across their normals within the friction, and a sphere that is pressed along a wall by
# its tangential spring; spectators with IDs between theirs. Springs that are lost show in the next steps.
SPHERES = ((2e-3, 18e-3, 18e-3), (5e-3, 9.5e-3, 10e-3), (5e-3, 10.49e-3, 10e-3), (18e-3, 18e-3, 18e-3),
           (15e-3, 9.5e-3, 10e-3), (15e-3, 10.49e-3, 10e-3), (18e-3, 2e-3, 2e-3), (10e-3, 10e-3, 0.495e-3))
HEAD = """
plugin load ${plugin}
units si
atom_style sphere
newton off
processors 1 * 1
"""
BOX = """
boundary f f f
region b block 0 0.02 0 0.02 0 0.02
create_box 1 b
%(spheres)s
set group all diameter 1e-3 density 2650
group up id 3
group down id 6
group along id 8
"""
FIXES = """
comm_modify vel yes
timestep 1e-5
neighbor 2e-4 bin
neigh_modify delay 0 every 1 check yes
%(pair)s
fix w all wall/%(wall)s zplane 0 NULL
fix pull up addforce 0 0 5e-4
fix pull2 down addforce 0 0 -5e-4
fix pull3 along addforce 5e-4 0 0
fix m all nve/sphere
"""
END = """
run 60
write_dump all custom end.txt x y z vx vy vz omegax omegay omegaz modify sort 1 format float %.17g
"""
RENUMBER = ('if "$(version) < 20220800" then "reset_atom_ids sort yes" else "reset_atoms id sort yes"\n')
DELETE = "group gone id 1 4 7\ndelete_atoms group gone compress "
WAYS = {"renumbered": RENUMBER, "deleted": DELETE + "yes\n", "deleted, others in their place":
        DELETE + "yes\ncreate_atoms 1 single 0.002 0.018 0.018\nset group all diameter 1e-3 density 2650\n",
        "deleted, IDs kept": DELETE + "no\n", "deleted, then renumbered": DELETE + "no\n" + RENUMBER}
CONTACT = "stiffness 800 restitution 0.9 friction 5 "
LAWS = {"gran/hamaker": "hamaker 1e-16 cutoff 4e-10 1e-7", "gran/squarewell": "well 1e-9 1.1",
        "gran/liquidbridge": "bridge 1e-4 1e-5"}


class Renumbered(FolderTestCase):
    def end(self, between, law="gran/hamaker", scheme="exact", ranks=1, map_words="", rolling="", restart=""):
        words = CONTACT + rolling + LAWS[law]
        spheres = "\n".join(f"create_atoms 1 single {x!r} {y!r} {z!r}" for x, y, z in SPHERES)
        fixes = FIXES % {"wall": f"{law} scheme {scheme} {words}",
                         "pair": f"pair_style {law} scheme {scheme}\npair_coeff * * {words}"}
        first = HEAD + map_words + BOX % {"spheres": spheres} + fixes + "run 60\n" + between
        parts = [first + END]
        if restart:
            parts = [first + restart,
                     HEAD + "read_restart some.restart\n" + fixes.replace("pair_", "#") + END]
        for part in parts:
            code, output = engine.run_text(part, self.folder, ranks=ranks)
            self.assertEqual(code, 0, output)
        end = engine.dump(self.folder, "end.txt")
        # In the order of their places, and without the spectators, which rest in corners.
        end = end[(numpy.abs(end[:, 0] - 10e-3) < 6e-3) & (end[:, 2] < 15e-3)]
        return end[numpy.lexsort((end[:, 1].round(3), end[:, 0].round(3)))]

    def same(self, ways=WAYS, **scene):
        whole = self.end("", **scene)
        self.assertEqual(len(whole), 5)
        self.assertGreater(numpy.abs(whole[:, 6:]).max(), 0.0)
        for name, between in ways.items():
            with self.subTest(name, **scene):
                numpy.testing.assert_array_equal(self.end(between, **scene), whole)

    def test_laws(self):
        for law in LAWS:
            self.same(law=law)

    def test_sampled(self):
        self.same({"deleted": WAYS["deleted"]}, scheme="sampled")

    def test_rolling(self):
        self.same({"deleted": WAYS["deleted"]}, rolling="rolling_friction 0.1 ")

    def test_two_ranks(self):
        # Each couple has one sphere on either rank.
        self.same(ranks=2)

    def test_atom_map(self):
        for words in ("atom_modify map array\n", "atom_modify map hash sort 1 1e-3\n"):
            self.same({name: WAYS[name] for name in ("renumbered", "deleted")}, map_words=words)

    def test_through_a_restart_file(self):
        ways = {name: WAYS[name] for name in ("renumbered", "deleted")}
        self.same(ways, restart="run 0\nwrite_restart some.restart noinit\n")

    def test_through_a_restart_file_at_once(self):
        # Without a set-up between, in which the engine makes a new neighbour list.
        ways = {name: way for name, way in WAYS.items() if "others" not in name}
        self.same(ways, restart="write_restart some.restart noinit\n")
        ways = {name: WAYS[name] for name in ("deleted", "deleted, IDs kept")}
        self.same(ways, restart="write_restart some.restart\n")
        self.same(ways, restart="write_restart some.restart noinit\n", ranks=2)

    def test_a_restart_file_changes_nothing_in_the_run_that_writes_it(self):
        for words in ("some.restart noinit", "some.restart"):
            self.same({name: way + f"write_restart {words}\n" for name, way in WAYS.items()})


if __name__ == "__main__":
    unittest.main()
