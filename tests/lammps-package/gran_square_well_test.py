# SPDX-License-Identifier: BSD-3-Clause
"""pair_style gran/squarewell and fix wall/gran/squarewell in LAMMPS, against closed forms. With the
table of escape velocities of both schemes."""
import math
import unittest

import numpy

from cohesion_tests import csv_table
from cohesion_tests.lammps_scenes import cohesive_gas as gas, couples
from cohesion_tests.lammps_scenes.square_well_scene import (RESTITUTION, T_C, Scene, escape_velocity, gaps, relative,
                                                            report, well_speed, words)
from cohesion_tests.theory import pair_motion
from cohesion_tests.theory.pair_motion import DAMPING, DIAMETER, MASS, MU, STIFFNESS
from cohesion_tests.thermo import thermo_lines

POSITIONS = 8  # of the contact within the step
DEPTHS = (1e-11, 5e-11, 1e-10)


def have_parted(gaps_then, width):
    """Whether couples are out of the well, from their gaps in the second half of a run's snapshots. A
    place on the grid can be half a step beyond the edge where a captured pair turns round within the
    step, but not again and again."""
    late = gaps_then[len(gaps_then) // 2:]
    return (late > width + 1e-9).all(axis=0)


class HeadOn(unittest.TestCase):
    RATIO = 1.01
    WIDTH = (RATIO - 1) * DIAMETER

    def limits(self, scheme, division, factors):
        """For each depth the slowest factor of the escape velocity at which a couple parted, and the
        fastest at which one stayed, over all positions of the contact in the step."""
        dt = T_C / division
        atoms = []
        for k, depth in enumerate(DEPTHS):
            for factor in factors:
                for position in range(POSITIONS):
                    speed = factor * escape_velocity(depth)
                    atoms += couples.couple(len(atoms) // 2,
                                            self.WIDTH + 1e-7 + speed * dt * position / POSITIONS,
                                            (0.0, speed, 0.0), types=(k + 1, k + 1))
        coefficients = [f"{k} {k} {words(depth, self.RATIO)}" for k, depth in enumerate(DEPTHS, 1)]
        # In and out of the well takes below 40 t_c, on the way to it 0.3 ms.
        path = couples.run(atoms, coefficients, dt, 200 * division, types=len(DEPTHS), skin=4e-4,
                           every=20 * division, style="gran/squarewell scheme " + scheme)[0]
        parted = have_parted(gaps(path), self.WIDTH)
        parted = parted.reshape(len(DEPTHS), len(factors), POSITIONS)
        factors = numpy.array(factors)
        return [(factors[p.any(axis=1)].min(), factors[~p.all(axis=1)].max()) for p in parted]

    def test_sampled_scheme_converges_to_the_same(self):
        # The impulses of a head-on passage are right at any place; what errs is the sampled contact,
        # whose energy leapfrog gets wrong by what depends on the position of the contact in the step.
        fine = [0.5 + 0.05 * k for k in range(9)] + [0.95 + 0.005 * k for k in range(21)]
        factors = [0.1, 0.2, 0.3, 0.4] + fine + [1.05 + 0.05 * k for k in range(1, 30)]
        errors = []
        for division in (4, 10, 46, 185):
            limits = self.limits("sampled", division, factors)
            for depth, (low, high) in zip(DEPTHS, limits):
                report(f"sampled, t_c/{division}, D {depth:g} J: slowest parted {low:.3f}, fastest "
                       f"captured {high:.3f}")
                for name, factor in (("slowest escape", low), ("fastest capture", high)):
                    csv_table.enter(csv_table.of_test("contacts"), {
                        "measurement": "square well", "case": f"sampled, D {depth:g} J", "step": f"t_c/{division}",
                        "quantity": f"{name} over the escape velocity"}, value=f"{factor:.3f}")
            errors.append(numpy.abs(numpy.array(limits) - 1).max())
        # First order, and the grading.
        self.assertLess(errors[3], errors[1] / 18.5 * 2 + 0.005)
        self.assertGreater(errors[0], 0.1)  # is why there is another scheme

    def test_sampled_pairs_pay_for_every_escape(self):
        # Both spheres as fast as any: found up to a whole step of both beyond the edge.
        speed, dt, atoms = 0.1, 2e-6, []
        for k in range(16):
            atoms += couples.couple(k, 5e-6 + speed * dt * k / 16, (0.0, -speed, 0.0))
        path = couples.run(atoms, ["* * " + words(5e-11, self.RATIO)], dt, 100,
                           style="gran/squarewell scheme sampled")[0]
        energies = 0.5 * MU * (relative(path[-1])[:, 3:6]**2).sum(axis=1)
        # A hundred roundings of places, of which the direction is made, and of speeds.
        expected = 0.5 * MU * speed**2 - 5e-11
        self.assertLess(numpy.abs(energies - expected).max(), 1e-12 * expected)

    def test_equal_escape_velocity_as_hamaker(self):
        # D = mu v_esc^2/(2 (1/e^2 - 1)), the pair of A = 7.49e-19 J by its own integration: what
        # src/advice/equal_escape.h states.
        escape = pair_motion.Pair(7.49e-19).escape_velocity()
        depth = MU * escape**2 / (2 * (1 / RESTITUTION**2 - 1))
        atoms = []
        for factor in (1 - 1e-5, 1 + 1e-5):
            atoms += couples.couple(len(atoms) // 2, self.WIDTH + 1e-7, (0, factor * escape, 0))
        for style, line in (("gran/squarewell", words(depth, self.RATIO)),
                            ("gran/hamaker", pair_motion.Pair(7.49e-19).words())):
            path = couples.run(atoms, ["* * " + line], T_C / 4, 1600, style=style, skin=4e-4,
                               every=80)[0]
            # The pair of gran/hamaker is free beyond H_cut, and then slow.
            width = self.WIDTH if style == "gran/squarewell" else pair_motion.CUT
            self.assertEqual(list(have_parted(gaps(path), width)), [False, True], style)
        report(f"A 7.49e-19 J and D {depth:.4g} J share the escape velocity {escape:.4g} m/s")


class Passes(unittest.TestCase):
    def test_passes_without_contact_are_refracted(self):
        # Unlike spheres, each type with its own ratio: the edge is where the wells' radii add up. A
        # pass at impact parameter s turns by 2 (asin(s/edge) - asin(s/(n edge))), n^2 = 1 + 2 D/(mu
        # v^2), D the geometric mean.
        diameters, densities, ratios = (1e-3, 0.6e-3), (2650.0, 5300.0), (1.5, 1.2)
        edge = 0.5 * (ratios[0] * diameters[0] + ratios[1] * diameters[1])
        masses = [math.pi / 6 * density * d**3 for d, density in zip(diameters, densities)]
        mass = masses[0] * masses[1] / sum(masses)
        depth, speed = 4e-11, 0.05
        n = math.sqrt(1 + 2 * depth / mass / speed**2)
        closest = 0.5 * sum(diameters)
        offsets = [n * closest + share * (edge - n * closest)
                   for share in (0.01, 0.3, 0.7, 0.99, 1 - 1e-6)] + [edge * (1 + 1e-9)]
        atoms = []
        for offset in offsets:
            along = math.sqrt(max(edge**2 - offset**2, 0.0)) + 1e-5
            distance = math.hypot(offset, along)
            atoms += couples.couple(len(atoms) // 2, distance - closest, (0.0, speed, 0.0),
                                    normal=(offset / distance, along / distance, 0.0), pitch=(4e-3, 6e-3),
                                    types=(1, 2), diameters=diameters, densities=densities)
        coefficients = [f"{k} {k} {words(d, ratio)}" for k, d, ratio in
                        ((1, 1e-11, ratios[0]), (2, 16e-11, ratios[1]))]
        for dt in (T_C / 20, T_C / 4):
            path, output = couples.run(atoms, coefficients, dt, int(2.2 * edge / speed / dt), types=2,
                                       style="gran/squarewell", skin=1e-3, size=(0.03, 0.01, 0.004),
                                       every=1 if dt == T_C / 4 else 0)
            out = relative(path[-1])[:, 3:5]
            turned = numpy.arctan2(-out[:, 0], -out[:, 1])
            for offset, angle, velocity in zip(offsets, turned, out):
                expected = 0.0
                slope = 1.0
                if offset < edge:
                    expected = 2 * (math.asin(offset / edge) - math.asin(offset / n / edge))
                    slope = 2 / math.sqrt(1 - (offset / edge)**2)
                # Positions in the box are rounded by 2e-18 m four times a step, at random.
                bound = 5 * math.sqrt(4 * 2.2 * edge / speed / dt) * 2e-18 / edge * slope
                # Between grid points the line of centres turns as on a straight flight: each of the
                # two impulses puts the distance up to a quarter of it times dt off.
                bound += 0.5 * speed * offset / edge**3 * math.sqrt(2 * depth / mass) * dt**2
                self.assertLess(abs(angle - expected), bound)
                # Impulses lead from place to place: the same rounding, over dt, in some ten steps.
                self.assertAlmostEqual(numpy.linalg.norm(velocity) / speed, 1,
                                       delta=10 * 2e-18 / dt / speed)
        names, lines = thermo_lines(output)
        table = dict(zip(names, numpy.array(lines).T))
        # Nothing but depths of pairs: all five are in the well at some time, and all have left.
        steps_of = numpy.round(table["PotEng"] / -depth)
        numpy.testing.assert_allclose(table["PotEng"], -depth * steps_of, rtol=0, atol=1e-25)
        self.assertEqual((steps_of.max(), steps_of[-1]), (5, 0))
        energy = 0.5 * mass * speed**2 * len(offsets)
        report(f"passes: energy tally {numpy.abs(table['c_tally[10]']).max() / energy:.1e} of all")
        # Two events of each couple, some twenty roundings each, of the pair's motion and of what leads to the true one.
        self.assertLess(numpy.abs(table["c_tally[10]"]).max(), 2 * 5 * 20 * 2.0**-53 * 2 * energy)

    def test_energy_tally_closes_in_contact(self):
        # Head-on, so that nothing turns: see gran_hamaker_couple_test.py for the roundings.
        depth, speed, dt = 5e-11, 0.02, T_C / 4
        atoms = []
        for k in range(20):
            atoms += couples.couple(k, 1e-5 + 1e-7 + k * speed * dt / 20, (0.0, speed, 0.0))
        path, output = couples.run(atoms, ["* * " + words(depth, 1.01)], dt, 100, every=1,
                                   style="gran/squarewell", skin=4e-4)
        names, lines = thermo_lines(output)
        table = dict(zip(names, numpy.array(lines).T))
        energy = table["c_tally[1]"][0]
        report(f"tally, head-on: {numpy.abs(table['c_tally[10]']).max() / energy:.1e} of all")
        self.assertGreater(table["c_tally[6]"][-1], 1e-2 * energy)
        self.assertLess(numpy.abs(table["c_tally[10]"]).max(),
                        math.sqrt(20 * 100) * 3e-17 * 3e-2 + 100 * 2.0**-53 * energy)
        out = relative(path[-1])[:, 4]
        inside = RESTITUTION**2 * (speed**2 + well_speed(depth)**2)
        # The gap is rounded by 3e-17 m, in contact that is w0 3e-17 m = 1e-12 m/s.
        numpy.testing.assert_allclose(out, math.sqrt(inside - well_speed(depth)**2), rtol=1e-9)


class Captured(Scene):
    def test_pairs_captured_under_gravity_stay(self):
        # 3e4 steps: a sphere that hangs in the well of one that is held, as wide as 0.001 d
        # (m g w = 1.4e-11 J < D), elastic; the same on top of it; one at its side; a pair on a floor.
        depth, ratio = 1e-10, 1.001
        atoms = []
        for k, (direction, gap) in enumerate((((0, 0, -1), 5e-7), ((0, 0, 1), 5e-7))):
            x = numpy.array([2e-3 + 3e-3 * k, 2e-3, 5e-3])
            atoms += [self.sphere(x, kind=2),
                      self.sphere(x + (DIAMETER + gap) * numpy.array(direction))]
        floor = numpy.array([2e-3, 6e-3, 0.5e-3])
        atoms += [self.sphere(floor), self.sphere(floor + (1.0005 * DIAMETER, 0, 0))]
        self.follow(atoms, ["* * " + words(depth, ratio, 0.0)], T_C / 4, 30000, every=300,
                    fixes=["fix floor all wall/gran/squarewell stiffness 800 damping 0 zplane 0 NULL",
                           "fix g moving gravity 9.81 vector 0 0 -1"])
        course = self.course()
        pairs = course[:, :, 1:4].reshape(len(course), 3, 2, 3)
        distance = numpy.linalg.norm(pairs[:, :, 1] - pairs[:, :, 0], axis=2)
        # Gravity acts on the grid: within a step it moves a particle by g dt^2/2 = 3e-9 m more than
        # the pair knows of, and by the flight of half a step at the speed of the well.
        slack = 9.81 * (T_C / 4)**2 + 0.5 * T_C / 4 * 2e-2
        self.assertLess(distance.max(), ratio * DIAMETER + slack)
        # Never more energy than at the start: falls of less than the well's width, and D.
        energy = 0.5 * MASS * (course[:, :, 4:7]**2).sum(axis=2) + MASS * 9.81 * course[:, :, 3]
        gain = (energy - energy[0]).max() / depth
        lost = (energy[0] - energy[-1]) / depth
        report(f"captured under gravity, 3e4 steps: most energy gained {gain:.3f} D; lost below, on top, "
               f"floor: {lost[1]:.3f}, {lost[3]:.3f}, {lost[4]:.3f} D")
        self.assertLess(gain, 0.1)

    def test_three_mutually_captured(self):
        # In a triangle; wide wells of D each, elastic, no gravity: the energy stays, and with it all
        # three. What the frame errs by with several contacts is measured here.
        depth, ratio, dt = 1e-10, 1.2, T_C / 10
        side = 1.1 * DIAMETER
        x = numpy.array([[0, 0, 0], [side, 0, 0], [0.5 * side, math.sqrt(0.75) * side, 0]]) + 5e-3
        v = 0.3 * well_speed(depth) * numpy.array([[1, 0.2, 0.1], [-0.8, 0.5, 0.0],
                                                   [-0.2, -0.7, -0.1]])
        self.follow([self.sphere(a, b) for a, b in zip(x, v)], ["* * " + words(depth, ratio, 0.0)],
                    dt, 30000, every=300, boundary="p p p")
        table, _ = gas.table(self.output)
        drift = numpy.abs(table[:, 12]).max() / table[0, 3]
        report(f"three captured, 3e4 steps at t_c/10: energy within {drift:.1e} of the kinetic")
        course = self.course()
        for a, b in ((0, 1), (1, 2), (0, 2)):
            d = course[:, a, 1:4] - course[:, b, 1:4]
            d -= 0.01 * numpy.round(d / 0.01)
            self.assertLess(numpy.linalg.norm(d, axis=1).max(), ratio * DIAMETER + 1e-6)


class Walls(Scene):
    def test_sampled_wall(self):
        # The velocity that the dashpot sees is half a step old: up to w0 dt/2 = 0.9 % of what it
        # takes, and that is what decides. Leapfrog's own error of (w0 dt)^2/8 of the energy is
        # 1/(1 - e^2) = 14 times more of it: 0.05 %. Half of that in speed; graded by 5 %.
        depth, ratio = 1e-10, 1.02
        alpha = DAMPING / (2 * MASS)
        q = math.sqrt(STIFFNESS / MASS - alpha**2)
        escape = escape_velocity(depth, MASS, math.exp(-math.pi * alpha / q))
        width, dt = (ratio - 1) * DIAMETER / 2, math.pi / q / 185
        atoms = [self.sphere((2e-3 * (k + 1), 2e-3 * (position + 1), DIAMETER / 2 + width + 1e-7
                              + factor * escape * dt * position / POSITIONS),
                             (0.0, 0.0, -factor * escape))
                 for k, factor in enumerate((0.95, 1.05)) for position in range(POSITIONS)]
        contact = words(depth, ratio)
        self.follow(atoms, ["* * " + words(0.0, 1.0)], dt, 40000, box=3 * [(0.0, 0.02)], every=2001,
                    fixes=[f"fix w all wall/gran/squarewell scheme sampled {contact} zplane 0 NULL"])
        parted = have_parted(self.course()[:, :, 3] - DIAMETER / 2, width).reshape(2, POSITIONS)
        self.assertFalse(parted[0].any())
        self.assertTrue(parted[1].all())

    def test_elastic_sphere_captured_in_a_corner(self):
        # Three walls, D each: captured by all, motion along each axis is its own: |v| at the grid
        # points outside contact and turns is the same after 3e4 steps.
        depth, ratio, dt = 1e-10, 1.05, T_C / 4
        v = 0.7 * well_speed(depth, MASS) * numpy.array([1.0, -0.83, 0.71])
        atoms = [self.sphere(DIAMETER / 2 * numpy.array([1.02, 1.03, 1.01]), v)]
        self.follow(atoms, ["* * " + words(0.0, 1.0)], dt, 30000, every=30,
                    fixes=["fix w all wall/gran/squarewell " + words(depth, ratio, 0.0) +
                           " xplane 0 NULL yplane 0 NULL zplane 0 NULL"])
        course = self.course()[:, 0]
        inside = (course[:, 1:4] > 0.5 * DIAMETER + 1e-6).all(axis=1)
        inside &= (course[:, 1:4] < 0.5 * ratio * DIAMETER - 1e-6).all(axis=1)
        self.assertGreater(inside.sum(), 200)
        self.assertLess(course[:, 1:4].max(), 0.5 * ratio * DIAMETER + 1e-6)
        error = numpy.abs(numpy.abs(course[inside, 4:7]) / numpy.abs(v) - 1).max()
        report(f"corner, 3e4 steps: speeds along the axes change by {error:.1e}")
        # Where two walls act in one step, half of the way that one moves the sphere by, below dt times
        # the change of speed 2 v, tilts the other's normal by that over R: 2 v dt/R of the speed, in
        # one of ten of the 600 turns, at random.
        self.assertLess(error, 5 * math.sqrt(60) * 2 * v[0] * dt / (DIAMETER / 2))

    def test_own_depth_or_none(self):
        # Without `well` the wall only repels.
        speed = 5e-3
        end = self.follow([self.sphere((5e-3, 5e-3, 0.51e-3), (0, 0, -speed))],
                          ["* * " + words(1e-10, 1.05)], T_C / 4, 400,
                          fixes=["fix w all wall/gran/squarewell stiffness 800 restitution 1 "
                                 "zplane 0 NULL"])
        self.assertAlmostEqual(end[0, 6] / speed, 1, delta=1e-9)


if __name__ == "__main__":
    unittest.main()
