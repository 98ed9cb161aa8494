# SPDX-License-Identifier: BSD-3-Clause
"""styles.py SOURCE_DIR: every style of the LAMMPS package that a script can name has a page, under its name, and the
README leads there: of a wall from the page of its pair style."""
import re
import sys
import unittest
from pathlib import Path

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
    page = PAGES / f"{kind.lower()}_{name.replace('/', '_')}.md"
    title = f"# {COMMANDS[kind]} {name} command"
    if not page.exists():
        return [f"no page {page.relative_to(SOURCE)}"]
    found = [] if page.read_text().startswith(title + "\n") else [f"{page.name} does not begin with `{title}`"]
    pair = PAGES / f"pair_{name.removeprefix('wall/').replace('/', '_')}.md"
    source = pair if name.startswith("wall/") and pair.exists() else SOURCE / "README.md"
    if f"{page.name})" not in source.read_text():
        found.append(f"no link to {page.name} in {source.relative_to(SOURCE)}")
    return found


class Styles(unittest.TestCase):
    def test_each_has_its_page(self):
        styles = registered()
        self.assertGreater(len(styles), 19)
        self.assertEqual({style: faults(*style) for style in styles if faults(*style)}, {})

    def test_one_without_is_seen(self):
        self.assertEqual(faults("Fix", "no/such"), ["no page docs/lammps-package/fix_no_such.md"])


if __name__ == "__main__":
    unittest.main()
