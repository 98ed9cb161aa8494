# SPDX-License-Identifier: BSD-3-Clause
"""Input of pair_style gran/hamaker and fix wall/gran/hamaker: what is refused and why, the advice
before the first step, the scaling of adhesion with the stiffness."""
import math
import re
import unittest

from script_test_case import ScriptTestCase

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
                ("stiffness 800 cutoff 4e-10", ("takes 2",))):
            with self.subTest(words):
                self.stops(script(style + words), *expected)

    def test_unknown_scheme_and_form_list_the_valid_ones(self):
        self.stops(script("pair_style gran/hamaker scheme exact"), "exact", "event", "sampled")
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
        self.stops(script(pair % "event", dt=f"{contact_time / 0.9:.6g}"), "a contact takes 0.9")
        output = self.goes(script(pair % "event", dt=f"{contact_time / 3:.6g}"))
        self.assertRegex(output, "WARNING.*a contact takes 3")
        self.stops(script(pair % "sampled", dt=f"{contact_time / 1.5:.6g}"), "unstable")
        output = self.goes(script(pair % "sampled"))
        self.assertRegex(output, "WARNING.*left to chance")

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
