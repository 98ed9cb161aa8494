# SPDX-License-Identifier: BSD-3-Clause
"""Spheres of which fix setforce, lineforce or planeforce sets the whole force count as held, as those of fix freeze:
what strikes them sees a wall. Where such fixes hold spheres in part, contacts are right in a layer, and the run stops
elsewhere."""
import unittest

import numpy

from cohesion_tests import lammps as engine
from cohesion_tests.lammps_scenes.small_box import box, spheres
from cohesion_tests.test_cases import ScriptTestCase

SPEED = 0.1
# The second sphere flies past the middle of the first, which is held.
HEAD = box(types=2) + spheres((1, 0.005, 0.005, 0.005), (2, 0.00605, "%(y)s", 0.005)) + f"""group held type 1
group flies type 2
velocity flies set -{SPEED} 0 0
neighbor 2e-4 bin
neigh_modify delay 0 every 1 check yes
timestep 1e-6
"""
MOVE, HOLD = "fix move all nve/sphere\n", "fix hold held setforce 0 0 0\n"
CONTACT = "stiffness 800 restitution %(e)s friction %(mu)s"
STYLES = {
    "gran/hamaker": (CONTACT + " hamaker 1e-18 cutoff 4e-10 1e-7", ""),
    "gran/squarewell": (CONTACT + " well 1e-12 1.01", ""),
    "gran/hamaker scheme sampled": (CONTACT + " hamaker 0 cutoff 4e-10 1e-7", ""),
    "hard/squarewell": ("restitution %(e)s friction %(mu)s well 1e-12 1.01", ""),
}
FREEZE = MOVE + "fix hold held freeze\n"
WHOLLY = {
    "setforce": MOVE + HOLD,
    "setforce first": HOLD + MOVE,
    "setforce twice": MOVE + "fix a held setforce 0 NULL 0\nfix b all setforce NULL NULL NULL\n"
                             "fix c held setforce NULL 0 NULL\n",
    "along each axis": MOVE + "fix a held planeforce 1 0 0\nfix b held planeforce 0 1 0\nfix c held planeforce 0 0 2\n",
    "line and plane": MOVE + "fix a held lineforce 1 0 1\nfix b held planeforce 2 0 2\n",
    "variables": MOVE + "variable none equal 0*step\nfix hold held setforce v_none v_none 0\n",
}
RESULT = "write_dump all custom end.txt id x y z vx vy vz omegax omegay omegaz modify format float %.17g sort id\n"


def script(style, fixes, run="run 3000\n", y="0.0052", e=0.5, mu=0.3):
    values = dict(y=y, e=e, mu=mu)
    return HEAD % values + f"pair_style {style}\npair_coeff * * {STYLES[style][0] % values}\n" + fixes + run + RESULT


class Held(ScriptTestCase):
    def ends(self, text, **options):
        self.goes(text, **options)
        return engine.dump(self.folder, "end.txt")[:, 1:]

    def test_as_frozen(self):
        for style in STYLES:
            frozen = self.ends(script(style, FREEZE))
            for how, fixes in WHOLLY.items():
                with self.subTest(style, how=how):
                    held = self.ends(script(style, fixes))
                    # A direction that is none of the axes leaves roundings of a force.
                    numpy.testing.assert_allclose(held[0], frozen[0], rtol=0, atol=1e-12)
                    # The same numbers but for roundings of what goes on beside the contact.
                    numpy.testing.assert_allclose(held[1], frozen[1], rtol=1e-9, atol=1e-12)

    def test_elastic_impact_gives_the_speed_back(self):
        for style in STYLES:
            # An elastic pair under *exact*, and hard spheres, keep the speed to rounding; a sampled one to
            # (w0 dt)^2/8, which is 7e-5 here: w0 dt = 1e-6 sqrt(800/1.39e-6).
            allowed = 1e-4 if "sampled" in style else 1e-5
            for how in ("setforce", "line and plane"):
                with self.subTest(style, how=how):
                    end = self.ends(script(style, WHOLLY[how], y="0.005", e=1, mu=0))
                    self.assertAlmostEqual(end[1][3] / SPEED, 1.0, delta=allowed)
                    numpy.testing.assert_allclose(end[0][3:6], 0.0, atol=1e-12)

    def test_ranks_and_restart(self):
        for style in ("gran/hamaker", "hard/squarewell"):
            whole = self.ends(script(style, WHOLLY["setforce"]))
            two = self.ends(script(style, WHOLLY["setforce"]), ranks=2)
            numpy.testing.assert_allclose(two[1], whole[1], rtol=1e-9, atol=1e-12)
            self.goes(script(style, WHOLLY["setforce"], "run 520\nwrite_restart half.restart\n"))
            self.goes("plugin load ${plugin}\nnewton off\nread_restart half.restart\ncomm_modify vel yes\n"
                      "neighbor 2e-4 bin\nneigh_modify delay 0 every 1 check yes\ntimestep 1e-6\n" + MOVE + HOLD +
                      "run 2480\n" + RESULT)
            again = engine.dump(self.folder, "end.txt")[:, 1:]
            numpy.testing.assert_allclose(again[1], whole[1], rtol=1e-9, atol=1e-12)

    def test_a_group_that_changes(self):
        """One that is let go is struck as a free one: the momentum is that of both."""
        release = HOLD + MOVE + "run 100\nunfix hold\nrun 2900\n"
        for style in ("gran/hamaker", "hard/squarewell"):
            end = self.ends(script(style, "", release, y="0.005", mu=0))
            self.assertAlmostEqual((end[0][3] + end[1][3]) / -SPEED, 1.0, delta=1e-9)

    def test_one_that_forces_lead(self):
        """A force that a fix sets leads a sphere, whatever strikes it: it goes on at constant acceleration."""
        for style in ("gran/hamaker", "hard/squarewell"):
            end = self.ends(script(style, MOVE + "fix lead held setforce 0 1e-6 0\n"))
            mass, time = 2650 * numpy.pi / 6 * 1e-9, 3000e-6
            self.assertAlmostEqual(end[0][1] - 0.005, 1e-6 / mass * time**2 / 2, delta=1e-9)
            self.assertEqual(end[0][0], 0.005)

    def test_walls_leave_the_held_alone(self):
        wall = "fix w all wall/gran/hamaker stiffness 800 restitution 0.5 zplane 0.0047 NULL\n"
        end = self.ends(script("gran/hamaker", HOLD + wall + MOVE + "fix down flies setforce NULL NULL 0\n", e=0.5))
        self.assertEqual(list(end[0][3:6]), [0.0, 0.0, 0.0])

    def test_bridges_of_the_held_stay(self):
        # The spheres touched and are in their gap, at rest, when both are held and released again.
        holds = {"freeze": ("fix hold all freeze", "unfix hold"), "setforce": ("fix hold all setforce 0 0 0", "unfix hold"),
                 "no integration": ("unfix move", MOVE)}
        for how, (hold, release) in holds.items():
            with self.subTest(how):
                self.goes(box() + spheres((1, 0.003, 0.005, 0.005), (1, 0.0039998, 0.005, 0.005)) + f"""
pair_style gran/liquidbridge
pair_coeff * * stiffness 800 restitution 0.8 bridge 1e-4 5e-5
{MOVE}timestep 2e-6
group second id 2
velocity second set 0.05 0 0
run 250
velocity all set 0 0 0
{hold}
run 100
{release}
run 3000
write_dump all custom end.txt id x modify sort id format float %.17g
""")
                (first,), (second,) = engine.dump(self.folder, "end.txt")[:, 1:]
                self.assertLess(second - first, 1e-3)

    def test_spins_are_held_and_a_warning_says_so(self):
        for style in STYLES:
            if "hard" in style:
                continue
            with self.subTest(style):
                output = self.goes(script(style, WHOLLY["setforce"], "run 1500\nrun 1500\n"))
                self.assertEqual(output.count("their spins are held"), 1, output)
                self.assertIn("friction acts on 1 particles that fixes setforce", output)
                self.assertEqual(list(engine.dump(self.folder, "end.txt")[0, 7:10]), [0.0, 0.0, 0.0])
        for fixes, mu in ((FREEZE, 0.3), (MOVE + HOLD, 0), ("fix move flies nve/sphere\n" + HOLD, 0.3)):
            self.assertNotIn("spins are held", self.goes(script("gran/hamaker", fixes, mu=mu)))

    def test_held_in_part(self):
        partly = {"planeforce 1 0 0": "(1, 0, 0)", "lineforce 0 1 0": "(1, 0, 0) and (0, 0, 1)",
                  "setforce 0 NULL NULL": "(1, 0, 0)", "planeforce 1 1 0": "(0.7071"}
        for style in STYLES:
            for how, along in partly.items():
                text = script(style, MOVE + f"fix part held {how}\n")
                with self.subTest(style, how=how):
                    if "sampled" in style:
                        output = self.goes(text + "run 1\n")
                        self.assertEqual(output.count("have the dashpot of spheres that are free"), 1, output)
                    else:
                        self.stops(text, f"fix part {how.split()[0]} holds 1 particles, the first of them 1, along "
                                   f"{along}", "in all directions or in none", "'fix setforce 0 0 0' or 'fix freeze'")
        # The second of two gives back in part what the first has taken.
        self.stops(script("gran/hamaker", MOVE + "fix a held planeforce 1 1 0\nfix b held lineforce 0 1 0\n"),
                   "fix a planeforce holds 1 particles")
        self.stops(script("gran/hamaker", MOVE + "region r block 0 0.01 0 0.01 0 0.01\n"
                          "fix part held setforce 0 0 0 region r\n"), "while they are in its region")

    def test_layers_are_right(self):
        """Held across the layer that all fly in, spheres are free in it: what a planeforce leaves of an impact is
        what there is without it."""
        for style in STYLES:
            free = self.ends(script(style, MOVE))
            for how in ("planeforce 0 0 1", "setforce NULL NULL 0"):
                with self.subTest(style, how=how):
                    layer = self.ends(script(style, MOVE + f"fix flat all {how}\n"))
                    numpy.testing.assert_allclose(layer, free, rtol=1e-9, atol=1e-12)


if __name__ == "__main__":
    unittest.main()
