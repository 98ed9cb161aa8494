# SPDX-License-Identifier: BSD-3-Clause
"""scripts/page-tables: the pages have the tables that the CSV files give, and each table of a page of measurements is
generated. page_tables_test.py SCRIPTS"""
import importlib.machinery
import importlib.util
import sqlite3
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SCRIPTS = Path(sys.argv.pop(1)).resolve()
SOURCE = SCRIPTS.parent
sys.dont_write_bytecode = True


def loaded(name):
    loader = importlib.machinery.SourceFileLoader(name.replace("-", "_"), str(SCRIPTS / name))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader(loader.name, loader))
    loader.exec_module(module)
    return module


page_tables, page_figures = loaded("page-tables"), loaded("page-figures")


class Pages(unittest.TestCase):
    def test_are_up_to_date(self):
        done = subprocess.run([sys.executable, SCRIPTS / "page-tables", "--check"], capture_output=True, text=True)
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "", ""))

    def test_of_measurements_have_generated_tables_only(self):
        for page in (*(SOURCE / "docs/verification").glob("*.md"), SOURCE / "docs/costs.md"):
            words = page_figures.count(page.read_text(), str(page.relative_to(SOURCE)) in page_figures.GENERATED)
            self.assertEqual(words["tables"], 0, page)


class Queries(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="cohesion-")
        self.addCleanup(folder.cleanup)
        file = Path(folder.name) / "speeds.csv"
        file.write_text("engine,case,speed [m/s]\nA,one,-2e-3\nA,two,0.001\nB,one,stops\nB,two,\n")
        unnamed = Path(folder.name) / "unnamed.csv"
        unnamed.write_text("end,end\n1,2\n")
        self.base = page_tables.database([file, unnamed])

    def page(self, query, table=""):
        return f"Words.\n\n<!-- table\n{query}\n-->\n{table}\nMore words.\n"

    def test_result_replaces_the_table(self):
        query = "select engine, largest(`speed [m/s]`) as largest from speeds group by engine"
        new = self.page(query, "| engine | largest |\n|---|---|\n| A | 2e-3 |\n| B | |\n")
        self.assertEqual(page_tables.rewritten(self.base, self.page(query, "| old |\n|---|\n")), new)
        self.assertEqual(page_tables.rewritten(self.base, self.page(query)), new)
        self.assertEqual(page_tables.rewritten(self.base, new), new)

    def test_without_rows_or_with_unknown_columns_stop(self):
        with self.assertRaises(ValueError):
            page_tables.rewritten(self.base, self.page("select engine from speeds where engine = 'C'"))
        with self.assertRaises(sqlite3.OperationalError):
            page_tables.rewritten(self.base, self.page("select `caze` from speeds"))

    def test_text_without_a_query_stays(self):
        text = "| a |\n|---|\n| 1 |\n\n<!-- a remark -->\n| b |\n"
        self.assertEqual(page_tables.rewritten(self.base, text), text)


if __name__ == "__main__":
    unittest.main()
