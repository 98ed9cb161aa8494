# SPDX-License-Identifier: BSD-3-Clause
"""fix deform/shear and its companions refuse what would lose particles or shear wrongly, and say why."""
import unittest
from concurrent.futures import ThreadPoolExecutor

from cohesion_tests import lammps as engine
from cohesion_tests.refusals import assert_refused

HEAD = """
plugin load ${plugin}
units lj
atom_style sphere
newton off
boundary %(boundary)s
box tilt large
region box %(region)s units box
create_box 1 box
create_atoms 1 single 2 3 4 units box
create_atoms 1 single 5 3 4 units box
set group all diameter 1.0 density 1.0
group one id 1
neighbor 0.3 bin
timestep %(dt)s
"""
PRISM = "prism 0 10 0 8 0 6 0 0 0"
PAIR = "pair_style gran/hooke/history 800 NULL 5 NULL 0.3 0\npair_coeff * *\n"
SHEAR = "fix shear all deform/shear rate 0.5\n"
MOVE = "fix move all nve/sphere\n"


def head(region=PRISM, boundary="p p p", dt="0.001"):
    return HEAD % {"region": region, "boundary": boundary, "dt": dt}


class Refusals(unittest.TestCase):
    def outputs(self, scripts):
        """Of each script, exit code and output; side by side, a start is mostly waiting."""
        def one(script):
            with engine.temporary_folder() as folder:
                return engine.run_text(script, folder)
        with ThreadPoolExecutor(4) as pool:
            return list(pool.map(one, scripts))

    def stop(self, *cases, begun=False):
        """Cases: a script and the words of its error."""
        for (script, *words), (code, output) in zip(cases, self.outputs([c[0] for c in cases])):
            with self.subTest(words=words):
                assert_refused(self, code, output, *words, begun=begun)

    def go(self, *scripts):
        results = self.outputs(scripts)
        for code, output in results:
            self.assertEqual(code, 0, output)
        return [output for _, output in results]

    def test_the_right_input_is_accepted(self):
        output, thermostat, _ = self.go(
            head() + PAIR + SHEAR + MOVE + "run 5\n",
            head() + PAIR + SHEAR + MOVE + "fix heat all langevin 1 1 1 4711\nrun 1\n",
            head() + PAIR + "comm_modify vel no\n" + SHEAR + MOVE + "run 1\n")
        self.assertNotIn("langevin", output)
        self.assertRegex(thermostat, r"WARNING.*fix heat langevin.*temp/deform")

    def test_words(self):
        fix = head() + PAIR + "fix shear all deform/shear "
        self.stop(
            (fix + "rates 1\n", "fix shear deform/shear", "'rates'", "rate, profile, rebuild"),
            (fix + "profile yes\n", "rate R", "v_name"),
            (fix + "rate\n", "rate takes a value"),
            (fix + "rate nan\n", "nan"),
            (fix + "rate 1 profile maybe\n", "'maybe'", "yes, no"),
            (fix + "rate 1 rebuild never\n", "'never'", "nonaffine, engine"),
            (fix + "rate v_none\n" + MOVE + "run 1\n", "equal-style variable 'none'"),
            (head() + "fix shear one deform/shear rate 1\n", "fix shear", "group must be all, not one"),
            (head() + "compute flow all shear/profile bins 4\n", "layers N"),
            (head() + "compute flow all shear/profile layers 2\n", "layers 2", "at least 3"))

    def test_box(self):
        self.stop(
            (head("block 0 10 0 8 0 6") + SHEAR, "prism", "change_box all triclinic"),
            (head(boundary="f p p") + SHEAR, "x is not"),
            (head(boundary="p f p") + SHEAR, "y is not"),
            (head(boundary="p f p") + "compute flow all shear/profile\n", "periodic"),
            (head("prism 0 10 0 8 0 6 6 0 0") + SHEAR, "tilt xy is 6", "half the length"),
            (head("prism 0 10 0 8 0 6 0 0 2") + SHEAR, "tilt yz is 2", "make it 0"))

    def test_incompatible_fixes(self):
        begin = head() + PAIR + SHEAR
        self.stop(*[(begin + f"fix other all {fix}\n" + MOVE + "run 1\n", *words)
                    for fix, *words in (
                        ("momentum 10 linear 1 1 1", "fix other momentum", "the profile has"),
                        ("press/berendsen z 1 1 1", "fix other press/berendsen", "changes the box"),
                        ("deform 1 xz erate 1", "fix"),
                        ("freeze", "fix other freeze", "whose images move"),
                        ("move linear 1 0 0", "fix other move", "paths"),
                        ("viscous 1", "fix other viscous", "another velocity"),
                        ("deform/shear rate 1", "multiple fixes change box"))],
                  (begin + MOVE + "compute tally all gran/energy\nrun 1\n", "compute tally gran/energy",
                   "fix shear deform/shear", "changes the box"),
                  (begin + "fix other all nvt temp 1 1 1\nrun 1\n", "fix other nvt", "nvt/sllod"),
                  (begin + MOVE + "run_style respa 2 2\nrun 1\n", "run_style verlet"),
                  (head() + "pair_style zero 1.0\npair_coeff * *\n" + SHEAR +
                   "comm_modify vel no\n" + MOVE + "run 1\n", "comm_modify vel no"),
                  (head() + SHEAR + PAIR + MOVE + "run 1\n", "give pair_style first"),
                  (head() + SHEAR + "pair_style gran/hamaker\npair_coeff * * stiffness 800 "
                   "restitution 0.9\n" + MOVE + "run 1\n", "pair_style"))

    def test_step_that_moves_the_images_half_a_box(self):
        self.stop((head(dt="2.0") + "pair_style zero 1.0\npair_coeff * *\n" + SHEAR + MOVE +
                   "run 3\n", "in a step", "smaller time step"), begun=True)


if __name__ == "__main__":
    unittest.main()
