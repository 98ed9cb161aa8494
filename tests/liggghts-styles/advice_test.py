# SPDX-License-Identifier: BSD-3-Clause
"""The table before the first step of a run against numbers worked out here, its warnings, and its refusals."""

import math
import re
import unittest

from scipy.optimize import brentq

from cohesion_tests.liggghts import Run, assert_refused
from cohesion_tests.liggghts_scenes.advice_table import A, ABSOLUTE, CUT, DT, FLOOR, LINEAR, OUT, SPEED, THREE, TWO, go, rows
from cohesion_tests.liggghts_scenes.scene import (DAMPING, MASS, RADIUS, STIFFNESS, contact, hamaker, liquid_bridge,
                                                  script, sphere, square_well)
from cohesion_tests.theory.pair_motion import Pair


def natural_frequency(stiffness, mass):
    return math.sqrt(stiffness / mass)


class Table(unittest.TestCase):
    def near(self, value, expected, digits=THREE):
        self.assertAlmostEqual(value, expected, delta=digits * abs(expected))

    def test_linear_pair(self):
        run = go(LINEAR + ABSOLUTE, hamaker(A, cut=CUT, out=OUT))
        row = rows(run)["1 - 1"]
        pair = Pair(A)
        tail = A * RADIUS / 2 / 6 * (1 / CUT - 1 / OUT) + pair.adhesion * CUT
        touch = math.sqrt(SPEED**2 + 4 * tail / MASS)
        self.near(row["speed"], SPEED)
        self.near(row["steps"], math.pi / natural_frequency(STIFFNESS, MASS / 2) / DT)
        self.near(row["cutoff"], CUT / touch / DT)
        self.near(row["static"], pair.adhesion / STIFFNESS / (2 * RADIUS), TWO)
        self.near(row["escape"], pair.escape_velocity())
        self.near(row["ratio"], tail / (pair.adhesion**2 / (2 * STIFFNESS)))
        self.assertEqual(row["bond"], math.inf)
        self.assertEqual(run.output.count("what to expect"), 1)
        self.assertIn("cohesion model hamaker, scheme sampled: what to expect", run.files["log.liggghts"])

    def test_dashpot_is_that_of_the_settings(self):
        # gamman times the reduced mass, or gamman_abs: another damping, another escape velocity.
        absolute, relative = (rows(go(LINEAR + words, hamaker(A, cut=CUT, out=OUT)))["1 - 1"]["escape"]
                              for words in (ABSOLUTE, ""))
        self.near(relative, Pair(A, damping=1000 * MASS / 2).escape_velocity())
        self.assertGreater(abs(relative / absolute - 1), 0.02)

    def test_gravity_a_wall_and_friction(self):
        models = "model hooke/stiffness tangential history cohesion hamaker"
        run = go(models, hamaker(A, wall=2 * A, cut=CUT, out=OUT), [sphere((0, 0, 0))], walls=[FLOOR],
                 extra="fix g all gravity 9.81 vector 0 0 -1\n")
        pair, wall = rows(run)["1 - 1"], rows(run)["1 - wall"]
        self.near(pair["speed"], math.sqrt(2 * 9.81 * 2 * RADIUS))
        self.near(pair["bond"], A * RADIUS / 2 / (6 * CUT**2) / (MASS * 9.81))
        # kt = kn: 7/2 of the square of the frequency.
        self.near(pair["steps"], math.pi / natural_frequency(3.5 * STIFFNESS, MASS / 2) / DT)
        self.near(wall["steps"], math.pi / natural_frequency(3.5 * STIFFNESS, MASS) / DT)
        self.near(wall["static"], 2 * A * RADIUS / (6 * CUT**2) / STIFFNESS / (2 * RADIUS), TWO)
        self.assertIn("cohesion model hamaker, fix wall/gran wall0, scheme sampled", run.output)

    def test_rolling_friction_counts(self):
        models = "model hooke/stiffness tangential history cohesion hamaker rolling_friction epsd2"
        run = go(models, hamaker(0, cut=CUT, out=OUT), walls=[FLOOR])
        # At a wall 5.55 K_t/mu, src/advice/contact_numbers.h.
        self.near(rows(run)["1 - wall"]["steps"],
                  math.pi / natural_frequency(5.55 * STIFFNESS, MASS) / DT)

    def test_spring_of_model_hooke_is_that_of_the_particles(self):
        small = 0.25e-3
        run = go("model hooke tangential off cohesion hamaker", hamaker(0, cut=CUT, out=OUT),
                 [sphere((0, 0, 0), (SPEED, 0, 0)), sphere((3e-3, 0, 0), radius=small)])
        # The lightest: r/2, m/8 each. Its formula as the engine's manual has it, characteristic velocity 1 m/s.
        root, modulus, mass = math.sqrt(small / 2), 5e6 / (2 * (1 - 0.09)), MASS / 16
        stiffness = 16 / 15 * root * modulus * (15 * mass / (16 * root * modulus))**0.2
        self.near(rows(run)["1 - 1"]["steps"], math.pi / natural_frequency(stiffness, mass) / DT)

    def test_a_mean_shear_is_no_speed_of_approach(self):
        # At rest beyond the shear, above and below the middle; the profile makes them 0.1 m/s fast.
        rate, box, shear = 20.0, "0 0.02 0 0.02 0 0.02 0 0 0", "fix shear all deform/shear rate 20\n"
        run = go(LINEAR, hamaker(A, cut=CUT, out=OUT), [sphere((0.01, 0.005, 0.01)), sphere((0.01, 0.015, 0.01))],
                 boundary="p p p", box=box, extra=shear)
        self.near(rows(run)["1 - 1"]["speed"], rate * 2 * RADIUS)

    def test_hertz_is_told_as_the_linear_spring_of_the_impact(self):
        run = go("model hertz tangential off cohesion hamaker", hamaker(0, cut=CUT, out=OUT))
        self.assertIn("hertz: linear springs that an impact presses as far", run.output)
        row = rows(run)["1 - 1"]
        c = 4 / 3 * 5e6 / (2 * (1 - 0.09)) * math.sqrt(RADIUS / 2)
        deepest = (1.25 * MASS / 2 * SPEED**2 / c)**0.4
        self.near(row["steps"], math.pi * deepest / SPEED / DT)
        # e = 0.9: the dashpot takes 1 - exp(-(alpha/q) asin(q/w0)) = 5 % of the overlap.
        self.near(row["impact"], 0.949 * deepest / (2 * RADIUS), TWO)

    def test_accuracy_of_the_escape_velocity_of_hertz(self):
        """By integrations of its impact (theory/hertz_contact.py), spheres of 1 mm: 0.018322, 0.072754 and 0.141285 m/s.
        At any speed of the particles."""
        for restitution, exact in ((0.9, 0.018322), (0.5, 0.072754), (0.3, 0.141285)):
            contacts = contact().replace("Restitution peratomtypepair 2 0.9 0.9 0.9 0.9",
                                         f"Restitution peratomtypepair 2{4 * f' {restitution}'}")
            for speed in (0.1 * exact, 5 * exact):
                run = go("model hertz tangential off cohesion hamaker", hamaker(A, cut=CUT, out=OUT),
                         [sphere((0, 0, 0), (speed, 0, 0)), sphere((3e-3, 0, 0))], dt=1e-8, contacts=contacts)
                self.assertAlmostEqual(rows(run)["1 - 1"]["escape"] / exact, 1, delta=1e-3 + THREE)

    def test_walls_of_the_same_numbers_share_a_table(self):
        planes = [f"primitive type 2 {axis}plane -5e-3" for axis in "xyz"]
        run = go(LINEAR, hamaker(A, cut=CUT, out=OUT), [sphere((0, 0, 0))], walls=planes)
        self.assertEqual(run.output.count("what to expect"), 2)  # of pairs, and of the walls
        self.assertIn("fix wall/gran wall0 and wall1 and wall2, scheme sampled: what to expect", run.output)
        # One of another type, to which adhesion is twice as strong, has a table of its own.
        planes[1] = planes[1].replace("type 2", "type 1")
        run = go(LINEAR, hamaker(A, wall=2 * A, cut=CUT, out=OUT), [sphere((0, 0, 0))], walls=planes)
        self.assertEqual(run.output.count("what to expect"), 3)
        self.assertIn("fix wall/gran wall0 and wall2, scheme", run.output)
        self.assertIn("fix wall/gran wall1, scheme", run.output)

    def test_square_well(self):
        row = rows(go("model hooke/stiffness tangential off cohesion square_well" + ABSOLUTE,
                      square_well(5e-11)))["1 - 1"]
        e = math.exp(-DAMPING / MASS * math.pi / math.sqrt(2 * STIFFNESS / MASS - (DAMPING / MASS)**2))
        self.near(row["escape"], math.sqrt(4 * 5e-11 / MASS * (1 / e**2 - 1)))
        self.assertTrue(math.isnan(row["ratio"]))

    def test_particles_that_are_still_to_come(self):
        text = script([], LINEAR, hamaker(A, cut=CUT, out=OUT), extra="""fix pts all particletemplate/sphere 15485863 \
atom_type 1 density constant 2650 radius constant 0.5e-3
fix pdd all particledistribution/discrete 15485867 1 pts 1.0
""")
        run = Run(text)
        self.assertEqual(run.code, 0, run.output[-1000:])
        self.assertIn("1 - 1", rows(run))

    def test_what_was_said_is_not_said_again(self):
        run = go(LINEAR, hamaker(A, cut=CUT, out=OUT), run="run 1\nwrite_restart r.*\nrun 1\nrun 1 pre no\n")
        self.assertEqual(run.output.count("what to expect"), 1)
        self.assertEqual(run.output.count("left to chance"), 1)

    def test_walls_and_pairs_that_are_defined_again_repeat_nothing(self):
        models = LINEAR + " scheme sampled"
        wall = "fix wall0 all wall/gran %s primitive type 2 xplane %s scheme sampled\n"
        again = (f"unfix wall0\n{wall % (LINEAR, '-6e-3')}pair_style gran {models}\npair_coeff * *\n")
        first, both = (go(models, hamaker(A, cut=CUT, out=OUT), walls=[wall % (LINEAR, "-5e-3")],
                          run=f"run 1\n{then}run 1\n")
                       for then in ("", again))
        self.assertEqual(both.output.count("what to expect"), 2)  # of pairs, and of the wall
        self.assertGreater(first.output.count("WARNING: cohesion"), 0)
        self.assertEqual(both.output.count("WARNING: cohesion"), first.output.count("WARNING: cohesion"))

    def test_wall_of_the_scheme_of_the_pairs_repeats_nothing_in_either_scheme(self):
        def scheme(name):
            return f"pair_style gran {LINEAR} scheme {name}\npair_coeff * *\n"

        fix = f"fix floor all wall/gran {LINEAR} {FLOOR}\n"
        again = "unfix floor\n" + fix
        tables = {name: f"fix wall/gran floor, scheme {name}: what to expect" for name in ("exact", "sampled")}

        def printed(run):
            run = go(LINEAR + " scheme exact", hamaker(A, cut=CUT, out=OUT), walls=[fix], run=run)
            self.assertEqual(run.code, 0, run.output[-1000:])
            return [run.output.count(text) for text in tables.values()], run.output.count("WARNING: cohesion")

        first = "run 1\n" + scheme("sampled") + "run 1\n"
        once = printed(first)
        self.assertEqual(once[0], [1, 1])
        self.assertGreater(once[1], 0)
        self.assertEqual(printed(first + again + "run 1\n"), once)
        self.assertEqual(printed(first + scheme("exact") + "run 1\n"), once)
        self.assertEqual(printed(first + again + scheme("exact") + "run 1\n"), once)
        # Numbers that only scheme sampled has printed are new to scheme exact.
        longer = f"timestep {3 * DT:.17g}\n"
        self.assertEqual(printed(first + longer + "run 1\n" + again + scheme("exact") + "run 1\n")[0], [2, 2])

    def test_another_step_is_told(self):
        for step, said in ((1.1 * DT, 2), (DT / 1.5, 1), (DT / 3, 2)):  # shorter: beyond a factor of two
            run = go(LINEAR, hamaker(A, cut=CUT, out=OUT), run=f"run 1\ntimestep {step}\nrun 1\n")
            self.assertEqual(run.output.count("what to expect"), said)


class Judgement(unittest.TestCase):
    LIMIT = 2 / natural_frequency(STIFFNESS, MASS / 2)  # of leapfrog, without dashpot

    def test_a_step_that_must_blow_up_is_refused_before_the_first(self):
        models = LINEAR + ABSOLUTE
        for wall in (False, True):
            with self.subTest(wall=wall):
                # Beside a wall the mass is twice as large, the spring here, too.
                spheres = [sphere((0, 0, 0), (0.01, 0, 0))] + ([] if wall else [sphere((3e-3, 0, 0))])
                options = dict(walls=[FLOOR + ABSOLUTE] if wall else [], contacts=contact(wall=2.0), steps=10)
                text = script(spheres, models, hamaker(0, cut=CUT, out=OUT), dt=1.001 * self.LIMIT, **options)
                text = text.replace(f"wall/gran {models}", f"wall/gran {LINEAR}")
                run = Run(text)
                assert_refused(self, run, "makes contacts unstable: reduce it below")
        run = go(models, hamaker(0, cut=CUT, out=OUT), dt=0.9 * self.LIMIT, steps=1)
        self.assertEqual(run.code, 0, run.output[-1000:])
        self.assertIn("the sampled scheme should have 15", run.output)

    def test_a_step_that_became_too_long_stops_a_run_that_is_not_set_up(self):
        run = go(LINEAR + ABSOLUTE, hamaker(0, cut=CUT, out=OUT),
                 run=f"run 1\ntimestep {1.1 * self.LIMIT:.6g}\nrun 50 pre no\n")
        assert_refused(self, run, "makes contacts unstable: reduce it below", begun=True)
        self.assertEqual(run.output.count("Loop time"), 1)

    def test_particles_that_become_lighter_within_a_run_stop_it(self):
        # To half the diameter, an eighth of the mass; nothing moves, and no list is made anew.
        shrink = "variable d equal 1e-3*(1-0.01*step)\nfix shrink all adapt 10 atom diameter v_d\n"
        run = go(LINEAR + ABSOLUTE, hamaker(0, cut=CUT, out=OUT), [sphere((0, 0, 0)), sphere((3e-3, 0, 0))],
                 dt=0.5 * self.LIMIT, extra=shrink, steps=60)
        assert_refused(self, run, "makes contacts unstable: reduce it below")

    def test_warnings_say_what_would_be_right(self):
        run = go(LINEAR + ABSOLUTE, hamaker(A, cut=CUT, out=OUT))
        self.assertIn("which pairs stick is left to chance: reduce the time step to 3.99e-09 or use the exact scheme",
                      run.output)
        self.assertIn("1 - 1: pairs would stick less with a stiffer spring", run.output)
        self.assertIn("'material_stiffness on' with fix property/global materialStiffness keeps its escape velocity "
                      "(collisions: which pairs stick), with 'material_keep force' its pull-off force (packings", run.output)

    def test_no_keyword_is_named_that_the_model_refuses(self):
        for models, properties in (("model hertz/stiffness tangential off cohesion hamaker", hamaker(A, cut=CUT, out=OUT)),
                                   ("model hooke/stiffness tangential off cohesion liquid_bridge",
                                    liquid_bridge(1e-4, 1e-9))):
            with self.subTest(models):
                run = go(models, properties)
                self.assertIn("pairs would stick less with a stiffer spring", run.output)
                self.assertNotIn("material_", run.output)

    def test_no_least_number_of_steps_where_there_is_none(self):
        run = go(LINEAR + ABSOLUTE, hamaker(0, cut=CUT, out=OUT), dt=1e-5)
        self.assertIn("the sampled scheme should have 15: reduce the time step", run.output)
        self.assertNotIn("fewer than", run.output)

    def test_nothing_to_warn_of(self):
        run = go(LINEAR + ABSOLUTE, hamaker(0, cut=CUT, out=OUT))
        self.assertNotIn("WARNING: cohesion model", run.output)


class StiffnessScaling(unittest.TestCase):
    WORDS = LINEAR + ABSOLUTE + " material_stiffness on"

    @staticmethod
    def properties(material, out=OUT):
        return hamaker(A, cut=CUT, out=out) + (
            f"fix km all property/global materialStiffness peratomtypepair 2 {4 * (repr(material) + ' ')}\n")

    FACTOR = 4.0

    def stiff(self):
        """A run whose springs are the material's; their dashpot of the same restitution goes as the root."""
        stiffer = contact()
        for name, value, times in (("kn", STIFFNESS, self.FACTOR), ("gamman_abs", DAMPING, math.sqrt(self.FACTOR))):
            line = f"fix {name} all property/global {name} peratomtypepair 2 " + " ".join(4 * [repr(float(value))])
            self.assertIn(line, stiffer)
            stiffer = stiffer.replace(line, line.replace(repr(float(value)), repr(times * value)))
        return go(LINEAR + ABSOLUTE, hamaker(A, cut=CUT, out=OUT), contacts=stiffer)

    def test_as_many_stick_as_of_the_material(self):
        stiff = self.stiff()
        scaled = go(self.WORDS, self.properties(self.FACTOR * STIFFNESS))
        self.assertEqual(rows(scaled)["1 - 1"]["escape"], rows(stiff)["1 - 1"]["escape"])
        self.assertNotEqual(rows(scaled)["1 - 1"]["escape"],
                            rows(go(LINEAR + ABSOLUTE, hamaker(A, cut=CUT, out=OUT)))["1 - 1"]["escape"])
        # H_cut and A grow by 1/f = 2 but for k = H_cut/H_out = 0.004 of it: h = (2 - k)/f/(1 + sqrt(1 - k (2 - k)/f)).
        self.assertIn("atom types 1 and 1: adhesion scaled from stiffness 3200 to 800, which keeps the escape "
                      "velocity: A 7.49e-19 -> 1.50", scaled.output)
        self.assertIn("H_cut 4e-10 -> 8.0", scaled.output)
        self.assertIn("stiffness 800 for 3200 of the material: escape velocity 1, pull-off force 0.5 times the "
                      "material's (1 - 1)", scaled.output)
        self.assertNotIn("stiffer spring", scaled.output)

    def test_the_force_can_be_kept_instead(self):
        as_given = go(LINEAR + ABSOLUTE, hamaker(A, cut=CUT, out=OUT))
        kept = go(self.WORDS + " material_keep force", self.properties(3200.0))
        self.assertEqual(rows(kept), rows(as_given))
        self.assertIn("atom types 1 and 1: adhesion not scaled from stiffness 3200 to 800, which keeps the pull-off "
                      "force", kept.output)
        escape = rows(kept)["1 - 1"]["escape"] / rows(self.stiff())["1 - 1"]["escape"]
        found = re.search("escape velocity (\\S+), pull-off force 1 times the material's \\(1 - 1\\)", kept.output)
        self.assertAlmostEqual(float(found[1]), escape, delta=3 * THREE * escape)  # of three printed numbers
        self.assertNotIn("stiffer spring", kept.output)

    def test_the_stiffness_of_the_material_itself_is_nothing_to_scale(self):
        run = go(self.WORDS, self.properties(STIFFNESS))
        self.assertEqual(run.code, 0, run.output[-1000:])
        for words in ("adhesion scaled", "of the material", "stiffer spring"):
            self.assertNotIn(words, run.output)

    def test_off_and_zero_scale_nothing(self):
        for words, material in ((LINEAR + ABSOLUTE, None), (self.WORDS, 0.0)):
            with self.subTest(material=material):
                run = go(words, hamaker(A, cut=CUT, out=OUT) if material is None else self.properties(material))
                self.assertEqual(run.code, 0, run.output[-1000:])
                self.assertNotIn("adhesion scaled", run.output)

    def test_a_stiffness_that_is_not_read_is_warned_of(self):
        for words, warned in ((LINEAR + ABSOLUTE, True), (self.WORDS, False)):
            with self.subTest(words=words):
                run = go(words, self.properties(3200.0))
                self.assertEqual("but material_stiffness is off" in run.output, warned)

    def test_what_it_cannot_do_is_refused(self):
        for words, properties, *messages in (
                ("model hertz tangential off cohesion hamaker material_stiffness on", self.properties(3200.0),
                 "model hertz has no such number for two types", "'material_modulus on' with model hertz"),
                ("model hooke tangential off cohesion hamaker material_stiffness on", self.properties(3200.0),
                 "model hooke has no such number for two types"),
                (self.WORDS, hamaker(A, cut=CUT, out=OUT), "materialStiffness"),
                (self.WORDS, self.properties(-1.0), "materialStiffness = -1: must be"),
                (self.WORDS + " material_keep adhesion", self.properties(3200.0),
                 "unknown material_keep 'adhesion'", "velocity, force"),
                (LINEAR + ABSOLUTE + " material_keep force", hamaker(A, cut=CUT, out=OUT),
                 "material_keep force needs 'material_stiffness on'"),
                (self.WORDS, self.properties(3200.0, out=1e-9), "too small for the softened contact")):
            with self.subTest(message=messages[0]):
                run = go(words, properties)
                assert_refused(self, run, *messages)


class SeveralContacts(unittest.TestCase):
    """Of a sphere that touches twelve others, the springs between two count four times."""
    MODELS = LINEAR + ABSOLUTE + " scheme exact"

    def limit(self):
        """Where x_(n+1) = (2 - 4 (k + h)) x_n - (1 - 4 h) x_(n-1) swings up, k = 1 + d - 2 c and h = 1 - d of the
        motion of a pair, d = exp(-2 alpha dt), c = sqrt(d) cos(q dt): there 4 (k + 2 h) = 4."""
        alpha, w0 = DAMPING / MASS, natural_frequency(STIFFNESS, MASS / 2)
        kept = lambda dt: math.exp(-alpha * dt)
        off = lambda dt: 3 - kept(dt)**2 - 2 * kept(dt) * math.cos(math.sqrt(w0**2 - alpha**2) * dt) - 1
        return brentq(off, 1e-3 / w0, math.pi / w0, xtol=1e-6 / w0)

    def run_spheres(self, dt, places):
        return go(self.MODELS, hamaker(0.0, cut=CUT, out=OUT), [sphere(place) for place in places], dt=dt, steps=3)

    def test_packings_stop_beyond_the_limit(self):
        near = 2 * RADIUS * (1 - 1e-3) / math.sqrt(2)
        packing = [(0, 0, 0)] + [place for a in (-near, near) for b in (-near, near)
                                 for place in ((a, b, 0), (a, 0, b), (0, a, b))]
        self.assertEqual(self.run_spheres(0.999 * self.limit(), packing).code, 0)
        named = math.floor(self.limit() * 1e7) / 1e7  # to three digits, rounded down
        assert_refused(self, self.run_spheres(1.001 * self.limit(), packing), "several contacts unstable",
                       f"reduce it to {named:.3g},")

    def test_pairs_do_not(self):
        pair = [(0, 0, 0), (2 * RADIUS, 0, 0)]
        run = self.run_spheres(1.1 * self.limit(), pair)
        self.assertEqual(run.code, 0, run.output[-1000:])
        self.assertNotIn("several contacts", run.output)
        run = self.run_spheres(1.1 * self.limit(), pair + [(0, 8 * RADIUS, 0)])
        self.assertEqual(run.code, 0, run.output[-1000:])
        self.assertIn("the run stops where a particle has two neighbours", run.output)


if __name__ == "__main__":
    unittest.main()
