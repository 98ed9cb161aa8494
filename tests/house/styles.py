# SPDX-License-Identifier: BSD-3-Clause
"""styles.py SOURCE_DIR: every style of the LAMMPS package that a script can name is in the title of a page, and the
README leads there: of a wall from the page of its pair style."""
import re
import sys
import unittest
from pathlib import Path

from cohesion_tests import page_scripts

SOURCE = Path(sys.argv.pop(1) if len(sys.argv) > 1 else Path(__file__).resolve().parents[2])
PACKAGE = SOURCE / "lammps-package"
PAGES = SOURCE / "docs/lammps-package"
COMMANDS = {"Pair": "pair_style", "Fix": "fix", "Compute": "compute"}
# Capitals are for internal use; a former name leads to the page of the current one.
REGISTERED = re.compile(r"^\s*(Pair|Fix|Compute)Style\(([a-z][\w/]*),(?!\s*Former)", re.M)
LAWS = PACKAGE / "soft_contacts/cohesion_laws.h"


def registered():
    """Kind and name of each style: those of files that hold one, and of the laws of cohesion, whose pair style has a
    wall beside it unless it is laid over another contact."""
    found = {match.groups() for header in PACKAGE.rglob("*.h") for match in REGISTERED.finditer(header.read_text())}
    for name in re.findall(r"^  ROW\(([a-z][\w/]*), \w+\)", LAWS.read_text(), re.M):
        found |= {("Pair", name)} | ({("Fix", f"wall/{name}")} if name.startswith("gran/") else set())
    return sorted(found)


def faults(kind, name):
    page = page_of(kind, name)
    if page is None:
        return [f"no page whose title names {COMMANDS[kind]} {name}"]
    source = SOURCE / "README.md"
    if name.startswith("wall/"):
        source = page_of("Pair", name.removeprefix("wall/")) or source
    if page != source and not re.search(rf"{page.name}[)#]", source.read_text()):
        return [f"no link to {page.name} in {source.relative_to(SOURCE)}"]
    return []


def page_of(kind, name):
    """The one whose title names the style."""
    wanted = (COMMANDS[kind], name)
    return next((page for page in sorted(PAGES.glob("*.md")) if wanted in page_scripts.titled(page.read_text())), None)


class Styles(unittest.TestCase):
    def test_each_has_its_page(self):
        styles = registered()
        self.assertGreater(len(styles), 19)
        self.assertEqual({style: faults(*style) for style in styles if faults(*style)}, {})

    def test_one_without_is_seen(self):
        self.assertEqual(faults("Fix", "no/such"), ["no page whose title names fix no/such"])


if __name__ == "__main__":
    unittest.main()
