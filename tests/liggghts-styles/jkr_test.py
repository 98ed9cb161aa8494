# SPDX-License-Identifier: BSD-3-Clause
"""cohesion jkr: sticking speed of pairs and at walls, strength, friction of the neck's radius of contact and energy,
against an integration that knows nothing of the engine."""
import math
import sys
import unittest

from scipy.optimize import brentq

from cohesion_tests.liggghts import Run, assert_refused
from cohesion_tests.liggghts_scenes import pull_off
from cohesion_tests.liggghts_scenes.impacts import DIAMETER, WALLS, contacts, left_after_sticking, limits
from cohesion_tests.liggghts_scenes.scene import contact, frames, part, script, sphere, surface_energy
from cohesion_tests.theory.hertz_contact import HertzPair
from cohesion_tests.theory.jkr_contact import JkrPair

GAMMA = 0.05
MODELS = "model hertz tangential off cohesion jkr"
KEYWORDS = "tangential_damping off"


def report(text):
    print(text, file=sys.stderr)


class Jkr(unittest.TestCase):
    def test_sticking(self):
        # Within 1e-3 of the sticking speed at t_c/20, and 2e-3 at t_c/10 for a restitution above 0.7.
        for restitution, division, grade in ((0.5, 20, 1e-3), (0.9, 20, 1e-3), (0.9, 10, 2e-3)):
            for name, wall in WALLS.items():
                pair = JkrPair(5e6, GAMMA, restitution, DIAMETER, poisson=0.3, plane=bool(wall))
                dt = pair.contact_time(pair.sticking_speed()) / division
                for degrees in (0, 80) if wall else (0, 40, 80):
                    speed = pair.sticking_speed(math.radians(degrees))
                    slowest, fastest = limits(MODELS, KEYWORDS, surface_energy(GAMMA), restitution, speed, degrees, grade,
                                              dt, 30 * division, 0.0, 2 * pair.tearing, 1.5 * pair.tearing, wall)
                    report(f"e {restitution}, t_c/{division}, {name}, {degrees} degrees: slowest parted {slowest}, fastest "
                           f"captured {fastest}")
                    self.assertEqual((slowest, fastest), (1 + grade, 1 - grade))

    def test_a_softer_modulus_sticks_as_the_material_does(self):
        # The scaling is exact head-on; the grade is that of the step, as above.
        grade, division, times = 1e-3, 20, 1e3
        keywords = f"{KEYWORDS} material_modulus on"
        properties = surface_energy(GAMMA) + (
            f"fix Em all property/global materialYoungsModulus peratomtype {times * 5e6} {times * 5e6}\n")
        for name in ("pair", "plane", "2 triangles"):
            wall = WALLS[name]
            real = JkrPair(times * 5e6, GAMMA, 0.9, DIAMETER, poisson=0.3, plane=bool(wall))
            soft = JkrPair(5e6, GAMMA * times**-0.4, 0.9, DIAMETER, poisson=0.3, plane=bool(wall))
            speed = real.sticking_speed()
            self.assertGreater(JkrPair(5e6, GAMMA, 0.9, DIAMETER, poisson=0.3, plane=bool(wall)).sticking_speed(), 3 * speed)
            slowest, fastest = limits(MODELS, keywords, properties, 0.9, speed, 0, grade, soft.contact_time(speed) / division,
                                      30 * division, 0.0, 2 * soft.tearing, 1.5 * soft.tearing, wall)
            report(f"E over the material's 1e-3, {name}: slowest parted {slowest}, captured {fastest}")
            self.assertEqual((slowest, fastest), (1 + grade, 1 - grade))

    def test_strength(self):
        # 1.5 pi w R; by the lag of the ramp up to 0.3 %.
        for partner in pull_off.PARTNERS:
            for division in (10, 20):
                found = pull_off.JkrGrain(5e6, 0.005, 0.9, partner=partner).load_at_parting(division)
                report(f"{partner}, t_c/{division}: {found:.4f} of the pull-off force")
                self.assertAlmostEqual(found, 1.0, delta=5e-3)

    def test_tangential_spring_has_the_radius_of_contact(self):
        # Where nothing acts along the normal, F_t = 8 G* a s, G* = E/(4 (2 - nu) (1 + nu)). The tangential
        # spring slows the slip down by a part of (omega_t t)^2/2, below 5e-4 until the second frame.
        pair = JkrPair(5e6, GAMMA, 0.9, DIAMETER, poisson=0.3)
        wide = brentq(pair.force, 1.01 * pair.smallest, 100 * pair.smallest)
        overlap, speed = pair.overlap(wide), 1e-5
        dt = pair.contact_time(pair.sticking_speed()) / 5000
        two = [sphere((0, 0, 0)), sphere((DIAMETER - overlap, 0, 0), (0, speed, 0))]
        first, second = frames(two, "model hertz tangential history cohesion jkr tangential_damping off",
                               surface_energy(GAMMA), dt=dt, steps=20, every=10)[1:]
        shear = 5e6 / (4 * (2 - 0.3) * (1 + 0.3))
        found = (part(first[2], "f")[1] - part(second[2], "f")[1]) / (8 * shear * speed * 10 * dt)
        report(f"radius of contact {found:.6g}, JKR's {wide:.6g}, Hertz's {math.sqrt(DIAMETER / 4 * overlap):.6g} m")
        self.assertAlmostEqual(found, wide, delta=1e-3 * wide)

    def test_a_grain_that_touches_exactly_makes_contact(self):
        # Without weight it is pressed in until its force is 0, and comes to rest there: with a restitution of 0.5 a swing
        # loses half of its speed in a contact time, and little is left after 60 of them.
        pair = JkrPair(5e6, GAMMA, 0.5, DIAMETER, poisson=0.3, plane=True)
        at_rest = pair.overlap(brentq(pair.force, 1.01 * pair.smallest, 100 * pair.smallest))
        dt = pair.contact_time(pair.sticking_speed()) / 20
        for tangential in ("off", "history"):
            models = f"model hertz tangential {tangential} cohesion jkr"
            text = script([sphere((0, 0, DIAMETER / 2))], models, surface_energy(GAMMA), dt=dt, steps=1200, every=1200,
                          contacts=contacts(0.5), walls=[f"fix floor all wall/gran {models} primitive type 1 zplane 0.0"])
            end = Run(text).frames("out.txt")[-1]
            self.assertAlmostEqual(DIAMETER / 2 - end[1][2], at_rest, delta=1e-3 * at_rest)

    def test_sticking_gives_no_energy(self):
        time = HertzPair(5e6, 1 - 1e-12, DIAMETER, poisson=0.3).contact_time(0.1)
        for degrees in (20, 45, 70, 85):
            left = left_after_sticking("model hertz tangential history cohesion jkr", KEYWORDS, surface_energy(GAMMA),
                                       degrees, time)
            report(f"{degrees} degrees: {left - 1:.2e}")
            self.assertLess(left, 1 + 1e-3)

    def test_without_surface_energy_it_is_hertz(self):
        # Two grains fall past each other at a distance of one diameter: they touch at an overlap of rounding.
        spheres = [sphere((x, 7e-4, z), radius=0.5e-3, density=2500.0) for x, z in ((3.3e-3, 1e-3), (2.3e-3, 3e-3))]
        models = "model hertz tangential history cohesion jkr"
        properties = contact().replace("0.3 0.3", "0.25 0.25").replace("0.9", "0.7").replace("0.3 ", "0.5 ")
        rows = frames(spheres, models, surface_energy(0.0), contacts=properties, dt=1e-5, steps=4000, every=400, skin=5e-4,
                      walls=["primitive type 2 zplane 0"], extra="fix weight all gravity 9.81 vector 0 0 -1\n")
        for frame in rows:
            for number in (1, 2):
                self.assertTrue(all(math.isfinite(value) for value in frame[number]))
                self.assertLess(math.hypot(*part(frame[number], "v")), 0.3)

    def test_what_stops_a_run(self):
        two = [sphere((0, 0, 0)), sphere((DIAMETER, 0, 0))]
        for models, energy, message in (
                ("model hooke/stiffness tangential off cohesion jkr", GAMMA, "needs 'model hertz'"),
                ("model hertz/stiffness tangential off cohesion jkr", GAMMA, "needs 'model hertz'"),
                (MODELS + " scheme sampled", GAMMA, "has no scheme sampled"),
                (MODELS + " limitForce on", GAMMA, "limitForce"),
                (MODELS, -1.0, "surface energy gamma"),
                (MODELS, 1e3, "gamma = 1000 J/m2 is above that of any material")):
            with self.subTest(models=models, energy=energy):
                assert_refused(self, Run(script(two, models, surface_energy(energy), dt=1e-8)), message)


if __name__ == "__main__":
    unittest.main()
