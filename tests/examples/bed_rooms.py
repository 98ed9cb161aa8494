# SPDX-License-Identifier: BSD-3-Clause
"""bed_rooms.py BUILD_FOLDER: the tables of examples/defluidisation-cycle and examples/overshoot-mechanisms, what is
expected of them, and small versions of both, with beds of 0.018 s; cells and width of a bed."""

import re
import shutil
import unittest

import study
from cohesion_studies import expected
from cohesion_studies.bed import bed_case, figures
from small_beds import BUILD, SOURCE, SmallBeds, variables


class Rooms(SmallBeds):
    @unittest.skipUnless((BUILD / "tools/cohesion-mapping").exists(), "built without tools")
    def test_levels_of_cohesion_are_pairs_of_equal_escape_velocity(self):
        table = study.rows(SOURCE / "examples/defluidisation-cycle/cohesion-levels.csv")
        speeds = {name: study.escape_velocities(BUILD, row) for name, row in table.items()}
        for none in ("none", "none-sampled", "none-well-sampled"):
            self.assertEqual(set(speeds.pop(none).values()), {0.0})
        self.assertEqual(len(speeds), 12)
        for depth in ("1e-11", "5e-11", "1e-10"):
            well, hamaker = (speeds[f"{law}-{depth}"]["v_esc"] for law in ("well", "hamaker"))
            # A has nine digits, half of the last one is up to 5e-9; v_esc is nearly proportional to it.
            self.assertAlmostEqual(hamaker / well, 1, delta=1e-8)
            self.assertEqual(table[f"well-{depth}"]["D"], float(depth))
            # Sampled is the same bed, at the thesis's step.
            for law in ("well", "hamaker"):
                self.assertEqual({**table[f"{law}-{depth}"], "scheme": "sampled", "dt": 2.25e-5},
                                 table[f"{law}-{depth}-sampled"])
        # The energy that a well takes goes with the square of the speed, so that a factor counts by its root.
        row = {**table["well-1e-11"], "cohesion_side": 4, "cohesion_plate": "no"}
        found = study.escape_velocities(BUILD, row)
        self.assertAlmostEqual(found["v_esc_side"] / speeds["well-1e-11"]["v_esc_side"], 2, places=12)
        self.assertEqual(found["v_esc_plate"], 0)

    @unittest.skipUnless((BUILD / "tools/cohesion-mapping").exists(), "built without tools")
    def test_expected_escape_velocities(self):
        """Those of expected.csv of the rooms, in the full tables."""
        for file, checked in (("defluidisation-cycle/cohesion-levels.csv", 7),
                              ("defluidisation-cycle/small.csv", 3),
                              ("overshoot-mechanisms/mechanisms.csv", 10)):
            table = SOURCE / "examples" / file
            found = {name: study.known_speeds(BUILD, name, row) for name, row in study.rows(table).items()}
            held = [holds for line, holds in expected.held(table.parent / "expected.csv", found)
                    if "v_esc" in line or "bond" in line]
            self.assertEqual(held, checked * [True], file)

    def test_small_table_is_of_rows_of_the_levels(self):
        """Each without cohesion, of the deepest wells and of their Hamaker attraction, by the same name, in half the
        width with cells of nearly the same width, through the brief schedule."""
        levels, small = (study.rows(SOURCE / "examples/defluidisation-cycle" / file)
                         for file in ("cohesion-levels.csv", "small.csv"))
        self.assertEqual(list(small), ["none-40", "well-1e-10-40", "hamaker-1e-10-40"])
        for name, row in small.items():
            level = levels[name.removesuffix("-40")]
            self.assertEqual({**level, "schedule": "brief", "width": 0.04, "across": 13}, row)
            self.assertEqual(row["width"], level["width"] / 2)
            self.assertLess(abs(level["across"] / row["across"] / 2 - 1), 0.04)

    def test_a_small_version_of_both_rooms(self):
        """Each law and switch of their tables, as beds of 0.018 s; what is expected of them is said in the end."""
        for file, rows in (("defluidisation-cycle/cohesion-levels.csv",
                            ("none", "well-5e-11", "hamaker-5e-11-sampled")),
                           ("overshoot-mechanisms/mechanisms.csv", ("none-friction", "hamaker-40", "well-no-plate"))):
            source = SOURCE / "examples" / file
            head, *lines = [line for line in source.read_text().splitlines() if line[0] != "#"]
            small = [head.replace("schedule", "settle") if "schedule" in head else f"{head}, settle"]
            small += [line.replace("short", "0.01") if "schedule" in head else f"{line}, 0.01" for line in lines
                      if line.split(",")[0] in rows]
            table, out = self.folder / source.name, self.folder / source.stem
            table.write_text("\n".join(small) + "\n")
            shutil.copy(source.parent / "expected.csv", self.folder)
            printed = self.call(study, table, "--seeds", 1, "--out", out)
            for name in rows:
                found, given = variables(out / "runs" / f"{name}-1"), study.rows(source)[name]
                for variable, value in given.items():
                    if variable not in ("settle", *bed_case.ENTRIES, *bed_case.GEOMETRY, "engine", "schedule"):
                        # foamDictionary writes six digits.
                        self.assertEqual(found[variable], value if isinstance(value, str) else float(f"{value:.6g}"))
            # Figures are made up of the seed, 1: the balance is 1.
            self.assertEqual("as expected: none, balance: 1, " in printed, "none" in rows)
            self.assertNotIn("NOT AS EXPECTED", printed)
        mesh = (out / "runs/hamaker-40-1/log.blockMesh").read_text()
        self.assertIn("nCells: 390\n", mesh)  # 13 x 30
        self.assertIn("2000", (out / "runs/hamaker-40-1/log.cohesiveBedFoam").read_text().split("Particles: ")[1][:5])

    def test_tells_what_is_not_as_expected(self):
        table = self.folder / "table.csv"
        table.write_text("name, A, settle\na, 0, 0.01\n")
        (self.folder / "expected.csv").write_text("# of a test\ncase,quantity,low,high,origin\na,balance,2,3,made up\n"
                                                  "a,U_mf_th,1,1,seed\na,missing,1,1,none\nb,balance,2,3,no row\n")
        printed = self.call(study, table, "--seeds", 1, "--out", self.folder / "out")
        self.assertIn("NOT AS EXPECTED: a, balance: 1, expected 2 to 3 (made up)\n"
                      "as expected: a, U_mf_th: 1, expected 1 to 1 (seed)\n"
                      "NOT AS EXPECTED: a, missing: none, expected 1 to 1 (none)\n", printed)
        self.assertNotIn("no row", printed)

    def test_refuses_cells_that_have_no_jets(self):
        table = self.folder / "table.csv"
        for column, value, says in (("across", 14, "across is 14: it must be odd"), ("up", 2, "up is 2"),
                                    ("width", 0.081, "width is 0.081 m: it must be a multiple")):
            table.write_text(f"name, {column}\na, {value}\n")
            with self.assertRaisesRegex(study.TableError, f"row 'a': {says}"):
                self.call(study, table, "--out", self.folder / "out")

    def test_cells_and_gas_step_of_a_row(self):
        table, out = self.folder / "table.csv", self.folder / "out"
        table.write_text("name, across, up, deltaT, K, settle\na, 13, 15, 9e-4, 200, 0.01\n")
        self.call(study, table, "--seeds", 1, "--out", out)
        case = out / "runs/a-1"
        self.assertIn("nCells: 195\n", (case / "log.blockMesh").read_text())
        self.assertRegex((case / "constant/polyMesh/boundary").read_text(), r"jets\s*\{[^}]*nFaces\s+6;")
        found = variables(case)
        self.assertEqual((found["K"], found["node"]), (200, 0.00666667))
        steps = re.findall(r"^Time = (\S+)", (case / "log.cohesiveBedFoam").read_text(), re.M)
        self.assertEqual(len(steps), 20)
        # The gas that all jets together bring is that of the schedule.
        jets = figures.analyse.read_vectors(case / "postProcessing/jetVelocity/0/surfaceFieldValue.dat")
        self.assertAlmostEqual(jets[-1, 2] * 6 / 13, 1.2, places=6)


if __name__ == "__main__":
    unittest.main()
