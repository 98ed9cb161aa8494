# SPDX-License-Identifier: BSD-3-Clause
"""headers.py SOURCE_DIR: `#include "name.h"` in an adapter means one file. The rooms of lammps-package/ are one folder
in a LAMMPS tree, and what install-into-tree.sh puts there is whole."""
import re
import subprocess
import sys
import tempfile
import unittest
from collections import Counter
from pathlib import Path

SOURCE = Path(sys.argv.pop(1) if len(sys.argv) > 1 else Path(__file__).resolve().parents[2])
PACKAGE = SOURCE / "lammps-package"
LIGGGHTS = SOURCE / "liggghts-styles"
PLUGIN = PACKAGE / "plugin"


def sources(*folders):
    return [file for folder in folders for file in sorted(folder.glob("*")) if file.suffix in (".h", ".cpp")]


def rooms():
    return [folder for folder in sorted(PACKAGE.iterdir()) if folder.is_dir()]


def twice(files):
    counts = Counter(file.name for file in files)
    return [str(file.relative_to(SOURCE)) for file in files if counts[file.name] > 1]


class Names(unittest.TestCase):
    def test_every_source_is_in_a_room(self):
        self.assertEqual(sources(PACKAGE), [])
        self.assertGreater(len(sources(*rooms())), 100)

    def test_no_name_twice_in_a_build(self):
        core = sources(SOURCE / "src")
        self.assertEqual(twice(core + sources(*rooms())), [])
        self.assertEqual(twice(core + sources(LIGGGHTS, LIGGGHTS / "model-lists", PACKAGE / "common")), [])

    def test_no_header_twice_in_both_adapters_unless_a_style_of_both(self):
        """Engines prescribe the file names of their styles."""
        found = [file for file in twice(sources(LIGGGHTS, *rooms()))
                 if file.endswith(".h") and not re.match("(pair|fix|compute)_", Path(file).name)]
        self.assertEqual(found, [])


class UnitTests(unittest.TestCase):
    def test_include_each_header_of_src(self):
        """Directly, or through another header: code that no unit test compiles can be wrong unseen."""
        def included(file):
            return {SOURCE / "src" / name for name in re.findall('^#include "(.*)"$', file.read_text(), re.M)}

        headers = set((SOURCE / "src").rglob("*.h"))
        found, new = set(), set().union(*map(included, (SOURCE / "tests/src").rglob("*_test.cpp"))) & headers
        while new:
            found |= new
            new = set().union(*map(included, new)) & headers - found
        self.assertEqual(sorted(str(file.relative_to(SOURCE)) for file in headers - found), [])


class InATree(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.tree = Path(folder.name)
        for name, text in (("src/lammps.h", ""), ("cmake/CMakeLists.txt", "set(STANDARD_PACKAGES\n  ASPHERE)\n")):
            (self.tree / name).parent.mkdir()
            (self.tree / name).write_text(text)

    def install(self):
        subprocess.run([PACKAGE / "install-into-tree.sh", self.tree], check=True, stdout=subprocess.DEVNULL)
        return self.tree / "src/COHESION"

    def test_package_is_flat_and_has_what_it_includes(self):
        package = self.install()
        expected = {file.name for room in rooms() if room != PLUGIN for file in sources(room)}
        core = {file.name for file in sources(SOURCE / "src")}
        self.assertEqual({file.name for file in sources(package)} - core, expected)
        names = expected | {str(file.relative_to(SOURCE / "src")) for file in (SOURCE / "src").rglob("*.h")}
        for file in package.rglob("*"):
            for name in re.findall('^#include "(.*)"$', file.read_text(), re.M) if file.is_file() else []:
                with self.subTest(file=file.name, include=name):
                    self.assertTrue((package / name).exists() or name not in names)

    def test_second_call_leaves_one_copy(self):
        self.install()
        package = self.install()
        (package / "left_over.h").write_text("")
        self.install()
        self.assertFalse((package / "left_over.h").exists())
        self.assertEqual((self.tree / "cmake/CMakeLists.txt").read_text(),
                         "set(STANDARD_PACKAGES\n  COHESION\n  ASPHERE)\n")


if __name__ == "__main__":
    unittest.main()
