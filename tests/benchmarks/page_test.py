# SPDX-License-Identifier: BSD-3-Clause
"""A section's table is replaced and nothing else."""
import tempfile
import unittest
from pathlib import Path

from page import replace_section

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

    def test_section_without_table_gets_one(self):
        self.assertEqual(self.replaced("## One\n\nSaid.\n\n## Two\n", "One", "| new |"),
                         "## One\n\nSaid.\n\n| new |\n\n## Two\n")

    def test_new_section_and_new_page(self):
        self.assertEqual(self.replaced("# Costs\n", "One", "| new |"), "# Costs\n\n## One\n\n| new |\n")
        self.file.unlink()
        self.assertEqual(self.replaced(None, "One", "| new |"), "## One\n\n| new |\n")


if __name__ == "__main__":
    unittest.main()
