# SPDX-License-Identifier: BSD-3-Clause
"""fix deform/shear in LIGGGHTS: images where they belong, contacts across the sheared faces, runs that
can be split and restarted, nothing lost in a long run."""

import unittest

import numpy

from cohesion_tests.liggghts import Run
from cohesion_tests.liggghts_scenes.scene import DAMPING, RADIUS, contact, hamaker, sphere
from cohesion_tests.liggghts_scenes.sheared_scene import BOX, COLUMNS, LAWS, PLAIN, RATE, gas, sheared
from cohesion_tests.theory.sheared_images import ShearedImages
from cohesion_tests.thermo import thermo_lines


def snapshots(run, dump="out.txt"):
    return numpy.array([[frame[n] for n in sorted(frame)] for frame in run.frames(dump)])


class FreeParticles(unittest.TestCase):
    def check(self, dimension, ranks, tilt, rate=RATE):
        """Positions and velocities against straight lines, up to a vector of the sheared lattice."""
        random = numpy.random.default_rng(1)
        x0, v0 = random.uniform(0, 1, (100, 3)) * BOX, random.normal(0, 0.1, (100, 3))
        if dimension == 2:
            x0[:, 2] = v0[:, 2] = 0.0
        x0[:, 0] += tilt * x0[:, 1] / BOX[1]  # the engine makes no particle outside the box
        steps, every, dt = 2000, 100, 1e-4
        run = Run(sheared([sphere(x, v, radius=1e-7) for x, v in zip(x0, v0)], PLAIN, rate=rate,
                          dimension=dimension, tilt=tilt, dt=dt, steps=steps, every=every, skin=3e-4,
                          columns=COLUMNS + ["xu", "yu", "zu"],
                          extra="thermo_style custom step atoms f_shear xy\n"
                          f"thermo_modify format float %.17g\nthermo {steps}\n"), ranks=ranks)
        images = ShearedImages(BOX if dimension == 3 else [BOX[0], BOX[1], 2 * RADIUS], rate, tilt)
        found = snapshots(run)
        self.assertEqual(len(found), steps // every + 1)
        for n, table in enumerate(found):
            places, velocities, crossings = images.off_free_flight(
                table[:, :3], table[:, 3:6], x0, v0, n * every * dt)
            # In each of 2000 steps an addition to a number below 1/32 m, perhaps with a conversion
            # to the coordinates of the box and back: three times half of 2^-57.
            self.assertLess(places, 5e-14)
            # Up to 20 crossings that each add 0.4 m/s to numbers below 8.
            self.assertLess(velocities, 20 * 2.0**-50)
            # Image flags are those of the box as it is now, flips included.
            self.assertLess(numpy.abs(x0 + n * every * dt * v0 - table[:, 6:9]).max(), 5e-14)
        self.assertGreater(crossings, 2)
        end = thermo_lines(run.output)[1][-1]
        self.assertEqual(end[1], 100)
        self.assertLess(abs(end[2] - rate * steps * dt), 1e-13)
        exact = tilt + rate * steps * dt * BOX[1]
        self.assertLess(abs((end[3] - exact + 5e-3) % 10e-3 - 5e-3), 1e-14)

    def test_3d(self):
        self.check(3, 0, 0.0)

    def test_2d_started_tilted(self):
        self.check(2, 0, 3e-3)

    def test_3d_two_ranks_backwards(self):
        self.check(3, 2, -2e-3, -RATE)


class Collisions(unittest.TestCase):
    STEPS, EVERY, DT = 8000, 100, 2e-6

    def pair(self, shift, law, dimension):
        """Two spheres that meet at the middle of the box moved up by `shift`: their relative motion."""
        middle = numpy.array([BOX[0] / 2, BOX[1] / 2, BOX[2] / 2 if dimension == 3 else 0.0])
        up, flow = numpy.array([0.0, shift, 0.0]), numpy.array([RATE * shift, 0.0, 0.0])
        z = 0.1e-3 if dimension == 3 else 0.0
        ends = []
        for sign in (-1, 1):
            x = middle + up + sign * numpy.array([0.2e-3, 0.8e-3, z])
            v = flow - sign * numpy.array([0.0, 0.1, 0.0])
            n = numpy.floor(x[1] / BOX[1])
            ends.append(sphere(x - n * numpy.array([0.0, BOX[1], 0.0]),
                               v - n * numpy.array([RATE * BOX[1], 0.0, 0.0]), (0, 0, 70.0)))
        models, properties = LAWS[law]
        found = snapshots(Run(sheared(ends, models, properties, dimension=dimension, dt=self.DT,
                                      steps=self.STEPS, every=self.EVERY, skin=3e-4)))
        images = ShearedImages(BOX, RATE)
        return numpy.array([images.nearest(table[1] - table[0], n * self.EVERY * self.DT)
                            for n, table in enumerate(found)])

    def test_across_the_boundary_is_as_in_the_middle(self):
        # A rounding of a coordinate below 1/64 m (2^-60 m) in each of 8000 steps is 7e-15 m. Over the
        # contact a difference grows by no more than e^pi (half a swing), with friction and spin some
        # ten times that: 2e-12 m, and with w0 = 3.4e4 1/s 6e-8 m/s.
        for law in LAWS:
            for dimension in (3, 2) if law == "spring" else (3,):
                with self.subTest(law=law, dimension=dimension):
                    middle, across = (self.pair(up, law, dimension) for up in (0.0, BOX[1] / 2))
                    self.assertGreater(middle[-1, 4] * -middle[0, 4], 0.0, "they did not collide")
                    off = numpy.abs(across - middle).max(axis=0)
                    self.assertLess(off[:3].max(), 2e-12)
                    self.assertLess(off[3:].max(), 6e-8)


class SplitRuns(unittest.TestCase):
    DT, HALF, REST = 5e-6, 800, 1200

    def check(self, models, properties, *cases):
        """Cases of a name, ranks, what is run, where {again} stands for the definitions after a restart
        from half, and the dump that the last frame is in. Without dashpots: a run begins with the
        forces of the step before it, for which LIGGGHTS then takes other velocities."""
        text = sheared(gas(), models, properties, profile="yes", dt=self.DT, every=400, skin=2e-4,
                       run="", contacts=contact().replace(repr(DAMPING), "0.0"))
        again = ("clear\nunits si\natom_style granular\natom_modify map array\nboundary p p p\n"
                 "newton off\ncommunicate single vel yes\nread_restart half\nneighbor 2e-4 bin\n"
                 "neigh_modify delay 0\n" +
                 text[text.index("fix E all"):].replace("out.txt", "again.txt"))
        whole = snapshots(Run(text + f"run {self.HALF + self.REST}\n"))[-1]
        self.assertGreater(numpy.abs(whole[:, 3]).max(), 0.3)
        images = ShearedImages(BOX, RATE)
        for name, ranks, tail, dump in cases:
            with self.subTest(name):
                run = Run(text + tail.format(again=again, half=self.HALF, rest=self.REST,
                                             all=self.HALF + self.REST), ranks=ranks)
                other = snapshots(run, dump)[-1]
                # A place below 1/64 m is rounded by 2^-60 m in each of 2000 steps: 2e-15 m. In a contact
                # that is a velocity w0 = 3.4e4 1/s times as large, and each of about two collisions (free
                # path 0.6 mm) makes a difference 2 (path)/d, ten times at the most, larger: 6e-9 m/s.
                self.assertLess(images.apart(whole, other, (self.HALF + self.REST) * self.DT), 1e-8)

    def test_split_and_restarted_runs_go_on_as_if_whole(self):
        """With friction and a well, which both remember their contacts."""
        self.check(*LAWS["square_well"],
                   ("two ranks", 2, "run {all}\n", "out.txt"),
                   ("split", 0, "run {half}\nrun {rest}\n", "out.txt"),
                   ("restarted", 0, "run {half}\nwrite_restart half\n{again}run {rest}\n",
                    "again.txt"))

    def test_restart_files_written_within_a_run(self):
        """Without memory of contacts, which LIGGGHTS writes to these files as it was a step before."""
        self.check("model hooke/stiffness tangential off cohesion hamaker absolute_damping on",
                   hamaker(1e-11),
                   *((f"{ranks} ranks", ranks, "restart {half} half.*\nrun {half}\nshell mv half.{half} half\n"
                       "{again}run {rest}\n",
                      "again.txt") for ranks in (0, 2)))


class LongRuns(unittest.TestCase):
    def test_no_particle_is_lost_and_no_momentum_gained(self):
        """A gas with friction and adhesion over a strain of 12, flips and all."""
        rate, steps, dt = 200.0, 12000, 5e-6
        for ranks in (0, 2):
            with self.subTest(ranks=ranks):
                run = Run(sheared(
                    gas(), *LAWS["hamaker"], rate=rate, profile="yes", dt=dt, every=steps, skin=2e-4,
                    steps=steps, extra="compute flow all shear/profile layers 4\n"
                    "variable py equal vcm(all,y)\nthermo 100\nthermo_style custom step atoms f_shear "
                    "f_shear[3] v_py c_flow[1] c_flow[3]\nthermo_modify format float %.15g\n"), ranks=ranks)
                self.assertEqual(run.code, 0, run.output[-2000:])
                rows = numpy.array(thermo_lines(run.output)[1])
                _, atoms, strain, flips, momentum, slope, temperature = rows.T
                self.assertTrue((atoms == 240).all())
                self.assertAlmostEqual(strain[-1], rate * steps * dt, 12)
                self.assertGreater(flips[-1], 8)
                # The rounding of velocities below 2 m/s in each step.
                self.assertLess(numpy.abs(momentum).max(), steps * 2.0**-53)
                # In the mean, the line is the one that the box asks for. The slope of one snapshot
                # varies by sqrt(12 T/N)/L_y, over a strain of 2 or so like over one snapshot.
                half = slice(len(rows) // 2, None)
                spread = numpy.sqrt(12 * temperature[half].mean() / 240) / BOX[1]
                self.assertLess(abs(slope[half].mean() - rate), 4 * spread / numpy.sqrt(3))
                # The engine would make lists at least every 12.5 steps: in each, the corners of the box
                # move by L_y rate dt = 8e-6 m to both sides, and both count against the skin.
                builds = int(run.output.split("Neighbor list builds =")[1].split()[0])
                self.assertLess(builds, steps / 25)


if __name__ == "__main__":
    unittest.main()
