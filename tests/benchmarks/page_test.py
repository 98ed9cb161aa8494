# SPDX-License-Identifier: BSD-3-Clause
"""A section's table is replaced and nothing else."""
import tempfile
import unittest
from pathlib import Path

from benchmarks import asked
from page import beside, read_csv, replace_section, source, write_csv

PAGE = """# Costs

Before.

## One

Said of one.

| a |
|---|
| old |
| old |

After one.

## One and more

| a |
|---|
| kept |
"""


class Page(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.file = Path(folder.name) / "page.md"

    def replaced(self, text, title, *lines):
        if text is not None:
            self.file.write_text(text)
        replace_section(self.file, title, lines)
        return self.file.read_text()

    def test_table_is_replaced_and_text_stays(self):
        self.assertEqual(self.replaced(PAGE, "One", "| a |", "|---|", "| new |"),
                         PAGE.replace("| old |\n| old |", "| new |"))

    def test_last_section(self):
        self.assertEqual(self.replaced(PAGE, "One and more", "| new |"),
                         PAGE.replace("| a |\n|---|\n| kept |", "| new |"))

    def test_tables_follow_each_other_and_the_source_is_replaced(self):
        source = "From `benchmarks.py BUILD one --small`, more."
        new = ("From `benchmarks.py BUILD one`.", "", "| a |", "|---|", "| new |", "", "| b |", "|---|", "| newer |")
        first, second = "| a |\n|---|\n| old |\n| old |\n", "| b |\n|---|\n| old |\n"
        expected = PAGE.replace("Said of one.\n", "Said of one.\n\nFrom `benchmarks.py BUILD one`.\n").replace(
            first, "| a |\n|---|\n| new |\n\n| b |\n|---|\n| newer |\n")
        given = PAGE.replace("Said of one.\n", f"Said of one.\n\n{source}\n")
        self.assertEqual(self.replaced(given, "One", *new), expected)
        # Again, with both tables there.
        self.assertEqual(self.replaced(given.replace(first, first + "\n" + second), "One", *new), expected)
        self.assertEqual(self.replaced(expected, "One", *new), expected)
        # No source yet: it comes first.
        self.assertEqual(self.replaced(PAGE, "One", *new[:5]), PAGE.replace("\nSaid of one.\n", (
            "\nFrom `benchmarks.py BUILD one`.\n\nSaid of one.\n")).replace("| old |\n| old |", "| new |"))

    def test_source_names_what_was_asked_for(self):
        words = ["dense", "--page", "step_costs.md", "--turns", "2", "--picture=p.png", "--way", "a b"]
        self.assertRegex(source(asked(words)), r"^From `benchmarks\.py BUILD dense --turns 2 --way 'a b'`, the load of "
                         r"the machine before it \d+\.\d on \d+ processors\.$")

    def test_section_without_table_gets_one(self):
        self.assertEqual(self.replaced("## One\n\nSaid.\n\n## Two\n", "One", "| new |"),
                         "## One\n\nSaid.\n\n| new |\n\n## Two\n")

    def test_new_section_and_new_page(self):
        self.assertEqual(self.replaced("# Costs\n", "One", "| new |"), "# Costs\n\n## One\n\n| new |\n")
        self.file.unlink()
        self.assertEqual(self.replaced(None, "One", "| new |"), "## One\n\n| new |\n")

    def test_all_rows_of_the_first_table_go_beside_the_page(self):
        lines = ["Source.", "", "| a | b |", "|---|---|", "| *x* | 1 |", "| y | 2 |", "", "| c |", "|---|", "| 3 |"]
        found = beside(self.file, lines, lambda rows: [f"| {rows[0]['a']} |"])
        self.assertEqual(found, ["Source.", "", "| x |", "", "| c |", "|---|", "| 3 |"])
        self.assertEqual(read_csv(self.file.with_suffix(".csv")), [{"a": "x", "b": "1"}, {"a": "y", "b": "2"}])

    def test_a_csv_file_has_the_first_table(self):
        file = self.file.with_suffix(".csv")
        write_csv(file, ["Source.", "", "| a | b |", "|---|---|", "| *x* | 1 |", "", "| c |", "|---|", "| 3 |"])
        self.assertEqual(file.read_text(), "a,b\nx,1\n")


if __name__ == "__main__":
    unittest.main()
