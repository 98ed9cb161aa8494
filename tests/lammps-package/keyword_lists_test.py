# SPDX-License-Identifier: BSD-3-Clause
"""Keywords of the pair and wall styles: those that the messages about an unknown one name, those on the style's page
and those that are read must be the same."""
import re
import unittest
from pathlib import Path

from cohesion_tests import lammps as engine
from cohesion_tests.lammps_scenes.small_box import box
from cohesion_tests.test_cases import ScriptTestCase

PAGES = Path(__file__).resolve().parents[2] / "docs" / "lammps-package"
HEAD = box()
# Commands up to their keywords, by style.
COMMANDS = {
    "pair_gran_hamaker": ("pair_style gran/hamaker ", "pair_style gran/hamaker\npair_coeff 1 1 "),
    "pair_gran_squarewell": ("pair_style gran/squarewell ", "pair_style gran/squarewell\npair_coeff 1 1 "),
    "pair_hard_squarewell": ("pair_style hard/squarewell ", "pair_style hard/squarewell\npair_coeff 1 1 "),
    "pair_gran_liquidbridge": ("pair_style gran/liquidbridge ", "pair_style gran/liquidbridge\npair_coeff 1 1 "),
    "pair_gran_jkr": ("pair_style gran/jkr ", "pair_style gran/jkr\npair_coeff 1 1 "),
    "pair_hamaker": ("pair_style hamaker ", "pair_style hamaker cutoff 4e-10 1e-7\npair_coeff 1 1 "),
    "pair_squarewell": ("pair_style squarewell\npair_coeff 1 1 ",),
    "fix_wall_gran_hamaker": ("fix w all wall/gran/hamaker ",),
    "fix_wall_gran_squarewell": ("fix w all wall/gran/squarewell ",),
    "fix_wall_gran_liquidbridge": ("fix w all wall/gran/liquidbridge ",),
    "fix_wall_gran_jkr": ("fix w all wall/gran/jkr ",),
    "fix_wall_hamaker": ("fix w all wall/hamaker ",),
    "fix_wall_hard_squarewell": ("fix w all wall/hard/squarewell ",),
}
# Pages of several styles, and of walls.
PAGE_OF = {"pair_squarewell": "pair_gran_squarewell", "fix_wall_hamaker": "pair_hamaker",
           "fix_wall_hard_squarewell": "pair_hard_squarewell"}
# Whose messages are written beside what reads, not made of it; one of the walls shares its list with the others.
WRITTEN_BY_HAND = ("pair_hard_squarewell", "fix_wall_hamaker", "fix_wall_hard_squarewell")
UNKNOWN = "no_such_keyword"


def page_of(style):
    return "fix_wall_gran" if style.startswith("fix_wall_gran") else PAGE_OF.get(style, style)


def syntax(page):
    """The part of a page that says what is typed: of its sections Syntax and Parameters."""
    text = (PAGES / f"{page}.md").read_text()
    sections = dict(re.findall(r"^## ([^\n]*)\n(.*?)(?=^## |\Z)", text, re.M | re.S))
    return sections["Syntax"] + sections.get("Parameters", "")


def words_of_code(page):
    """All that stands in code or is emphasised there."""
    text = syntax(page)
    code = re.findall(r"```(.*?)```", text, re.S) + re.findall(r"`([^`\n]+)`|\*([^*\n]+)\*", text)
    return set(re.findall(r"[a-z_]+", str(code)))


def described(page):
    """Keywords that are explained there: at the start of a line of a list in code, or with their value in code, as in the
    first column of a table."""
    text = syntax(page)
    heads = re.findall(r"^  ([a-z_]+ .*?)(?:  |$)", "\n".join(re.findall(r"  ```(.*?)```", text, re.S)), re.M)
    pieces = [piece for head in heads for piece in head.split(", ")]
    return {piece.split()[0] for piece in pieces} | set(re.findall(r"`([a-z_]+) [^`\n]+`", text))


class KeywordLists(ScriptTestCase):
    def error(self, command, words):
        """Of LAMMPS at these words behind the command; none where it takes them."""
        code, output = engine.run_text(f"{HEAD}{command}{words}\n", self.folder)
        return "" if code == 0 else next(line for line in output.splitlines() if "ERROR" in line)

    def listed(self, style):
        """What the messages about an unknown keyword name."""
        names = set()
        for command in COMMANDS[style]:
            message = self.error(command, f"{UNKNOWN} 1")
            found = re.search(rf"'{UNKNOWN}'; valid(?: ones| names)?: ([a-z_, ]+)", message)
            self.assertIsNotNone(found, message)
            names |= set(found[1].strip().split(", "))
        return names

    def test_a_keyword_of_the_message_is_on_the_page_and_the_other_way_round(self):
        for page in {page_of(style) for style in COMMANDS}:
            with self.subTest(page):
                listed = set().union(*(self.listed(style) for style in COMMANDS if page_of(style) == page))
                self.assertEqual(listed - words_of_code(page), set())
                self.assertEqual(described(page) - listed, set())

    def test_a_wall_takes_what_its_pair_style_takes(self):
        for style in ("gran_hamaker", "gran_squarewell", "gran_liquidbridge", "gran_jkr"):
            with self.subTest(style):
                self.assertEqual(self.listed(f"pair_{style}") - self.listed(f"fix_wall_{style}"), set())

    def test_a_keyword_of_the_message_is_read(self):
        for style in WRITTEN_BY_HAND:
            for keyword in self.listed(style):
                with self.subTest(style, keyword=keyword):
                    refusals = [self.error(command, f"{keyword} {UNKNOWN}") for command in COMMANDS[style]]
                    self.assertFalse(all("unknown keyword" in refusal for refusal in refusals), refusals)


if __name__ == "__main__":
    unittest.main()
