# SPDX-License-Identifier: BSD-3-Clause
"""compute gran/energy against energies worked out here, against the engine's own, and its balance."""

import math
import unittest

from cohesion_tests.liggghts import Run, assert_refused
from cohesion_tests.liggghts_scenes.mesh import rectangle, stl, wall
from cohesion_tests.liggghts_scenes.scene import MASS, RADIUS, STIFFNESS, contact, hamaker, script, sphere, square_well

(KINETIC, ROTATIONAL, SPRING, TANGENTIAL, ADHESION, DAMPING, TANGENTIAL_DAMPING, FRICTION, WORK, RESIDUAL,
 GRAVITY, ROLLING_SPRING, ROLLING) = range(1, 14)
TALLY = "compute tally all gran/energy\n"
PRINT = ("thermo_style custom step c_tally " + " ".join(f"c_tally[{k}]" for k in range(1, 14))
         + "\nthermo {every}\nthermo_modify norm no " + " ".join(f"format {k} %.17g" for k in range(2, 16)) + "\n")
DT = 5e-7
T_C = math.pi * math.sqrt(MASS / 2 / STIFFNESS)
# (w dt)^2/8, w the tangential frequency sqrt(7/2 K/m) of kt = kn: what the tally of leapfrog moves by, of the
# energy of the impact; entry and exit at any phase of the step change it by a factor of some.
STEP_ERROR = 4 * (math.sqrt(3.5) * math.pi / T_C * DT)**2 / 8
SLIDING = "model hooke/stiffness tangential history cohesion "
FULL = " rolling_friction epsd2"
FLOOR = "primitive type 2 zplane -5e-3"


def tallies(run):
    """One list per line of thermo output: step, scalar, entries; of all runs."""
    if run.code:
        raise AssertionError(run.output[-3000:])
    found = []
    for line in run.files["log.liggghts"].split("\n"):
        words = line.split()
        if len(words) == 15 and words[0].isdigit():
            found.append([float(w) for w in words])
    return found


def entry(row, k):
    """row: step, scalar, vector."""
    return row[k + 1]


def go(models, properties, spheres, every=10, steps=400, dt=DT, extra="", inputs=None, **options):
    return Run(script(spheres, models, properties, dt=dt, steps=steps, every=max(steps, 1),
                      extra=TALLY + PRINT.format(every=every) + extra, **options), inputs=inputs)


def oblique():
    return [sphere((0, 0, 0), (0.05, 0.03, 0), (20, -30, 40)),
            sphere((2 * RADIUS + 2e-6, 0, 0), (-0.05, 0, 0.01), (0, 10, 5))]


class Runs(unittest.TestCase):
    """The tally over runs: it begins with the first, whoever asks and when."""

    def end(self, how):
        """The last line, asked for when all is over."""
        run = Run(script(oblique(), SLIDING + "hamaker", hamaker(1e-14), dt=DT,
                         run=how + PRINT.format(every=1) + "run 0\n",
                         extra=TALLY + "thermo_style custom step\nthermo 1000\n"))
        return tallies(run)[-1]

    def test_what_is_missing_does_not_depend_on_who_looks(self):
        first = self.end(PRINT.format(every=1) + "run 400\n")
        self.assertGreater(abs(entry(first, RESIDUAL)), 1e-9 * first[1])
        self.assertEqual(self.end("run 400\n"), first)
        self.assertEqual(self.end("run 0\nrun 400\n"), first)

    def change_box(self, spheres, sides):
        """Between two runs; one more sphere, which meets nothing, has energy before."""
        return Run(script([*spheres, sphere((0, 5e-3, 0), (0, 0, 0.5))], "model hooke/stiffness tangential off "
                          "cohesion hamaker", hamaker(0), dt=DT, extra=TALLY + PRINT.format(every=1000),
                          run=f"run 10\nchange_box all x final {sides} units box\nrun 400\n"))

    def test_box_that_changes_nothing_but_itself(self):
        run = self.change_box([], "-0.01 0.011")
        self.assertEqual([entry(row, k) for row in tallies(run) for k in (WORK, RESIDUAL)], 8 * [0.0])
        self.assertNotIn("the box was changed", run.output)

    def test_box_that_presses_two_spheres_into_each_other(self):
        apart, shrunk = 1.05 * 2 * RADIUS, 0.875
        run = self.change_box([sphere((0, 0, 0)), sphere((apart, 0, 0))],
                              f"-0.01 {0.02 * shrunk - 0.01!r} remap")
        work = 0.5 * STIFFNESS * (2 * RADIUS - apart * shrunk)**2
        rows = tallies(run)
        self.assertEqual(len(rows), 4)
        self.assertEqual([entry(row, k) for row in rows[:2] for k in (WORK, RESIDUAL)], 4 * [0.0])
        self.assertGreater(entry(rows[1], KINETIC), 0.01 * work)
        for row in rows[2:]:
            self.assertAlmostEqual(entry(row, WORK) / work, 1, delta=STEP_ERROR)
            self.assertAlmostEqual(entry(row, RESIDUAL) / work, 0, delta=STEP_ERROR)
        self.assertEqual(run.output.count("the box was changed between two runs"), 1)


class Balance(unittest.TestCase):
    def closes(self, rows, allowed, energy=None):
        energy = energy or entry(rows[0], KINETIC) + entry(rows[0], ROTATIONAL)
        self.assertLess(max(abs(entry(row, RESIDUAL)) for row in rows), allowed * energy)
        for row in rows:
            stored = sum(entry(row, k) for k in (KINETIC, ROTATIONAL, SPRING, TANGENTIAL, ADHESION, GRAVITY,
                                                 ROLLING_SPRING))
            self.assertAlmostEqual(row[1], stored, delta=1e-12 * energy)

    def test_impact_with_each_contact_model(self):
        for normal in ("hooke", "hooke/stiffness", "hertz", "hertz/stiffness"):
            for tangential in ("off", "no_history", "history"):
                for rolling in ("", " rolling_friction cdt", FULL):
                    if tangential != "history" and rolling == FULL:
                        continue  # the engine's epsd2 asks for history
                    models = f"model {normal} tangential {tangential} cohesion hamaker{rolling}"
                    with self.subTest(models=models):
                        # hertz/stiffness: constants of other units, as stiff as hertz.
                        options = dict(contacts=contact(stiffness=4e6, gamman=5e7)) if "z/" in normal else {}
                        rows = tallies(go(models, hamaker(0), oblique(), steps=1200, **options))
                        self.closes(rows, STEP_ERROR)
                        end = rows[-1]
                        self.assertEqual([entry(end, k) for k in (SPRING, TANGENTIAL, ADHESION, ROLLING_SPRING)],
                                         4 * [0.0])
                        lost = entry(end, DAMPING)
                        self.assertGreater(lost, 0.01 * end[1])
                        # More than rounding.
                        self.assertEqual(entry(end, ROLLING) > 1e-6 * end[1], rolling != "")
                        self.assertEqual(entry(end, TANGENTIAL_DAMPING) > 1e-6 * end[1], tangential != "off")

    def test_head_on_loss_is_the_restitutions(self):
        # hooke, e = 0.9: 19 % in the dashpot, at a step of t_c/400 within (w dt)^2.
        rows = tallies(go("model hooke tangential off cohesion hamaker", hamaker(0),
                        [sphere((0, 0, 0), (0.05, 0, 0)), sphere((2 * RADIUS + 1e-6, 0, 0), (-0.05, 0, 0))],
                        dt=1e-7, steps=3000, every=100))
        self.assertAlmostEqual(entry(rows[-1], DAMPING) / entry(rows[0], KINETIC), 1 - 0.81, delta=2e-4)
        self.assertAlmostEqual(max(entry(row, SPRING) for row in rows) / entry(rows[0], KINETIC), 0.9, delta=0.05)

    def test_adhesion_is_the_energy_of_the_law(self):
        A, cut, out, gap = 1e-14, 1e-6, 2e-5, 3e-6
        run = go("model hooke/stiffness tangential off cohesion hamaker", hamaker(A, cut=cut, out=out),
                 [sphere((0, 0, 0)), sphere((2 * RADIUS + gap, 0, 0)), sphere((0, 0, -5e-3 + RADIUS + gap))],
                 steps=0, walls=[FLOOR])
        # -A R*/6 (1/H - 1/H_out), R* = r/2 and r: positions are good to 1e-18 m of 1e-6.
        expected = -A * 1.5 * RADIUS / 6 * (1 / gap - 1 / out)
        self.assertAlmostEqual(entry(tallies(run)[0], ADHESION), expected, delta=1e-9 * abs(expected))

    def test_hamaker_at_a_resolved_cutoff(self):
        # H_cut = 1e-6 m is crossed in 20 steps.
        rows = tallies(go(SLIDING + "hamaker" + FULL, hamaker(1e-12), oblique(), steps=800))
        self.assertLess(min(entry(row, ADHESION) for row in rows), -1e-12)
        self.closes(rows, 3 * STEP_ERROR)

    def test_edge_of_a_well_is_exact(self):
        depth = 5e-11
        rows = tallies(go("model hooke/stiffness tangential off cohesion square_well", square_well(depth),
                        [sphere((0, 0, 0), (0.05, 0, 0)), sphere((2 * RADIUS + 12e-6, 0, 0), (-0.05, 0, 0))],
                        every=1, steps=150))
        self.assertEqual({entry(row, ADHESION) for row in rows}, {0.0, -depth})
        # In the step of the impulse itself half of its work is still to come.
        at_rest = [row for row, last in zip(rows, rows[:1] + rows) if entry(row, ADHESION) == entry(last, ADHESION)]
        self.closes(at_rest, 1e-13)
        self.assertAlmostEqual(entry(rows[-1], KINETIC) - entry(rows[0], KINETIC), depth, delta=1e-12 * rows[0][1])

    def test_moving_wall_puts_work_in(self):
        rows = tallies(go(SLIDING + "hamaker" + FULL, hamaker(0), [sphere((0, 0, -5e-3 + RADIUS - 1e-6))],
                        steps=2000, every=100, walls=["primitive type 2 zplane -5e-3 shear x 0.1"],
                        extra="fix g all gravity 9.81 vector 0 0 -1\n"))
        work = entry(rows[-1], WORK)
        self.assertGreater(work, 1e-11)
        self.closes(rows, 0.01, energy=work)

    def test_wall_whose_pairs_change_from_exact_to_sampled(self):
        # One impact in each run; the wall has the scheme of the pairs.
        def pairs(scheme):
            return f"pair_style gran {models} scheme {scheme}\npair_coeff * *\n"

        models = "model hooke/stiffness tangential off cohesion hamaker"
        ball = [sphere((0, 0, -5e-3 + RADIUS + 5e-6), (0, 0, -0.05))]
        rows = {}
        for second in ("exact", "sampled"):
            rows[second] = tallies(go(models + " scheme exact", hamaker(0), ball, every=20,
                                      walls=[f"fix floor all wall/gran {models} {FLOOR}"],
                                      extra="fix g all gravity 200 vector 0 0 -1\n",
                                      run="run 600\n" + pairs(second) + "run 1600\n"))
            energy = entry(rows[second][0], KINETIC)
            self.closes(rows[second], STEP_ERROR)
            self.assertLess(abs(entry(rows[second][-1], SPRING)), 1e-12 * energy)
            first = [entry(row, DAMPING) for row in rows[second] if row[0] == 600][0]
            self.assertGreater(first, 0.1 * energy)
            self.assertGreater(entry(rows[second][-1], DAMPING), first + 0.05 * energy)
        for k in range(1, 14):
            self.assertAlmostEqual(entry(rows["exact"][-1], k), entry(rows["sampled"][-1], k),
                                   delta=STEP_ERROR * energy, msg=f"entry {k}")

    def test_contacts_that_change_from_exact_to_sampled(self):
        # In the middle of an impact, of two spheres and of one with a wall.
        models = "model hooke/stiffness tangential off cohesion hamaker"
        to_sampled = f"pair_style gran {models} scheme sampled\npair_coeff * *\n"
        for spheres, steps in (([sphere((0, 0, -5e-3 + RADIUS + 5e-6), (0, 0, -0.05))], 300),
                               ([sphere((0, 0, 0), (0.05, 0, 0)), sphere((2 * RADIUS + 5e-6, 0, 0), (-0.05, 0, 0))],
                                200)):
            with self.subTest(spheres=len(spheres)):
                rows = tallies(go(models + " scheme exact", hamaker(0), spheres, every=20,
                                  walls=[f"fix floor all wall/gran {models} {FLOOR}"],
                                  run=f"run {steps}\n{to_sampled}run 600\n"))
                before, after = [row for row in rows if row[0] == steps]
                energy = rows[0][1]
                self.assertGreater(entry(before, SPRING), 0.1 * energy)
                for k in (KINETIC, SPRING):
                    self.assertAlmostEqual(entry(after, k), entry(before, k), delta=STEP_ERROR * energy)
                self.closes(rows, STEP_ERROR)

    def test_contact_that_slides_in_a_set_up_has_no_tangential_dashpot(self):
        # With less friction the stored spring exceeds the Coulomb force until the first step.
        less = "fix coefficientFriction all property/global coefficientFriction peratomtypepair 2 0.02 0.02 0.02 0.02\n"
        for scheme in ("sampled", "exact"):
            for rolling in ("", FULL):
                with self.subTest(scheme=scheme, rolling=rolling):
                    rows = tallies(go(f"{SLIDING}hamaker{rolling} scheme {scheme} tangential_damping off", hamaker(0),
                                      oblique(), run=f"run 60\n{less}run 1\nrun 30\n"))
                    before, after = [entry(row, TANGENTIAL) for row in rows if row[0] in (60, 61)][1:3]
                    self.assertLess(after, 0.1 * before)
                    for row in rows:
                        self.assertAlmostEqual(entry(row, TANGENTIAL_DAMPING), 0.0, delta=1e-9 * before)

    def test_other_forces_are_work(self):
        rows = tallies(go("model hooke/stiffness tangential off cohesion hamaker", hamaker(0),
                        [sphere((0, 0, 0), (0.01, 0, 0)), sphere((4e-3, 0, 0))], steps=200,
                        extra="fix push all addforce 1e-5 0 0\n"))
        self.assertGreater(entry(rows[-1], WORK), 0.1 * entry(rows[-1], KINETIC))
        self.closes(rows, 1e-12, energy=rows[-1][1])

    def test_gravity_is_stored(self):
        rows = tallies(go("model hooke/stiffness tangential off cohesion hamaker", hamaker(0),
                        [sphere((0, 0, 3e-3), (0, 0, 0.1)), sphere((4e-3, 0, 0))], steps=1000,
                        extra="fix g all gravity 9.81 vector 0 0 -1\n"))
        # Both fall as in closed form, which leapfrog with a constant force meets.
        g, time = 9.81, 1000 * DT
        fall = 2 * (g * time**2 / 2) - 0.1 * time
        self.assertAlmostEqual(entry(rows[0], GRAVITY) - entry(rows[-1], GRAVITY), MASS * g * fall,
                               delta=1e-9 * MASS * g * abs(fall))
        self.closes(rows, 1e-9)
        self.assertEqual(entry(rows[-1], WORK), 0.0)

    def test_mesh_wall(self):
        mesh = stl(rectangle((-8e-3, -8e-3, -5e-3), (16e-3, 0, 0), (0, 16e-3, 0), 8))
        for law, properties in (("hamaker", hamaker(1e-12, wall=2e-12)), ("square_well", square_well(0, 2e-11))):
            models = SLIDING + law + FULL
            ends = []
            for walls in ([FLOOR], wall(models)):
                with self.subTest(law=law, walls=walls):
                    rows = tallies(go(models, properties,
                                    [sphere((1e-3, 1e-3, -5e-3 + RADIUS + 5e-6), (0.05, 0.02, -0.05), (10, 20, 30))],
                                    steps=1500, walls=walls, inputs={"plate.stl": mesh}))
                    self.closes(rows, 3 * STEP_ERROR)
                    self.assertLess(min(entry(row, ADHESION) for row in rows), -1e-12)
                ends.append(rows[-1])
            for k in range(1, 14):
                self.assertAlmostEqual(entry(ends[0], k), entry(ends[1], k), delta=1e-6 * ends[0][1],
                                       msg=f"{law}, entry {k}")


class SeveralWays(unittest.TestCase):
    """A packing of 27 that falls on a floor, cohesive, with all models."""

    MODELS = SLIDING + "hamaker" + FULL

    def packing(self, run="run 2000\n", ranks=0, models=None, properties=None):
        spheres = [sphere((1.002e-3 * (i - 1) + 1e-5 * k, 1.002e-3 * (j - 1) - 1e-5 * k, -4.4e-3 + 1.001e-3 * k),
                          (0.02 * (j - 1), 0.01 * (k - 1), -0.05), (10, 20 * i, -5 * k))
                   for i in range(3) for j in range(3) for k in range(3)]
        text = script(spheres, models or self.MODELS, properties or hamaker(1e-13), dt=DT, every=10000,
                      walls=[FLOOR], run=run, extra="fix g all gravity 9.81 vector 0 0 -1\n" + TALLY
                      + PRINT.format(every=100))
        return tallies(Run(text.replace("create_box", "processors 2 1 1\ncreate_box") if ranks else text, ranks=ranks))

    def test_many_contacts_close(self):
        rows = self.packing()
        energy = entry(rows[0], KINETIC)
        self.assertLess(abs(entry(rows[-1], RESIDUAL)), 0.01 * energy)
        self.assertGreater(entry(rows[-1], FRICTION) + entry(rows[-1], DAMPING), 0.01 * energy)

    def test_two_ranks_and_two_runs_keep_the_same_tally(self):
        whole = self.packing()
        for name, rows in (("ranks", self.packing(ranks=2)), ("runs", self.packing(run="run 1000\nrun 1000\n"))):
            with self.subTest(name):
                steps = {row[0]: row for row in rows}
                end = steps[2000.0]
                for k in range(1, 14):
                    # Of two runs the set-up takes the dashpots from the velocities on the grid.
                    self.assertAlmostEqual(entry(end, k), entry(whole[-1], k), delta=1e-3 * entry(whole[0], KINETIC),
                                           msg=f"entry {k}")


class SharedPairs(unittest.TestCase):
    """A pair that two ranks, or two images of the box, have: it is in the tally once."""

    MODELS = SLIDING + "hamaker" + FULL

    def rows(self, centre, boundary="f f f", ranks=0):
        spheres = oblique()
        for s in spheres:
            x = s["place"][0] + centre - RADIUS - 1e-6
            s["place"] = (x - 0.02 if x > 0.01 else x, *s["place"][1:])
        text = script(spheres, self.MODELS, hamaker(1e-12), dt=DT, every=10000, boundary=boundary, run="run 600\n",
                      extra=TALLY + PRINT.format(every=20))
        return tallies(Run(text.replace("create_box", "processors 2 1 1\ncreate_box") if ranks else text, ranks=ranks))

    def test_it_is_counted_once(self):
        alone = self.rows(0.003)
        energy = alone[0][1]
        self.assertGreater(max(entry(row, SPRING) for row in alone), 0.1 * energy)
        for name, rows in (("ranks", self.rows(0.0, ranks=2)), ("face", self.rows(0.01, boundary="p p p")),
                           ("face between ranks", self.rows(0.01, boundary="p p p", ranks=2))):
            with self.subTest(name):
                self.assertEqual(len(rows), len(alone))
                for row, other in zip(rows, alone):
                    # The same path but for the rounding of other places, 1e-18 m of an overlap of 1e-6 m.
                    for k in range(1, 14):
                        self.assertAlmostEqual(entry(row, k), entry(other, k), delta=1e-9 * energy,
                                               msg=f"entry {k} at step {row[0]}")


class Refusals(unittest.TestCase):
    def refused(self, text, *messages):
        assert_refused(self, Run(text), *messages)

    def test_input(self):
        models = SLIDING + "hamaker"
        for compute, message in (("compute tally all gran/energy yes\n", "takes no further arguments; 'yes' was given"),
                                 ("group few id 1\ncompute tally few gran/energy\n", "its group must be 'all', not 'few'"),
                                 (TALLY + "compute again all gran/energy\n", "there is one already")):
            with self.subTest(message=message):
                self.refused(script(oblique(), models, hamaker(0), extra=compute), "gran/energy", message)

    def test_walls_and_bodies_that_keep_no_tally(self):
        models = SLIDING + "hamaker"
        self.refused(script(oblique(), models, hamaker(0), extra=TALLY, walls=[
            "fix bare all wall/gran model hooke/stiffness tangential history primitive type 2 zplane -5e-3"]),
            "compute gran/energy: fix wall/gran bare has none of the cohesion models", "a strength of 0")
        # A pair style without: the compute exists once a model of this package was named.
        self.refused(script(oblique(), models, hamaker(0),
                            extra=TALLY + "pair_style gran model hooke/stiffness tangential history\npair_coeff * *\n"),
                     "pair_style gran has none of the cohesion models")

    def test_a_box_that_is_sheared(self):
        self.refused(script([sphere((0.01, 0.005, 0.01)), sphere((0.01, 0.015, 0.01))], SLIDING + "hamaker",
                            hamaker(0), boundary="p p p", box="0 0.02 0 0.02 0 0.02 0 0 0",
                            extra="fix shear all deform/shear rate 20\n" + TALLY),
                     "compute tally gran/energy: fix shear deform/shear changes the box")

    def test_particles_that_come_or_go_are_warned_of(self):
        gone = "run 10\ngroup few id 1\ndelete_atoms group few\nrun 10\n"
        for run, warned in ((gone, True), ("run 10\nrun 10\n", False)):
            with self.subTest(warned=warned):
                done = Run(script(oblique(), SLIDING + "hamaker", hamaker(0), extra=TALLY + PRINT.format(every=10),
                                  run=run))
                self.assertEqual(done.code, 0, done.output[-2000:])
                self.assertEqual("there were 2 particles and now are 1; the energy" in done.output, warned)

    def test_taken_back_it_costs_and_stops_nothing(self):
        text = script(oblique(), SLIDING + "hamaker", hamaker(0), extra=TALLY, run="run 1\nuncompute tally\nrun 400\n")
        self.assertEqual(Run(text).code, 0)


if __name__ == "__main__":
    unittest.main()
