# SPDX-License-Identifier: BSD-3-Clause
"""fix deform/shear: images where they belong, collisions across the faces, runs that can be split."""
import unittest
from concurrent.futures import ThreadPoolExecutor

import numpy

from cohesion_tests import dumps, lammps as engine
from cohesion_tests.lammps_scenes.sheared_script import BOX, DUMP, HEAD, RATE, Shear, dense_gas, sides_of, spheres
from cohesion_tests.theory.sheared_images import ShearedImages
from cohesion_tests.thermo import thermo_end


class FreeParticles(Shear):
    def check(self, dimension, ranks, tilt, rate=RATE):
        """Positions and velocities against straight lines, up to a vector of the sheared lattice."""
        atoms = spheres(200, dimension)
        self.write(atoms, dimension, tilt)
        steps, every, dt = 2000, 100, 0.01
        output = self.run_script(
            HEAD % {"dimension": dimension, "skin": "0.3"} + "pair_style zero 1.0\npair_coeff * *\n"
            f"fix shear all deform/shear rate {rate} profile no\nfix move all nve/sphere\n" +
            ("fix flat all enforce2d\n" if dimension == 2 else "") + DUMP % every +
            f"timestep {dt}\nthermo {steps}\nthermo_style custom step atoms f_shear xy\n"
            f"run {steps}\n", ranks=ranks)
        x0 = numpy.array([atom["x"] for atom in atoms])
        v0 = numpy.array([atom["v"] for atom in atoms])
        images = ShearedImages(BOX if dimension == 3 else [BOX[0], BOX[1], 1.0], rate, tilt)
        for n, table in enumerate(self.snapshots()):
            places, velocities, crossings = images.off_free_flight(
                table[:, 1:4], table[:, 4:7], x0, v0, n * every * dt)
            # 2000 additions of 0.01 v to numbers below 50: 2000 * 4e-15 at the very most.
            self.assertLess(places, 1e-11)
            self.assertLess(velocities, 1e-11)
            # Image flags are those of the box as it is now, flips included.
            self.assertLess(numpy.abs(x0 + n * every * dt * v0 - table[:, 7:10]).max(), 1e-11)
        self.assertGreater(crossings, 2)
        end = thermo_end(output)
        self.assertEqual(end["Atoms"], 200)
        self.assertLess(abs(end["f_shear"] - rate * steps * dt), 1e-13)
        exact = tilt + rate * steps * dt * BOX[1]
        self.assertLess(abs((end["Xy"] - exact + 5) % 10 - 5), 1e-11)

    def test_3d(self):
        self.check(3, 1, 0.0)

    def test_2d_started_tilted(self):
        self.check(2, 1, 3.0)

    def test_3d_two_ranks_backwards(self):
        self.check(3, 2, -2.0, -RATE)

    def test_2d_two_ranks(self):
        self.check(2, 2, 0.0)


class RateOfAVariable(Shear):
    VARIABLE = ("variable rate equal 0.5*(step<400)-2.0*(step>=400&&step<700)"
                "+(step>=900)*cos(0.01*step)\n")

    @staticmethod
    def rate(step):
        if step < 400:
            return 0.5
        return -2.0 if step < 700 else numpy.cos(0.01 * step) if step >= 900 else 0.0

    def test_free_particles_take_the_rate_of_the_step_they_cross_in(self):
        self.write(spheres(200, 3, speed=0.3))
        dt, end = 0.01, 1200
        # A wide skin: particles are far outside the box when the rate changes.
        script = (HEAD % {"dimension": 3, "skin": "1.0"} + "pair_style zero 1.0\npair_coeff * *\n" +
                  self.VARIABLE + "fix shear all deform/shear rate v_rate\n"
                  "fix move all nve/sphere\n" + DUMP % 100 + f"timestep {dt}\n")
        self.run_script(script + "run 0\n")
        x, v = (self.snapshots()[0][:, k:k + 3].copy() for k in (1, 4))
        shift, expected, faster = 0.0, {0: (x.copy(), v.copy(), 0.0)}, 0.0
        for n in range(1, end + 1):
            faster = self.rate(n - 1) * BOX[1]  # holds from the end of a step to that of the next
            shift += faster * dt
            x += dt * v
            count = numpy.floor(x[:, 1] / BOX[1])
            x -= count[:, None] * numpy.array([shift, BOX[1], 0.0])
            v[:, 0] -= count * faster
            expected[n] = x.copy(), v.copy(), shift
        for ranks, runs in ((1, f"run {end}\n"), (2, "run 410\nrun 290\nrun 500\n")):
            with self.subTest(ranks=ranks):
                self.run_script(script + runs, ranks=ranks)
                for n, table in zip(range(0, end + 1, 100), self.at_hundreds()):
                    at, velocity, shift = expected[n]
                    away = table[:, 1:4] - at
                    count = numpy.rint(away[:, 1] / BOX[1])
                    away -= count[:, None] * numpy.array([shift, BOX[1], 0.0])
                    away -= BOX * numpy.rint(away / BOX)
                    # 1200 additions to numbers below 10, and of the shift to one below 50.
                    self.assertLess(numpy.abs(away).max(), 1e-11, f"step {n}")
                    outside = count * self.rate(n - 1 if n else 0) * BOX[1]
                    faster = table[:, 4:7] - velocity
                    faster[:, 0] -= outside
                    self.assertLess(numpy.abs(faster).max(), 1e-11, f"step {n}")

    def at_hundreds(self):
        kept = {snapshot.step: snapshot for snapshot in dumps.read(self.path("out.txt"))}
        return [kept[n].sorted() for n in range(0, 1201, 100)]


class Collisions(Shear):
    def pair(self, shift, style, dimension):
        """Two spheres that meet at the middle of the box moved up by `shift`: their relative motion."""
        middle = BOX / 2 + (numpy.array([0, 0, 0]) if dimension == 3 else [0, 0, -3.0])
        up = numpy.array([0.0, shift, 0.0])
        flow = numpy.array([RATE * shift, 0.0, 0.0])
        z = 0.1 if dimension == 3 else 0.0
        ends = []
        for sign in (-1, 1):
            ends.append({"type": 1, "diameter": 1.0, "density": 1.0,
                         "x": middle + up + sign * numpy.array([0.3, 0.8, z]),
                         "v": flow - sign * numpy.array([0.2, 1.0, 0.05 * (z != 0)]),
                         "omega": numpy.array([0.0, 0.0, 0.7])})
        for end in ends:
            n = numpy.floor(end["x"][1] / BOX[1])
            end["x"] = end["x"] - n * numpy.array([0.0, BOX[1], 0.0])
            end["v"] = end["v"] - n * numpy.array([RATE * BOX[1], 0.0, 0.0])
        with engine.temporary_folder() as folder:
            engine.write_spheres(folder, ends, sides_of(BOX, dimension), 1, tilt=(0.0, 0.0, 0.0))
            code, output = engine.run_text(
                HEAD % {"dimension": dimension, "skin": "0.3"} + style +
                f"fix shear all deform/shear rate {RATE} profile no\nfix move all nve/sphere\n" +
                ("fix flat all enforce2d\n" if dimension == 2 else "") + DUMP % 10 +
                "timestep 0.002\nrun 1000\n", folder)
            self.assertEqual(code, 0, output)
            tables = engine.dumps(folder, "out.txt")
        images = ShearedImages(BOX, RATE)
        return numpy.array([images.nearest(table[1, 1:7] - table[0, 1:7], n * 0.02)
                            for n, table in enumerate(tables)])

    def test_across_the_boundary_is_as_in_the_middle(self):
        # Contact of 800/0.5 (t_c = 0.057) in both soft laws; over the contact, a rounding of a coordinate
        # near 10 (2e-15) grows by no more than exp(w0 t_c) = e^pi, with friction and spins some ten
        # times that; a thousand additions make a thousand: 1e-15 * 1e3 * 1e3.
        laws = {"sampled": "pair_style gran/hooke/history 800 NULL 5 NULL 0.3 0\npair_coeff * *\n",
                "exact": "pair_style gran/hamaker\npair_coeff * * stiffness 800 restitution 0.9 "
                         "friction 0.3 hamaker 1e-6 cutoff 1e-4 1e-2\n",
                "hard": "pair_style hard/squarewell\npair_coeff * * restitution 0.9 "
                        "friction 0.3 well 0.05 1.05\n"}
        cases = [(law, dimension) for law in laws for dimension in (2, 3)]
        with ThreadPoolExecutor(4) as pool:  # a start is mostly waiting
            motions = list(pool.map(
                lambda case: [self.pair(up, laws[case[0]], case[1]) for up in (0.0, BOX[1] / 2)],
                cases))
        for case, (middle, across) in zip(cases, motions):
            with self.subTest(case):
                self.assertGreater(middle[-1, 4] * -middle[0, 4], 0.0, "they did not collide")
                self.assertLess(numpy.abs(across - middle).max(), 1e-9)


class SplitRuns(Shear):
    GAS = (HEAD % {"dimension": 3, "skin": "0.3"} +
           "pair_style gran/hamaker\npair_coeff * * stiffness 2000 restitution 0.9 friction 0.3\n")

    SHEAR = f"fix shear all deform/shear rate {RATE}\nfix move all nve/sphere\ntimestep 0.002\n"

    def assert_same(self, one, other, strain):
        self.assertLess(ShearedImages(BOX, RATE).apart(one[:, 1:7], other[:, 1:7], strain / RATE),
                        1e-10)

    def test_split_and_restarted_runs_go_on_as_if_whole(self):
        # Every particle has a collision or two in the 600 steps after the split, of which each
        # multiplies a difference by 2 (path)/d = 10 or so: 1e-15 to 1e-12.
        self.write(dense_gas(5, 0.9))
        self.run_script(self.GAS + self.SHEAR + DUMP % 500 + "restart 400 half.*\nrun 1000\n")
        whole = self.snapshots()[-1]
        self.assertGreater(numpy.abs(whole[:, 4]).max(), 1.0)
        for name, script in (
                ("split", self.GAS + self.SHEAR + DUMP % 500 + "run 400\nrun 600\n"),
                ("continued", self.GAS + self.SHEAR + DUMP % 500 + "run 400\nrun 600 pre no\n"),
                ("in pieces", self.GAS + self.SHEAR + DUMP % 500 + "run 1000 every 100 NULL\n")):
            with self.subTest(name):
                self.run_script(script)
                self.assert_same(self.snapshots()[-1], whole, RATE * 2.0)
        restart = ("plugin load ${plugin}\nnewton off\nread_restart half.400\n"
                   "comm_modify vel yes\nneighbor 0.3 bin\nneigh_modify delay 0 every 1 check yes\n")
        for ranks in (1, 2):
            with self.subTest(restart_on=ranks):
                self.run_script(restart + self.SHEAR + DUMP % 500 + "run 600\n", ranks=ranks)
                self.assert_same(self.snapshots()[-1], whole, RATE * 2.0)

    def test_restart_file_of_a_step_in_which_a_disc_leaves(self):
        """A disc is hit just below the sheared face and leaves through it in the very step that a restart
        file is written: it comes back as its image, with that one's velocity. A velocity less that of
        the flow is the same for all images."""
        self.write([{"type": 1, "diameter": 1.0, "density": 1.0, "x": numpy.array([5.0, y, 0.0]),
                     "v": numpy.array([0.3, v, 0.0])} for y, v in ((7.95, -1.0), (6.9, 2.0))], 2)
        head, pair = HEAD % {"dimension": 2, "skin": "1.5"}, ("pair_style hard/squarewell\npair_coeff * * "
                                                             "restitution 1\n")
        tail = (f"fix shear all deform/shear rate {RATE} profile no\nfix move all nve/sphere disc\n"
                "fix flat all enforce2d\ntimestep 0.2\n" + DUMP % 1)
        own = []
        for script in (head + pair + tail + "run 3\n",
                       head + pair + tail + "restart 1 half.*\nrun 3\n",
                       "plugin load ${plugin}\nnewton off\nread_restart half.1\ncomm_modify vel yes\n"
                       "neighbor 1.5 bin\nneigh_modify delay 0 every 1 check yes\n" + pair + tail +
                       "run 2\n"):
            self.run_script(script)
            end = self.snapshots()[-1]
            own.append(numpy.array([end[:, 4] - RATE * (end[:, 2] - BOX[1] / 2), end[:, 5]]))
        self.assertLess(abs(own[0][1] - [2.0, -1.0]).max(), 1e-14)  # they did collide
        # Places are rounded to 2^-44 of the box for the restart file, 5e-13.
        for other in own[1:]:
            self.assertLess(abs(other - own[0]).max(), 1e-12)


if __name__ == "__main__":
    unittest.main()
