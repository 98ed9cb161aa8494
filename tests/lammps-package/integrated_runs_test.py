# SPDX-License-Identifier: BSD-3-Clause
"""Hertz and JKR contacts in ordinary ways of working: run after run, from a restart file, on two ranks, with another step,
with grains taken away: a pile goes on as if nothing had happened."""
import sys
import unittest

import numpy

from cohesion_tests import lammps
from cohesion_tests.lammps_scenes.small_box import box, spheres
from cohesion_tests.test_cases import ScriptTestCase

# A grain falls at up to 0.1 m/s; at t_c/20 of that.
STEP = 1.2e-5
STEPS = 400
# What is rounded differently, 1e-16 of 1e-2 m, grows by a contact's own divergence, by 10 in each of some five impacts
# that a grain has; and by the step before that a sliding contact sticks.
SAME = 1e-11  # [m]
LAWS = {"gran/hamaker": "normal hertz 5e6 0.25 restitution 0.7 friction 0.3 rolling_friction 0.05 hamaker 7.49e-19 cutoff 4e-10 1e-7",
        "gran/jkr": "normal hertz 5e6 0.25 restitution 0.7 friction 0.3 rolling_friction 0.05 surface_energy 0.05"}
BOX = box(size=(4.2e-3, 4.2e-3, 8e-3), boundary="p p f")
OPENING = BOX[:BOX.index("region")]


class Runs(ScriptTestCase):
    def make(self):
        random = numpy.random.default_rng(4711)
        grid = numpy.array([(x, y, z) for z in (0.55e-3, 1.6e-3, 2.65e-3) for y in (1e-3, 2.1e-3, 3.2e-3)
                            for x in (1e-3, 2.1e-3, 3.2e-3)])
        places = grid + random.uniform(-2e-5, 2e-5, grid.shape)
        return BOX + spheres(*((1, *p) for p in places)) + "neighbor 4e-4 bin\nvelocity all set 0.01 0 -0.1 units box\n"

    def end(self, style, runs, head=None, ranks=1):
        """Places and velocities of the grains by id after `runs`."""
        words = LAWS[style]
        pair = "" if head else f"pair_style {style}\npair_coeff * * {words}\n"
        self.goes(f"""{head or self.make()}{pair}fix floor all wall/{style} {words} zplane 0 NULL
fix down all gravity 9.81 vector 0 0 -1
fix move all nve/sphere
timestep {STEP}
{runs}
write_dump all custom end.txt id x y z vx vy vz modify sort id format float %.17g
""", ranks=ranks)
        return lammps.dump(self.folder, "end.txt")

    def same(self, one, other, within=SAME):
        self.assertEqual(len(one), len(other))
        apart = numpy.abs(one[:, 1:4] - other[:, 1:4]).max()
        print(f"{self.id().split('.')[-1]}: {apart:.1e} m apart", file=sys.stderr)
        self.assertLessEqual(apart, within)

    def test_they_touch(self):
        for style in LAWS:
            end = self.end(style, f"run {STEPS}")
            self.assertLess(end[:, 3].min(), 0.5e-3)
            self.assertTrue(numpy.isfinite(end).all())

    def test_run_after_run(self):
        for style in LAWS:
            whole = self.end(style, f"run {STEPS}")
            self.same(whole, self.end(style, "\n".join(4 * [f"run {STEPS // 4}"])))
            self.same(whole, self.end(style, f"run {STEPS} every 20 NULL"))

    def test_restart(self):
        for style in LAWS:
            whole = self.end(style, f"run {STEPS}")
            for at in (100, 137, 250):
                self.end(style, f"run {at}\nwrite_restart half.restart noinit")
                head = f"{OPENING}read_restart half.restart\ncomm_modify vel yes\nneighbor 4e-4 bin\n"
                self.same(whole, self.end(style, f"run {STEPS - at}", head=head))

    def test_two_ranks(self):
        for style in LAWS:
            self.same(self.end(style, f"run {STEPS}"), self.end(style, f"run {STEPS}", ranks=2))

    def test_grains_taken_away(self):
        # Those above; the others go on alike, whether they get other numbers or not.
        for style in LAWS:
            away = "region high block INF INF INF INF 2.2e-3 INF units box\ndelete_atoms region high"
            renumbered = self.end(style, f"run 100\n{away}\nrun 100")
            kept = self.end(style, f"run 100\n{away} compress no\nrun 100")
            by_place = [end[numpy.lexsort(numpy.round(end[:, 1:4], 7).T)] for end in (renumbered, kept)]
            self.same(*by_place)

    def test_another_step(self):
        # The error of a step is of second order; of an impact at t_c/20, up to 1e-4 of what the contact moves.
        for style in LAWS:
            whole = self.end(style, f"run {STEPS}")
            self.same(whole, self.end(style, f"run {STEPS // 2}\ntimestep {STEP / 2}\nrun {STEPS}"), within=2e-6)


if __name__ == "__main__":
    unittest.main()
