# SPDX-License-Identifier: BSD-3-Clause
"""coarse_graining.py BUILD_FOLDER: a small version of examples/coarse-graining, a bed of 1000 grains and the same as
parcels; the reading of a curve that is known."""

import math
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np

import analyse
import picture
import run
from cohesion_studies import raised_gas
from cohesion_studies.case_entries import entries
from cohesion_studies.foam_case import environment
from cohesion_studies.job_pool import carry_out
from cohesion_studies.powder_program import PowderProgram
from cohesion_tests.coupling.cases import exchange_lines

SOURCE = Path(__file__).resolve().parents[2]

BUILD = sys.argv.pop(1) if len(sys.argv) > 1 else str(SOURCE / "build")
SMALL = {"--width": 0.012, "--depth": 0.012, "--height": 0.012}
COURSE = {"fastest": 1.2, "ramp": 0.2, "hold": 0.05}


class SmallBed(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.keeper = tempfile.TemporaryDirectory(prefix="cohesion-")
        cls.addClassCleanup(cls.keeper.cleanup)
        env, powder = environment(BUILD, ["lammps"]), PowderProgram(BUILD)
        cls.jobs = [run.bed(Path(cls.keeper.name), env, powder, ratio, 5, SMALL, COURSE)
                    for ratio in (1, 2)]
        cls.results = carry_out(cls.jobs, 2)

    def test_gas_and_spheres_balance(self):
        """Round-off, 2^-53 each, of sums over the spheres in all particle steps of a gas step."""
        for job, result in zip(self.jobs, self.results):
            lines = exchange_lines((job.folder / "log.cohesiveBedFoam").read_text())
            steps = entries(job.folder / "constant/powder")["gasStep"] / entries(job.folder / "constant/grains")["dt"]
            self.assertLess(max(line["imbalance"] for line in lines), result["spheres"] * steps * 2.0**-53)

    def test_a_parcel_is_eight_grains(self):
        grains, parcels = (result["spheres"] for result in self.results)
        # Each number is rounded to a whole one.
        self.assertAlmostEqual(grains, 8 * parcels, delta=4.5)
        texts = [(job.folder / "constant/contacts").read_text() for job in self.jobs]
        self.assertIn("stiffness 100 ", texts[0])
        self.assertIn("stiffness 200 ", texts[1])
        self.assertIn("hamaker 1.6e-18 cutoff 8e-10 2e-07", texts[1])

    def test_the_resting_bed_has_the_drag_of_the_grains(self):
        """The closure at the mean void fraction: the packing is looser at walls, where a layer of a quarter of a sphere
        is empty, a twelfth (l = 1) and a sixth of the width for all four; the gas prefers it, by about U ~ eps^3/(1 -
        eps)^2 of it. Parcels with `coarseGraining 1` have no U_mf: the pressure drop reaches at most 0.449 of the
        weight, and the reading says that the gas has not opened the bed."""
        for result, share in zip(self.results, (1 / 12, 1 / 6)):
            found, known = result["U_mf"], result["U_mf_of_the_closure"]
            self.assertAlmostEqual(found / known, 1, delta=1.5 * share)
        self.assertEqual(picture.draw(Path(self.keeper.name) / "result.png", self.jobs), None)


class Reading(unittest.TestCase):
    def test_line_of_the_resting_bed(self):
        """Through what it was made of, to round-off; what comes after the bed has opened is left out."""
        velocity = np.linspace(0, 1, 400)
        drop = np.where(velocity < 0.75, 0.9 * velocity + 0.5 * velocity**2, 1.0)
        a, b = raised_gas.resting_line(velocity, drop)
        self.assertAlmostEqual(a, 0.9, delta=1e-12)
        self.assertAlmostEqual(b, 0.5, delta=1e-12)

    def test_changes_have_their_standard_error(self):
        kinds = {"l 1": [{"U_mf": 1.0}, {"U_mf": 1.2}], "l 2": [{"U_mf": 1.5}, {"U_mf": 1.5}]}
        self.assertEqual(analyse.change("U_mf", kinds["l 1"], kinds["l 2"]), f"+0.4 +- {0.1:.1g}")
        self.assertTrue(math.isclose(0.1, np.std([1.0, 1.2], ddof=1) / math.sqrt(2)))


if __name__ == "__main__":
    unittest.main()
