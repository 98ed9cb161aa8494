# SPDX-License-Identifier: BSD-3-Clause
"""filtered_drag.py BUILD_FOLDER: boxes of examples/filtered-drag, of one cell with and without the filter against closed
forms, and small ones as the example runs them: momentum, the table, the picture."""

import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np
from scipy.optimize import brentq

import analyse
import picture
import run
from cohesion_studies import expected
from cohesion_tests.coupling.cases import exchange_lines
from cohesion_tests.theory import filtered_drag
from cohesion_tests.theory.closure_formulas import CLOSURES, DOUBLE

SOURCE = Path(__file__).resolve().parents[2]

BUILD = sys.argv.pop(1) if len(sys.argv) > 1 else str(SOURCE / "build")
# A quarter of the example's box, for 0.02 s
SMALL = {"width": 1.6e-3, "height": 3.2e-3, "across": 11, "up": 21, "endTime": 0.02}
MU = 1.3 * 1.384615e-5


def uniform_slip(box, cell, with_filter):
    """Where the closure, in form B over the void fraction, carries the weight in the gas [m/s]."""
    of, solid, g = box.is_of, box.solid, 9.81

    def law(phi, slip):
        return CLOSURES["beetstra"](DOUBLE, 1 - phi, slip, of["diameter"], box.rho, MU)

    def surplus(slip):
        share = filtered_drag.share(solid, cell, of["diameter"], of["density"], box.rho, MU, g) if with_filter else 1
        return share * law(solid, slip) * slip / (1 - solid) - (of["density"] - box.rho) * g
    return brentq(surplus, 1e-6, 10, xtol=1e-15)


class SmallBoxes(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.keeper = tempfile.TemporaryDirectory(prefix="cohesion-")
        cls.addClassCleanup(cls.keeper.cleanup)
        cls.out, cls.env = Path(cls.keeper.name), run.environment(BUILD, ["lammps"])

    def box(self, name, kind, **changed):
        job = run.Box(self.out / name, self.env, "", kind, changed={**SMALL, **changed})
        job.prepare()
        return job, exchange_lines(job.case.solve())

    def test_one_cell_is_as_on_paper(self):
        # coarse-8 and filtered-8 have an eighth of the columns and rows
        for kind in ("coarse-8", "filtered-8"):
            with self.subTest(kind):
                job, _ = self.box("one-cell", kind, columns=8, rows=8)
                box = analyse.Box(job.folder)
                _, gas, grains = box.velocities()
                cell = np.sqrt(box.is_of["width"] * box.is_of["height"])
                right = uniform_slip(box, cell, kind.startswith("filtered"))
                # Written with six digits each, of two numbers of which the larger is below 1.1 of the slip; the gas meets
                # the slip within 1.3/150 of m/b = 0.01 s, the run is 200 of these.
                self.assertLess(abs((gas - grains)[-1] / right - 1), 3e-6)

    def test_small_boxes(self):
        kinds, jobs = {}, []
        for kind in ("fine", "coarse-4", "filtered-4"):
            job, lines = self.box("small", kind, columns=8, rows=16)
            jobs.append(job)
            kinds[kind] = [job.figures()]
            # Sums over some 500 grains and 128 cells, each rounded to 1e-16
            self.assertLess(max(line["imbalance"] for line in lines), 1e-12)
            # Until the gas flows, a gas step at most, grains fall freely.
            fall = 9.81 * 2e-4 / kinds[kind][0]["slip"]
            self.assertLess(abs(kinds[kind][0]["drift"]), fall)
        slips = {kind: found[0]["first_slip"] for kind, found in kinds.items()}
        self.assertGreater(slips["filtered-4"], slips["coarse-4"])
        self.assertIn("cells of 4 times", analyse.table(analyse.differences(kinds)))
        file = self.out / "result.png"
        picture.draw(file, jobs)
        self.assertGreater(file.stat().st_size, 10000)

    def test_differences(self):
        def kind(slip):
            return [{"slip": slip, "slip_error": 0.0}]
        found = analyse.differences({"fine": kind(0.2), "coarse-4": kind(0.1), "filtered-4": kind(0.17)})
        self.assertEqual(set(found), {"4 times"})
        for name, right in (("unfiltered", -0.5), ("filtered", -0.15), ("left", 0.3), ("left_error", 0)):
            self.assertAlmostEqual(found["4 times"][name], right, 12)

    def test_expectations_are_of_what_is_compared(self):
        rows = expected.rows(run.EXPECTED)
        self.assertEqual({(row["case"], row["quantity"]) for row in rows}, {("4 times", "left"), ("8 times", "left")})


if __name__ == "__main__":
    unittest.main()
