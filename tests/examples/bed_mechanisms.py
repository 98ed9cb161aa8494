# SPDX-License-Identifier: BSD-3-Clause
"""bed_mechanisms.py BUILD_FOLDER: cohesion in the bed of examples/fluidised-bed between particles, at the
side walls and at the plate, each switched by a variable of the case; LAMMPS alone, before the gas."""

import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np

SOURCE = Path(__file__).resolve().parents[2]
CASE = SOURCE / "examples/fluidised-bed/case"
MECHANISMS = ("particles", "side", "plate")
BUILD = Path(sys.argv.pop(1) if len(sys.argv) > 1 else SOURCE / "build").resolve()

# After 0.03 s of settling: energies of the attraction [J], none without such a fix; forces [N].
LOOK = """
compute thermo_pe all pe
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

# Energy of the wells [J], a few steps later. Then the places and velocities.
LOOK_AT_WELLS = """
compute tally all gran/energy
thermo_style custom step c_tally[5]
run 10
variable held equal c_tally[5]
print "found held ${held} plate_pull ${plate_pull}"
write_dump all custom places id x y vx vy modify format float %.17g
"""
STEP = 1.5e-5  # [s]
DEPTH, RATIO, DIAMETER, WIDTH = 5e-11, 1.02, 1e-3, 0.02


def bed(look=LOOK, A=7.49e-19, **variables):
    """The line of the LOOK, by name, and the table that it dumps as "places"."""
    with tempfile.TemporaryDirectory(prefix="cohesion-") as folder:
        script = Path(folder) / "in.look"
        script.write_text(f"include {CASE / 'bed.lmp'}\n{look}")
        command = [BUILD / "lammps/stock/lmp-cohesion", "-in", script, "-log", "none"]
        given = {"plugin": BUILD / "lammps/stock/cohesionplugin.so", "A": A, "dt": 1.125e-5,
                 "settle": 0.03, "node": 3.333e-3, "width": WIDTH, **variables}
        for name, value in given.items():
            command += ["-var", name, value]
        done = subprocess.run([str(word) for word in command], cwd=folder, capture_output=True, text=True)
        dump = Path(folder) / "places"
        places = np.loadtxt(dump, skiprows=9) if dump.exists() else None
    if done.returncode != 0:
        raise RuntimeError(done.stdout[-2000:])
    words = re.search(r"^found (.*)$", done.stdout, re.M)[1].split()
    return {"places": places, **{name: value if value == "none" else float(value)
                                 for name, value in zip(words[::2], words[1::2])}}


def within_edges(places):
    """{mechanism: (for sure, perhaps)}: how many of its pairs are nearer than the edge of their well, all the time
    from one step before `places` to one after it on straight ways, or at some time of these."""
    at = places[:, 1:3]
    near = [(i, i + 1 + j) for i in range(len(at) - 1)
            for j in np.flatnonzero(np.hypot(*(at[i + 1:] - at[i]).T) < 1.2 * DIAMETER)]
    i, j = np.array(near).T
    inside = {name: [] for name in MECHANISMS}
    for steps in (-1, -0.5, 0, 0.5, 1):
        x, y = (at + steps * STEP * places[:, 3:]).T
        inside["particles"].append(np.hypot(x[i] - x[j], y[i] - y[j]) < RATIO * DIAMETER)
        inside["side"].append(np.minimum(x, WIDTH - x) < RATIO * DIAMETER / 2)
        inside["plate"].append(y < RATIO * DIAMETER / 2)
    return {name: (np.all(found, axis=0).sum(), np.any(found, axis=0).sum()) for name, found in inside.items()}


class Mechanisms(unittest.TestCase):
    def check(self, found, particles, side, plate):
        self.assertEqual(found["particles"] < 0, particles, found)
        for name, on in (("side", side), ("plate", plate)):
            self.assertEqual(found[name] != "none" and found[name] < 0, on, found)
            self.assertEqual(found[name] == "none", not on, found)
        # A sum of wall forces of some 0.01 N, with six digits printed.
        self.assertAlmostEqual(found["pulled"], found["pull"], delta=2e-8)
        # The plate pulls down.
        self.assertEqual(found["pull"] < 0, plate, found)

    def test_each_by_itself(self):
        for given in ((1, 1, 1), (0, 1, 1), (1, 0, 1), (1, 1, 0), (0, 0, 0)):
            with self.subTest(given):
                # What is not said is on.
                off = {f"cohesion_{name}": 0 for name, on in zip(MECHANISMS, given) if not on}
                self.check(bed(scheme="sampled", **off), *map(bool, given))

    def test_square_wells_each_by_itself(self):
        """The energy is D for each pair of particles that is nearer than the edge of its well and 2 D for each particle
        that is nearer to a wall than the edge of its. The tally is some half a step away from the places."""
        # It takes longer until particles come to the side walls.
        for scheme, given, settle in (("exact", (1, 0, 0), 0.02), ("exact", (0, 1, 0), 0.04),
                                      ("exact", (0, 0, 1), 0.02), ("exact", (0, 0, 0), 0.02),
                                      ("sampled", (1, 1, 1), 0.02)):
            with self.subTest(scheme=scheme, given=given):
                off = {f"cohesion_{name}": 0 for name, on in zip(MECHANISMS, given) if not on}
                found = bed(LOOK_AT_WELLS, A=0, law="square_well", D=DEPTH, ratio=RATIO, scheme=scheme, dt=STEP,
                            settle=settle, **off)
                pairs = within_edges(found["places"])
                least, most = (sum(on * (1 if name == "particles" else 2) * pairs[name][k]
                                   for name, on in zip(MECHANISMS, given)) for k in (0, 1))
                held = -found["held"] / DEPTH
                # Round-off of a sum of some thousand.
                self.assertLess(abs(held - round(held)), 1e-9)
                self.assertLessEqual(least, round(held))
                self.assertLessEqual(round(held), most)
                self.assertEqual(held > 0, any(given))
                if not given[2]:
                    self.assertEqual(found["plate_pull"], 0)

    def test_refuses_a_strength_of_the_other_law(self):
        for says, given in (("A is 7.49e-19, of law hamaker", {"law": "square_well"}),
                            ("D is 5e-11, of law square_well", {"A": 0, "D": 5e-11}),
                            ("law is well; there are hamaker and square_well", {"law": "well"})):
            with self.assertRaisesRegex(RuntimeError, f"ERROR: bed.lmp: {says}"):
                bed(**given)

    def test_words_for_on_and_off(self):
        self.check(bed(scheme="sampled", cohesion_plate="off", cohesion_particles="on"), True, True, False)
        with self.assertRaisesRegex(RuntimeError, "ERROR.*formula"):
            bed(cohesion_side="perhaps")

    def test_case_has_them_all(self):
        text = (CASE / "constant/couplingProperties").read_text()
        for name in MECHANISMS:
            self.assertRegex(text, rf"\n\s+cohesion_{name}\s+1;")


if __name__ == "__main__":
    unittest.main()
