# SPDX-License-Identifier: BSD-3-Clause
"""Pages of the stability campaign: every corner point is either counted as correct or listed in the table, and the
committed pages are those that the program makes: stability_pages_test.py SOURCE."""
import re
import sys
import unittest
from pathlib import Path

import numpy

from cohesion_tests.lammps_scenes import stability_corners, stability_laws, stability_pages as pages
from cohesion_tests.lammps_scenes.stability_judge import Result
from cohesion_tests.lammps_scenes.stability_points import Point

DOCS = Path(sys.argv[1]) / "docs"
LAWS = {law.name: law for law in stability_laws.LAWS}
SAMPLED = LAWS["gran/hamaker, sampled"]
CORRECT = Result({"first": "right", "second": "right"}, {"first": 1e-3, "second": 2e-3}, "10 steps per contact", None)


def result(first, second, said):
    return Result({"first": first, "second": second}, {"first": 0.3, "second": 1e-3}, said, None)


def stopped(reason):
    return Result({"first": "refused", "second": "refused"}, {}, reason, None)


def make(law, values):
    return Point(law, values, numpy.random.default_rng(1))


def campaign(law, corners, inner=()):
    """Rows of a law: CORRECT at all corner points but those of `corners` (number -> Result); `inner`: time steps and
    results of random points."""
    found = [(n, make(law, values), corners.get(n, CORRECT)) for n, values in enumerate(law.corners)]
    found += [(len(found) + n, make(law, {"steps": steps}), one) for n, (steps, one) in enumerate(inner)]
    return {law.name: found}


def cells(page, section):
    """Rows of the table in a section, without its head."""
    body = re.split(r"^## ", page.split(f"## {section}\n")[1], flags=re.M)[0]
    lines = [line for line in body.splitlines() if line.startswith("|")]
    return [[cell.strip() for cell in line.strip("|").split("|")] for line in lines[2:]]


OTHER = f"Points that are {stability_corners.NEITHER}"


def made(corners, inner=()):
    """Lines of the table of SAMPLED, and its page."""
    lines = stability_corners.lines_of(SAMPLED.name, campaign(SAMPLED, corners, inner)[SAMPLED.name])
    return lines, stability_corners.page("pairs", lines, "stability.md")


class CornerPoints(unittest.TestCase):
    def test_correct_points_are_counted_by_what_they_vary(self):
        """Hamaker's corner points begin with two of K, of which the second is not correct here."""
        corners = {1: result("wrong by 0.3", "right", "2 steps per contact"),
                   2: CORRECT._replace(errors={"first": 0.04, "second": 0.01}, said="")}
        lines, page = made(corners)
        counted = {line["varied"]: (line["number"], line["largest error"], line["reported"]) for line in lines}
        number = len(SAMPLED.corners)
        self.assertEqual(counted["K"], ("1", "2.0e-03", ""))
        self.assertEqual(counted["e"], ("4", "4.0e-02", ""))
        self.assertEqual(counted["all"], (str(number - 1), "4.0e-02", f"{number - 2} with a warning"))
        self.assertEqual(cells(page, "Corner points"),
                         [[SAMPLED.name, str(number), str(number - 1), "0", "1", "4.0e-02", str(number - 2)]])
        self.assertEqual(cells(page, OTHER), [[SAMPLED.name, "K 1e+07 N/m", "incorrect (3.0e-01)", "correct (1.0e-03)",
                                               "yes"]])
        self.assertNotIn("Points that stop", page)
        self.assertIn("Incorrect corner points without a warning: 0.", page.replace("\n", " "))
        page = made({1: result("wrong", "right", "")})[1]
        self.assertIn("Incorrect corner points without a warning: 1.", page.replace("\n", " "))

    def test_points_that_stop_are_counted_by_their_error(self):
        corners = {0: stopped("contacts unstable"), 3: stopped("contacts unstable"), 1: stopped("impact overlap 140 %")}
        inner = ((3.0, stopped("impact overlap 140 %; more")), (3.0, stopped("impact overlap 3e+02 %")))
        lines, page = made(corners, inner)
        self.assertEqual([line["varied"] for line in lines if line["reported"] == "contacts unstable"],
                         ["K 10 N/m", "e 0.001"])
        self.assertEqual(cells(page, "Points that stop with an error"),
                         [["contacts unstable", "2, 0"], ["impact overlap # %", "1, 2"]])

    def test_random_points_are_listed_without_a_warning_for_their_contact(self):
        inner = ((10.0, result("wrong by 0.3", "right", "10 steps per contact")),
                 (16.0, result("other outcome", "right", "11 steps per contact (2 - 2)")),
                 (17.0, result("wrong: not a number", "right", "")))
        lines, page = made({}, inner)
        number = len(SAMPLED.corners)
        self.assertEqual([(line["varied"], line["first case"]) for line in lines if line["points"] == "random"],
                         [(f"random {number + 1}: t_c/dt 16", "other outcome (3.0e-01)"),
                          (f"random {number + 2}: t_c/dt 17", "incorrect: not a number (3.0e-01)")])
        self.assertEqual(cells(page, OTHER), [[SAMPLED.name, "2 random points: t_c/dt 16 to 17", "errors up to 3.0e-01",
                                               "errors up to 1.0e-03", "of others, no"]])


class MainPage(unittest.TestCase):
    def test_random_points_by_their_time_step(self):
        inner = ((2.5, CORRECT), (2.5, stopped("contacts unstable")),
                 (16.0, result("wrong by 0.3", "marginal", "11 steps per contact (2 - 2)")), (16.0, CORRECT))
        rows = campaign(SAMPLED, {}, inner)
        found = {row[1]: list(map(str, row[2:])) for row in pages.by_steps(rows)[1:]}
        self.assertEqual([found[name][0] for name in pages.FIGURES], ["2/2", "0", "1/2"])
        self.assertEqual([found[name][-1] for name in pages.FIGURES], ["2/3", "1", "0/2"])
        self.assertEqual(cells(pages.main_page(rows, {}), "Results")[0],
                         [SAMPLED.name, str(len(SAMPLED.corners) + 4), str(2 * len(SAMPLED.corners) + 4), "0", "1", "0",
                          "1", "0", "1"])

    def test_laws_without_results_are_named(self):
        page = pages.main_page(campaign(SAMPLED, {}), {})
        self.assertEqual(set(re.findall(r"^- (.*)$", page, re.M)), set(LAWS) - {SAMPLED.name})


class CommittedPages(unittest.TestCase):
    def setUp(self):
        self.main = (DOCS / "verification/stability.md").read_text()
        self.tables = {what: stability_corners.read(DOCS / f"verification/stability_{what}.csv")
                       for what in stability_corners.SUBJECTS}

    def test_every_corner_point_is_counted_or_listed(self):
        measured = [row[0] for row in cells(self.main, "Results")]
        laws = {law: own for lines in self.tables.values() for law, own in stability_corners.by_law(lines).items()}
        self.assertEqual(sorted(measured), sorted(laws))
        for name, own in laws.items():
            with self.subTest(name):
                counted = [line for line in own if stability_corners.is_counted(line)]
                listed = [line["varied"] for line in own if line["points"] == "corner" and line not in counted]
                correct = int(stability_corners.total(own)["number"])
                self.assertEqual(sum(int(line["number"]) for line in counted), 2 * correct)
                self.assertEqual(correct + len(listed), len(LAWS[name].corners))
                self.assertLessEqual(set(listed), corner_texts(LAWS[name]))

    def test_pages_are_those_of_the_tables(self):
        for words in (pages.HEAD, pages.TERMS, pages.BY_STEPS.splitlines()):
            self.assertIn("\n".join(words), self.main)
        for what, lines in self.tables.items():
            self.assertEqual((DOCS / f"verification/stability_{what}.md").read_text(),
                             stability_corners.page(what, lines, "stability.md"))


def corner_texts(law):
    return {stability_corners.text(law, stability_corners.changed(make(law, values))) for values in law.corners}


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
