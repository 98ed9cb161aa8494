# SPDX-License-Identifier: BSD-3-Clause
"""A small stability campaign (stability-campaign.py): nothing crashes, nothing is wrong without a warning; and the
judge sees what is wrong."""
import math
import unittest
from concurrent.futures import ThreadPoolExecutor
from unittest import mock

import numpy

from cohesion_tests import lammps as engine
from cohesion_tests.lammps_scenes import stability_judge as judge, stability_laws, stability_points as points

RANDOM = 3  # of each law


def make(law, values, number=0):
    return points.Point(law, values, numpy.random.default_rng([815, number]))


def law(name):
    return next(law for law in stability_laws.LAWS if law.name == name)


class Campaign(unittest.TestCase):
    def test_random_points(self):
        """Other points than the campaign's, the same in every run."""
        found = []
        for number, one in enumerate(stability_laws.LAWS):
            random = numpy.random.default_rng([815, number])
            found += [make(one, one.random(random), number) for _ in range(RANDOM)]
        with ThreadPoolExecutor(4) as pool:
            results = list(pool.map(lambda point: judge.judge(point, engine), found))
        right = marginal = warned = 0
        for point, result in zip(found, results):
            with self.subTest(point.law.name + ": " + point.text()):
                for verdict in result.verdicts.values():
                    self.assertIn(judge.kind(verdict, result.said),
                                  ("right", "marginal", "not judged", "refused", "warned", "elsewhere"), result)
                    right += verdict == "right"
                    marginal += verdict == "marginal"
                    kind = judge.kind(verdict, result.said)
                    warned += kind in ("warned", "elsewhere")
                    if kind in ("warned", "elsewhere"):
                        self.assertEqual(point.law.scheme, "sampled", result)
                if "refused" in result.verdicts.values():
                    self.assertNotEqual(result.said, "")
        # At least half of the points are within the range of the laws: those of Hertz and JKR begin at three steps per
        # contact, and half of them stop. In the campaign 2 % of the cases are marginal, of the sampled forces' one in
        # five is wrong: of 50 and of 18 cases, three standard deviations above.
        self.assertGreaterEqual(right, len(found))
        self.assertLessEqual(marginal, 4)
        self.assertLessEqual(warned, 9)

    def test_overlap_beyond_the_particle_is_refused_with_its_reason(self):
        for name in ("gran/hamaker, exact", "gran/squarewell, sampled", "fix wall/gran/hamaker, exact"):
            result = judge.judge(make(law(name), dict(speed=100.0)), engine)
            self.assertEqual(set(result.verdicts.values()), {"refused"})
            self.assertRegex(result.said, "impact overlap [0-9]+ %")

    def test_sampled_forces_at_two_steps_per_contact_are_wrong_and_say_so(self):
        result = judge.judge(make(law("gran/hamaker, sampled"), dict(steps=2.0, angle=0.0)), engine)
        self.assertNotEqual(result.verdicts["first"], "right")
        self.assertEqual(judge.kind(result.verdicts["first"], result.said), "warned")
        self.assertIn("2 steps per contact", result.said)

    def test_what_runs_say_is_told_in_short_and_of_whom(self):
        """In both the small spheres, of type 2, do not meet each other."""
        for name, values, said in (
                ("gran/squarewell, sampled", dict(e=0.5, steps=20.0),
                 r"^escape open by 9\.\d+ %$"),
                ("gran/hamaker, sampled", dict(A=0.0, speed=1e-9, K=1e6, steps=1000.0), r"^rounded places, 13\.\d %$"),
                ("gran/squarewell, sampled", dict(steps=17.0, ratio=10.0, e=1.0),
                 r"^12 steps per contact \(2 - 2\)$")):
            with self.subTest(said):
                point = make(law(name), values)
                self.assertRegex(judge.run(point, engine, "sampled", 1)[1], said)


class DeeperWell(stability_laws.SquareWell):
    """A well of the engine that is a hundredth too deep."""

    def words(self, point):
        return f" well {1.01 * point.well:.17g} {1 + point.wide / point.reach:.17g}"


class WrongLaw(unittest.TestCase):
    def test_is_found_by_the_closed_form(self):
        """Coarse and fine agree; but with 2 W/mu in place of which 1.01 times that acts, e^2 (v^2 + 2 W/mu) -
        2 W/mu changes by (e^2 - 1) of a hundredth of it."""
        point = make(DeeperWell("exact"), dict(angle=0.0))
        result = judge.judge(point, engine)
        added = point.values["depth"]  # over the speed
        share = added**2 / (1 + added**2)
        self.assertAlmostEqual(result.exact, 0.01 * share * (1 - point.values["e"]**2), delta=1e-10)
        self.assertTrue(result.verdicts["first"].startswith("wrong: "), result)
        self.assertEqual(judge.kind(result.verdicts["first"], result.said), "silent")


class Judge(unittest.TestCase):
    """What it makes of an end that is changed by hand."""

    def setUp(self):
        self.point = make(law("gran/squarewell, exact"), dict(angle=0.0, e=1.0))
        state, _, end = judge.run(self.point, engine, "exact", 1)
        self.assertEqual(state, "ran")
        self.end = end
        # Elastic, so that they part again.
        self.assertEqual(judge.together(self.point, [(0, 1)], end[0]), [False])

    def changed(self, share):
        velocities = self.end[1].copy()
        velocities[1, 0] += share * self.point.scale
        return self.end[0], velocities

    def test_errors(self):
        aim = judge.up_to(1e-6)
        error, verdict = judge.compare(self.point, "first", self.changed(1e-5), self.end, aim)
        self.assertAlmostEqual(error, 1e-5, delta=1e-12)
        self.assertEqual(verdict, "wrong by 1e-05")
        self.assertEqual(judge.compare(self.point, "first", self.changed(1e-7), self.end, aim)[1], "right")
        self.assertEqual(judge.compare(self.point, "first", self.changed(numpy.nan), self.end, aim)[1],
                         "wrong: not a number")

    def test_what_the_grid_leaves_open_is_not_judged(self):
        aim = judge.Aim(0.1, 0.4)
        self.assertEqual([judge.verdict(error, True, aim) for error in (0.09, 0.2, 0.5)],
                         ["right", judge.COARSE, "wrong by 0.5"])
        self.assertEqual(judge.verdict(0.2, False, aim), "other outcome")
        self.assertEqual(judge.verdict(numpy.nan, True, aim), judge.NOT_A_NUMBER)
        self.assertEqual(judge.kind(judge.COARSE, "2 steps per contact"), "not judged")

    def test_marginal_needs_both_sides(self):
        wrong = self.changed(0.01)
        for shares, found in (((-0.1, 0.1), True), ((-0.1, 0.001), False), ((0.001, 0.1), False)):
            others = [self.changed(share) for share in shares]
            self.assertEqual(judge.marginal(self.point, "first", wrong, self.end, others), found)
        self.assertFalse(judge.marginal(self.point, "first", wrong, self.end, [self.changed(0.1), None]))
        # Of another outcome one side is enough, if it has the same.
        places = self.end[0].copy()
        places[1] = [self.point.reach, 0, 0] + places[0]
        stuck = places, self.end[1]
        self.assertTrue(judge.marginal(self.point, "first", stuck, self.end, [self.changed(0.1), stuck]))
        self.assertFalse(judge.marginal(self.point, "first", stuck, self.end, 2 * [self.changed(0.1)]))

    def test_nothing_excuses_what_is_not_a_number(self):
        nan = self.changed(numpy.nan)
        with mock.patch.object(judge, "rounding_decides", return_value=True):
            self.assertEqual(judge.doubted(self.point, engine, "first", nan, self.end, 1e-6, judge.NOT_A_NUMBER, {}),
                             judge.NOT_A_NUMBER)
        # Nor does a reference that is none excuse others.
        self.assertFalse(judge.marginal(self.point, "first", self.changed(0.01), self.end, 2 * [nan]))

    def test_a_reference_that_crashes_excuses_nothing(self):
        """At half or at twice the fine step; one that is off there does excuse."""
        fine = judge.REFERENCE
        same, crashed = ("ran", "", self.end), ("crashed", "", None)
        for finer, other, found in ((fine, same, "wrong by 0.01"), (2 * fine, crashed, "reference crashed"),
                                    (fine // 2, crashed, "reference crashed"),
                                    (2 * fine, ("ran", "", self.changed(numpy.nan)), judge.NOT_A_NUMBER),
                                    (2 * fine, ("ran", "", self.changed(1e-5)), "not judged")):
            with mock.patch.object(judge, "run", lambda *words: other if words[3] == finer else same):
                self.assertEqual(judge.doubted(self.point, engine, "first", self.changed(0.01), self.end, 1e-6,
                                               "wrong by 0.01", {}), found)
        self.assertEqual(judge.kind("reference crashed", ""), "crashed")

    def test_aims_at_known_points(self):
        """w dt is 0.314 at 10 steps of a contact and 0.157 at 20. Rounding is below 1e-7 of the speed there: 2e-16 of
        places of 2 cm, times w = 3e4/s, in some 3000 fine steps, over 0.05 m/s."""
        for name, steps, mu, parted, held, room in (
                ("gran/squarewell, exact", 10.0, 0.0, (1e-6, 0.0986960), (0.1, 0.1), (0.314160, 0.412856)),
                ("gran/squarewell, exact", 20.0, 0.3, (0.0246740, 0.0246740), (0.1, 0.1), (0.181754, 0.181754)),
                ("gran/hamaker, exact", 20.0, 0.0, (1e-6, 0.0246740), (0.003085, 0.027758), (0.003085, 0.027758)),
                ("gran/hamaker, exact", 2.0, 0.0, (1e-6, 0.1), (0.1, 0.1), (0.308426, 0.408425))):
            point = make(law(name), dict(angle=0.0, e=1.0, steps=steps, mu=mu))
            with mock.patch.object(judge, "run", lambda *words: ("ran", "", self.end)):
                known = judge.fine_run(point, engine)[1]
            for number, case in enumerate(("first", "second")):
                with self.subTest(law=name, steps=steps, case=case):
                    aim = known[case][1]
                    self.assertAlmostEqual(aim(False).right, parted[number], delta=1e-7)
                    self.assertAlmostEqual(aim(True).right, held[number], delta=1e-6)
                    self.assertAlmostEqual(aim(True).room, room[number], delta=1e-6)

    def test_turning_load_is_the_error_of_oblique_impacts(self):
        """Of damped ones: their error is of the size of this bound, and far above 1e-6 and the square of the angle."""
        point = make(law("gran/squarewell, exact"), dict(angle=60.0, e=0.5, steps=8.0, depth=0.0, width=0.0, speed=5.0,
                                                          K=1e6))
        result = judge.judge(point, engine)
        self.assertEqual(result.verdicts["first"], "right", result)
        bound = judge.turning_load(point, 5.0 * math.sin(math.radians(60.0)))
        self.assertGreater(result.errors["first"], 0.3 * bound)
        self.assertGreater(bound, 1e-4)

    def test_late_dashpot(self):
        """zeta of e = 0.5 is 0.215; 2 0.3 0.215 pi/10."""
        point = make(law("fix wall/gran/hamaker, exact"), dict(mu=0.3, e=0.5, steps=10.0))
        self.assertAlmostEqual(judge.late_dashpot(point), 0.0406, delta=1e-4)

    def test_an_outcome_of_less_energy_than_the_aim_changes_is_marginal(self):
        places = self.end[0].copy()
        places[1] = [self.point.reach, 0, 0] + places[0]
        stuck = places, self.end[1]
        aim = 0.5 * (self.point.rate_of(*self.end, (0, 1)) / self.point.scale)**2
        for ends in ((stuck, self.end), (self.end, stuck)):
            self.assertTrue(judge.barely_parted(self.point, "first", *ends, 1.01 * aim))
            self.assertFalse(judge.barely_parted(self.point, "first", *ends, 0.99 * aim))

    def test_outcome(self):
        places = self.end[0].copy()
        places[1] = [self.point.reach, 0, 0] + places[0]
        self.assertEqual(judge.compare(self.point, "first", (places, self.end[1]), self.end,
                                       judge.up_to(1e-6))[1], "other outcome")

    def test_closed_form(self):
        """e = 1: all energy of the first touch is left but the well's, 1e-12 by rounding; a thousandth of the
        speed is 2e-3 of it."""
        self.assertLess(judge.closed_form(self.point, self.end), 1e-11)
        wrong = self.end[0], 1.001 * self.end[1]
        touch = self.point.law.head_on(self.point)[1]
        left = (self.point.values["speed"] / touch)**2
        self.assertAlmostEqual(judge.closed_form(self.point, wrong), 2.001e-3 * left, delta=1e-6)

    def test_kinds(self):
        self.assertEqual(judge.kind("wrong by 1", ""), "silent")
        self.assertEqual(judge.kind("wrong by 1", "2 steps per contact"), "warned")
        self.assertEqual(judge.kind("wrong by 1", "impact overlap 12.8 %; resting overlap 3 %"), "silent")
        self.assertEqual(judge.kind("wrong by 1", "impact overlap 2 %; 2 steps per contact (2 - 2)"), "elsewhere")
        self.assertEqual(judge.kind("wrong by 1", "escape open by 9 %; 2 steps per contact (2 - 2)"), "warned")
        self.assertEqual(judge.kind("other outcome", ""), "silent")
        self.assertEqual(judge.kind("hangs", ""), "crashed")
        self.assertEqual(judge.kind("right", ""), "right")


if __name__ == "__main__":
    unittest.main()
