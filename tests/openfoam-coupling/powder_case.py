# SPDX-License-Identifier: BSD-3-Clause
"""A case as cohesion-powder writes it runs unedited to its end, of one size and of a distribution, and the gas carries
the bed."""

import os
import re
import subprocess
import unittest
from pathlib import Path

import numpy as np

from cohesion_studies.foam_case import environment
from cohesion_tests import powder as program
from cohesion_tests.coupling.cases import exchange_lines
from cohesion_tests.coupling.fields import numbers
from cohesion_tests.coupling.test_case import CoupledTestCase

G = 9.81
BUILD, WORK = os.environ["COHESION_BUILD"], Path(os.environ["COHESION_WORK"])
BED = ("--density", 2500, "--stiffness", 100, "--hamaker", 6.5e-20, "--width", 0.05, "--depth", 0.05, "--height", 0.08,
       "--grains", 700)


def rise(case, time):
    """Mean vertical velocity of the grains, by mass [m/s]."""
    cloud = sorted(case.glob("[0-9]*.[0-9]*"), key=lambda folder: abs(float(folder.name) - float(time)))[0]
    cloud /= "lagrangian/particles"
    speeds = numbers(cloud / "U", 3)[:, 2]
    # Equal ones are written as one number.
    equal = re.search(r"\n\d+\{", (cloud / "radius").read_text())
    return np.average(speeds, weights=None if equal else numbers(cloud / "radius", 1)[:, 0] ** 3)


class PowderCase(CoupledTestCase):
    def check(self, name, *sizes):
        case = WORK / name
        subprocess.run(["rm", "-rf", str(case)], check=True)
        code, _, said = program.call("--diameter", *sizes, *BED, "--write", case)
        self.expect_equal(f"{name}: code of cohesion-powder", code, 0)
        self.expect_true(f"{name}: it says what it wrote: {said}", "wrote a case" in said)
        done = subprocess.run(["./Allrun"], cwd=case, env=environment(BUILD), capture_output=True, text=True)
        self.expect_equal(f"{name}: code of Allrun\n{done.stdout[-2000:]}", done.returncode, 0)
        lines = exchange_lines((case / "log.cohesiveBedFoam").read_text())
        self.expect_below(f"{name}: imbalance of momentum [1]", max(line["imbalance"] for line in lines), 1e-10)
        # The gas carries the bed, and what that gains of momentum meanwhile. Walls and plate take a part, and what is
        # below the lowest node of the pressure is not in it: a tenth, of a bed as high as wide.
        table = np.loadtxt(case / "postProcessing/drop/0/bedPressureDrop.dat")
        carried = table[table[:, 0] > 0.05, -1].mean()
        gained = (rise(case, "0.1") - rise(case, "0.05")) / (G * 0.05)
        self.expect_near(f"{name}: pressure drop over weight, of which {gained:.3f} for its motion [1]", carried,
                         1 + gained, 0.1)

    def test_one_size(self):
        self.check("one", 5e-4)

    def test_two_sizes(self):
        self.check("two", 4e-4, 6e-4)


if __name__ == "__main__":
    unittest.main()
