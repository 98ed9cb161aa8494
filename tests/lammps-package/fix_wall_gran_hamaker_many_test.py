# SPDX-License-Identifier: BSD-3-Clause
"""Walls of the exact scheme, in LAMMPS: ranks and restarts, and a huge sphere in place of the wall."""
import math
import unittest

import numpy

from cohesion_tests.lammps_scenes.exact_wall import (CUT, DENSITY, OUT, RADIUS, SPEED, STIFFNESS, W0, ExactWall,
                                                     contact_time, say)
from cohesion_tests.thermo import thermo_end


class HugeSphere(ExactWall):
    """A wall is the limit of a sphere that is fixed and large."""
    CONTACT = (f"stiffness {STIFFNESS} restitution 0.9 friction 0.3 hamaker 2e-17 cutoff 4e-9 1e-6")

    def test_limit(self):
        dt = contact_time() / 10
        x = self.places(3)
        x[:, 2] = 1e-2 + RADIUS + 1e-6
        v = numpy.array([(0.0, 0.0, -SPEED), (0.02, 0.0, -SPEED), (0.0, 0.3, -SPEED)])
        box = 3 * [(-0.5, 0.5)]
        self.write(x, v, box=box)
        steps = 20
        plane = self.run_wall(f"{self.CONTACT} zplane 0.01 NULL", dt, steps)
        differences = []
        for ratio in (1e3, 1e4, 1e5, 1e6):
            big = ratio * RADIUS
            worst = 0.0
            for k in range(3):
                others = [{"type": 2, "diameter": 2 * big, "density": DENSITY,
                           "x": [x[k, 0], x[k, 1], 0.01 - big]}]
                self.write(x[k:k + 1], v[k:k + 1], others=others,
                           box=[(-2 * big, 2 * big), (-2 * big, 2 * big), (-2 * big, 1.0)])
                end = self.run_wall("stiffness 1 zplane NULL 100", dt, steps, pairs=1,
                                    pair=self.CONTACT)
                worst = max(worst, numpy.abs(end[0, 4:7] - plane[k, 4:7]).max(),
                            numpy.abs(end[0, 7:] - plane[k, 7:]).max() * RADIUS)
            differences.append(worst / SPEED)
        say("huge sphere against wall, ratio 1e3 ... 1e6: differences of the speeds "
            + ", ".join(f"{d:.1e}" for d in differences))
        # Curvature: the normal turns by way/R, R* and the lever arm differ by 1/ratio: of order
        # 1/ratio; at 1e6 the place is rounded by 6e-14 m of a range of 4e-9 m.
        for ratio, difference in zip((1e3, 1e4, 1e5, 1e6), differences):
            self.assertLessEqual(difference, 3.0 / ratio + 1e-6)


class RestartAndRanks(ExactWall):
    WALLS = (f"stiffness {STIFFNESS} restitution 0.8 friction 0.3 hamaker 5e-19 cutoff {CUT} {OUT} "
             "zplane 0.01 NULL xplane 0.001 0.035")

    def spheres(self):
        dt = contact_time() / 10
        x = self.places(60)
        x[:, 2] = 0.01 + RADIUS + SPEED * dt * (1 + numpy.arange(60) / 6)
        v = [(0.02 * math.sin(k), 0.3 * math.cos(3 * k), -SPEED) for k in range(60)]
        self.write(x, v)
        return dt

    def test_restart_in_a_contact(self):
        dt = self.spheres()
        for motion in ("", f"wiggle z 1e-5 {5 * contact_time():.17g}"):
            walls = f"{self.WALLS} {motion}"
            for steps in (16, 60):
                whole = self.run_wall(walls, dt, steps)
                force = thermo_end(self.output)["f_walls[3]"]
                halves = self.run_wall(walls, dt, steps, save=13)
                again = self.run_wall(walls, dt, steps, start="restart")
                self.assertEqual(force != 0.0, steps == 16)
                self.assertEqual(thermo_end(self.output)["f_walls[3]"], force)
                self.assertEqual(whole.tolist(), halves.tolist())
                self.assertEqual(whole.tolist(), again.tolist())

    def test_force_on_the_walls_survives_a_restart(self):
        dt = self.spheres()
        self.run_wall(self.WALLS, dt, 13, save=13)
        force = thermo_end(self.output)["f_walls[3]"]
        self.run_wall(self.WALLS, dt, 13, start="restart")
        self.assertNotEqual(force, 0.0)
        self.assertEqual(thermo_end(self.output)["f_walls[3]"], force)

    def test_restart_with_other_walls_is_refused(self):
        dt = self.spheres()
        self.run_wall(self.WALLS, dt, 13, save=13)
        for walls in (self.WALLS + " yplane 0 NULL", self.WALLS.replace("friction 0.3", ""),
                      self.WALLS + " rolling_friction 0.1"):
            with self.assertRaisesRegex(RuntimeError, "other walls than in the restart file"):
                self.run_wall(walls, dt, 30, start="restart")

    def test_restart_with_as_many_numbers_of_other_walls_is_refused(self):
        dt = self.spheres()
        smooth = f"stiffness {STIFFNESS} restitution 0.8 zplane 0.01 NULL xplane 0.001 0.035 yplane 0 NULL"
        self.run_wall(smooth, dt, 13, save=13)
        rough = f"stiffness {STIFFNESS} restitution 0.8 friction 0.3 zplane 0.01 NULL"
        with self.assertRaisesRegex(RuntimeError, "4 walls and 0 regions with 8 numbers .* there, 1 and 0 with 14 here"):
            self.run_wall(rough, dt, 30, start="restart")

    def test_two_ranks(self):
        dt = self.spheres()
        # Fast enough to change the process while in contact; the list is built at every step.
        one = self.run_wall(self.WALLS, dt, 60, skin=1e-5)
        two = self.run_wall(self.WALLS, dt, 60, skin=1e-5, ranks=2)
        self.assertEqual(one.tolist(), two.tolist())

    def test_two_ranks_with_pairs(self):
        random = numpy.random.default_rng(4711)
        grid = 0.011 + 1.01e-3 * numpy.arange(5)
        x = numpy.array(numpy.meshgrid(grid, grid, grid)).reshape(3, -1).T
        v = random.uniform(-SPEED, SPEED, x.shape)
        self.write(x, v, box=3 * [(0.0, 0.026)])
        contact = (f"stiffness {STIFFNESS} restitution 0.8 friction 0.3 hamaker 5e-19 cutoff {CUT} "
                   f"{OUT}")
        planes = "xplane 0.0105 0.0156 yplane 0.0105 0.0156 zplane 0.0105 0.0156"
        ends = [self.run_wall(f"{contact} {planes}", contact_time() / 10, 100, pairs=1,
                              pair=contact, ranks=ranks) for ranks in (1, 2)]
        self.assertGreater(numpy.abs(ends[0][:, 4:7] - v).max(axis=1).min(), 0.0)
        difference = numpy.abs(ends[0] - ends[1])
        say(f"two ranks with pairs: {difference[:, 1:4].max():.1e} m, {difference[:, 4:7].max():.1e} m/s")
        # Sums in another order: 2^-53 of 0.02 m a step, times w0 for speeds; collisions make
        # tenfold of a difference, three of them a thousandfold.
        self.assertLessEqual(difference[:, 1:4].max(), 1e-12)
        self.assertLessEqual(difference[:, 4:7].max(), W0 * 1e-12)


if __name__ == "__main__":
    unittest.main()
