# SPDX-License-Identifier: BSD-3-Clause
"""compute gran/energy of contacts of scheme exact: it closes, over runs, ranks and restarts, at walls and meshes."""
import math
import unittest

from cohesion_tests.liggghts import Run
from cohesion_tests.liggghts_scenes.elastic_gas import (CONTACT_TIME, PRINT, TALLY, frictional, gas, tally_lines,
                                                        tallied_gas)
from cohesion_tests.liggghts_scenes.mesh import rectangle, stl, wall
from cohesion_tests.liggghts_scenes.scene import RADIUS, hamaker, liquid_bridge, script, sphere, square_well
from cohesion_tests.theory.pair_motion import CUT, OUT

(KINETIC, ROTATIONAL, SPRING, TANGENTIAL, ADHESION, DAMPING, TANGENTIAL_DAMPING, FRICTION, WORK, RESIDUAL,
 GRAVITY, ROLLING_SPRING, ROLLING) = range(1, 14)
COHESION = {"hamaker": hamaker(1e-17, cut=CUT, out=OUT), "square_well": square_well(2e-12, ratio=1.01),
            "liquid_bridge": liquid_bridge(1e-6, 1e-5)}
FLOOR = "primitive type 2 zplane -5e-3"
FALL = "fix g all gravity 9.81 vector 0 0 -1\n"
# Rounding, over the energy of the impact. Positions up to 5e-3 m are rounded by 4.3e-19 m. Where a contact crosses
# H_cut, 4e-10 m, that changes the energy of the attraction by 1e-9 of it, once. In overlaps of 1e-6 m it is 9e-13 of
# the energy of the spring a step: of one sign in 100 steps 9e-11.
ROUNDING = 1e-9


def entry(row, k):
    """row: step, scalar, vector."""
    return row[k + 1]


def missing(rows):
    """Largest part of the first kinetic energy that the tally does not account for."""
    return max(abs(entry(row, RESIDUAL)) for row in rows) / (entry(rows[0], KINETIC) + entry(rows[0], ROTATIONAL))


def lines(text, ranks=0, inputs=None):
    run = Run(text.replace("create_box", "processors 2 1 1\ncreate_box") if ranks else text, ranks=ranks, inputs=inputs)
    if run.code:
        raise AssertionError(run.output[-3000:])
    return tally_lines(run)


def models(law, friction, rolling=""):
    """Models, and the keywords that stand behind all else."""
    return (f"model hooke/stiffness tangential {'history' if friction else 'off'} cohesion {law}{rolling}",
            f" absolute_damping on tangential_damping {'on' if friction else 'off'} scheme exact")


def scene(spheres, restitution=0.9, friction=0.0, law="hamaker", properties=None, walls=(), part=10, time=1e-3,
          every=10, extra="", rolling="", run=None, **options):
    """part: steps per contact time; walls: words of fix wall/gran, or lines with fix."""
    names, keywords = models(law, friction, rolling)
    walls = [w if w.startswith("fix") and "wall/gran" not in w else
             (w if w.startswith("fix") else f"fix w all wall/gran {names} {w}") + keywords for w in walls]
    dt = CONTACT_TIME / part
    steps = round(time / dt / every) * every
    return script(spheres, names + keywords, properties or COHESION[law], dt=dt, steps=steps, every=10**8, walls=walls,
                  contacts=frictional(restitution, friction), extra=TALLY + PRINT.format(every=every) + extra, run=run,
                  **options)


def couple(speed=0.05, gap=12e-6, spin=False):
    """Two spheres that fly against each other, oblique where they spin."""
    if spin:
        return [sphere((0, 0, 0), (0.05, 0.03, 0), (20, -30, 40)),
                sphere((2 * RADIUS + gap, 0, 0), (-0.05, 0, 0.01), (0, 10, 5))]
    return [sphere((0, 0, 0), (speed, 0, 0)), sphere((2 * RADIUS + gap, 0, 0), (-speed, 0, 0))]


class Couples(unittest.TestCase):
    def test_head_on_closes_to_rounding(self):
        for law in COHESION:
            for restitution in (1.0, 0.9, 0.5):
                for part in (5, 10):
                    for speed in (0.05, 2e-3):  # the slower ones are captured
                        with self.subTest(law=law, restitution=restitution, part=part, speed=speed):
                            rows = lines(scene(couple(speed), restitution, law=law, part=part, time=5e-5 / speed))
                            self.assertLess(missing(rows), ROUNDING)

    def test_dashpot_takes_what_the_restitution_says(self):
        for part in (5, 10):
            rows = lines(scene(couple(), 0.5, properties=hamaker(0, cut=CUT, out=OUT), part=part))
            # In closed form at any step.
            self.assertAlmostEqual(entry(rows[-1], DAMPING) / entry(rows[0], KINETIC), 1 - 0.25, delta=1e-9)
            self.assertEqual([entry(rows[-1], k) for k in (TANGENTIAL, ADHESION, FRICTION)], 3 * [0.0])

    def test_oblique_with_adhesion_is_of_second_order(self):
        # While the pair turns in its well: a step of an eighth leaves 1/64, which the phase of entry and exit changes
        # by a factor of two on either side. Positions of 1e-3 m are rounded by 1.1e-19 m: in overlaps of 7e-6 m, of
        # one sign in 350 steps, that is 5e-11 of the first energy, a third of what the shortest step leaves.
        gone = [missing(lines(scene(couple(gap=2e-6, spin=True), 0.9, 0.3, part=part, time=4e-4, every=part)))
                for part in (10, 80)]
        self.assertLess(gone[1], gone[0] / 16)
        self.assertLess(gone[0], 1e-6)

    def test_friction_is_the_work_of_its_forces(self):
        # Accounts know friction one step late and leave out what that exchanges: dt^2/8 of the change of force times
        # acceleration by friction along the normal, which has turned away by u_t t_c/d when the contact ends. Over the
        # energy of the impact that is (w0 dt)^2/4 times mu and the angle.
        turned = 0.05 * CONTACT_TIME / (2 * RADIUS)
        allowed = (math.pi / 10)**2 / 4 * 0.3 * turned
        for rolling in ("", " rolling_friction cdt", " rolling_friction epsd2"):
            with self.subTest(rolling=rolling):
                rows = lines(scene(couple(gap=2e-6, spin=True), 0.9, 0.3, properties=hamaker(0, cut=CUT, out=OUT),
                                   rolling=rolling, time=4e-4))
                end, begin = rows[-1], rows[0]
                self.assertLess(missing(rows), allowed)
                self.assertGreater(entry(end, FRICTION), 2 * allowed * begin[1])
                self.assertGreater(entry(end, TANGENTIAL_DAMPING), 1e-5 * begin[1])
                self.assertEqual(entry(end, ROLLING) > 1e-6 * begin[1], rolling != "")
                self.assertEqual([entry(end, k) for k in (TANGENTIAL, ROLLING_SPRING)], [0.0, 0.0])


class Walls(unittest.TestCase):
    BALL = [sphere((1e-3, 1e-3, -5e-3 + RADIUS + 5e-6), (0.05, 0.02, -0.05), (10, 20, 30))]
    MESH = stl(rectangle((-8e-3, -8e-3, -5e-3), (16e-3, 0, 0), (0, 16e-3, 0), 8))

    def test_primitive_and_mesh(self):
        for law in COHESION:
            ends = []
            for walls in ([FLOOR], wall(models(law, 0.3)[0])):
                with self.subTest(law=law, walls=walls):
                    rows = lines(scene(self.BALL, 0.9, 0.3, law, walls=walls, time=1e-2, every=50, extra=FALL),
                                 inputs={"plate.stl": self.MESH})
                    self.assertLess(missing(rows), ROUNDING)
                    self.assertGreater(entry(rows[-1], DAMPING), 0.1 * entry(rows[0], KINETIC))
                ends.append(rows[-1])
            for k in range(1, 14):
                self.assertAlmostEqual(entry(ends[0], k), entry(ends[1], k), delta=ROUNDING * ends[0][1], msg=law)

    def test_moving_wall_puts_work_in(self):
        rows = lines(scene([sphere((0, 0, -5e-3 + RADIUS + 1e-6))], 0.9, 0.3, walls=[FLOOR + " shear x 0.1"], time=1e-2,
                           every=100, extra=FALL))
        work = entry(rows[-1], WORK)
        self.assertGreater(work, 1e-11)
        self.assertLess(max(abs(entry(row, RESIDUAL)) for row in rows), ROUNDING * work)


class Gases(unittest.TestCase):
    """Several contacts of a particle settle their accounts when they end."""

    def test_what_is_missing_is_of_second_order(self):
        for constant, restitution, friction in ((0.0, 0.9, 0.0), (0.0, 1.0, 0.3), (2e-18, 0.9, 0.3)):
            with self.subTest(constant=constant, restitution=restitution, friction=friction):
                gone = []
                for part in (5, 10):
                    rows = tallied_gas(6, 0.5, constant, 0.1, restitution, friction, CONTACT_TIME / part, 8e-3)
                    gone.append(abs(entry(rows[-1], RESIDUAL)) / entry(rows[0], KINETIC))
                # (w dt)^2/8, w = sqrt(2/mu) of a particle between two others, is 5e-2 at t_c/10; of it the accounts
                # leave what moves between contacts within one step, a share of the order of the step over the contact
                # time for each of the few simultaneous contacts: less than a hundredth.
                self.assertLess(gone[1], 5e-4)
                self.assertLess(gone[1], gone[0])

    def test_pairs_that_part_fast_keep_no_account(self):
        # Spheres approach and part by 1 % of their diameter in a step, some while other contacts act on them. What is
        # missing is that of the same gas in LAMMPS at most, 2e-6.
        rows = tallied_gas(6, 0.5, 0.0, 0.1, 1.0, 0.0, CONTACT_TIME / 4, 8e-3, samples=50)
        self.assertLess(max(abs(entry(row, RESIDUAL)) for row in rows), 2e-6 * entry(rows[0], KINETIC))

    def test_springs_hold_no_more_than_they_do(self):
        # What contacts exchange without friction is their own; with friction nothing is exchanged. At the end of an
        # elastic frictional gas entry 3 is what contacts hold then: at 0.5, with Enskog's rate and t_c, a sphere is in
        # contact for a share 0.02 of the time, with half of the energy of an impact: a few 1e-3 of the kinetic energy.
        rows = tallied_gas(6, 0.5, 0.0, 0.1, 1.0, 0.3, CONTACT_TIME / 5, 3e-2)
        self.assertLess(abs(entry(rows[-1], SPRING)), 5e-3 * entry(rows[0], KINETIC))


class StepsOfOutput(unittest.TestCase):
    def test_entries_are_independent_of_the_steps_with_output(self):
        """Stored energies are evaluated only at steps with output. Sums over 200 steps of terms below the first kinetic
        energy differ by round-off at most, 200 times 1e-16 of it."""
        for law in COHESION:
            for wall in ([], [FLOOR + " shear x 0.1"]):
                with self.subTest(law=law, wall=wall):
                    made = [scene(couple(2e-3, 2e-6, True) + Walls.BALL, 0.9, 0.3, law, walls=wall, time=20 * CONTACT_TIME,
                                  every=every, rolling=" rolling_friction epsd2") for every in (1, 50)]
                    each, few = ({row[0]: row for row in lines(text)} for text in made)
                    self.assertGreater(len(few), 3)
                    for step, row in few.items():
                        for k in range(1, 14):
                            self.assertAlmostEqual(entry(row, k), entry(each[step], k), delta=2e-14 * each[0][1], msg=k)


class SeveralWays(unittest.TestCase):
    """A cohesive frictional gas in one run, and otherwise."""

    HEAD = ("units si\natom_style granular\natom_modify map array\nboundary p p p\nnewton off\n"
            "communicate single vel yes\nprocessors * * *\n")

    def text(self, run, friction):
        spheres, side = gas(5, 0.45, speed=0.1)
        return scene(spheres, 0.9, friction, properties=hamaker(2e-18, cut=CUT, out=OUT), run=run, every=60,
                     boundary="p p p", box=f"0 {side} 0 {side} 0 {side}")

    def assert_same(self, ours, others, what, allowed):
        energy = ours[0][1]
        for k in range(1, 14):
            self.assertAlmostEqual(entry(ours[-1], k), entry(others[-1], k), delta=allowed * energy,
                                   msg=f"{what}, entry {k}")

    def test_two_ranks_and_two_runs(self):
        for friction in (0.0, 0.3):
            whole = lines(self.text("run 120\n", friction))
            self.assertLess(missing(whole), 1e-3)
            for what, run, ranks in (("ranks", "run 120\n", 2), ("runs", "run 60\nrun 60\n", 0)):
                with self.subTest(what, friction=friction):
                    # Friction begins a run from the velocities of the time level, those of half a step before it else:
                    # K_t v dt/2 of a sphere at 0.1 m/s is 2e-2 of the force of an impact, once.
                    self.assert_same(whole, lines(self.text(run, friction), ranks), what,
                                     1e-3 if friction and not ranks else 1e-7)

    def test_restart(self):
        begin = self.text("run 60\nwrite_restart a.rest\nrun 60\n", 0.0)
        whole = lines(begin)
        again = begin[begin.index("fix E all"):begin.index("run 60")].replace("dump out all custom 100000000 out.txt",
                                                                             "dump out all custom 100000000 more.txt")
        rows = lines(begin[:begin.index("run 60\nwrite")] + "run 60\nwrite_restart a.rest\nclear\n" + self.HEAD
                     + "read_restart a.rest\nneighbor 1e-4 bin\nneigh_modify delay 0\n" + again + "run 60\n")
        energy = whole[0][1]
        first, end = rows[2], rows[-1]
        for k in (KINETIC, SPRING, ADHESION):
            self.assertAlmostEqual(entry(end, k), entry(whole[-1], k), delta=1e-7 * energy)
            self.assertAlmostEqual(entry(first, k), entry(rows[1], k), delta=1e-12 * energy)
        # Entries 6 to 10 begin anew.
        self.assertEqual(entry(first, DAMPING), 0.0)
        self.assertAlmostEqual(entry(end, DAMPING), entry(whole[-1], DAMPING) - entry(rows[1], DAMPING),
                               delta=1e-7 * energy)
        self.assertAlmostEqual(entry(end, RESIDUAL), entry(whole[-1], RESIDUAL) - entry(rows[1], RESIDUAL),
                               delta=1e-7 * energy)

    def test_defined_between_two_runs_it_warns(self):
        text = self.text("run 60\nTALLYrun 60\n", 0.0)
        defined = TALLY + PRINT.format(every=60)
        late = text.replace(defined, "").replace("TALLY", defined)
        run = Run(late)
        self.assertEqual(run.code, 0, run.output[-2000:])
        self.assertEqual(run.output.count("compute gran/energy: the last step has no energy tally"), 1)
        self.assertNotIn("no energy tally", Run(text.replace("TALLY", "")).output)


if __name__ == "__main__":
    unittest.main()
