# SPDX-License-Identifier: BSD-3-Clause
"""bed_mechanisms.py BUILD_FOLDER: cohesion in the bed of examples/fluidised-bed between particles, at the
side walls and at the plate, each switched by a variable of the case; LAMMPS alone, before the gas."""

import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SOURCE = Path(__file__).resolve().parents[2]
CASE = SOURCE / "examples/fluidised-bed/case"
MECHANISMS = ("particles", "side", "plate")
BUILD = Path(sys.argv.pop(1) if len(sys.argv) > 1 else SOURCE / "build").resolve()

# After 0.03 s of settling: energies of the attraction [J], none without such a fix; forces [N].
LOOK = """
thermo_style custom step pe v_carried
run 0
variable particles equal pe
variable side string none
variable plate string none
if "$(is_defined(fix,side_adhesion))" then "variable side delete" "variable side equal f_side_adhesion"
if "$(is_defined(fix,plate_adhesion))" then "variable plate delete" "variable plate equal f_plate_adhesion"
variable walls equal c_carried[1]+c_carried[2]
variable pulled equal v_carried-v_walls
variable total equal v_side_pull+v_plate_pull
print "found particles ${particles} side ${side} plate ${plate} pulled ${pulled} pull ${total}"
"""


def bed(A=7.49e-19, **variables):
    """The line of LOOK, by name."""
    with tempfile.TemporaryDirectory(prefix="cohesion-") as folder:
        script = Path(folder) / "in.look"
        script.write_text(f"include {CASE / 'bed.lmp'}\n{LOOK}")
        command = [BUILD / "lammps/stock/lmp-cohesion", "-in", script, "-log", "none"]
        given = {"plugin": BUILD / "lammps/stock/cohesionplugin.so", "A": A, "dt": 1.125e-5,
                 "settle": 0.03, "node": 3.333e-3, **variables}
        for name, value in given.items():
            command += ["-var", name, value]
        done = subprocess.run([str(word) for word in command], cwd=folder, capture_output=True, text=True)
    if done.returncode != 0:
        raise RuntimeError(done.stdout[-2000:])
    words = re.search(r"^found (.*)$", done.stdout, re.M)[1].split()
    return {name: value if value == "none" else float(value)
            for name, value in zip(words[::2], words[1::2])}


class Mechanisms(unittest.TestCase):
    def check(self, found, particles, side, plate):
        self.assertEqual(found["particles"] < 0, particles, found)
        for name, on in (("side", side), ("plate", plate)):
            self.assertEqual(found[name] != "none" and found[name] < 0, on, found)
            self.assertEqual(found[name] == "none", not on, found)
        # A sum of wall forces of some 0.05 N, with six digits printed.
        self.assertAlmostEqual(found["pulled"], found["pull"], delta=1e-7)
        # The plate pulls down.
        self.assertEqual(found["pull"] < 0, plate, found)

    def test_each_by_itself(self):
        for given in ((1, 1, 1), (0, 1, 1), (1, 0, 1), (1, 1, 0), (0, 0, 0)):
            with self.subTest(given):
                # What is not said is on.
                off = {f"cohesion_{name}": 0 for name, on in zip(MECHANISMS, given) if not on}
                self.check(bed(**off), *map(bool, given))

    def test_words_for_on_and_off(self):
        self.check(bed(cohesion_plate="off", cohesion_particles="on"), True, True, False)
        with self.assertRaisesRegex(RuntimeError, "ERROR.*formula"):
            bed(cohesion_side="perhaps")

    def test_case_has_them_all(self):
        text = (CASE / "constant/couplingProperties").read_text()
        for name in MECHANISMS:
            self.assertRegex(text, rf"\n\s+cohesion_{name}\s+1;")


if __name__ == "__main__":
    unittest.main()
