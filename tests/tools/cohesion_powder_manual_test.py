# SPDX-License-Identifier: BSD-3-Clause
"""The manual of cohesion-powder lists every option that the program has, and no other, with its default."""
import re
import sys
import unittest
from pathlib import Path

from cohesion_tests.csv_program import CsvProgram

program = CsvProgram("COHESION_POWDER")
PAGE = Path(sys.argv.pop(1)) / "docs/tools/cohesion-powder.md"
OPTION = r"--[a-z][\w-]*"


def rows():
    """Cells of each row of the table of options."""
    section = PAGE.read_text().split("\n## Options\n")[1].split("\n## ")[0]
    return [[cell.strip() for cell in line.split("|")[1:-1]] for line in section.splitlines() if line.startswith("| `--")]


def options_of_program():
    """Name and default, or None, of each option. A list is printed as [a,b] x 2, and a range may stand before the default."""
    code, output, error = program.call("--help")
    assert code == 0, error
    found = {}
    for line in output.splitlines():
        name = re.match(rf"\s+(?:-h,)?({OPTION})\s*(.*)", line)
        if name:
            default = re.match(r"[A-Z]+(?::(?:\{.*?\}|[A-Z]\w+(?: in \[[^]]*\])?))?=(\[[^]]*\]|\S+)", name[2])
            found[name[1]] = default and default[1]
    return found


class Manual(unittest.TestCase):
    def test_its_options_are_those_of_the_program(self):
        listed = [option for row in rows() for option in re.findall(OPTION, row[0])]
        self.assertEqual(sorted(listed), sorted(options_of_program()))

    def test_its_defaults_are_those_of_the_program(self):
        defaults = {option: value for option, value in options_of_program().items() if value}
        self.assertGreater(len(defaults), 15)
        for row in rows():
            names, given = re.findall(OPTION, row[0]), re.split(r",\s*", row[2])
            for name, value in zip(names, given if len(names) > 1 else [row[2]]):
                if name in defaults:
                    self.assertEqual(numbers(value), numbers(defaults[name]), name)


def numbers(text):
    """Words of a default, numbers by their value."""
    words = re.split(r"[\s,]+", text.strip("[]"))
    return [float(word) if re.fullmatch(r"[-+\d.e]+", word) else word for word in words]


if __name__ == "__main__":
    unittest.main()
