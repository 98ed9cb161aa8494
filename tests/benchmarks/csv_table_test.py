# SPDX-License-Identifier: BSD-3-Clause
"""What the option --csv of the benchmarks enters into tables of docs/verification: csv_table_test.py SOURCE."""
import csv
import importlib.machinery
import importlib.util
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path
from types import SimpleNamespace

from cohesion_tests import csv_table
from cohesion_tests.theory import hertzian_laws

SOURCE = Path(sys.argv[1])
TABLES = SOURCE / "docs/verification"
WITHOUT_PROGRAM = {"published_cases"}
# What the source of a program has if its rows are ...
HOW = {"entered": r"\bcsv_table\.enter|\benter_quantities\(", "written": r"csv|--table|def rows\(",
       "printed": r"\b(print|report)\(|\bexpect_", "checked": r"assert|EXPECT_"}


def program(name):
    file = SOURCE / "benchmarks" / (name if name.startswith("..") else f"{name}.py")
    loader = importlib.machinery.SourceFileLoader(file.stem.replace("-", "_"), str(file))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader(loader.name, loader))
    loader.exec_module(module)
    return module


def rows(name):
    with open(TABLES / f"{name}.csv", newline="") as lines:
        return list(csv.DictReader(lines))


class Entered(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="cohesion-")
        self.addCleanup(folder.cleanup)
        self.file = Path(folder.name) / "table.csv"

    def copy(self, name):
        shutil.copy(TABLES / f"{name}.csv", self.file)
        return self.file.read_text()

    def test_same_values_change_nothing(self):
        for name, measured in (("contact_energies", ("value",)), ("contacts", ("value",)),
                               ("contact_motion", ("value",)), ("contact_costs", ("instructions of the reference", "instructions", "ratio"))):
            text = self.copy(name)
            row = rows(name)[3]
            csv_table.enter(self.file, {key: row[key] for key in row if key not in measured},
                            **{key: row[key] for key in measured})
            self.assertEqual(self.file.read_text(), text, name)

    def test_value_of_a_row_and_a_new_row(self):
        self.file.write_text("a,b,value\nx,,1\nx,y,2\n")
        csv_table.enter(self.file, {"a": "x"}, value="3")
        csv_table.enter(self.file, {"a": "z"}, value="4")
        self.assertEqual(self.file.read_text(), "a,b,value\nx,,3\nx,y,2\nz,,4\n")

    def test_unknown_columns_stop_and_no_file_is_none(self):
        self.copy("contacts")
        with self.assertRaises(ValueError):
            csv_table.enter(self.file, {"a": "x"}, value="3")
        csv_table.enter(None, {"a": "x"}, value="3")

    def test_columns_of_a_key_alone_name_a_row(self):
        self.file.write_text("a,b,value\nx,1,2\n")
        csv_table.enter(self.file, {"a": "x"}, key=("a",), value="3")
        self.assertEqual(self.file.read_text(), "a,b,value\nx,1,3\n")

    def test_quantities_of_a_case(self):
        self.file.write_text("table,case,quantity,value\nt,c,q,1\n")
        csv_table.enter_quantities(self.file, "t", "c", {"q": 2, "r": 3})
        self.assertEqual(self.file.read_text(), "table,case,quantity,value\nt,c,q,2\nt,c,r,3\n")

    def test_options_that_no_column_has(self):
        words = SimpleNamespace(csv="table.csv", side=5, diameter=[75e-6])
        csv_table.require_published(words, side=5, diameter=[75e-6])
        csv_table.require_published(SimpleNamespace(csv=None, side=6), side=5)
        with self.assertRaisesRegex(SystemExit, "--csv: with --side 6"):
            csv_table.require_published(words, side=6, diameter=[75e-6])
        with self.assertRaisesRegex(SystemExit, "--csv: with --diameter 1e-05 0.001"):
            csv_table.require_published(words, diameter=[1e-5, 1e-3])

    def test_processes_that_enter_at_once(self):
        self.file.write_text("a,value\n")
        code = ("import sys; from cohesion_tests import csv_table\n"
                "for n in range(20): csv_table.enter(sys.argv[1], {'a': f'{sys.argv[2]} {n}'}, value='1')")
        for process in [subprocess.Popen([sys.executable, "-c", code, self.file, name]) for name in "xyz"]:
            self.assertEqual(process.wait(), 0)
        self.assertEqual(len(csv_table.rows(self.file)), 60)

    def test_numbers(self):
        self.assertEqual([csv_table.power(1.4e6), csv_table.power(3.19e-4, 2), csv_table.power(0)],
                         ["1.4e6", "3.19e-4", "0.0e0"])
        self.assertEqual([csv_table.figures(value) for value in (2812, 0.004, 2.24e6, 1)], ["2800", "0.0040", "2.2e6", "1.0"])
        self.assertEqual([csv_table.grouped(6144), csv_table.grouped(49152)], ["6144", "49,152"])


class Programs(unittest.TestCase):
    """The rows that they enter are rows of the tables."""

    def expect(self, table, wanted):
        known = rows(table)
        for row in wanted:
            names = known[0].keys() - {"value", "instructions of the reference", "instructions", "ratio"}
            self.assertIn({name: row.get(name, "") for name in names},
                          [{name: one[name] for name in names} for one in known])

    def test_energy_of_gases(self):
        for engine in ("LAMMPS", "LIGGGHTS"):
            for law in ("hertz", "dmt", "jkr"):
                self.expect("contact_energies", (csv_table.energy(engine, law, gas, contact, division, 20.0)
                                                 for gas in hertzian_laws.gases(law, 0.5)
                                                 for contact in hertzian_laws.CONTACTS for division in (10, 20)))

    def test_costs(self):
        cost = program("lammps-package/cost-per-step")
        self.expect("contact_costs", (cost.table_row("hamaker", scene, mu, constant, "stock")
                                      for scene in cost.SCENES for mu in (0.0, 0.3) for constant in (0.0, 2e-18)))
        self.expect("contact_costs", (cost.table_row(law, "gas", mu, cost.STRENGTHS[law], reference)
                                      for law, reference in (("hertz", "stock_hertz"), ("jkr", "stock_jkr"),
                                                             ("capillary", "stock"), ("liquid_bridge", "stock"))
                                      for mu in (0.0, 0.3)))

    def entered(self, module, call):
        """Rows that `call` enters."""
        found, kept = [], csv_table.enter
        self.addCleanup(setattr, module.csv_table, "enter", kept)
        module.csv_table.enter = lambda file, row, **measured: found.append(row)
        call()
        return found

    def test_motion(self):
        steps, pairs, impacts = (program(f"lammps-package/{name}")
                                 for name in ("step-error", "struck-pairs", "agglomerate-impacts"))
        self.expect("contacts", self.entered(steps, lambda: [
            steps.enter("", scheme, dt, 1.0, 1.0) for scheme in steps.SCHEMES for dt in steps.SCHEMES[scheme][1]]))
        self.expect("contacts", self.entered(impacts, lambda: [
            impacts.enter("", mu, step, [(0.0, 0.0, 0.5)] * 3, step == 100)
            for mu in (0.0, 0.3) for step in (5.0, 100)]))
        self.expect("contacts", self.entered(impacts, lambda: [
            impacts.enter_escape("", step, 100, 45.0, 0.03, 1.0, 1.1) for step in (5.0, 100)]))
        for scheme, friction in (("exact", 0.0), ("exact", 0.3), ("sampled", 0.0)):
            words = type("Words", (), {"scheme": scheme, "plugin": "plugin", "csv": "", "law": "linear"})
            self.expect("contact_motion", self.entered(pairs, lambda: pairs.enter(words, friction, 10, 1, 0.1)))
        for law in pairs.NAMES:
            words = type("Words", (), {"scheme": "exact", "plugin": "plugin", "csv": "", "law": law})
            self.expect("contact_motion", self.entered(pairs, lambda: [
                (pairs.enter(words, friction, division, 0, None if division == 5 else 0.1),
                 pairs.enter_row(words, restitution, speed, division, float("inf")))
                for friction in (0.0, 0.3) for restitution in (1.0, 0.9) for speed in (0.03, 0.1)
                for division in pairs.DIVISIONS["exact"]]))

    def test_shear_noise_and_cohesion(self):
        shear, noise, hover, cohesion = (program(name) for name in (
            "lammps-package/shear-cost", "openfoam-coupling/kernel_noise", "openfoam-coupling/hovering_plates",
            "liggghts-styles/cohesion-cost"))
        self.expect("sheared_spheres", self.entered(shear, lambda: shear.enter("", 32000, 0.1, (100, 8), 0.58)))
        self.expect("void_fraction", self.entered(noise, lambda: [
            noise.enter("", 3, 0.15, kernel, width, (1, 1, 1)) for kernel in noise.KERNELS for width in (0, 2)]))
        self.expect("void_fraction", self.entered(hover, lambda: [
            hover.enter("", cell, *more, []) for cell, more in
            ((3, (0, "cell", 1.2)), (3, (2, "cell", 1.4)), (3, (0, "interpolated", 1.2)), (1.5, (0, "cell", 1.4)))]))
        self.expect("contact_costs", self.entered(cohesion, lambda: [
            cohesion.enter("", scene, dict.fromkeys(cohesion.COHESION, 1.0))
            for scene in ("pair in contact", "pair across a gap")]))


class Sources(unittest.TestCase):
    """benchmarks/tables.csv names the program of each row of each table, and how its values come into the table."""

    def setUp(self):
        self.sources = csv_table.rows(SOURCE / "benchmarks/tables.csv")

    def test_each_table_has_a_program(self):
        self.assertEqual({source["table"] for source in self.sources}, {file.stem for file in TABLES.glob("*.csv")})
        self.assertEqual({source["table"] for source in self.sources} - WITHOUT_PROGRAM,
                         {source["table"] for source in self.sources if source["program"]})

    def test_each_row_is_of_an_entry(self):
        base = program("../scripts/page-tables").database(sorted(TABLES.glob("*.csv")))
        for table in {source["table"] for source in self.sources if source["rows"]}:
            found = [{number for number, in base.execute(f"select rowid from {table} where {source['rows']}")}
                     for source in self.sources if source["table"] == table]
            self.assertTrue(all(found), table)
            self.assertEqual(sum(map(len, found)), len(rows(table)), table)
            self.assertEqual(len(set.union(*found)), len(rows(table)), table)

    def test_programs_do_what_the_table_says(self):
        for source in self.sources:
            if source["program"]:
                self.assertRegex((SOURCE / source["program"]).read_text(), HOW[source["how"]], source)
            else:
                self.assertIn(source["how"], ("literature", "by hand"), source)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
