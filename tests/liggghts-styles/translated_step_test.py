# SPDX-License-Identifier: BSD-3-Clause
"""A script that cohesion-translate writes stops with a time step above the one that the program names, and neither
stops nor warns of the step with this one, while grains that fall through the box reach its floor."""
import re
import tempfile
import unittest
from pathlib import Path

from cohesion_studies import thermo
from cohesion_tests.csv_program import CsvProgram
from cohesion_tests.liggghts import Run

program = CsvProgram("COHESION_TRANSLATE")
#: Of the fall, in which grains meet each other and the floor [s].
DURATION, RUNS = 0.025, 10
#: Restitution, rolling model, and the step above which runs stop over the one that the program names. The program
#: assumes a rolling dashpot of eta_t, which epsd2 lacks in a run. With s = 25 and d = 25, without it d = 20, the limit
#: is the root of s K_t dt^2 + 2 d eta_t dt = 4 mu (closest_packing.h): at the largest overlap of 1.34 m/s, 2.23e-6 s
#: and 2.68e-6 s. cdt has no spring of rolling.
CASES = (0.5, "cdt", 1.0), (0.3, "epsd2", 1.2)
SCRIPT = """units si
atom_style granular
atom_modify map array
boundary f f f
newton off
communicate single vel yes
region box block -3e-3 3e-3 -3e-3 3e-3 0 0.04 units box
create_box 2 box
neighbor 5e-4 bin
neigh_modify delay 0
variable model string "model hertz tangential history cohesion sjkr rolling_friction {rolling}"
fix E all property/global youngsModulus peratomtype 2e7 2e7
fix nu all property/global poissonsRatio peratomtype 0.25 0.25
fix e all property/global coefficientRestitution peratomtypepair 2{restitution}
fix mu all property/global coefficientFriction peratomtypepair 2 0.5 0.5 0.5 0.5
fix mr all property/global coefficientRollingFriction peratomtypepair 2 0.1 0.1 0.1 0.1
fix k all property/global cohesionEnergyDensity peratomtypepair 2 2e5 2e5 2e5 0
pair_style gran ${{model}}
pair_coeff * *
fix floor all wall/gran ${{model}} primitive type 2 zplane 0
fix sides all wall/gran ${{model}} primitive type 2 zcylinder 3e-3 0 0
fix weight all gravity 9.81 vector 0 0 -1
fix template all particletemplate/sphere 15485863 atom_type 1 density constant 2500 radius constant 5e-4
fix beads all particledistribution/discrete 15485867 1 template 1
region fill cylinder z 0 0 2.5e-3 0.02 0.039 units box
fix pour all insert/pack seed 32452843 distributiontemplate beads vel constant 0 0 -1 &
   insert_every once overlapcheck yes all_in yes volumefraction_region 0.2 region fill
fix move all nve/sphere
compute down all reduce min vz
thermo_style custom step atoms c_down
thermo 100
timestep {step}
run 1
"""


class TranslatedStep(unittest.TestCase):
    def written(self, step, law, friction):
        """The script that is written for this time step, and the step that the program names; none: 0."""
        script = SCRIPT.format(step=step, **friction) + f"run {int(DURATION / RUNS / step)}\n" * RUNS
        with tempfile.TemporaryDirectory() as name:
            source, target = Path(name) / "in.case", Path(name) / "out.case"
            source.write_text(script)
            code, _, error = program.call(source, "--write", "equal-force", target, "--law", law)
            self.assertEqual(code, 0, error)
            text = target.read_text()
        named, of_report = (re.findall(r"time step \S+ is longer than advised for the exact scheme \(.*\): "
                                       r"use a timestep of at most (\S+)", place) for place in (text, error))
        self.assertEqual(named, of_report)
        return text, float(named[0]) if named else 0.0

    def test_the_step_that_is_named_does(self):
        for law in ("hamaker", "jkr"):
            for restitution, rolling, limit in CASES:
                friction = {"restitution": 4 * f" {restitution}", "rolling": rolling}
                with self.subTest(law=law, **friction):
                    _, step = self.written(1e-4, law, friction)
                    text, named = self.written(1.05 * limit * step, law, friction)
                    self.assertEqual(named, step)
                    run = Run(text)
                    self.assertNotEqual(run.code, 0)
                    self.assertIn("makes particles with several contacts unstable", run.output)
                    text, named = self.written(step, law, friction)
                    self.assertEqual(named, 0.0)
                    run = Run(text)
                    self.assertEqual(run.code, 0, run.output[-3000:])
                    for of_step in ("unstable", "time steps, the exact scheme should have"):
                        self.assertNotIn(of_step, run.output)
                    # 1 m/s at insertion, and nearly 40 mm of fall.
                    down = [float(line[2]) for names, lines in thermo.runs(run.output) for line in lines]
                    self.assertLess(min(down), -1.2)


if __name__ == "__main__":
    unittest.main()
