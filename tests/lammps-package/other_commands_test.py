# SPDX-License-Identifier: BSD-3-Clause
"""Commands of LAMMPS that contacts cannot follow stop the run and say what can be used in their place; and that can."""
import unittest

from cohesion_tests import lammps
from cohesion_tests.lammps_scenes.small_box import box, spheres
from cohesion_tests.test_cases import ScriptTestCase
from cohesion_tests.thermo import thermo_columns, thermo_lines

HEAD = box() + spheres((1, 0.005, 0.005, 0.005), (1, 0.006003, 0.005, 0.005)) + """neighbor 2e-4 bin
neigh_modify delay 0 every 1 check yes
timestep 1e-6
group second id 2
velocity second set -0.05 0 0
"""
CONTACT = "stiffness 800 restitution 0.9 "
STYLES = {
    "gran/hamaker": CONTACT + "hamaker 1e-18 cutoff 4e-10 1e-7",
    "gran/hamaker scheme sampled": CONTACT + "hamaker 1e-18 cutoff 4e-10 1e-7",
    "gran/squarewell": CONTACT + "well 1e-11 1.01",
    "gran/liquidbridge scheme sampled": CONTACT + "bridge 1e-5 1e-5",
    "hard/squarewell": "restitution 0.9 well 1e-11 1.01",
}
FRAMES = "dump all all custom 20 all.dump id type x y z vx vy vz\n"


def pair(style):
    return f"pair_style {style}\npair_coeff * * {STYLES[style]}\n"


class Rerun(ScriptTestCase):
    def test_refused(self):
        rerun = "undump all\nrerun all.dump dump x y z vx vy vz\n"
        for style in STYLES:
            with self.subTest(style):
                # After a run, and in a script of its own.
                self.stops(HEAD + pair(style) + "fix move all nve/sphere\n" + FRAMES + "run 100\n" + rerun,
                           "'rerun' reads places and velocities", "'read_dump' and 'run 0'", after_a_run=True)
                self.stops(HEAD + pair(style) + rerun.replace("undump all\n", ""), "'rerun' reads places")
                self.stops(HEAD + pair(style) + "run 0\n" + rerun.replace("undump all\n", "").replace(
                    " dump", " first 40 last 40 dump"), "'rerun' reads places", after_a_run=True)
        self.stops(HEAD + "pair_style none\nfix w all wall/gran/hamaker " + STYLES["gran/hamaker"] +
                   " zplane 0 NULL\n" + rerun.replace("undump all\n", ""), "'rerun' reads places")

    def test_what_is_advised(self):
        """Energy of a frame, from a script of its own: that of the spring and of the well, from the places alone."""
        for style in STYLES:
            with self.subTest(style):
                self.goes(HEAD + pair(style) + "fix move all nve/sphere\n" + FRAMES + "run 100\n")
                output = self.goes(HEAD + pair(style) + "read_dump all.dump 80 x y z vx vy vz\nfix move all nve/sphere\n"
                                   "thermo_style custom step pe\nthermo_modify format float %.17g\nrun 0\n")
                self.assertNotEqual(thermo_columns(output)["PotEng"][0], 0.0)

    def test_attraction_alone(self):
        text = HEAD + "pair_style hamaker\npair_coeff * * hamaker 1e-18 cutoff 4e-10 1e-4\nfix move all nve/sphere\n"
        text += "thermo_style custom step pe\nthermo 20\nthermo_modify format float %.17g\n"
        output = self.goes(text + FRAMES.replace("vz", "vz\ndump_modify all format float %.17g") + "run 100\nundump all\n"
                           "rerun all.dump dump x y z vx vy vz\n")
        names, in_the_run = thermo_lines(output, 0)
        self.assertEqual(in_the_run, thermo_lines(output, 1)[1])
        self.assertLess(in_the_run[-1][names.index("PotEng")], 0.0)


class Rigid(ScriptTestCase):
    def setUp(self):
        super().setUp()
        if "RIGID package" in lammps.run_text(HEAD + "fix body all rigid single\n", self.folder)[1]:
            self.skipTest("this LAMMPS has no fix rigid")

    def test_refused_with_what_goes(self):
        for style in STYLES:
            where = ("pair_style hard" if "hard" in style else "scheme sampled: contacts move each sphere by itself"
                     if "sampled" in style else "scheme exact: contacts move each sphere by itself")
            with self.subTest(style):
                self.stops(HEAD + pair(style) + "fix body all rigid single\nrun 1\n", where, "fix body",
                           *([] if "hard" in style else ["'pair_style hybrid/overlay' and 'pair_style hamaker'"]))

    def test_what_is_advised(self):
        self.goes(HEAD + "pair_style hybrid/overlay gran/hooke/history 800 NULL 0 0 0 0 hamaker\n"
                  "pair_coeff * * gran/hooke/history\npair_coeff * * hamaker hamaker 1e-18 cutoff 4e-10 1e-7\n"
                  "create_atoms 1 single 0.008 0.008 0.008 units box\nset group all diameter 1e-3 density 2650\n"
                  "group body id 1 2\nfix body body rigid single\nrun 10\n")


if __name__ == "__main__":
    unittest.main()
