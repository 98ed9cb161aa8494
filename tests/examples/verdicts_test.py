# SPDX-License-Identifier: BSD-3-Clause
"""The table of claims of the sources: each row is complete and has one of four verdicts, and the pages are current."""
import subprocess
import sys
import unittest

import verdicts


class Table(unittest.TestCase):
    def test_rows_are_valid(self):
        rows = verdicts.read()
        self.assertEqual(list(rows[0]), verdicts.COLUMNS)
        self.assertEqual({f"{row['source']}, {row['claim']}": verdicts.faults(row) for row in rows
                          if verdicts.faults(row)}, {})
        self.assertEqual({row["verdict"] for row in rows}, {"agrees", "differs", "cannot tell", "not run"})
        self.assertEqual({row["source"] for row in rows}, set(verdicts.SOURCES))
        claims = [(row["source"], row["place"], row["claim"]) for row in rows]
        self.assertEqual(len(claims), len(set(claims)))

    def test_faults_are_seen(self):
        row = verdicts.read()[0]
        for name, value, fault in (("verdict", "yes", "unknown verdict: yes"), ("source", "X", "unknown source: X"),
                                   ("why", "", "no why"), ("claim", "a " * 16, "claim: more than 15 words"),
                                   ("quote", "a " * 26, "quote: more than 25 words"),
                                   ("where", "examples/none", "no page in examples/none")):
            self.assertEqual(verdicts.faults({**row, name: value}), [fault])


class Pages(unittest.TestCase):
    def test_pages_are_current(self):
        done = subprocess.run([sys.executable, verdicts.__file__, "--check"], text=True, capture_output=True)
        self.assertEqual((done.returncode, done.stderr), (0, ""))

    def test_pages_are_short_and_complete(self):
        rows = verdicts.read()
        for source in verdicts.SOURCES:
            text, of_it = verdicts.page(source, rows), [row for row in rows if row["source"] == source]
            self.assertLessEqual(verdicts.words(text), verdicts.WORDS)
            differing = [row for row in of_it if row["verdict"] == "differs"]
            self.assertEqual(text.count("/README.md) |\n"), len(differing))
            for row in differing:
                self.assertIn(f"| {row['place']} | {row['claim']} | ".replace("*", r"\*"), text)
            counts = [sum(row["verdict"] == verdict for row in of_it) for verdict in verdicts.VERDICTS]
            self.assertIn(f"| {' | '.join(map(str, [*counts, len(of_it)]))} |\n", text)

    def test_words(self):
        self.assertEqual(verdicts.words("| a | b 3.5 |\n|---|---|\n"), 3)


if __name__ == "__main__":
    unittest.main()
