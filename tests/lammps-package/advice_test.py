# SPDX-License-Identifier: BSD-3-Clause
"""When the advice is given and a run stopped: in every set-up and within a run, where step, particles or coefficients
have become worse; and that nothing is said twice."""
import re
import unittest
from pathlib import Path

from cohesion_tests.lammps_scenes import packed_cluster
from cohesion_tests.lammps_scenes.small_box import box, spheres
from cohesion_tests.test_cases import ScriptTestCase

CONTACT = "stiffness 800 restitution 0.9 hamaker 5e-19 cutoff 4e-10 1e-7"
STYLE = f"pair_style gran/hamaker\npair_coeff * * {CONTACT}\n"
BOX = box(types=2, size=(0.02, 0.02, 0.02)) + """neighbor 1e-3 bin
neigh_modify delay 0
"""
# Of two spheres of 1 mm and 2650 kg/m^3 a contact takes pi sqrt(m/2K) = 9.25e-5 s.
TWO = BOX + spheres((1, 0.002, 0.005, 0.005), (1, 0.0035, 0.005, 0.005)) + "velocity all set 0.01 0 0\n"
CHANGING = TWO.replace("sphere\n", "sphere 1\n", 1)
MOVE = "fix move all nve/sphere\n"
PAIRS_OF_TYPES = 3
GOOD, WARNED, TOO_LONG = "5e-6", "3.1e-5", "4e-4"
ADVICE = "what to expect"
FEW_STEPS = "a contact takes"
POURED = """region top block 0.002 0.018 0.002 0.018 0.01 0.018 units box
fix g all gravity 9.81 vector 0 0 -1
fix ins all pour 20 1 4711 region top vol 0.1 50 """


class Step(ScriptTestCase):
    def script(self, runs, first=GOOD, style=STYLE):
        return f"{TWO}{style}{MOVE}timestep {first}\n{runs}"

    def test_a_step_that_became_too_long_between_runs_stops_the_next(self):
        wall = f"pair_style none\nfix plate all wall/gran/hamaker {CONTACT} zplane 0 NULL\n"
        for style in (STYLE, wall, STYLE.replace("hamaker\n", "hamaker scheme sampled\n")):
            for how in ("", " pre no"):
                with self.subTest(style=style, how=how):
                    output = self.stops(self.script(f"run 1\ntimestep {TOO_LONG}\nrun 50{how}\n", style=style),
                                        "reduce", after_a_run=True)
                    self.assertEqual(output.count("Loop time"), 1)

    def test_a_warning_that_a_longer_step_brings(self):
        output = self.goes(self.script(f"run 1\ntimestep {WARNED}\nrun 1\nrun 1\n"))
        self.assertEqual(output.count(FEW_STEPS), 1)
        self.assertEqual(output.count(ADVICE), 2)
        self.assertGreater(output.index(FEW_STEPS), output.index("Loop time"))

    def test_a_run_from_a_restart_file_is_judged(self):
        self.goes(self.script("run 1\nwrite_restart r.rest\n"))
        self.stops("plugin load ${plugin}\nnewton off\nread_restart r.rest\ncomm_modify vel yes\n"
                   f"neighbor 1e-3 bin\n{MOVE}timestep {TOO_LONG}\nrun 10\n", FEW_STEPS)

    def test_a_step_that_grows_within_a_run(self):
        self.stops(self.script(f"fix longer all dt/reset 1 1e-9 {TOO_LONG} 4e-6\nrun 50\n", first="1e-5"), FEW_STEPS)

    def test_what_was_said_is_not_said_again(self):
        for runs in ("run 5\nrun 5\nrun 5\n", "run 20 every 5 NULL\n", 'run 20 every 5 "print again"\n',
                     "run 5\nrun 5 pre no\n", f"run 5\nrun 5 pre no\nset group all density 2650\nrun 5\n"):
            with self.subTest(runs):
                output = self.goes(self.script(runs, first=WARNED))
                self.assertEqual((output.count(ADVICE), output.count(FEW_STEPS)), (1, 1), output)

    def test_how_adhesion_was_scaled_is_told_once(self):
        for told, keep in (("adhesion scaled from", "velocity"), ("adhesion not scaled from", "force")):
            style = f"{STYLE.strip()} material_stiffness 8000 material_keep {keep}\n"
            output = self.goes(self.script("run 1\nrun 1\npair_coeff * * " +
                                           style.split("* *")[1].replace("800 ", "400 ", 1) + "run 1\nrun 1\n",
                                           style=style))
            self.assertEqual(output.count(told), 2 * PAIRS_OF_TYPES, output)

    def test_extremes_that_leave_a_mixture_are_not_news(self):
        rows = "".join(f"create_atoms 1 single {0.001 * k} 0.01 0.01 units box\n"
                       f"set atom {k + 2} diameter {0.5e-3 + 2e-5 * k} density 2650\n" for k in range(1, 11))
        fewer = "".join(f"group out{k} id {k + 2}\ndelete_atoms group out{k} compress no\nrun 1\n"
                        for k in range(1, 11))
        output = self.goes(TWO + rows + STYLE + MOVE + f"timestep {GOOD}\nrun 1\n" + fewer)
        # Heavier by (1/0.52)^3, two times a factor above 2.
        self.assertLessEqual(output.count(ADVICE), 3)

    def test_other_coefficients_are_told(self):
        output = self.goes(self.script(f"run 5\npair_coeff * * {CONTACT.replace('800', '400')}\nrun 5\n"))
        self.assertEqual(output.count(ADVICE), 2)


class Particles(ScriptTestCase):
    def script(self, step, what, style=STYLE, how="pour"):
        region = POURED if how == "pour" else POURED[:POURED.index("fix ins")]
        return f"{BOX}{style}{what}{MOVE}{region}%s\ntimestep {step}\nrun 50\nrun 50\n"

    def test_what_pour_will_bring_is_judged_before_it_comes(self):
        for size in ("diam one 1e-3 dens 2650 2650", "diam range 1e-3 2e-3 dens 2650 3000",
                     "diam poly 2 2e-3 0.5 1e-3 0.5 dens 2650 2650"):
            with self.subTest(size):
                output = self.stops(self.script(TOO_LONG, "") % size, FEW_STEPS)
                self.assertNotIn("Step ", output)
                # m(1 mm) at 2650 kg/m^3
                self.assertIn(f"{FEW_STEPS} 0.231 time steps", output)
                # A spring that a fall through the box presses by less than 1 %.
                stiff = STYLE.replace("800", "4000")
                output = self.goes(self.script("2e-6", "", style=stiff) % size)
                self.assertEqual(output.count(ADVICE), 1, output)

    def test_the_weight_of_what_will_come_among_held_particles(self):
        held = "create_atoms 2 single 0.001 0.001 0.001 units box\nset type 2 diameter 1e-3 density 2650\n"
        script = (self.script("2e-6", "", style=STYLE.replace("800", "4000")) % "diam one 1e-3 dens 2650 2650")
        for name in ("fix move", "fix g", "fix ins"):
            script = script.replace(f"{name} all", f"{name} free")
        script = script.replace("neighbor", held + "group free type 1\nneighbor", 1)
        for ranks in (1, 2):
            # sqrt(2 g d)
            self.assertRegex(self.goes(script, ranks=ranks), r"1 - 1 +0\.14 ")

    def test_at_a_wall_too(self):
        wall = f"fix plate all wall/gran/hamaker {CONTACT} zplane 0 NULL\n"
        self.stops(self.script(TOO_LONG, wall, style="pair_style none\n") % "diam one 1e-3 dens 2650 2650",
                   "1 - wall", f"{FEW_STEPS} 0.327 time steps")

    def test_what_deposit_will_bring(self):
        # Spheres of 1 m and 1 kg/m^3, where nothing says otherwise: of two a contact takes 0.0568 s.
        deposit = "fix ins all deposit 5 1 5 4711 region top near 1e-3\n"
        self.stops(self.script("0.1", "", how="deposit") % deposit, f"{FEW_STEPS} 0.568 time steps")
        (Path(self.folder) / "grain.txt").write_text(
            "a grain\n\n1 atoms\n\nCoords\n\n1 0 0 0\n\nTypes\n\n1 1\n\nDiameters\n\n1 1e-3\n\nMasses\n\n1 1.3875e-6\n")
        molecule = "molecule grain grain.txt\nfix ins all deposit 5 0 5 4711 region top near 1e-3 mol grain\n"
        self.stops(self.script(TOO_LONG, "", how="deposit") % molecule, f"{FEW_STEPS} 0.231 time steps")

    def test_particles_that_become_lighter_within_a_run(self):
        # Half the diameter, an eighth of the mass: a contact of 3.27e-5 s.
        smaller = "variable d equal 1e-3*(1-0.01*step)\nfix shrink all adapt 10 atom diameter v_d\n"
        start = f"{CHANGING}{STYLE}{smaller}{MOVE}"
        for ranks in (1, 2):
            with self.subTest(ranks=ranks):
                self.stops(start + "timestep 4e-5\nrun 60\n", FEW_STEPS, ranks=ranks)
        output = self.goes(start + "timestep 8e-6\nrun 50\n")
        self.assertNotIn(FEW_STEPS, output)

    def test_a_mass_of_zero_is_an_error_of_the_engine(self):
        # 1e-330 kg
        zero = "variable d equal 1e-110\nfix shrink all adapt 5 atom diameter v_d\n"
        self.stops(f"{CHANGING}{STYLE}{zero}{MOVE}timestep {GOOD}\nrun 50\n", "gran/hamaker: reduced mass = 0")


class AttractionAlone(ScriptTestCase):
    SCRIPT = TWO + """pair_style hybrid/overlay gran/hooke/history 800 NULL 0.001 NULL 0.3 0 hamaker cutoff 4e-10 1e-7
pair_coeff * * gran/hooke/history
pair_coeff * * hamaker %s
""" + MOVE + "timestep %s\nrun 5\nrun 5\n"

    def test_a_step_that_jumps_over_the_cut_off_is_warned_of(self):
        # F_ad R*/(6 H_cut^2) with R* = 0.25 mm, both rates of which add 0.001 to 0.01 m/s: 4e-8 s.
        for step, said in (("4e-7", 1), ("3.9e-8", 0)):
            output = self.goes(self.SCRIPT % ("5e-19", step))
            self.assertEqual(output.count("which pairs stick is left to chance: reduce the time step to 3.99e-08 or "
                                          "use pair_style gran/hamaker"), said, output)
            self.assertEqual(output.count("pair_style hamaker, scheme sampled: what to expect"), 1)
        self.assertNotIn(ADVICE, self.goes(self.SCRIPT % ("0", "4e-7")))

    def test_beside_a_wall(self):
        wall = TWO + f"pair_style none\nfix wall all wall/hamaker hamaker 5e-19 cutoff 4e-10 1e-7 xplane 0 NULL\n{MOVE}"
        for step, said in (("4e-7", 1), ("3.9e-8", 0)):
            output = self.goes(f"{wall}timestep {step}\nrun 5\nrun 5\n")
            self.assertEqual(output.count("1 - wall: a pair at 0.01"), said, output)


class SixWalls(ScriptTestCase):
    """Walls in fixes of their own with the same coefficients have one table and one warning of each kind, which say
    whose they are; walls of another material, group or style have theirs."""
    SIDES = [("low", "xplane 0 NULL"), ("high", "xplane NULL 0.02"), ("left", "yplane 0 NULL"),
             ("right", "yplane NULL 0.02"), ("floor", "zplane 0 NULL"), ("lid", "zplane NULL 0.02")]

    def walls(self, words, **others):
        return "".join(f"fix {name} {others.get(name, f'all {words}')} {plane}\n" for name, plane in self.SIDES)

    def run_with(self, walls, step=WARNED, runs="run 5\nrun 5\n", **options):
        return self.goes(f"{TWO}pair_style none\n{walls}{MOVE}timestep {step}\n{runs}", **options)

    def test_one_table(self):
        for style, words, step, warning in (
                ("wall/gran/hamaker", CONTACT, "4.5e-5", FEW_STEPS),
                ("wall/gran/squarewell", "stiffness 800 restitution 0.9 well 1e-12 1.01", "4.5e-5", FEW_STEPS),
                ("wall/hamaker", "hamaker 5e-19 cutoff 4e-10 1e-7", "4e-7", "which pairs stick is left to chance")):
            for ranks in (1, 2):
                with self.subTest(style, ranks=ranks):
                    output = self.run_with(self.walls(f"{style} {words}"), step, ranks=ranks)
                    self.assertEqual((output.count(ADVICE), output.count(warning)), (1, 1), output)
                    self.assertGreaterEqual(output.count(f"fixes low, high, left, right, floor, lid {style}"), 2)
                    self.assertNotIn("fix low", output.replace("fix low all", ""))

    def test_another_wall_has_its_own(self):
        softer = CONTACT.replace("800", "600")
        output = self.run_with(self.walls(f"wall/gran/hamaker {CONTACT}", floor=f"all wall/gran/hamaker {softer}"))
        self.assertEqual(output.count(ADVICE), 2, output)
        self.assertIn("fixes low, high, left, right, lid wall/gran/hamaker, scheme exact: what", output)
        self.assertIn("fix floor wall/gran/hamaker, scheme exact: what", output)

    def test_why_a_run_must_not_begin(self):
        self.stops(f"{TWO}pair_style none\n{self.walls(f'wall/gran/hamaker {CONTACT}')}{MOVE}timestep {TOO_LONG}\nrun 1\n",
                   "fixes low, high, left, right, floor, lid wall/gran/hamaker, 1 - wall: a contact takes")

    def test_a_wall_that_comes_later(self):
        """Says what is known of the others once more, since it is another's."""
        late = f"run 5\nfix mid all wall/gran/hamaker {CONTACT} xplane 0.001 NULL\nrun 5\n"
        walls = self.walls(f"wall/gran/hamaker {CONTACT}") + "unfix lid\n"
        script = f"{TWO}pair_style none\n{walls}{MOVE}timestep {GOOD}\n{late}".replace("fix mid", "unfix move\nfix mid")
        output = self.goes(script.replace("\nrun 5\n", f"\nrun 5\n{MOVE}").replace(MOVE + "unfix", "unfix")
                           .replace("xplane 0.001 NULL\nrun 5\n", f"xplane 0.001 NULL\n{MOVE}run 5\n"))
        self.assertEqual(output.count(ADVICE), 2, output)
        self.assertIn("fix mid wall/gran/hamaker, scheme exact: what", output)


class SeveralContacts(ScriptTestCase):
    """Steps in which particles with several contacts gain energy."""
    DAMPED = "stiffness 800 restitution 0.5 friction {} hamaker 1e-17 cutoff 4e-10 1e-7"
    CONTACT_TIME = 9.2515e-5

    def cluster(self, dt, friction):
        return packed_cluster.script(lattice="1.40961e-3", box=4, radius=1.5, dt=dt,
                                     steps=20 * round(2 * self.CONTACT_TIME / dt),
                                     coefficients=self.DAMPED.format(friction))

    def test_a_packing_is_stopped_and_goes_on_with_the_step_that_the_message_names(self):
        for friction in (0, 0.3):
            with self.subTest(friction=friction):
                output = self.stops(self.cluster(self.CONTACT_TIME / 3, friction), "several contacts unstable", "reduce it to")
                limit = float(re.search(r"reduce it to (\S+),", output)[1])
                # Named to three digits, rounded down.
                self.stops(self.cluster(1.01 * limit, friction), "several contacts unstable")
                self.goes(self.cluster(limit, friction))
                output = self.goes(self.cluster(0.99 * limit, friction))
                last = [line.split() for line in output.splitlines() if re.match(r" +\d+ +\S+ +\S+ *$", line)][-1]
                # A contact loses three quarters of its energy in a contact time, and some 200 of them had
                # up to 800 N/m (2e-9 m)^2/2.
                self.assertLess(float(last[1]) + float(last[2]), 1e-3 * 200 * 400 * (2e-9)**2)

    def test_pairs_apart_are_warned_and_stopped_when_they_meet(self):
        coefficients = self.DAMPED.format(0)
        apart = (BOX + spheres((1, 0.002, 0.005, 0.005), (1, 0.0031, 0.005, 0.005), (1, 0.009, 0.005, 0.005))
                 + "group flies id 3\nvelocity flies set -5 0 0\nneighbor 5e-4 bin\n")
        script = apart + f"pair_style gran/hamaker\npair_coeff * * {coefficients}\n{MOVE}timestep {self.CONTACT_TIME / 3}\n"
        output = self.goes(script + "run 10\n")
        self.assertEqual(output.count("the run stops where a particle has two neighbours"), 1)
        self.stops(script + "run 100\n", "gain energy without bound", after_a_run=True)

    def test_two_spheres_may_take_any_step(self):
        coefficients = self.DAMPED.format(0)
        output = self.goes(f"{TWO}pair_style gran/hamaker\npair_coeff * * {coefficients}\n{MOVE}"
                           f"timestep {self.CONTACT_TIME / 3}\nrun 10\n")
        self.assertNotIn("several contacts", output)

    def test_particles_that_are_to_be_poured_count(self):
        coefficients = self.DAMPED.format(0)
        self.stops(f"{BOX}{POURED}diam one 1e-3 dens 2650 2650\npair_style gran/hamaker\npair_coeff * * {coefficients}\n{MOVE}"
                   f"timestep {self.CONTACT_TIME / 3}\nrun 10\n", "several contacts unstable")


if __name__ == "__main__":
    unittest.main()
