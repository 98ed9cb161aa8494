# SPDX-License-Identifier: BSD-3-Clause
"""programs.py SOURCE_DIR: what a user runs by hand, in examples/ and benchmarks/, finds its modules from any
folder and without any environment; and no program changes where Python looks for them."""
import ast
import os
import subprocess
import sys
import tempfile
import unittest
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

SOURCE = Path(sys.argv.pop(1) if len(sys.argv) > 1 else Path(__file__).resolve().parents[2])
FILES = [file for folder in ("benchmarks", "examples", "tests") for file in sorted((SOURCE / folder).rglob("*.py"))
         if file != Path(__file__)]
PROGRAMS = [file for file in FILES if "__main__" in file.read_text() and not file.name.endswith("_test.py")
            and file.relative_to(SOURCE).parts[0] != "tests"]
PACKAGES = {"cohesion_studies": SOURCE / "examples/common/cohesion_studies",
            "cohesion_tests": SOURCE / "tests/support/cohesion_tests"}


def imported(file):
    """Names of the packages and modules that a file imports."""
    found = set()
    for node in ast.walk(ast.parse(file.read_text())):
        if isinstance(node, ast.Import):
            found |= {alias.name.split(".")[0] for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            found.add(node.module.split(".")[0])
    return found


class Programs(unittest.TestCase):
    def test_packages_lie_beside_them(self):
        self.assertGreater(len(PROGRAMS), 40)
        for file in PROGRAMS:
            for name in imported(file) & set(PACKAGES):
                with self.subTest(file=file, package=name):
                    self.assertEqual((file.parent / name).resolve(), PACKAGES[name].resolve())

    def test_one_of_each_folder_starts_without_an_environment(self):
        """From elsewhere, and says what it takes."""
        ones = list({file.parent: file for file in PROGRAMS}.values())
        env = {name: value for name, value in os.environ.items() if not name.startswith(("PYTHON", "COHESION"))}

        def start(file):
            with tempfile.TemporaryDirectory(prefix="cohesion-") as folder:
                return subprocess.run([sys.executable, str(file), "--help"], cwd=folder, text=True, timeout=100,
                                      env={**env, "PYTHONDONTWRITEBYTECODE": "1"}, stdin=subprocess.DEVNULL,
                                      stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        with ThreadPoolExecutor(2) as pool:
            for file, done in zip(ones, pool.map(start, ones)):
                with self.subTest(file):
                    self.assertEqual(done.returncode, 0, done.stdout)
                    self.assertIn(file.name, done.stdout)

    def test_none_says_where_modules_are(self):
        for file in FILES:
            with self.subTest(file):
                self.assertNotIn("sys.path", file.read_text())

    def test_every_test_is_registered(self):
        """By its name, without the ending, in the CMakeLists.txt of its folder or of one above."""
        tests = [file for file in FILES if file.name.endswith("_test.py")]
        self.assertGreater(len(tests), 100)
        for file in tests:
            with self.subTest(file):
                lists = next(path for path in (folder / "CMakeLists.txt" for folder in file.parents) if path.exists())
                text = lists.read_text()
                self.assertRegex(text, rf"\b{file.stem.removesuffix('_test')}(_test\.py)?\b")

    def test_names_are_of_one_program_each(self):
        """Also but for the sign between words; a test may be named as what it tests."""
        names = [file.stem.replace("-", "_") for file in PROGRAMS if "benchmarks" in file.parts]
        modules = [file.stem for file in FILES if "support" in file.parts and file.stem != "__init__"]
        self.assertEqual(sorted({name for name in names if (names + modules).count(name) > 1}), [])


if __name__ == "__main__":
    unittest.main()
