# SPDX-License-Identifier: BSD-3-Clause
"""The judges of the campaigns (cohesion_tests/brief_warnings.py) know all warnings that tell of the step of a run, as
the sources write them."""
import re
import unittest
from pathlib import Path

from cohesion_tests import brief_warnings

SOURCE = Path(__file__).resolve().parents[2]
# Of what a script has set up, not of a step: no sphere of a campaign meets them.
OF_THE_SET_UP = (
    "gran/stress leaves pair_style", "friction acts on", "their contacts have the dashpot", "stands before", "without being stationary",
    "takes the mean flow for heat", "now are", "the last run ended early", "has no energy tally", "the box was changed", "is not scaled", "contact_distance_factor",
    "numbers without keywords", "no fix integrates the motion", "the contact springs of")
LITERAL = r'"(?:[^"\\]|\\.)*"'


def joined(source):
    """The literals of a piece of source, one after the other."""
    return "".join(literal[1:-1] for literal in re.findall(LITERAL, source))


def texts():
    """What the sources give to warning() or late_warning(): of each call all literals, joined; and where."""
    for folder in ("lammps-package", "liggghts-styles"):
        for file in sorted((SOURCE / folder).rglob("*.[ch]*")):
            source = re.sub(r"//[^\n]*", "", file.read_text())
            constants = {name: joined(value) for name, value in
                         re.findall(r"constexpr const char\* (\w+) =([^;]*);", source)}
            for call in re.findall(rf"warning\(((?:{LITERAL}|[^;\"])*);", source):
                told = joined(call) or " ".join(
                    constants[name] for name in constants if re.search(rf"\b{name}\b", call))
                if told:
                    yield file.name, told


class Known(unittest.TestCase):
    def test_subjects_of_the_advice(self):
        header = (SOURCE / "src/advice/contact_advice.h").read_text()
        subjects = re.findall(r"^  (\w+),", re.search(r"enum class Subject \{(.*?)\};", header, re.S)[1], re.M)
        self.assertGreater(len(subjects), 5)
        self.assertEqual(sorted(subjects), sorted(known.subject for known in brief_warnings.KNOWN if known.subject))

    def test_warnings_of_both_engines(self):
        found = list(texts())
        self.assertGreater(len(found), 10)
        for file, told in found:
            with self.subTest(file, told=told):
                # Numbers are put between literals.
                numbered = re.sub(r"\{[^}]*\}", "3", told)
                self.assertTrue(any(re.search(known.pattern, numbered) for known in brief_warnings.KNOWN) or
                                any(words in told for words in OF_THE_SET_UP), told)

    def test_each_in_short_tells_what_it_should(self):
        for known in brief_warnings.KNOWN:
            with self.subTest(known.pattern):
                message = "style: " + known.pattern.replace("([^ ]*)", "3.5").replace("[^ ]*", "2").replace(".*", " ")
                self.assertEqual(brief_warnings.fits(brief_warnings.short(message)), "warned" if known.fits else "silent")


if __name__ == "__main__":
    unittest.main()
