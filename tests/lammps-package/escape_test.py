# SPDX-License-Identifier: BSD-3-Clause
"""Who stays and who parts, scheme exact in LAMMPS: pairs, planes and cylinders of both laws, three strengths, head-on
to 80 degrees, at any step and any position of the contact in it; against an integration that knows nothing of the
package. The same for LIGGGHTS: tests/liggghts-styles/head_on_test.py.

A wall whose spring, dashpot and attraction are twice those of two spheres moves a sphere, of twice the reduced mass,
exactly as a pair: one number for both."""
import math
import unittest

import numpy

from cohesion_tests.lammps_scenes import couples
from cohesion_tests.lammps_scenes.square_well_scene import T_C, Scene, gaps, report
from cohesion_tests.theory import oblique_escape
from cohesion_tests.theory.pair_motion import (ALPHA, CONTACT_TIME, CUT, DAMPING, DIAMETER, MU, OUT, STIFFNESS,
                                                Pair)

POSITIONS = 8  # of the contact within the step
DIVISIONS = (4, 8, 16, 50)
GRADE = 1e-3
FACTORS = (0.99, 1 - GRADE, 1 + GRADE, 1.01)
RADIUS, CYLINDER = DIAMETER / 2, 0.02
LENGTH = 200  # of a run in contact times: the slowest leaves with e sqrt(2e-3) of the escape velocity


class Hamaker:
    STYLE = "gran/hamaker"
    STRENGTHS = (1e-19, 7.49e-19, 2e-18)
    START = 1.001 * OUT  # gap at which a flight ends
    WALL_START = START

    def words(self, strength):
        return Pair(strength).words()

    def wall_words(self, strength):
        # Attracted by a plane, a sphere is attracted twice as much as by another.
        return (f"stiffness {2 * STIFFNESS:.17g} damping {2 * DAMPING:.17g} hamaker {strength:.17g} "
                f"cutoff {CUT} {OUT}")

    def escape_velocity(self, strength, angle):
        return oblique_escape.of_hamaker(Pair(strength), angle, self.START)


class SquareWell:
    STYLE = "gran/square_well"
    STRENGTHS = (1e-11, 5e-11, 1e-10)
    RATIO = 1.01
    WIDTH = (RATIO - 1) * DIAMETER
    START = 1.001 * WIDTH
    WALL_START = START / 2

    def words(self, strength, share=1):
        return (f"stiffness {share * STIFFNESS:.17g} damping {share * DAMPING:.17g} "
                f"well {share * strength:.17g} {self.RATIO}")

    def wall_words(self, strength):
        return self.words(strength, 2)

    def escape_velocity(self, strength, angle):
        return oblique_escape.of_well(strength, self.WIDTH, angle, self.START)


LAWS = (Hamaker(), SquareWell())


class Escape(Scene):
    def judge(self, parted, law, strengths, what):
        """parted: (strength, factor, position)."""
        for strength, answers in zip(strengths, parted):
            low = min((f for f, out in zip(FACTORS, answers) if out.any()), default=math.inf)
            high = max((f for f, out in zip(FACTORS, answers) if not out.all()), default=0.0)
            report(f"{law.STYLE}, {strength:g} J, {what}: slowest parted {low}, fastest captured {high}")
            self.assertEqual((low, high), (1 + GRADE, 1 - GRADE), (law.STYLE, strength, what))

    def test_yardstick_head_on(self):
        # Where there are other ways to know it; both to 1e-9 by their own tolerances.
        e = math.exp(-ALPHA * CONTACT_TIME)
        for strength in SquareWell.STRENGTHS:
            known = math.sqrt(2 * strength / MU * (1 / e**2 - 1))
            found = oblique_escape.of_well(strength, SquareWell.WIDTH, 0.0, SquareWell.START)
            self.assertAlmostEqual(found / known, 1, delta=1e-8)
        for strength in Hamaker.STRENGTHS:
            known = Pair(strength).escape_velocity()
            found = oblique_escape.of_hamaker(Pair(strength), 0.0, Hamaker.START)
            self.assertAlmostEqual(found / known, 1, delta=1e-8)

    def test_pairs(self):
        # Against the way through the tail, on which the turning helps. What steps leave out is below 1e-5: the
        # centrifugal force is that of touching centres (gran_hamaker_couple_test.py), a step turns as on a straight
        # flight (gran_square_well_test.py).
        angles = (0, 20, 40, 60, 80)
        for law in LAWS:
            escape = [[law.escape_velocity(strength, math.radians(angle)) for angle in angles]
                      for strength in law.STRENGTHS]
            coefficients = [f"{k} {k} {law.words(strength)}" for k, strength in enumerate(law.STRENGTHS, 1)]
            for division in DIVISIONS:
                atoms, dt = [], T_C / division
                for kind, speeds in enumerate(escape, 1):
                    for angle, speed in zip(angles, speeds):
                        across = math.tan(math.radians(angle))
                        for factor in FACTORS:
                            for position in range(POSITIONS):
                                velocity = factor * speed * numpy.array([across, 1.0, 0.0])
                                away = numpy.array([0.0, DIAMETER + law.START, 0.0])
                                away += velocity * dt * position / POSITIONS
                                distance = numpy.linalg.norm(away)
                                atoms += couples.couple(len(atoms) // 2, distance - DIAMETER, velocity,
                                                        normal=away / distance, types=(kind, kind))
                end = couples.run(atoms, coefficients, dt, LENGTH * division, style=law.STYLE,
                                  types=len(law.STRENGTHS), skin=4e-4)[0][-1]
                parted = (gaps(end) > law.START).reshape(len(law.STRENGTHS), len(angles), len(FACTORS), POSITIONS)
                for k, angle in enumerate(angles):
                    self.judge(parted[:, k], law, law.STRENGTHS, f"pairs, {angle} degrees, t_c/{division}")

    def test_walls(self):
        # Without friction nothing acts across the normal of a wall, nor along a cylinder.
        angles = (0, 40, 80)
        for law in LAWS:
            for strength in law.STRENGTHS:
                speed = law.escape_velocity(strength, 0.0)
                for division in DIVISIONS:
                    for wall in ("zplane 0 NULL", f"zcylinder {CYLINDER}"):
                        gaps_left = self.from_a_wall(law, strength, speed, T_C / division, angles, wall)
                        parted = (gaps_left > law.WALL_START).reshape(len(angles), len(FACTORS), POSITIONS)
                        for angle, answers in zip(angles, parted):
                            self.judge([answers], law, [strength],
                                       f"{wall.split()[0]}, {angle} degrees, t_c/{division}")

    def from_a_wall(self, law, strength, speed, dt, angles, wall):
        """Gaps at the end of spheres that meet it, for (angle, factor, position)."""
        atoms = []
        for angle in angles:
            for factor in FACTORS:
                for position in range(POSITIONS):
                    inwards = factor * speed
                    across = inwards * math.tan(math.radians(angle))
                    gap = law.WALL_START + inwards * dt * position / POSITIONS
                    n = len(atoms)
                    if wall.startswith("zplane"):
                        atoms.append(self.sphere((-0.015 + 3e-3 * (n % 11), -0.015 + 3e-3 * (n // 11), RADIUS + gap),
                                                 (across, 0.0, -inwards)))
                    else:
                        turn, away = 2 * math.pi * (n % 11) / 11, CYLINDER - RADIUS - gap
                        out = numpy.array([math.cos(turn), math.sin(turn), 0.0])
                        atoms.append(self.sphere(away * out + [0.0, 0.0, 2e-3 * (1 + n // 11)],
                                                 inwards * out + [0.0, 0.0, across]))
        steps = LENGTH * round(T_C / dt)
        end = self.follow(atoms, ["* * " + law.words(strength)], dt, steps, style=law.STYLE,
                          box=[(-0.025, 0.025), (-0.025, 0.025), (0.0, 0.03)],
                          fixes=[f"fix w all wall/{law.STYLE} {law.wall_words(strength)} {wall}"])
        away = end[:, 3] if wall.startswith("zplane") else CYLINDER - numpy.hypot(end[:, 1], end[:, 2])
        return away - RADIUS


if __name__ == "__main__":
    unittest.main()
