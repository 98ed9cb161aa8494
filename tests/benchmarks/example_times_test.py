# SPDX-License-Identifier: BSD-3-Clause
"""benchmarks/example-times.py runs the commands that the examples' pages show, and the table of run times has no others:
example_times_test.py SOURCE."""
import importlib.util
import sys
import tempfile
import unittest
from pathlib import Path

from printed_table import read_csv

SOURCE = Path(sys.argv.pop(1))
#: Long commands whose time is not measured.
UNTIMED = {"geldart-a-two-fluid/run.py", "geldart-a-two-fluid/grains.py"}
sys.dont_write_bytecode = True
spec = importlib.util.spec_from_file_location("example_times", SOURCE / "benchmarks/example-times.py")
example_times = importlib.util.module_from_spec(spec)
spec.loader.exec_module(example_times)


class Commands(unittest.TestCase):
    def test_are_on_the_pages(self):
        for command in example_times.commands():
            page = (SOURCE / "examples" / command.split("/")[0] / "README.md").read_text()
            self.assertIn(f"python3 examples/{command}", page)

    def test_of_the_table_are_known(self):
        table = [row["command"] for row in read_csv(SOURCE / "docs/verification/example_times.csv")]
        self.assertEqual(set(example_times.commands()) - set(table), UNTIMED)
        self.assertEqual(set(table) - set(example_times.commands()), set())
        self.assertEqual(table, sorted(table))

    def test_receive_options_build_and_a_folder(self):
        with tempfile.TemporaryDirectory(prefix="cohesion-") as folder:
            seen, example_times.EXAMPLES = Path(folder) / "seen", Path(folder)
            (Path(folder) / "run.py").write_text(f"import sys\nopen({str(seen)!r}, 'w').write(' '.join(sys.argv[1:]))\n")
            row = example_times.row(Path("/build"), "run.py --thesis")
            self.assertRegex(seen.read_text(), r"^--thesis --build /build --out /\S+$")
        self.assertEqual(row["command"], "run.py --thesis")


if __name__ == "__main__":
    unittest.main()
