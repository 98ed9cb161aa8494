# SPDX-License-Identifier: BSD-3-Clause
"""Pages of the stability campaign: every corner point is either counted as correct or listed, and the committed pages
have the form that the program writes: stability_pages_test.py SOURCE."""
import re
import sys
import unittest
from pathlib import Path

import numpy

from cohesion_tests.lammps_scenes import stability_laws, stability_pages as pages
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


class CornerPoints(unittest.TestCase):
    def test_correct_points_are_counted_by_what_they_vary(self):
        """Hamaker's corner points begin with two of K, of which the second is not correct here."""
        corners = {1: result("wrong by 0.3", "right", "2 steps per contact"),
                   2: CORRECT._replace(errors={"first": 0.04, "second": 0.01}, said="")}
        page = pages.corner_page("pairs", campaign(SAMPLED, corners), "stability.md")
        counted = dict(cells(page, "Correct corner points"))
        number = len(SAMPLED.corners)
        self.assertEqual(counted["K"], "1 (2.0e-03)")
        self.assertEqual(counted["e"], "4 (4.0e-02)")
        self.assertEqual(counted["all"], f"{number - 1} (4.0e-02)")
        self.assertEqual(counted["of these with a warning"], str(number - 2))
        self.assertEqual(counted["all corner points"], str(number))
        self.assertEqual(cells(page, "Other points"),
                         [[SAMPLED.name, "K 1e+07 N/m", "incorrect (3.0e-01)", "correct (1.0e-03)",
                           "2 steps per contact"]])
        self.assertNotIn("Random points that stop", page)

    def test_points_of_the_same_cells_share_a_row(self):
        corners = {0: stopped("contacts unstable"), 3: stopped("contacts unstable"), 1: stopped("impact overlap 140 %")}
        page = pages.corner_page("pairs", campaign(SAMPLED, corners), "stability.md")
        self.assertEqual([row[1:] for row in cells(page, "Other points")],
                         [["K 10 N/m; e 0.001", "stops", "stops", "contacts unstable"],
                          ["K 1e+07 N/m", "stops", "stops", "impact overlap 140 %"]])

    def test_random_points_are_listed_without_a_warning_for_their_contact(self):
        inner = ((10.0, result("wrong by 0.3", "right", "10 steps per contact")),
                 (16.0, result("other outcome", "right", "11 steps per contact (2 - 2)")),
                 (17.0, result("wrong: not a number", "right", "")), (3.0, stopped("impact overlap 140 %; more")),
                 (3.0, stopped("impact overlap 3e+02 %")))
        page = pages.corner_page("pairs", campaign(SAMPLED, {}, inner), "stability.md")
        number = len(SAMPLED.corners)
        self.assertEqual([row[1:3] for row in cells(page, "Other points")],
                         [[f"random {number + 1}: t_c/dt 16", "other outcome (3.0e-01)"],
                          [f"random {number + 2}: t_c/dt 17", "incorrect: not a number (3.0e-01)"]])
        self.assertEqual(cells(page, "Random points that stop with an error"),
                         [[SAMPLED.name, "impact overlap # %", "2"]])


class MainPage(unittest.TestCase):
    def test_random_points_by_their_time_step(self):
        inner = ((2.5, CORRECT), (2.5, stopped("contacts unstable")),
                 (16.0, result("wrong by 0.3", "marginal", "11 steps per contact (2 - 2)")), (16.0, CORRECT))
        rows = campaign(SAMPLED, {}, inner)
        found = {row[1]: row[2:] for row in cells(pages.main_page(rows, {}), pages.STEPS_TITLE)}
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
        self.main = (DOCS / "lammps-package/stability.md").read_text()
        self.corners = {what: (DOCS / f"verification/stability_{what}.md").read_text() for what in ("pairs", "walls")}

    def test_every_corner_point_is_counted_or_listed(self):
        measured = [row[0] for row in cells(self.main, "Results")]
        for page in self.corners.values():
            names = re.search(r"^\| varied \|(.*)\|$", page, re.M)[1].split(" | ")
            counted = {row[0]: row[1:] for row in cells(page, "Correct corner points")}
            for number, name in enumerate(map(str.strip, names)):
                with self.subTest(name):
                    measured.remove(name)
                    listed = [point for row in cells(page, "Other points") if row[0] == name
                              for point in row[1].split("; ") if not point.startswith("random ")]
                    correct = int(counted["all"][number].split()[0])
                    self.assertEqual(correct + len(listed), len(LAWS[name].corners))
                    self.assertEqual(counted["all corner points"][number], str(len(LAWS[name].corners)))
                    self.assertLessEqual(set(listed), corner_texts(LAWS[name]))
        self.assertEqual(measured, [])

    def test_words_of_the_pages_are_those_of_the_program(self):
        for words in (pages.HEAD, pages.TERMS, pages.BY_STEPS.splitlines()):
            self.assertIn("\n".join(words), self.main)
        for what, page in self.corners.items():
            for words in (pages.CORNER_HEAD.format(what=what, back="../lammps-package/stability.md"), pages.CORRECT,
                          pages.OTHER, pages.STOPPED):
                self.assertIn(words, page)


def corner_texts(law):
    return {pages.text(law, pages.changed(make(law, values))) for values in law.corners}


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
