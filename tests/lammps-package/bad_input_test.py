# SPDX-License-Identifier: BSD-3-Clause
"""Every wrong input ends in an error that says what, where and what would be right."""
import os
import unittest

from cohesion_tests import lammps
from cohesion_tests.lammps_scenes.two_at_rest import PAIR, POINTS, SPHERES, TAIL
from cohesion_tests.test_cases import ScriptTestCase


class BadInput(ScriptTestCase):
    def test_the_right_input_is_accepted(self):
        self.goes(SPHERES + PAIR + "fix wall all wall/hamaker hamaker 1e-19 cutoff 4e-10 1e-7 xplane 0 NULL\n"
                  "fix gas all gas/coupling\n" + TAIL)

    # The Hamaker constant
    def test_pair_constant(self):
        for value, shown in (("-1e-19", "A = -1e-19"), ("1e400", "1e400"), ("nan", "nan"),
                             ("inf", "inf"), ("abc", "abc")):
            with self.subTest(value):
                self.stops(SPHERES + "pair_style hamaker cutoff 4e-10 1e-7\npair_coeff 1 2 hamaker " + value +
                           TAIL, *([shown] if value != "1e400" else []))

    def test_pair_constant_message_names_place_and_remedy(self):
        self.stops(SPHERES + "pair_style hamaker cutoff 4e-10 1e-7\npair_coeff 1 2 hamaker -1e-19" + TAIL,
                   "pair_coeff 1 2", "hamaker", "A = -1e-19", "not below zero")

    def test_wall_constant(self):
        for value in ("-1e-19", "1e400", "nan", "inf"):
            with self.subTest(value):
                self.stops(SPHERES + PAIR + f"fix wall all wall/hamaker hamaker {value} cutoff 4e-10 1e-7 "
                           "xplane 0 NULL" + TAIL)
        self.stops(SPHERES + PAIR + "fix wall all wall/hamaker hamaker -1e-19 cutoff 4e-10 1e-7 xplane 0 NULL" +
                   TAIL, "fix wall wall/hamaker", "A = -1e-19", "not below zero")

    # The cut-offs
    def test_pair_cutoffs(self):
        for cut, out, words in (
                ("0", "1e-7", ["H_cut = 0", "greater than zero"]),
                ("-4e-10", "1e-7", ["H_cut = -4e-10", "greater than zero"]),
                ("nan", "1e-7", ["nan"]), ("1e400", "1e-7", []), ("4e-10", "inf", ["inf"]),
                ("4e-10", "1e400", []),
                ("1e-7", "1e-7", ["H_cut = 1e-07", "smaller than the outer cut-off"]),
                ("2e-7", "1e-7", ["H_cut = 2e-07", "smaller than the outer cut-off"])):
            with self.subTest(cut=cut, out=out, where="pair_style"):
                self.stops(SPHERES + f"pair_style hamaker cutoff {cut} {out}\npair_coeff * * hamaker 1e-19" +
                           TAIL, *words)
            with self.subTest(cut=cut, out=out, where="pair_coeff"):
                self.stops(SPHERES + "pair_style hamaker cutoff 4e-10 1e-7\npair_coeff * * hamaker 1e-19 "
                           f"cutoff {cut} {out}" + TAIL, *words)
            with self.subTest(cut=cut, out=out, where="wall"):
                self.stops(SPHERES + PAIR + f"fix wall all wall/hamaker hamaker 1e-19 cutoff {cut} {out} "
                           "xplane 0 NULL" + TAIL, *words)

    def test_outer_cutoff_beyond_the_neighbour_range(self):
        # Particles of twice the size that the neighbour range was made for.
        growing = SPHERES.replace("atom_style sphere", "atom_style sphere 1")
        self.stops(growing + PAIR + "variable d equal 1e-3*(1+step/10)\n"
                   "fix grow all adapt 1 atom diameter v_d\n"
                   "neigh_modify delay 0 every 1 check no\nfix move all nve\nrun 10\n",
                   "pair_style hamaker", "beyond the neighbour range", "type 1", "had at most",
                   "start a new one", after_a_run=True)

    def test_constant_that_is_raised_where_pairs_have_no_list(self):
        none = SPHERES + PAIR.replace("1e-19", "0") + "fix move all nve\n"
        self.goes(none + 'run 1\nrun 4 every 2 "pair_coeff * * hamaker 1e-19"\n')
        self.stops(none + 'run 1\nrun 4 pre no every 2 "pair_coeff * * hamaker 1e-19"\n', "pair_style hamaker",
                   "an A was raised", "without fix adapt", "before the run", after_a_run=True)

    def test_time_step(self):
        """Contacts and events act over the length of a step; in the first run and in a later one."""
        contact = "stiffness 800 restitution 0.9"
        head = SPHERES.replace("newton off", "newton off\ncomm_modify vel yes")
        wall = "fix w all wall/gran/hamaker " + contact + " hamaker 1e-19 cutoff 4e-10 1e-7 xplane 0 NULL\n"
        for style, coefficients, others, says in (
                ("gran/hamaker", contact + " hamaker 1e-19 cutoff 4e-10 1e-7", "", "pair_style gran/hamaker"),
                ("gran/hamaker scheme sampled", contact, "", "pair_style gran/hamaker"),
                ("gran/squarewell", contact + " well 1e-11 1.1", "", "pair_style gran/squarewell"),
                ("hard/squarewell", "restitution 0.9 well 1e-11 1.1", "", "pair_style hard/squarewell"),
                ("zero 1e-3", "", wall, "fix w wall/gran/hamaker")):
            start = f"{head}pair_style {style}\npair_coeff * * {coefficients}\n{others}fix move all nve/sphere\n"
            for step in ("0", "-1e-7"):
                with self.subTest(style, step=step):
                    said = (says, f"timestep {float(step):g}: give a time step above 0")
                    self.stops(start + f"timestep {step}\nrun 1\n", *said)
                    self.stops(start + f"run 1\ntimestep {step}\nrun 1\n", *said, after_a_run=True)

    def test_coefficients_that_no_set_up_takes(self):
        contact = "stiffness 800 restitution 0.9"
        for style, first, then in (
                ("hamaker cutoff 4e-10 1e-7", "hamaker 1e-19", "hamaker 2e-19"),
                ("squarewell", "well 0 1.1", "well 1e-11 1.1"),
                ("gran/hamaker", contact, contact + " hamaker 1e-19 cutoff 4e-10 1e-7"),
                ("gran/squarewell", contact, contact + " well 1e-11 1.1"),
                ("hard/squarewell", "restitution 0.9", "restitution 0.9 well 1e-11 1.1")):
            begun = (SPHERES.replace("newton off", "newton off\ncomm_modify vel yes") + f"pair_style {style}\n"
                     f"pair_coeff * * {first}\nfix move all nve/sphere\nrun 1\n")
            change = f"pair_coeff * * {then}"
            said = ("pair_style " + style.split()[0], "pair_coeff was given after", "leave out 'pre no'")
            with self.subTest(style):
                self.goes(begun + f'run 4 every 2 "{change}"\n')
                self.goes(begun + 'run 4 pre no every 2 "print next"\n')
                self.stops(begun + f'run 4 pre no every 2 "{change}"\n', *said, after_a_run=True)
                self.stops(begun + change + "\nrun 4 pre no\n", *said, after_a_run=True)

    def test_pour_of_larger_particles_is_within_the_neighbour_range(self):
        output = self.goes(
            SPHERES.replace("boundary f f p", "boundary p p f").replace("0 0.01 units", "0 0.04 units")
            .replace("comm_modify", "#") + PAIR +
            "region up block 0.001 0.009 0.001 0.009 0.02 0.038 units box\n"
            "group all_of_them type 1 2\nfix fall all gravity 9.81 vector 0 0 -1\n"
            "fix pour all pour 5 1 4711 region up diam one 2e-3 dens 2650 2650\n"
            "fix floor all wall/reflect zlo EDGE\n"
            "neigh_modify delay 0 every 1 check no\nfix move all nve/sphere\nrun 3\n"
            "variable n equal atoms\nprint \"particles ${n}\"\n")
        self.assertIn("particles 7", output)

    # What else is missing or wrong
    def test_pair_arguments(self):
        self.stops(SPHERES + "pair_style hamaker cutoff 4e-10\n", "needs 'cutoff H_cut H_out': H_out is missing")
        self.stops(SPHERES + "pair_style hamaker cutoff 4e-10 1e-7\npair_coeff * *\n", "i j hamaker A")
        self.stops(SPHERES + "pair_style hamaker cutoff 4e-10 1e-7\npair_coeff * * hamaker 1e-19 cutoff 4e-10\n",
                   "needs 'cutoff H_cut H_out': H_out is missing")

    def test_no_coefficients_to_mix(self):
        self.stops(SPHERES + "pair_style hamaker cutoff 4e-10 1e-7\npair_coeff 1 1 hamaker 1e-19\n" + TAIL)

    def test_atoms_without_radii(self):
        self.stops(POINTS + PAIR + TAIL, "pair_style hamaker", "atom_style sphere")
        self.stops(POINTS + "pair_style none\nfix wall all wall/hamaker hamaker 1e-19 cutoff 4e-10 1e-7 xplane 0 "
                   "NULL" + TAIL, "fix wall/hamaker", "atom_style sphere")
        self.stops(POINTS + "pair_style none\nfix gas all gas/coupling" + TAIL, "fix gas/coupling",
                   "atom_style sphere")

    def test_wall_planes(self):
        wall = SPHERES + PAIR + "fix wall all wall/hamaker hamaker 1e-19 cutoff 4e-10 1e-7"
        self.stops(wall, "hamaker A cutoff H_cut H_out", "xplane lo hi")
        self.stops(wall + " cylinder 0 1", "'cylinder'", "xplane, yplane, zplane")
        self.stops(wall + " xplane 0 NULL yplane 0", "yplane takes two positions")
        self.stops(wall + " zplane 0 NULL", "no zplane in a periodic direction", "boundary f")
        self.stops(wall + " xplane nan NULL", "nan")
        self.stops(wall + " xplane 1e400 NULL", "1e400")
        self.stops(wall + " xplane NULL NULL", "xplane NULL NULL is no wall")
        self.stops(wall + " xplane 0.01 0", "xplane", "below")

    @unittest.skipUnless("lmp-cohesion" in os.environ["COHESION_LMP"], "another engine's own launcher")
    def test_an_error_of_one_rank_reaches_a_file(self):
        """One that the engine reports by the rank alone, which ends at once; a pipe is buffered as a file is."""
        text = "\n".join(["units lj", "atom_style sphere", "region box block 0 10 0 10 0 10", "create_box 1 box",
                          *(f"create_atoms 1 single {1 + 1.1 * k} 5 5" for k in range(4)), "set group all diameter 1",
                          "neigh_modify delay 0 one 1 page 10", "pair_style zero 3", "pair_coeff * *", "run 0"])
        with lammps.temporary_folder() as folder:
            code, output = lammps.run_text(text + "\n", folder)
        self.assertNotEqual(code, 0)
        self.assertIn("Neighbor list overflow", output)

    def test_gas_coupling_takes_no_values(self):
        self.stops(SPHERES + PAIR + "fix gas all gas/coupling 1\n", "fix ID group gas/coupling")

    def test_force_that_the_gas_coupling_cannot_see_is_named(self):
        output = self.goes(SPHERES + PAIR + "fix gas all gas/coupling\n"
                           "fix late all gravity 9.81 vector 0 -1 0" + TAIL)
        self.assertRegex(output, r"WARNING.*gas/coupling stands before fix late gravity")
        output = self.goes(SPHERES + PAIR + "fix late all gravity 9.81 vector 0 -1 0\n"
                           "fix gas all gas/coupling" + TAIL)
        self.assertNotIn("stands before", output)


if __name__ == "__main__":
    unittest.main()
