# SPDX-License-Identifier: BSD-3-Clause
"""Pairs that stand in their wells without having flown there, in LIGGGHTS: inserted in a run, created, displaced or
released between two runs."""
import unittest

import numpy

from cohesion_tests.liggghts import Run
from cohesion_tests.liggghts_scenes.scene import RADIUS, liquid_bridge, script, sphere, square_well
from cohesion_tests.thermo import thermo_lines

RATIO = 1.5
MODELS = "model hooke/stiffness tangential off cohesion square_well scheme {} absolute_damping on"
SETS = "fix sets all agglomerates 1\nthermo_style custom step f_sets f_sets[2]\nthermo 1\n"
INSERT = """region fill block -0.004 0.004 -0.004 0.004 -0.004 0.004 units box
fix grain all particletemplate/sphere 15485863 atom_type 1 density constant 2650 radius constant 0.5e-3
fix grains all particledistribution/discrete 15485867 1 grain 1.0
fix pour all insert/pack seed 32452843 distributiontemplate grains insert_every once overlapcheck yes all_in yes vel &
 constant 0 0 0 particles_in_region 60 region fill
"""
FAR = (-0.009, -0.009, -0.009)


def sets_of(places):
    """Number and mean size of the sets of two or more that are connected by distances within the wells."""
    label = numpy.arange(len(places))
    apart = numpy.linalg.norm(places[:, None] - places, axis=2)
    near = apart < RATIO * 2 * RADIUS
    while True:
        smallest = numpy.where(near, label, len(label)).min(axis=1)
        if (smallest == label).all():
            break
        label = smallest
    sizes = numpy.bincount(label)
    sizes = sizes[sizes > 1]
    return len(sizes), sizes.mean() if len(sizes) else 0.0


class Standing(unittest.TestCase):
    def check(self, spheres, extra, run):
        for scheme in ("exact", "sampled"):
            with self.subTest(scheme):
                done = Run(script(spheres, MODELS.format(scheme), square_well(1e-10, ratio=RATIO), dt=1e-6, skin=1e-4,
                                  extra=SETS + extra, run=run))
                last = done.frames("out.txt")[-1]
                number, size = sets_of(numpy.array([row[:3] for row in last.values()]))
                self.assertGreater(number, 0)
                row = thermo_lines(done.output)[1][-1]
                self.assertEqual(row[1], number)
                self.assertAlmostEqual(row[2], size, delta=1e-5 * size)

    def test_inserted(self):
        self.check([sphere(FAR)], INSERT, "run 20\n")

    def test_created(self):
        self.check([sphere(FAR), sphere((0, 0, 0))], "",
                   "run 10\ncreate_atoms 1 single 1.2e-3 0 0 units box\nset atom 3 diameter 1e-3 density 2650\nrun 10\n")

    def test_displaced(self):
        for start in (3e-3, 1.502e-3):
            self.check([sphere(FAR), sphere((0, 0, 0)), sphere((start, 0, 0))], "group last id 3\n",
                       f"run 10\ndisplace_atoms last move {1.2e-3 - start!r} 0 0 units box\nrun 10\n")

    def test_released(self):
        spheres = [sphere(FAR), sphere((0, 0, 0)), sphere((1.2e-3, 0, 0))]
        self.check(spheres, "group pair id 2 3\nfix hold pair freeze\n", "run 10\nunfix hold\nrun 10\n")
        self.check(spheres, "group pair id 2 3\ngroup far id 1\nunfix move\nfix move far nve/sphere\n",
                   "run 10\nunfix move\nfix move all nve/sphere\nrun 10\n")


class Bridges(unittest.TestCase):
    def test_a_bridge_in_its_gap_remains_in_a_run_of_another_step(self):
        # The grains touch, and their bridge holds them in the gap when the step changes.
        spheres = [sphere((-RADIUS - 1.5e-6, 0, 0)), sphere((RADIUS + 1.5e-6, 0, 0), (-0.1, 0, 0))]
        for change in ("", "timestep 8.9e-6\n"):
            with self.subTest(change):
                done = Run(script(spheres, "model hooke/stiffness tangential off cohesion liquid_bridge scheme exact absolute_damping on",
                                  liquid_bridge(1e-4, 5e-5), dt=9e-6, skin=2e-4, run=f"run 25\n{change}run 3000\n"))
                (a, b) = (numpy.array(row[:3]) for row in list(done.frames("out.txt")[-1].values())[:2])
                self.assertLess(numpy.linalg.norm(a - b) - 2 * RADIUS, 5e-5)

    def test_a_bridge_of_two_that_are_held_stays(self):
        # They touched and are in their gap, at rest, when both are held and released again. The third is not held.
        spheres = [sphere((-RADIUS + 1e-7, 0, 0)), sphere((RADIUS - 1e-7, 0, 0), (0.05, 0, 0)), sphere(FAR)]
        for steps in (0, 100):
            with self.subTest(steps):
                done = Run(script(spheres, "model hooke/stiffness tangential off cohesion liquid_bridge scheme exact "
                                  "absolute_damping on", liquid_bridge(1e-4, 5e-5), dt=2e-6, every=50,
                                  extra="group pair id 1 2\n", run="run 250\nset group pair vx 0 vy 0 vz 0\n"
                                  f"fix hold pair freeze\nrun {steps}\nunfix hold\nrun 3000\n"))
                pairs = [numpy.array([row[:3] for row in frame.values()])[:2] for frame in done.frames("out.txt")]
                gaps = [numpy.linalg.norm(a - b) - 2 * RADIUS for a, b in pairs]
                self.assertGreater(gaps[5], 5e-6)
                self.assertLess(min(gaps[-50:]), 0.0)

    def test_bridges_stay_where_they_are_when_particles_are_deleted(self):
        # One pair is wet and one dry, with gaps within the reach of a bridge. delete_atoms renumbers unless told not to.
        wet, dry = (-RADIUS - 1.5e-6, 0, 0), (-RADIUS - 1.5e-6, 5e-3, 0)
        spheres = [sphere(FAR), sphere(wet), sphere((RADIUS + 1.5e-6, 0, 0), (-0.1, 0, 0)),
                   sphere((9e-3, 9e-3, 9e-3)), sphere(dry), sphere((RADIUS + 1e-5, 5e-3, 0))]
        for compress in ("yes", "no"):
            for ranks in (1, 2):
                with self.subTest(compress=compress, ranks=ranks):
                    done = Run(script(spheres, "model hooke/stiffness tangential off cohesion liquid_bridge "
                                      "scheme exact absolute_damping on", liquid_bridge(1e-4, 5e-5), dt=9e-6,
                                      every=25, skin=2e-4, run="run 25\ngroup gone id 1 4\n"
                                      f"delete_atoms group gone compress {compress}\nrun 3000\n"), ranks=ranks)
                    places = sorted(list(row[:3]) for row in done.frames("out.txt")[-1].values())
                    a, b = (numpy.array(place) for place in places if place[1] < 2.5e-3)
                    c, d = (numpy.array(place) for place in places if place[1] > 2.5e-3)
                    self.assertLess(numpy.linalg.norm(a - b) - 2 * RADIUS, 5e-5)
                    self.assertAlmostEqual(numpy.linalg.norm(c - d) - 2 * RADIUS, 1.15e-5, delta=1e-12)


if __name__ == "__main__":
    unittest.main()
