# SPDX-License-Identifier: BSD-3-Clause
"""geldart_a_grains.py BUILD_FOLDER: a small version of examples/geldart-a-two-fluid with parcels, coarse ones in coarse
cells for a tenth of a second; what parcels of another size have."""

import math
import sys
import tempfile
import unittest
from pathlib import Path

import analyse
import grains
import picture
from cohesion_studies import case_entries, expected

SOURCE = Path(__file__).resolve().parents[2]
BUILD = sys.argv.pop(1) if len(sys.argv) > 1 else str(SOURCE / "build")
RATIO, CELLS, END = 60, 10, 0.1  # parcels of 4.5 mm in cells of 15 mm
OF_CASE = case_entries.entries(grains.CASE / analyse.BED)


class OtherParcels(unittest.TestCase):
    def test_the_slab_holds_the_same_mass_for_its_depth(self):
        for ratio in (20, 30, 45, 60):
            of = grains.of_ratio(OF_CASE, ratio)
            solid = 8 * of["across"] * of["up"] * math.pi / 6 * of["parcel"]**3
            held = OF_CASE["solid"] * OF_CASE["width"] * OF_CASE["rest"] * of["depth"]
            self.assertAlmostEqual(solid / held, 1, delta=1e-12)
            # As deep over a parcel, but for whole lattice cells: half of one in 17 and in 20
            self.assertAlmostEqual(of["depth"] / of["parcel"] / (OF_CASE["depth"] / OF_CASE["parcel"]), 1, delta=0.06)

    def test_a_contact_lasts_as_many_steps(self):
        """t_c ~ sqrt(m/K) ~ l, and the step of the gas is a whole number of the parcels'."""
        for ratio in (20, 30, 45, 60):
            of = grains.of_ratio(OF_CASE, ratio)
            longer = math.sqrt((ratio / 30)**3 / (of["stiffness"] / OF_CASE["stiffness"]))
            self.assertAlmostEqual(longer, ratio / 30, delta=1e-12)
            self.assertLessEqual(of["dt"], OF_CASE["dt"] * longer * (1 + 1e-9))
            self.assertAlmostEqual(OF_CASE["step"] / of["dt"] % 1, 0, delta=1e-9)

    def test_the_case_is_that_of_its_own_ratio(self):
        for name, value in grains.of_ratio(OF_CASE, OF_CASE["ratio"]).items():
            self.assertAlmostEqual(value / OF_CASE[name], 1, delta=1e-4, msg=name)


class SmallBed(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.keeper = tempfile.TemporaryDirectory(prefix="cohesion-")
        cls.addClassCleanup(cls.keeper.cleanup)
        env = grains.environment(BUILD, ["lammps"])
        changed = {"columns": CELLS, "rows": 27, "height": 0.405}  # whole cells of 15 mm
        cls.job = grains.GrainBed(Path(cls.keeper.name), env, "", "slow-n9.6", RATIO, END, changed)
        cls.result = grains.carry_out([cls.job], 1)[0]

    def test_solid_is_that_of_the_bed(self):
        """In the field that the gas sees; the parcels' shares of cells are exact, the field has 8 digits."""
        for solid in analyse.fractions(self.job.folder)[1]:
            self.assertAlmostEqual(solid.mean() * 0.405 / (0.6 * 0.15), 1, delta=1e-6)

    def test_it_starts_loose(self):
        """At a fraction of 0.5 where the rest has 0.6: 0.2 higher. In 0.1 s gas of 9 mm/s moves it by 0.9 mm, 0.006 of
        its height; its centre of mass among 2720 parcels at random places scatters by less than 0.52/sqrt(12 * 2720) of
        its height, 0.003, times 2; three of these. Twice the height of the centre of mass is read in cells."""
        times, expanded = analyse.expansion(self.job.folder)
        self.assertEqual(len(times), round(END / 0.05))
        self.assertAlmostEqual(expanded[0], 0.2, delta=0.006 + 3 * 0.006)

    def test_slow_gas_carries_the_bed(self):
        """Drag of the exponent 9.6 takes the parcels to the gas within milliseconds; what they are faster by from 0.05 to
        0.1 s is less than the 9 mm/s of the gas: 0.18 m/s2, 0.018 of their weight, and the gas weighs 0.004 of it."""
        times, drop = analyse.pressure(self.job.folder)
        self.assertAlmostEqual(drop[times > END / 2].mean(), 1, delta=0.025)

    def test_picture_and_expectations(self):
        file = Path(self.keeper.name) / "grains.png"
        picture.draw(file, [self.job.folder], END)
        self.assertGreater(file.stat().st_size, 10000)
        self.assertTrue(all(row["case"].removeprefix("grains-") in grains.BEDS for row in expected.rows(grains.EXPECTED)))

    def test_fluids_that_are_not_there(self):
        self.assertEqual(grains.fluids(Path(self.keeper.name), "slow-n9.6", END), [])


if __name__ == "__main__":
    unittest.main()
