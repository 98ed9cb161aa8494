# SPDX-License-Identifier: BSD-3-Clause
"""Moving walls go on from where they are: over runs, another time step, other numbers of the steps, and restart files,
whose motion may be another one from there on."""
import math
import unittest

from cohesion_tests.lammps_scenes.small_box import box
from cohesion_tests.test_cases import ScriptTestCase
from cohesion_tests.thermo import thermo_end

R, DENSITY, K, V = 5e-4, 2650.0, 800.0, 0.05
MASS = DENSITY * 4 / 3 * math.pi * R**3
CONTACT_TIME = math.pi * math.sqrt(MASS / K)
DT, STEPS = CONTACT_TIME / 16, 400
GAP = 150.5 * DT * V  # reached at V after 150 steps and a half
SOFT = {f"wall/gran/{law}": f"pair_style gran/{law}\npair_coeff * * stiffness {K} restitution 1\n"
        for law in ("hamaker", "squarewell", "liquidbridge")}
STYLES = {**{f"{wall} stiffness {K} restitution 1": (pair, CONTACT_TIME) for wall, pair in SOFT.items()},
          "wall/hard/squarewell restitution 1 well off":
              ("pair_style hard/squarewell\npair_coeff * * restitution 1\n", 0.0)}
SOFT_AND_HARD = [style for style in STYLES if "hamaker" in style or "hard" in style]
READ = "plugin load ${plugin}\nnewton off\nread_restart half.rest\ncomm_modify vel yes\nneighbor 1e-4 bin\n"
PLACES = ("variable x equal xcm(all,x)\nvariable vx equal vcm(all,x)\nthermo_style custom step v_x v_vx\n"
          "thermo_modify norm no format float %.17g\n")


class MovingWalls(ScriptTestCase):
    """Observed by a sphere at rest at GAP before the wall, which reaches it at V and throws it away at 2 V, in a contact
    of pi sqrt(m/K) or an impact. From where the sphere is in the end follows when that was; positions of 0.01 m are
    rounded by 2e-18 m in each of 400 steps: 1e-15 m, of which the wall's way in a step is 3e-8 m."""

    def opening(self, style, motion, position=0.0, gap=GAP, speed=0.0):
        return (box(boundary="f p p") + f"create_atoms 1 single {R + gap:.17g} 0.005 0.005 units box\n"
                f"set group all diameter {2 * R} density {DENSITY}\nset atom 1 vx {speed:.17g}\nneighbor 1e-4 bin\n"
                f"{STYLES[style][0]}{self.walls(style, motion, position)}timestep {DT:.17g}\n")

    @staticmethod
    def walls(style, motion, position=0.0):
        return f"fix w all {style} xplane {position} NULL {motion}\nfix move all nve/sphere\n{PLACES}"

    def end(self, script):
        line = thermo_end(self.goes(script))
        return line["v_x"] - R, line["v_vx"]

    def thrown(self, style, reached, time):
        """Where the sphere is at `time`."""
        contact = STYLES[style][1]
        return GAP + V * contact + 2 * V * (time - reached - contact)

    def check(self, style, script, reached, time):
        place, speed = self.end(script)
        self.assertAlmostEqual(speed, 2 * V, delta=1e-9 * V)
        self.assertAlmostEqual(place, self.thrown(style, reached, time), delta=1e-9 * V * DT + 1e-14)

    def test_runs_and_numbers_of_steps(self):
        for style in STYLES:
            for change, first in (("reset_timestep 0\n", 100), ("reset_timestep 1000000\n", 155)):
                with self.subTest(style, change=change, first=first):
                    self.check(style, self.opening(style, f"translate x {V}") +
                               f"run 50\nrun {first - 50}\n{change}run {STEPS - first}\n", GAP / V, STEPS * DT)

    def test_another_time_step(self):
        for style in SOFT_AND_HARD:
            for factor in (0.5, 2.0):
                with self.subTest(style, factor=factor):
                    self.check(style, self.opening(style, f"translate x {V}") +
                               f"run 100\ntimestep {factor * DT:.17g}\nrun 240\n",
                               GAP / V, (100 + factor * 240) * DT)

    def test_restart_with_the_same_motion(self):
        """To the last bit; with a swing, too."""
        for style in SOFT_AND_HARD:
            for motion, half in ((f"translate x {V}", 155), (f"wiggle x {2 * GAP} {500 * DT}", 100)):
                with self.subTest(style, motion=motion, half=half):
                    whole = self.end(self.opening(style, motion) +
                                     f"run {half}\nwrite_restart half.rest\nrun {STEPS - half}\n")
                    self.assertGreater(whole[0], GAP)
                    for change in ("", "reset_timestep 7\n"):
                        self.assertEqual(whole, self.end(f"{READ}{change}{self.walls(style, motion)}"
                                                         f"timestep {DT:.17g}\nrun {STEPS - half}\n"))

    def test_restart_with_another_motion(self):
        """It begins where the wall is, at the restart: of one that stood still, of one that moved at another speed, and
        of one that swung."""
        period = 100 * DT
        swing = GAP / 4
        for style in SOFT_AND_HARD:
            for motion, way in (("", 0.0), (f"translate x {V / 4}", V / 4 * 100 * DT),
                                (f"wiggle x {swing} {4 * period}", swing), (f"shear y {V}", 0.0)):
                with self.subTest(style, motion=motion):
                    self.goes(self.opening(style, motion) + "run 100\nwrite_restart half.rest\n")
                    self.check(style, f"{READ}{self.walls(style, f'translate x {V}')}timestep {DT:.17g}\nrun {STEPS}\n",
                               (GAP - way) / V, STEPS * DT)

    def test_a_wall_that_stops(self):
        """After a restart without motion it stays where it is: a sphere bounces there."""
        speed, way = 1.5 * V, V * 100 * DT
        for style in SOFT_AND_HARD:
            contact = STYLES[style][1]
            with self.subTest(style):
                self.goes(self.opening(style, f"translate x {V}", gap=2 * GAP) + "run 100\nwrite_restart half.rest\n")
                script = f"{READ}{self.walls(style, '')}set atom 1 vx {-speed:.17g}\ntimestep {DT:.17g}\nrun {STEPS}\n"
                place, back = self.end(script)
                self.assertAlmostEqual(back, speed, delta=1e-9 * V)
                reached = (2 * GAP - way) / speed
                self.assertAlmostEqual(place, way + speed * (STEPS * DT - reached - contact), delta=1e-14)

    def test_a_new_fix_has_a_motion_of_its_own(self):
        """From the position that the command says, from the step on at which it is given."""
        for style in SOFT_AND_HARD:
            with self.subTest(style):
                script = self.opening(style, f"translate x {-V}") + "run 50\nunfix w\nunfix move\n"
                self.check(style, f"{script}{self.walls(style, f'translate x {V}')}run {STEPS}\n", GAP / V, STEPS * DT)

    def test_walls_elsewhere_are_others(self):
        for style in SOFT_AND_HARD:
            self.goes(self.opening(style, f"translate x {V}") + "run 10\nwrite_restart half.rest\n")
            with self.subTest(style):
                self.stops(f"{READ}{self.walls(style, f'translate x {V}', 1e-4)}timestep {DT:.17g}\nrun 1\n",
                           "fix w " + style.split()[0], "0.0001", "another ID")


if __name__ == "__main__":
    unittest.main()
