# SPDX-License-Identifier: BSD-3-Clause
"""Tables of what is expected: those of the examples can be read; what cannot be right is refused by its row; how
figures are held against them. How a program begins and ends."""

import contextlib
import io
import math
import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

from cohesion_studies import expected, program

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"

HEAD = "# said\ncase,quantity,low,high,origin\n"


class Tables(unittest.TestCase):
    def setUp(self):
        keeper = tempfile.TemporaryDirectory(prefix="cohesion-")
        self.addCleanup(keeper.cleanup)
        self.file = Path(keeper.name) / "expected.csv"

    def test_those_of_the_examples_can_be_read(self):
        files = sorted(EXAMPLES.glob("*/expected.csv"))
        self.assertGreater(len(files), 5)
        for file in files:
            self.assertTrue(expected.rows(file), file)

    def test_what_cannot_be_right_is_refused(self):
        for text, says in (("case,quantity,low,origin\n", "columns must be case, quantity, low, high, origin"),
                           (HEAD + "a,u,2,1,why\n", "row 'a, u': 2 is above 1"),
                           (HEAD + "a,u,nan,1,why\n", "row 'a, u': nan is above 1"),
                           (HEAD + "a,u,2,,why\n", "row 'a, u': low and high must be numbers"),
                           (HEAD + "a,u,2\n", "row 'a, u': low and high must be numbers"),
                           (HEAD + "a,u,1,2,\n", "row 'a, u': it needs an origin"),
                           (HEAD + "a,u,1,2,why, not quoted\n", "row 'a, u': it needs an origin, in quotes")):
            self.file.write_text(text)
            with self.assertRaisesRegex(expected.ExpectationError, says):
                expected.rows(self.file)

    def test_figures_are_held_against_it(self):
        """Ends of the range belong to it; what is no number holds nowhere; cases that are not there are passed."""
        self.file.write_text(HEAD + "a,u,1,2,why\na,v,1,1,that\nb,u,1,2,why\n")
        for found, holds in (({"u": 1, "v": 1}, [True, True]), ({"u": 2.0, "v": 1.1}, [True, False]),
                             ({"u": math.nan}, [False, False])):
            self.assertEqual([held for _, held in expected.held(self.file, {"a": found})], holds)
        self.assertEqual(expected.text(self.file, {"a": {"u": 3}, "other": {}}),
                         "NOT AS EXPECTED: a, u: 3, expected 1 to 2 (why)\n"
                         "NOT AS EXPECTED: a, v: none, expected 1 to 1 (that)")
        self.assertEqual(expected.text(self.file.parent / "none.csv", {"a": {"u": 3}}), "")


class Programs(unittest.TestCase):
    def test_an_error_that_is_known_ends_it_with_a_text(self):
        def fail():
            raise KeyError("key")

        with mock.patch.object(sys, "argv", ["/some/run.py"]):
            with self.assertRaisesRegex(SystemExit, "^run.py: 'key'$"):
                program.run(fail, ValueError, LookupError)
            with self.assertRaises(KeyError):
                program.run(fail, ValueError)

    def test_words_that_are_missing_end_it_with_its_text(self):
        with mock.patch.object(sys, "argv", ["run.py", "a", "b"]):
            self.assertEqual(program.words("what it is", 2), ["a", "b"])
            with self.assertRaisesRegex(SystemExit, "^what it is$"):
                program.words("what it is", 3)

    def test_its_text_is_help(self):
        for word in ("--help", "-h"):
            with mock.patch.object(sys, "argv", ["run.py", word]), self.assertRaises(SystemExit) as end, \
                    contextlib.redirect_stdout(io.StringIO()) as said:
                program.words("what it is", 1)
            self.assertEqual((end.exception.code, said.getvalue()), (0, "what it is\n"))

    def test_runs_at_a_time_are_one_or_more(self):
        parser = program.argparse.ArgumentParser()
        program.together_words(parser)
        self.assertEqual(parser.parse_args(["--together", "1"]).together, 1)
        for word, says in (("0", "0: it must be 1 or more"), ("some", "invalid")):
            with self.assertRaises(SystemExit), contextlib.redirect_stderr(io.StringIO()) as said:
                parser.parse_args(["--together", word])
            self.assertIn(says, said.getvalue())


if __name__ == "__main__":
    unittest.main()
