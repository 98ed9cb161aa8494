# SPDX-License-Identifier: BSD-3-Clause
"""`normal hertz E nu`: restitution, capture and strength of Hertz contacts with a Hamaker attraction, against an
integration that knows nothing of the package."""
import math
import re
import sys
import unittest

import numpy

from cohesion_tests import lammps
from cohesion_tests.lammps_scenes import couples, pull_off
from cohesion_tests.lammps_scenes.oblique_pairs import PHASES, limits
from cohesion_tests.lammps_scenes.one_sphere import HEAD, MOVE
from cohesion_tests.lammps_scenes.small_box import box, spheres
from cohesion_tests.test_cases import ScriptTestCase
from cohesion_tests.theory.hertz_contact import OUT, HertzPair
from cohesion_tests.theory.slow_ramp import HertzGrain

DIAMETER, DENSITY, MODULUS, HAMAKER = 1e-3, 2650.0, 5e6, 7.49e-19
START = 1.001 * OUT


def report(text):
    print(text, file=sys.stderr)


class Hertz(unittest.TestCase):
    def test_restitution(self):
        # The discrete orbit is of second order in the step, and loses a part of what the dashpot takes: at t_c/20 2e-4
        # for e 0.5 and 1e-5 for e 0.9, at t_c/10 four times that (IntegratedContact.RestitutionIsTheSameAtEverySpeed).
        for restitution, division, within in ((0.5, 20, 1e-3), (0.9, 20, 1e-4), (0.9, 10, 1e-3)):
            for speed in (1e-3, 0.1):
                pair = HertzPair(MODULUS, restitution, DIAMETER)
                dt = pair.contact_time(speed) / division
                atoms = []
                for phase in range(PHASES):
                    atoms += couples.couple(len(atoms) // 2, 1e-5 * DIAMETER + speed * dt * phase / PHASES,
                                            (0.0, speed, 0.0))
                steps = math.ceil(1e-5 * DIAMETER / speed / dt) + 3 * division
                end = couples.run(atoms, [f"1 1 {pair.words()}"], dt, steps)[0][-1]
                left = -(end[:, 0, 4] - end[:, 1, 4]) / speed / restitution
                report(f"e {restitution}, t_c/{division}, {speed} m/s: {left.min() - 1:.1e} {left.max() - 1:.1e}")
                self.assertLess(numpy.abs(left - 1).max(), within)

    def test_capture(self):
        # Within 1e-3 of the escape velocity at t_c/20, and 2e-3 at t_c/10 for a restitution of 0.7 or more.
        for restitution, division, grade in ((0.5, 20, 1e-3), *((e, *step) for e in (0.7, 0.9, 0.99)
                                                                for step in ((10, 2e-3), (20, 1e-3)))):
            pair = HertzPair(MODULUS, restitution, DIAMETER, HAMAKER)
            speeds = {angle: pair.escape_velocity(math.radians(angle), START) for angle in (0, 40, 80)}
            dt = pair.contact_time(pair.touching_speed(speeds[0])) / division
            for angle, slowest, fastest in limits(pair.words(), "gran/hamaker", speeds, grade, dt, 30 * division,
                                                  START, 0.0, START):
                report(f"e {restitution}, {angle} degrees, t_c/{division}: slowest parted {slowest}, captured {fastest}")
                self.assertEqual((slowest, fastest), (1 + grade, 1 - grade))

    def test_a_softer_modulus_captures_as_the_material_does(self):
        # The scaling is exact head-on; the grade is that of the step, as above.
        grade, division = 1e-3, 20
        real = HertzPair(1e3 * MODULUS, 0.9, DIAMETER, HAMAKER)
        soft = HertzPair(MODULUS, 0.9, DIAMETER, HAMAKER)
        speed = real.escape_velocity(0.0, START)
        self.assertGreater(soft.escape_velocity(0.0, START), 3 * speed)
        words = f"{soft.words()} material_modulus {real.modulus} {real.poisson}"
        dt = soft.contact_time(soft.touching_speed(speed)) / division
        (_, slowest, fastest), = limits(words, "gran/hamaker", {0: speed}, grade, dt, 30 * division, START, 0.0, START)
        report(f"E over the material's 1e-3: slowest parted {slowest}, captured {fastest}")
        self.assertEqual((slowest, fastest), (1 + grade, 1 - grade))

    def test_strength(self):
        for partner in pull_off.PARTNERS:
            for division in (10, 20, 50):
                grain = HertzGrain(5e6, 0.9, partner=partner)
                found = pull_off.load_at_parting(grain, division)
                report(f"{partner}, t_c/{division}: {found:.4f} F_ad")
                self.assertAlmostEqual(found, 1.0, delta=0.01)


class Sampled(unittest.TestCase):
    """Scheme sampled is of first order in the step, and comes to scheme exact."""

    def test_it_comes_to_scheme_exact(self):
        # Oblique impacts at eight phases of the step, with friction, rolling friction and a dashpot: what velocities of
        # half a step before leave open is w dt/2 = pi/(2 n) of them at n steps per contact.
        speed, angle = 0.1, math.radians(50)
        pair = HertzPair(MODULUS, 0.8, DIAMETER)
        words = pair.words() + " friction 0.3 rolling_friction 0.1"

        def ends(scheme, division):
            dt = pair.contact_time(speed) / division
            atoms = []
            for phase in range(PHASES):
                velocity = (speed * math.tan(angle), speed, 0.0)
                away = numpy.array([0.0, (1 + 1e-5) * DIAMETER, 0.0]) + dt * phase / PHASES * numpy.array(velocity)
                start = numpy.linalg.norm(away)
                atoms += couples.couple(len(atoms) // 2, start - DIAMETER, velocity, normal=away / start,
                                        spins=((0.0, 0.0, 0.0), (20.0, 10.0, 30.0)))
            steps = math.ceil(1e-5 * DIAMETER / speed / dt) + 3 * division
            end = couples.run(atoms, [f"1 1 {words}"], dt, steps, style=f"gran/hamaker scheme {scheme}")[0][-1]
            return numpy.concatenate([end[..., 3:6], 0.5 * DIAMETER * end[..., 6:9]], axis=-1)

        errors = [numpy.abs(ends("sampled", n) - ends("exact", n)).max() / speed for n in (100, 800)]
        report(f"velocities of sampled less exact over the speed, t_c/100 and t_c/800: {errors[0]:.1e}, {errors[1]:.1e}")
        self.assertLess(errors[0], math.pi / 200)
        self.assertLess(errors[1], math.pi / 1600)

    def test_losses_of_both_schemes(self):
        # Of normal dashpot, tangential dashpot and slider, entries 6 to 8 of compute gran/energy. A spring that stiffens
        # loses stretch by that, which no dashpot sees. First order: as above, of all that is lost.
        speed, division = 0.1, 400
        pair = HertzPair(MODULUS, 0.8, DIAMETER)
        atoms = couples.couple(0, 1e-5 * DIAMETER, (1.2 * speed, speed, 0), spins=((0, 0, 0), (20.0, 10.0, 30.0)))
        losses = []
        for scheme in ("exact", "sampled"):
            output = couples.run(atoms, [f"1 1 {pair.words()} friction 0.3"], pair.contact_time(speed) / division,
                                 3 * division, every=3 * division, style=f"gran/hamaker scheme {scheme}")[1]
            last = [line.split() for line in output.split("\n") if re.match(rf"\s*{3 * division}\s", line)][-1]
            losses.append(numpy.array(last[7:10], float))
        report(f"lost in normal dashpot, tangential dashpot and slider: exact {losses[0]}, sampled {losses[1]} J")
        self.assertGreater(losses[0][1], 0.0)
        self.assertLess(numpy.abs(losses[0] - losses[1]).max(), math.pi / (2 * division) * losses[0].sum())

    def test_each_law_has_it_beside_a_wall(self):
        # As above; a bridge that breaks at 1e-5 m is found v dt late, which is half a percent of a tenth of the energy.
        speed, division = 0.1, 400
        pair = HertzPair(MODULUS, 0.8, DIAMETER, plane=True)
        dt, energy = pair.contact_time(speed) / division, 0.5 * pair.mu * speed**2
        for law, words in (("hamaker", "hamaker 1e-19 cutoff 4e-10 1e-7"), ("squarewell", f"well {0.1 * energy} 1.01"),
                           ("liquidbridge", f"bridge {0.1 * energy / 1e-5} 1e-5")):
            exact, sampled = (self.bounce(law, f"{pair.words()} friction 0.3 {words}", scheme, speed, dt, 8 * division)
                              for scheme in ("exact", "sampled"))
            report(f"{law}: velocities after a bounce, exact {exact}, sampled {sampled}")
            self.assertGreater(exact[1], 0.0)  # it has parted
            for one, other in zip(exact, sampled):
                self.assertLess(abs(one - other), (math.pi / (2 * division) + 1e-3) * speed)

    def bounce(self, law, contact, scheme, speed, dt, steps):
        """The velocities along and away from a wall that a sphere has met."""
        script = f"""{box()}{spheres((1, 0.005, 0.005, 0.52e-3))}velocity all set 0.05 0 {-speed}
neighbor 4e-4 bin
pair_style gran/{law} scheme {scheme}
pair_coeff * * {contact}
fix w all wall/gran/{law} {contact} zplane 0 NULL scheme {scheme}
fix move all nve/sphere
timestep {dt}
run {steps}
print "ended $(vcm(all,x)) $(vcm(all,z))"
"""
        with lammps.temporary_folder() as folder:
            code, output = lammps.run_text(script, folder)
        self.assertEqual(code, 0, output)
        return [float(value) for value in re.findall(r"^ended (\S+) (\S+)$", output, re.M)[-1]]

    def test_capture_at_steps_within_the_cut_off(self):
        # A pair crosses H_cut in 20 steps, so that the work of the attraction is open by up to half a step of it, 2.5 %,
        # and the speed by half of that.
        pair = HertzPair(MODULUS, 0.9, DIAMETER, HAMAKER)
        speed = pair.escape_velocity(0.0, START)
        touching = pair.touching_speed(speed)
        dt = 4e-10 / touching / 20
        steps = math.ceil(2.5 * pair.contact_time(touching) / dt)
        (_, slowest, fastest), = limits(pair.words(), "gran/hamaker scheme sampled", {0: speed}, 1.25e-2, dt, steps, START,
                                        0.0, START)
        report(f"sampled: slowest parted {slowest}, captured {fastest}")
        self.assertGreaterEqual(slowest, 1 - 1e-2)
        self.assertLessEqual(fastest, 1 + 1e-2)


class Words(ScriptTestCase):
    CONTACT = "normal hertz 5e6 0.25 restitution 0.9 hamaker 7.49e-19 cutoff 4e-10 1e-7"
    MATERIAL = " material_modulus 5e9 0.25"
    MODULI = "modulus E* 2.66667e+06 for 2.66667e+09 of the material: "

    def with_wall(self, words):
        return self.goes(f"{HEAD}pair_style gran/hamaker\npair_coeff * * {words}\n"
                         f"fix plate all wall/gran/hamaker {words} zplane 0 NULL{MOVE}")

    def test_the_run_prints_the_scaled_adhesion_and_what_it_keeps(self):
        output = self.with_wall(self.CONTACT + self.MATERIAL)
        f = 1e-3**0.4
        notes = re.findall(r"adhesion scaled from modulus E\* 2.66667e\+09 to 2.66667e\+06, which keeps the escape "
                           r"velocity: A 7.49e-19 -> (\S+), H_cut 4e-10 -> (\S+)", output)
        self.assertEqual(len(notes), 4)  # three pairs of types and a wall
        constant, cut = map(float, notes[0])
        # Six digits are printed: force f of the real one, and the same energy at contact.
        self.assertAlmostEqual(constant / cut**2 / (7.49e-19 / 4e-10**2) / f, 1, delta=3e-5)
        self.assertAlmostEqual(constant * (2 / cut - 1e7) / (7.49e-19 * (2 / 4e-10 - 1e7)), 1, delta=3e-5)
        for names in ("1 - 1", "1 - wall"):
            self.assertIn(f"{self.MODULI}escape velocity 1, pull-off force 0.0631 times the material's ({names})", output)
        kept = self.with_wall(self.CONTACT + self.MATERIAL + " material_keep force")
        self.assertEqual(kept.count("adhesion not scaled from modulus E* 2.66667e+09 to 2.66667e+06, which keeps the "
                                    "pull-off force"), 4)
        real, soft = (HertzPair(modulus, 0.9, DIAMETER, HAMAKER).escape_velocity() for modulus in (5e9, 5e6))
        found = re.search(re.escape(self.MODULI) + r"escape velocity (\S+), pull-off force 1 times the material's \(1 - 1\)",
                          kept)
        # Three digits are printed.
        self.assertAlmostEqual(float(found[1]) / (soft / real), 1, delta=6e-3)

    def test_a_soft_modulus_is_warned_of_with_the_keyword_of_the_material(self):
        # Without it, at a speed of which the escape velocity is a part.
        output = self.with_wall(self.CONTACT)
        self.assertEqual(len(re.findall(r"WARNING: .*stiffer spring.*'material_modulus E_m nu_m' keeps", output)), 2)
        self.assertNotIn("stiffer spring", self.with_wall(self.CONTACT + self.MATERIAL))

    def test_a_restart_file_has_the_material(self):
        self.goes(f"{HEAD}pair_style gran/hamaker\npair_coeff * * {self.CONTACT}{self.MATERIAL}{MOVE}"
                  "write_restart some.restart noinit\n")
        again = self.goes("plugin load ${plugin}\nnewton off\nread_restart some.restart\ncomm_modify vel yes\n"
                          f"neighbor 1e-4 bin\n{MOVE}")
        self.assertIn("adhesion scaled from modulus E* 2.66667e+09", again)

    def test_what_stops_a_run(self):
        for words, settings, message in (
                ("normal hertz 5e6 0.25 stiffness 100", "", "stiffness K = 100: is of a linear spring"),
                ("normal hertz 5e6 0.7", "", "Poisson's ratio nu = 0.7"),
                ("normal hertz -5e6 0.2", "", "Young's modulus E"),
                ("normal hooke 5e6 0.2", "", "normal"),
                ("normal hertz 5e6 0.2 damping 1e-3", "", "damping eta"),
                ("normal hertz 5e6 0.2 material_stiffness 1e5 hamaker 1e-19 cutoff 4e-10 1e-7", "",
                 "with 'normal hertz' give 'material_modulus E_m nu_m'"),
                ("stiffness 800 material_modulus 5e9 0.25", "", "with 'stiffness' give 'material_stiffness K_m'"),
                ("normal hertz 5e6 0.2 material_keep force", "", "'material_keep' needs 'material_modulus E_m nu_m'"),
                ("normal hertz 5e6 0.2 material_modulus 5e9", "", "needs 'material_modulus E_m nu_m': nu_m is missing"),
                ("normal hertz 5e6 restitution 0.9", "",
                 "pair_coeff * * of gran/hamaker: keyword 'normal' needs 'normal hertz E nu': 'restitution' stands in "
                 "the place of nu"),
                ("normal hertz restitution 0.9", "", "'restitution' stands in the place of E"),
                ("normal 5e6 0.2 restitution 0.9", "", "'5e6' stands in the place of hertz"),
                ("normal hertz 5e6 0.2 material_keep 1", "", "'1' stands in the place of name"),
                (f"{self.CONTACT} asperity 1e-7{self.MATERIAL}", "", "without asperities"),
                (f"{self.CONTACT} material_modulus 60 0.25", "", "a contact must not be stiffer than its material")):
            with self.subTest(words=words):
                self.stops(f"{HEAD}pair_style gran/hamaker {settings}\npair_coeff * * {words}{MOVE}", message)


if __name__ == "__main__":
    unittest.main()
