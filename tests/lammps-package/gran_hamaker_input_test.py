# SPDX-License-Identifier: BSD-3-Clause
"""Input of pair_style gran/hamaker and fix wall/gran/hamaker: what is refused and why, the advice
before the first step, the scaling of adhesion with the stiffness."""
import math
import re
import unittest

from cohesion_tests.test_cases import ScriptTestCase

HEAD = """
plugin load ${plugin}
units si
atom_style sphere
boundary f f f
newton %(newton)s
%(velocities)s
region box block 0 0.01 0 0.01 0 0.01 units box
create_box 2 box
create_atoms 1 single 0.002 0.005 0.005 units box
create_atoms 2 single 0.008 0.005 0.005 units box
set group all diameter 1e-3 density 2650
velocity all set 0.01 0 0
neighbor 1e-4 bin
timestep %(dt)s
"""
USUAL = {"newton": "off", "velocities": "comm_modify vel yes", "dt": "5e-6"}
CONTACT = "stiffness 800 restitution 0.9487 friction 0.3 hamaker 5e-19 cutoff 4e-10 1e-7"
MOVE = "\nfix move all nve/sphere\nrun 2\n"
MASS = math.pi / 6 * 2650 * 1e-9


def script(pair="pair_style gran/hamaker\npair_coeff * * " + CONTACT, tail=MOVE, **changes):
    return HEAD % {**USUAL, **changes} + pair + "\n" + tail


class Input(ScriptTestCase):
    def advised(self, output, name):
        """The table's row of a contact, as numbers."""
        row = next(line for line in output.splitlines() if line.strip().startswith(name))
        return [float(word) for word in row.split()[3:]]

    def test_wrong_words_and_values(self):
        style = "pair_style gran/hamaker\npair_coeff * * "
        for words, expected in (
                ("stifness 800", ("stifness", "stiffness", "hamaker")),
                ("stiffness -800", ("stiffness K = -800",)),
                ("stiffness 800 restitution 1.5", ("restitution e = 1.5", "between 0 and 1")),
                ("stiffness 800 restitution 0.9 damping 1e-3", ("not both",)),
                ("stiffness 800 hamaker 5e-19", ("cutoff H_cut H_out",)),
                ("stiffness 800 hamaker 5e-19 cutoff 1e-7 4e-10", ("H_cut", "smaller")),
                ("stiffness 800 friction nan", ("nan",)),
                (CONTACT + " asperity 1e-8 roughness 5e-9 5e-7", ("'asperity'", "'roughness'", "not both")),
                (CONTACT + " roughness 1e-9 1e-8", ("wavelength of the roughness = 1e-08", "at least 10.2785 times")),
                (CONTACT + " roughness 5e-9 5e-7 material_stiffness 80000", ("without asperities",)),
                ("stiffness 800 cutoff 4e-10", ("needs 'cutoff H_cut H_out': H_out is missing",))):
            with self.subTest(words):
                self.stops(script(style + words), *expected)

    def test_unknown_scheme_and_form_list_the_valid_ones(self):
        self.stops(script("pair_style gran/hamaker scheme sometimes"), "sometimes", "exact", "sampled")
        self.stops(script("pair_style gran/hamaker form linear"), "linear", "small_gap", "exact")

    def test_what_the_engine_must_provide(self):
        self.stops(script(newton="on"), "newton off")
        self.stops(script(velocities=""), "comm_modify vel yes")
        self.stops(script(tail="run_style respa 2 2\n" + MOVE), "run_style verlet")
        self.stops(script("", "fix move all nve/sphere\npair_style gran/hamaker\n"
                          "pair_coeff * * " + CONTACT + "\nrun 1\n"), "fix move", "behind")

    def test_advice_names_the_numbers_of_the_pair_and_of_the_wall(self):
        output = self.goes(script(tail="fix plate all wall/gran/hamaker " + CONTACT +
                                  " zplane 0 NULL" + MOVE))
        for name, mass, radius in (("1 - 1", MASS / 2, 2.5e-4), ("1 - wall", MASS, 5e-4)):
            speed, steps, cutoff_steps, static = self.advised(output, name)[:4]
            force = 5e-19 * radius / (6 * 4e-10**2)
            entry = math.sqrt(0.01**2 + 2 * force * (2 * 4e-10 - 4e-10**2 / 1e-7) / mass)
            self.assertAlmostEqual(speed, 0.01, delta=1e-5)
            # Three or four digits are printed.
            self.assertAlmostEqual(steps, math.pi / math.sqrt(800 / mass) / 5e-6, delta=0.005)
            self.assertAlmostEqual(cutoff_steps / (4e-10 / (entry * 5e-6)), 1, delta=5e-3)
            self.assertAlmostEqual(static / (force / 800 / 1e-3), 1, delta=5e-2)

    def test_steps_too_large_are_refused_by_each_scheme(self):
        pair = "pair_style gran/hamaker scheme %s\npair_coeff * * " + CONTACT
        contact_time = math.pi / math.sqrt(800 / (MASS / 2))
        self.stops(script(pair % "exact", dt=f"{contact_time / 0.9:.6g}"), "a contact takes 0.9")
        output = self.goes(script(pair % "exact", dt=f"{contact_time / 3:.6g}"))
        self.assertRegex(output, "WARNING.*a contact takes 3")
        self.stops(script(pair % "sampled", dt=f"{contact_time / 1.5:.6g}"), "unstable")
        output = self.goes(script(pair % "sampled"))
        self.assertRegex(output, "WARNING.*left to chance")

    def ratios(self, output, names):
        """Escape velocity and pull-off force over those of the material, as printed under a table."""
        found = re.search(r"stiffness 800 for 80000 of the material: escape velocity (\S+), pull-off force (\S+) "
                          r"times the material's \(" + re.escape(names) + r"\)", output)
        self.assertIsNotNone(found, output)
        return float(found[1]), float(found[2])

    def both(self, words, **changes):
        """Pairs and a wall of these words."""
        return self.goes(script(f"pair_style gran/hamaker\npair_coeff * * {words}\n",
                                f"fix plate all wall/gran/hamaker {words} zplane 0 NULL{MOVE}", **changes))

    def test_both_ratios_to_the_material_are_printed(self):
        scaled = self.both(CONTACT + " material_stiffness 80000")
        for names in ("1 - 1, 1 - 2, 2 - 2", "1 - wall, 2 - wall"):
            # f = sqrt(800/80000), exactly.
            self.assertEqual(self.ratios(scaled, names), (1.0, 0.1))
        self.assertNotIn("stiffer spring", scaled)

    def test_the_force_can_be_kept_instead(self):
        as_given = self.both(CONTACT)
        kept = self.both(CONTACT + " material_stiffness 80000 material_keep force")
        stiff = self.both(CONTACT.replace("800", "80000"), dt="5e-7")
        for name, names in (("1 - 1", "1 - 1, 1 - 2, 2 - 2"), ("1 - wall", "1 - wall, 2 - wall")):
            self.assertEqual(self.advised(kept, name), self.advised(as_given, name))
            escape, force = self.ratios(kept, names)
            self.assertEqual(force, 1.0)
            # Three digits are printed of all three.
            v_esc = self.advised(kept, name)[-2] / self.advised(stiff, name)[-2]
            self.assertAlmostEqual(escape / v_esc, 1, delta=0.015)
        self.assertIn("adhesion not scaled from stiffness 80000 to 800, which keeps the pull-off force", kept)
        self.assertNotIn("stiffer spring", kept)

    def test_what_hangs_by_the_force_of_the_material_hangs_by_the_force_that_is_kept(self):
        # Below a plane: F_ad = A r/(6 H_cut^2) is 2.5 weights, sqrt(800/80000) of it a quarter of one.
        force = 5e-19 * 5e-4 / (6 * 4e-10**2)
        hang = ("fix ceiling all wall/gran/hamaker " + CONTACT + " material_stiffness 80000 material_keep %s "
                f"zplane NULL 0.0055\nfix g all gravity {force / MASS / 2.5} vector 0 0 -1\n"
                "fix move all nve/sphere\nrun 400\nvariable low equal \"bound(all,zmin) < 5e-3 - 1e-5\"\n"
                "print \"fell ${low}\"\n")
        for keep, fell in (("velocity", 1), ("force", 0)):
            with self.subTest(keep):
                output = self.goes(script("pair_style gran/hamaker\npair_coeff * * stiffness 800", hang % keep)
                                   .replace("velocity all set 0.01 0 0\n", ""))
                self.assertIn(f"\nfell {fell}", output)

    def test_softness_is_warned_of_once_with_what_to_do(self):
        output = self.both(CONTACT)
        for who, names in (("pair_style gran/hamaker", "1 - 1, 1 - 2, 2 - 2"),
                           ("fix plate wall/gran/hamaker", "1 - wall, 2 - wall")):
            warning, = re.findall(rf"WARNING: {who}, (.*?stiffer.*)", output)
            self.assertTrue(warning.startswith(names + ": "), warning)
            for words in ("'material_stiffness K_m'", "collisions", "'material_keep force'", "packings"):
                self.assertIn(words, warning)

    def test_softness_without_consequence_is_no_warning(self):
        for words in (CONTACT + " material_stiffness 800",  # it is the material's
                      CONTACT.replace("restitution 0.9487", "restitution 1"),  # nothing sticks
                      CONTACT.replace("restitution 0.9487", "restitution 0"),  # all stick, stiff or not
                      "stiffness 800 restitution 0.9487"):  # no attraction
            with self.subTest(words):
                output = self.both(words)
                self.assertNotIn("stiffer spring", output)
                self.assertNotIn("of the material", output)
        # 10 m/s, 4000 times the escape velocity.
        fast = script(tail="velocity all set 10 0 0" + MOVE, dt="1e-7")
        self.assertNotIn("stiffer spring", self.goes(fast))

    def test_what_to_keep_must_be_known_and_have_a_stiffness(self):
        style = "pair_style gran/hamaker\npair_coeff * * " + CONTACT
        self.stops(script(style + " material_keep force"), "'material_keep' needs 'material_stiffness K_m'")
        self.stops(script(style + " material_stiffness 80000 material_keep adhesion"),
                   "unknown material_keep 'adhesion'", "velocity, force")
        self.stops(script(f"pair_style gran/hamaker\npair_coeff 1 1 {CONTACT} material_stiffness 80000\n"
                          f"pair_coeff 2 2 {CONTACT} material_stiffness 80000 material_keep force"),
                   "types 1 and 2", "tell the pair what to keep")

    def test_any_form_keeps_its_force(self):
        words = CONTACT + " asperity 1e-7 material_stiffness 80000"
        style = "pair_style gran/hamaker form exact\npair_coeff * * "
        self.stops(script(style + words), "small_gap only", "'material_keep force'")
        self.assertIn("which keeps the pull-off force", self.goes(script(style + words + " material_keep force")))

    def test_what_is_kept_is_in_restart_files(self):
        words = CONTACT + " material_stiffness 80000 material_keep force"
        self.goes(script("pair_style gran/hamaker\npair_coeff * * " + words,
                         MOVE + "write_restart some.restart noinit\n"))
        again = self.goes("plugin load ${plugin}\nunits si\natom_style sphere\nnewton off\n"
                          "read_restart some.restart\ncomm_modify vel yes\nneighbor 1e-4 bin\ntimestep 5e-6" + MOVE)
        self.assertEqual(again.count("which keeps the pull-off force"), 3)

    def test_no_least_number_of_steps_where_there_is_none(self):
        output = self.goes(script("pair_style gran/hamaker scheme sampled\npair_coeff * * " + CONTACT, dt="1e-5"))
        self.assertRegex(output, "sampled scheme should have 15: reduce the time step")
        self.assertNotIn("fewer than", output)

    def test_adhesion_is_scaled_with_the_stiffness_and_says_so(self):
        real = 80000.0  # 100 times that of CONTACT
        output = self.goes(script(f"pair_style gran/hamaker\npair_coeff * * {CONTACT} "
                                  f"material_stiffness {real}"))
        printed = re.search(r"A 5e-19 -> (\S+), H_cut 4e-10 -> (\S+)", output)
        # f = sqrt(800/K_real) = 0.1: A and H_cut grow by 1/f but for the small share of H_out.
        self.assertAlmostEqual(float(printed[1]) / 5e-18, 1, delta=0.05)
        self.assertAlmostEqual(float(printed[2]) / 4e-9, 1, delta=0.05)
        stiff = self.goes(script("pair_style gran/hamaker\npair_coeff * * " +
                                 CONTACT.replace("800", "80000"), dt="5e-7"))
        self.assertAlmostEqual(self.advised(output, "1 - 1")[-2] /
                               self.advised(stiff, "1 - 1")[-2], 1, delta=5e-3)  # v_esc, printed
        self.stops(script("pair_style gran/hamaker form exact\npair_coeff * * " + CONTACT +
                          " material_stiffness 80000"), "small_gap only")


if __name__ == "__main__":
    unittest.main()
