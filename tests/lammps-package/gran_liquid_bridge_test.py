# SPDX-License-Identifier: BSD-3-Clause
"""pair_style gran/liquidbridge and fix wall/gran/liquidbridge in LAMMPS, against closed forms: who
stays, what a broken bridge takes, and that a bridge goes from run to run, rank to rank and through
restart files."""
import math
import unittest

import numpy

from cohesion_tests import lammps as engine
from cohesion_tests.lammps_scenes import couples
from cohesion_tests.lammps_scenes.one_sphere import HEAD, MOVE
from cohesion_tests.lammps_scenes.square_well_scene import T_C, Scene, gaps, relative, report
from cohesion_tests.refusals import assert_refused
from cohesion_tests.theory.liquid_bridge import FORCE, GAP, Capillary, escape_velocity, parting_speed
from cohesion_tests.theory.pair_motion import DAMPING, DENSITY, DIAMETER, MASS, MU, STIFFNESS
from cohesion_tests.thermo import thermo_lines

STYLE = "gran/liquidbridge"
POSITIONS = 8  # of the touch within the step
LAWS = ((1e-5, 1e-5), (FORCE, GAP), (1e-3, 2e-6))  # F_b, h_r


def words(force=FORCE, gap=GAP, damping=DAMPING, **more):
    text = f"stiffness {STIFFNESS:.17g} damping {damping:.17g} bridge {force:.17g} {gap:.17g}"
    return text + "".join(f" {name} {value:.17g}" for name, value in more.items())


def have_parted(gaps_then, width):
    """Whether couples have broken their bridge, from their gaps in the second half of a run."""
    late = gaps_then[len(gaps_then) // 2:]
    return (late > width + 1e-9).all(axis=0)


class HeadOn(unittest.TestCase):
    def parted(self, style, division, factors):
        """By law, factor of the escape velocity, and position of the touch in the step."""
        dt, atoms = T_C / division, []
        for k, (force, gap) in enumerate(LAWS, 1):
            for factor in factors:
                for position in range(POSITIONS):
                    speed = factor * escape_velocity(force, gap)
                    atoms += couples.couple(len(atoms) // 2, 1e-7 + speed * dt * position / POSITIONS,
                                            (0.0, speed, 0.0), types=(k, k))
        coefficients = [f"{k} {k} {words(*law)}" for k, law in enumerate(LAWS, 1)]
        # Up the bridge takes sqrt(2 mu h_r/F_b), 0.8 ms = 9 t_c at most; a captured pair falls back as
        # long, and the slowest that parted, at sqrt(2e-6) of 0.02 m/s, are far beyond 1e-9 m then.
        path = couples.run(atoms, coefficients, dt, 120 * division, types=len(LAWS), skin=4e-4,
                           every=12 * division, style=f"{STYLE} scheme {style}")[0]
        widths = numpy.repeat([gap for _, gap in LAWS], len(factors) * POSITIONS)
        return have_parted(gaps(path), widths).reshape(len(LAWS), len(factors), POSITIONS)

    def test_sampled_scheme_converges_to_the_same(self):
        # Leapfrog's contact is off by up to a step of its dashpot, 2 zeta w0 dt = 0.034 pi/division of
        # the speed, and the rupture by up to a step of flight: F v dt of F h_r.
        for division, grade in ((50, 0.2), (400, 0.03)):
            parted = self.parted("sampled", division, (1 - grade, 1 + grade))
            report(f"sampled, t_c/{division}, within {grade}: "
                   f"{parted[:, 0].sum()} of {parted[:, 0].size} slow ones parted, "
                   f"{(~parted[:, 1]).sum()} fast ones stayed")
            for law, (force, gap) in enumerate(LAWS):
                late = escape_velocity(force, gap) * T_C / division / gap
                if 0.034 * math.pi / division + late < grade:
                    self.assertFalse(parted[law, 0].any(), (division, force, gap))
                    self.assertTrue(parted[law, 1].all(), (division, force, gap))

    def test_a_broken_bridge_takes_its_work(self):
        # Head-on: out at sqrt(w^2 - 2 F_b h_r/mu), w the speed at which the contact ends.
        speed = 0.5
        for division in (4, 10, 50):
            dt, atoms = T_C / division, []
            for k in range(20):
                atoms += couples.couple(k, 1e-6 + k * speed * dt / 20, (0.0, speed, 0.0))
            path, output = couples.run(atoms, ["* * " + words()], dt, 10 * division, style=STYLE,
                                       skin=4e-4, every=1)
            out = relative(path[-1])[:, 4]
            w = parting_speed(speed, FORCE, MU, DAMPING)
            # The gap is rounded by 3e-17 m, in contact that is w0 3e-17 m = 1e-12 m/s.
            numpy.testing.assert_allclose(out, math.sqrt(w**2 - 2 * FORCE * GAP / MU), rtol=1e-9)
            names, lines = thermo_lines(output)
            tally = dict(zip(names, numpy.array(lines).T))
            energy = 20 * 0.5 * MU * speed**2
            # Nothing is stored, all that is lost counts as normal damping, and the sum is right at
            # each grid point: roundings of the energy, and of the gap at the force of the contact.
            lost = energy - 20 * 0.5 * MU * out[0]**2
            self.assertAlmostEqual(tally["c_tally[6]"][-1] / lost, 1, delta=1e-9)
            self.assertEqual(tally["PotEng"][-1], 0.0)
            self.assertLess(numpy.abs(tally["c_tally[10]"]).max(),
                            math.sqrt(20 * 10 * division) * 3e-17 * 1.0 +
                            10 * division * 2.0**-53 * energy)

    def test_nothing_before_touch(self):
        # Passes at less than h_r: as without a bridge, to the last bit; and runs that begin there.
        atoms = couples.couple(0, 0.2 * GAP, (0.1, 0.0, 0.0))
        atoms += couples.couple(1, 0.9 * GAP, (0.0, -0.1, 0.0))
        ends = [couples.run(atoms, ["* * " + line], T_C / 4, 200, style=STYLE, skin=4e-4)[0][-1]
                for line in (words(), words(0.0, 0.0))]
        numpy.testing.assert_array_equal(ends[0], ends[1])


class Passes(unittest.TestCase):
    def test_oblique_bridges_turn_and_break(self):
        # The relative motion integrated by itself, with everything central: what a pair with a bridge
        # does while it turns. The step errs in the turning alone, second order.
        from scipy.integrate import solve_ivp
        speed = 0.3
        ends, offsets = {}, (0.2, 0.5, 0.8)
        for division in (4, 16):
            dt, atoms = T_C / division, []
            for offset in offsets:
                normal = (offset, math.sqrt(1 - offset**2), 0.0)
                atoms += couples.couple(len(atoms) // 2, 1e-9, (0.0, speed, 0.0), normal=normal)
            path = couples.run(atoms, ["* * " + words(damping=0.0)], dt, 40 * division, style=STYLE,
                               skin=4e-4)[0]
            ends[division] = relative(path[-1])[:, 3:5]
        for k, offset in enumerate(offsets):
            bridged = [False]

            def motion(_, s, bridged=bridged):
                distance = math.hypot(s[0], s[1])
                gap = distance - DIAMETER
                force = -FORCE - STIFFNESS * min(gap, 0.0) if bridged[0] else 0.0
                return [s[2], s[3], force * s[0] / distance / MU, force * s[1] / distance / MU]

            def touch(_, s):
                return math.hypot(s[0], s[1]) - DIAMETER

            def rupture(_, s):
                return math.hypot(s[0], s[1]) - DIAMETER - GAP
            touch.terminal, touch.direction = True, -1
            rupture.terminal, rupture.direction = True, 1
            state, time = [(DIAMETER + 1e-9) * offset, (DIAMETER + 1e-9) * math.sqrt(1 - offset**2),
                           0.0, -speed], 0.0
            settings = {"method": "DOP853", "rtol": 1e-12, "atol": 1e-16, "max_step": T_C / 20}
            path = solve_ivp(motion, (0, T_C), state, events=touch, **settings)
            state, time, bridged[0] = path.y[:, -1], path.t[-1], True
            path = solve_ivp(motion, (time, 40 * T_C), state, events=rupture, **settings)
            parted = len(path.t_events[0]) > 0
            expected = path.y[2:, -1]
            self.assertTrue(parted, offset)
            errors = [numpy.linalg.norm(ends[d][k] - expected) / speed for d in (4, 16)]
            report(f"oblique, {offset} of the diameter: error {errors[0]:.1e} at t_c/4, {errors[1]:.1e} "
                   "at t_c/16")
            # Second order in the angle by which a pair turns in a step, v dt/d, and in contact, where
            # what turning does counts as constant, in the overlap over the distance, v/(w0 d).
            overlap = speed / math.sqrt(STIFFNESS / MU) / DIAMETER
            for error, division in zip(errors, (4, 16)):
                self.assertLess(error, (speed * T_C / division / DIAMETER)**2 + overlap**2)


class Walls(Scene):
    def test_nothing_before_touch(self):
        # A sphere that a run finds in the gap of rupture falls freely, with friction and all.
        end = self.follow([self.sphere((5e-3, 5e-3, DIAMETER / 2 + 0.5 * GAP), (0, 0, 0.01))],
                          ["* * " + words(0.0, 0.0)], T_C / 4, 40, style=STYLE,
                          fixes=[f"fix w all wall/{STYLE} " + words(friction=0.3) + " zplane 0 NULL"])
        self.assertEqual(end[0, 6], 0.01)


class Continued(Scene):
    """Captured couples, a bead on a wall, and a couple within h_r that never touched, at a time when all
    are in the gap: the bridges that are there go on, and no other begins."""

    def scene(self, mode, ranks=1, file="end.txt", scheme="exact"):
        speed = 0.8 * escape_velocity()
        atoms = [self.sphere((3e-3, 3e-3, 3e-3), (speed, 0, 0)),
                 self.sphere((3e-3 + DIAMETER + 1e-7, 3e-3, 3e-3)),
                 self.sphere((5.5e-3 - DIAMETER / 2 - 1e-7, 7e-3, 3e-3), (speed, 1e-2, 0), kind=3),
                 self.sphere((5.5e-3 + DIAMETER / 2, 7e-3, 3e-3), (0, 1e-2, 0)),
                 self.sphere((3e-3, 3e-3, 6e-3)),
                 self.sphere((3e-3 + DIAMETER + 0.3 * GAP, 3e-3, 6e-3), (1e-4, 0, 0)),
                 self.sphere((8e-3, 8e-3, DIAMETER / 2 + 1e-7), (0, 0, -speed))]
        # Steps: until the couples, of which the time up and down is 2 sqrt(2 mu h_r/F_b), are half-way.
        return self.follow(atoms if mode != "restart" else [], ["* * " + words()], T_C / 8, self.STEPS,
                           style=f"{STYLE} scheme {scheme}", boundary="p p f", mode=mode, file=file,
                           ranks=ranks, every=1,
                           fixes=[f"fix w all wall/{STYLE} " + words() + f" scheme {scheme} "
                                  "zplane 0 NULL"])

    STEPS = 40

    def test_runs_ranks_and_restart(self):
        for scheme in ("exact", "sampled"):
            whole = self.scene("restart_file", scheme=scheme)
            middle = self.course()[self.STEPS // 2]
            gap = numpy.linalg.norm(middle[0, 1:4] - middle[1, 1:4]) - DIAMETER
            # The bridges that are to go on are open.
            self.assertGreater(gap, 0.05 * GAP, scheme)
            self.assertLess(gap, 0.95 * GAP, scheme)
            self.assertGreater(middle[6, 3] - DIAMETER / 2, 0.05 * GAP)
            for mode, ranks in (("restart", 1), ("halves", 1), ("whole", 2), ("halves", 2)):
                other = self.scene(mode, ranks=ranks, scheme=scheme)
                # Roundings of 0.01 m in 40 steps of which some are in contact, w0 1e-18 m each.
                numpy.testing.assert_allclose(other[:, 1:4], whole[:, 1:4], rtol=0, atol=1e-14,
                                              err_msg=f"{scheme} {mode} {ranks}")
                numpy.testing.assert_allclose(other[:, 4:7], whole[:, 4:7], rtol=0, atol=1e-10)
            # The couple that never touched: as it was set off.
            numpy.testing.assert_array_equal(whole[4, 4:7], 0.0)
            numpy.testing.assert_array_equal(whole[5, 4:7], (1e-4, 0, 0))


class Liquids(Scene):
    """Bridges of a liquid; whether pairs stick with them: escape_test.py."""
    TENSION, ANGLE, VOLUME = 0.05, 0.6, 1e-13
    WORDS = f"stiffness {STIFFNESS} capillary {TENSION} {ANGLE} {VOLUME}"
    RADII = ((5e-4, 5e-4), (5e-4, 2.5e-4), (5e-4, math.inf))

    def bridge(self, radii):
        return Capillary(self.TENSION, self.ANGLE, self.VOLUME, *radii)

    def test_the_pull_is_the_published_curve(self):
        """Of equal and unequal spheres and a wall, so heavy that they are hardly slowed as their bridges open."""
        speed, dt, density = 0.02, 1e-5, 1e6
        atoms = []
        for n, (radius, other) in enumerate(self.RADII[:2]):
            x = 2e-3 + 3e-3 * n
            for r, place, v in ((radius, 3e-3, -speed / 2), (other, 3e-3 + radius + other - 1e-9, speed / 2)):
                atoms.append(self.sphere((x, 5e-3, place), (0, 0, v), diameter=2 * r, density=density))
        atoms.append(self.sphere((8e-3, 8e-3, 5e-4 - 1e-9), (0, 0, speed), density=density))
        mass = [density * math.pi / 6 * atom["diameter"]**3 for atom in atoms]
        for scheme in ("exact", "sampled"):
            self.follow(atoms, ["* * " + self.WORDS], dt, 330, style=f"{STYLE} scheme {scheme}", every=1,
                        boundary="p p f", fixes=[f"fix w all wall/{STYLE} {self.WORDS} scheme {scheme} zplane 0 NULL"])
            course = self.course()
            z, vz = course[:, :, 3], course[:, :, 6]
            for k, radii in enumerate(self.RADII):
                bridge, first = self.bridge(radii), 2 * k
                if k < 2:
                    gap = z[:, first + 1] - z[:, first] - sum(radii)
                    rate = vz[:, first + 1] - vz[:, first]
                    reduced = 1 / (1 / mass[first] + 1 / mass[first + 1])
                else:
                    gap, rate, reduced = z[:, first] - radii[0], vz[:, first], mass[first]
                # Velocities of the time levels change by the mean of two forces. What a force exact puts into a step
                # is the mean of the pull over two of them, F'' (v dt)^2/12 more, F'' below 7 F/L^2 (at touch).
                pull = numpy.array([bridge.force(g) for g in gap])
                inside = (gap[:-1] > 2 * speed * dt) & (gap[1:] < bridge.rupture - 2 * speed * dt)
                self.assertGreater(inside.sum(), 250)
                expected = 0.5 * (pull[:-1] + pull[1:])[inside]
                found = -reduced * numpy.diff(rate)[inside] / dt
                curved = 0.0 if scheme == "sampled" else 7 / 12 * (speed * dt)**2 / (bridge.volume / bridge.radius)
                # Velocities are rounded by 1e-18 m/s, places by 1e-18 m; exact puts these over the step.
                rounding = reduced * (4e-18 / dt + (0 if scheme == "sampled" else 4e-18 / dt**2))
                error = numpy.abs(found - expected)
                report(f"{scheme}, radii {radii}: pull off by {(error / expected).max():.1e} at most")
                self.assertTrue((error < curved * bridge.touch + rounding + 1e-9 * expected).all(), (scheme, radii))
                # Broken, nothing pulls any more.
                self.assertGreater(gap[-1], bridge.rupture)
                numpy.testing.assert_array_equal(rate[-1], rate[-3])

    def test_a_broken_bridge_takes_the_work_of_its_curve(self):
        bridge, speed = self.bridge(self.RADII[0]), 0.5
        for division in (4, 50):
            dt, atoms = T_C / division, []
            for k in range(20):
                atoms += couples.couple(k, 1e-6 + k * speed * dt / 20, (0.0, speed, 0.0))
            path, _ = couples.run(atoms, ["* * " + self.WORDS], dt, 10 * division, style=STYLE, skin=4e-4, every=1)
            out = relative(path[-1])[:, 4]
            numpy.testing.assert_allclose(out, math.sqrt(speed**2 - 2 * bridge.work(bridge.rupture) / MU), rtol=1e-9)

    def test_a_bridge_carries_the_pull_of_touch(self):
        """Spheres that hang from a plane by bridges, of 0.98 and 1.02 of the weight that one carries, at rest where
        spring, bridge and weight balance; the heavy one at touch."""
        bridge = self.bridge(self.RADII[2])
        g, factors = bridge.touch / MASS, (0.98, 1.02)
        atoms = [self.sphere((3e-3 + 3e-3 * n, 5e-3, 0.01 - DIAMETER / 2 + max(1 - f, 1e-9) * bridge.touch / STIFFNESS),
                             density=f * DENSITY) for n, f in enumerate(factors)]
        for scheme in ("exact", "sampled"):
            words = f"{self.WORDS} damping {DAMPING} scheme {scheme}"
            end = self.follow(atoms, ["* * " + self.WORDS], T_C / 20, 4000, style=f"{STYLE} scheme {scheme}",
                              boundary="p p f", fixes=[f"fix w all wall/{STYLE} {words} zplane NULL 0.01",
                                                       f"fix g all gravity {g:.17g} vector 0 0 -1"],
                              box=[(0, 0.01), (0, 0.01), (-0.05, 0.01)])
            gaps_then = 0.01 - DIAMETER / 2 - end[:, 3]
            self.assertLess(gaps_then[0], 0.0, scheme)
            self.assertGreater(gaps_then[1], bridge.rupture, scheme)

    def test_bridges_in_a_wrong_unit(self):
        """Spheres of R = 0.5 mm: V in m^3 is below 0.1 R^3 = 1.25e-11; 1e-3 is a volume in mm^3, and breaks at 0.1 m."""
        pair, wall = (f"pair_style {STYLE}\npair_coeff * * stiffness 800 ",
                      f"stiffness 800\nfix w all wall/{STYLE} stiffness 800 ")
        for text, where in ((pair + "{}", f"pair_style {STYLE}, types 1 and 1"),
                            (pair.replace("stiffness 800 ", "") + wall + "{} zplane 0 NULL", f"fix w wall/{STYLE}")):
            for law, expected in (
                    ("capillary 0.07 0 1e-3", ("h_r of the bridge = 0.1: must not be above 0.0005",
                                               "volume V of the bridge = 0.001, which should be below 1.25e-11")),
                    ("bridge 1e-4 0.1", ("h_r of the bridge = 0.1: must not be above 0.0005", "check its unit"))):
                with self.subTest(where, law=law):
                    code, output = engine.run_text(HEAD + text.format(law) + MOVE, self.folder)
                    assert_refused(self, code, output, where, *expected)
            for volume, warns in ((1.2e-11, 0), (1.3e-11, 1), (1.24e-10, 1)):
                with self.subTest(where, volume=volume):
                    code, output = engine.run_text(
                        HEAD + text.format(f"capillary 1e-6 0 {volume}") + MOVE + "\nrun 0", self.folder)
                    self.assertEqual(code, 0, output)
                    warnings = [l for l in output.splitlines() if "WARNING" in l and "of the cube of the radius" in l]
                    self.assertEqual(len(warnings), warns, output)

    def test_advice_has_the_escape_velocity(self):
        """Of a constant pull in contact, that loses the work of the curve."""
        words = f"{self.WORDS} damping {DAMPING:.17g}"
        code, output = engine.run_text(
            HEAD + f"pair_style {STYLE}\npair_coeff * * {words}\nfix w all wall/{STYLE} {words} zplane 0 NULL" + MOVE,
            self.folder)
        self.assertEqual(code, 0, output)
        for name, mass, radii in (("1 - 1", MU, self.RADII[0]), ("1 - wall", MASS, self.RADII[2])):
            bridge = self.bridge(radii)
            expected = escape_velocity(bridge.touch, bridge.work(bridge.rupture) / bridge.touch, mass)
            row = next(l for l in output.splitlines() if l.strip().startswith(name)).split()
            self.assertAlmostEqual(float(row[-2]) / expected, 1, delta=5e-3)  # printed

    def test_runs_ranks_and_restart(self):
        bridge = self.bridge(self.RADII[0])
        speed = 0.9 * math.sqrt(2 * bridge.work(bridge.rupture) / MU)
        atoms = [self.sphere((3e-3, 3e-3, 3e-3), (speed, 0, 0)),
                 self.sphere((3e-3 + DIAMETER + 1e-7, 3e-3, 3e-3))]

        def end(mode, ranks=1):
            self.follow(atoms if mode != "restart" else [], ["* * " + self.WORDS], T_C / 8, 40, style=STYLE,
                        boundary="p p f", mode=mode, ranks=ranks, every=1)
            return self.course()

        whole = end("restart_file")
        gap = whole[20, 1, 1] - whole[20, 0, 1] - DIAMETER
        self.assertTrue(0.05 * bridge.rupture < gap < 0.95 * bridge.rupture, gap)
        for mode, ranks in (("restart", 1), ("halves", 1), ("whole", 2)):
            # Roundings of 0.01 m in 40 steps, and these over a step.
            other = end(mode, ranks)
            numpy.testing.assert_allclose(other[-1, :, 1:4], whole[-1, :, 1:4], rtol=0, atol=1e-14)
            numpy.testing.assert_allclose(other[-1, :, 4:7], whole[-1, :, 4:7], rtol=0, atol=1e-10)


class Input(Scene):
    def test_wrong_words_and_values(self):
        style = f"pair_style {STYLE}\npair_coeff * * "
        wall = style + f"stiffness 800\nfix w all wall/{STYLE} "
        for text, expected in (
                (f"pair_style {STYLE} form exact", ("form", "valid ones: scheme")),
                (style + "stiffness 800 hamaker 1e-19", ("hamaker", "bridge")),
                (style + "stiffness 800 bridge 1e-4", ("needs 'bridge F_b h_r': h_r is missing",)),
                (wall + "stiffness 800 bridge 1e-4 zplane 0 NULL", ("fix w", "'zplane' stands in the place of h_r")),
                (style + "capillary 0.07 0.3 stiffness 800",
                 ("needs 'capillary gamma theta V': 'stiffness' stands in the place of V",)),
                (style + "stiffness 800 bridge -1e-4 1e-5", ("force F_b", "-0.0001")),
                (style + "stiffness 800 bridge 1e-4 0", ("rupture gap h_r", "greater than zero")),
                (style + "stiffness 800 bridge 1e-4 nan", ("nan",)),
                (style + "stiffness 800 capillary 0.07 30 1e-13", ("contact angle theta", "30", "radians")),
                (style + "stiffness 800 capillary 0.07 0 0", ("volume V", "greater than zero")),
                (style + "stiffness 800 bridge 1e-4 1e-5 capillary 0.07 0 1e-13", ("not both",)),
                (wall + "stiffness 800 bridge 1e-4 -1 zplane 0 NULL", ("fix w", "h_r")),
                (f"pair_style {STYLE}\npair_coeff 1 1 bridge 1e-4 1e-5", ("stiffness",))):
            with self.subTest(text):
                code, output = engine.run_text(HEAD + text + MOVE, self.folder)
                assert_refused(self, code, output, *expected)

    def test_advice_has_the_escape_velocity(self):
        code, output = engine.run_text(
            HEAD + f"pair_style {STYLE}\npair_coeff * * " + words() + f"\nfix w all wall/{STYLE} " +
            words() + " zplane 0 NULL" + MOVE, self.folder)
        self.assertEqual(code, 0, output)
        for name, mass in (("1 - 1", MU), ("1 - wall", MASS)):
            row = next(l for l in output.splitlines() if l.strip().startswith(name)).split()
            self.assertAlmostEqual(float(row[-2]) / escape_velocity(mass=mass), 1, delta=5e-3)  # printed

    def test_mixing(self):
        # Geometric means: a pair of unlike types as if it were given so.
        speed, ends = 0.5, []
        atoms = couples.couple(0, 1e-6, (0.0, speed, 0.0), types=(1, 2))
        for lines in ([f"{k} {k} {words(*law)}" for k, law in ((1, (1e-4, 2e-5)), (2, (4e-4, 8e-5)))],
                      [f"* * {words(2e-4, 4e-5)}"]):
            ends.append(couples.run(atoms, lines, T_C / 4, 60, types=2, style=STYLE, skin=4e-4)[0][-1])
        numpy.testing.assert_allclose(ends[0], ends[1], rtol=1e-12, atol=1e-18)


if __name__ == "__main__":
    unittest.main()
