# SPDX-License-Identifier: BSD-3-Clause
"""The table of the thesis's statements, on made-up studies that agree, disagree and cannot tell; its pictures."""

import importlib.util
import itertools
import tempfile
import unittest
from pathlib import Path

from scipy.stats import ttest_ind_from_stats

import study
from cohesion_studies.bed import statements
from cohesion_studies.bed.verdict import (AGREES, CANNOT_TELL, DIFFERS, NOT_SEEN, Claim, Study, above, alike,
                                          less_than_half, together, trend)
from cohesion_studies.study_table import write_summary

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"

TABLES = {"levels": EXAMPLES / "defluidisation-cycle/cohesion-levels.csv",
          "mechanisms": EXAMPLES / "overshoot-mechanisms/mechanisms.csv"}
SPEEDS = {"none": 0.0, "1e-11": 1.79e-3, "5e-11": 4.0e-3, "1e-10": 5.66e-3}
OVERSHOOT = {"none": -0.05, "none-friction": -0.04, "none-40": -0.05, "none-120": -0.05,
             "well": 0.3, "well-no-particles": 0.05, "well-no-plate": 0.1, "well-no-side": 0.28, "well-40": 0.31,
             "well-120": 0.29, "hamaker": 0.32, "hamaker-no-particles": 0.05, "hamaker-no-side": 0.1,
             "hamaker-no-plate": 0.3, "hamaker-40": 0.4, "hamaker-120": 0.2}


def picture(room):
    """picture.py of a room; they have one name."""
    spec = importlib.util.spec_from_file_location(f"{room}_picture", EXAMPLES / room / "picture.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def spread(mean, deviation, seeds=3):
    """Figures of that mean and deviation."""
    step = deviation * ((seeds + 1) * seeds / 12) ** -0.5
    return [mean + step * (k - (seeds - 1) / 2) for k in range(seeds)]


class Made(unittest.TestCase):
    def setUp(self):
        keeper = tempfile.TemporaryDirectory(prefix="cohesion-")
        self.addCleanup(keeper.cleanup)
        self.folder = Path(keeper.name)

    def made_up(self, rows, parameters=None):
        """Study of {row: {figure: values of the seeds}}; `parameters`: {row: dict}."""
        results = {row: [dict(zip(figures, values)) for values in zip(*figures.values())]
                   for row, figures in rows.items()}
        write_summary(self.folder / "summary.csv", {row: (parameters or {}).get(row, {}) for row in rows}, results)
        return Study(self.folder / "summary.csv")

    def level_study(self, slope, deviation, seeds=3):
        """All rows of cohesion-levels.csv; with `slope` 1 as the thesis says, with -1 the opposite."""
        rows, speeds = {}, {}
        for row in study.rows(TABLES["levels"]):
            speed = next(v for k, v in SPEEDS.items() if k in row)
            speeds[row] = {"v_esc": speed}
            change = slope * speed / 5.66e-3
            rows[row] = {**{figure: spread(0.7 + 0.2 * change, deviation, seeds) for figure in statements.VELOCITIES},
                         "mixing": spread(2 - change, deviation, seeds),
                         "movement": spread(2e-3 - 1e-3 * change, 1e-3 * deviation, seeds),
                         "overshoot": spread(0.1 * change, deviation, seeds),
                         "overshoot_over_plateau": spread(0.1 * change, deviation, seeds),
                         "plugging": spread(0.5 + 0.4 * change, deviation, seeds)}
        return self.made_up(rows, speeds)

    def mechanism_study(self, turn, deviation):
        """All rows of mechanisms.csv; `turn`: of their overshoot."""
        self.assertEqual(set(OVERSHOOT), set(study.rows(TABLES["mechanisms"])))
        return self.made_up({row: {figure: spread(turn(mean), deviation) for figure in statements.OVERSHOOTS}
                             for row, mean in OVERSHOOT.items()})


class Rule(Made):
    def test_of_two_rows_it_is_welchs_test(self):
        """By another program, around its border of 5 %."""
        seen = set()
        for first, deviation, seeds, other in itertools.product((0.0, 1.0, 2.0), (0.1, 0.5, 1.5), (2, 3, 7), (3, 4)):
            made = self.made_up({"a": {"u": spread(first, deviation, seeds)}, "b": {"u": spread(1.0, 0.3, other)}})
            a, b = made.mean("a", "u"), made.mean("b", "u")
            test = ttest_ind_from_stats(a.value, a.deviation, a.seeds, b.value, b.deviation, b.seeds, equal_var=False)
            expected = CANNOT_TELL if test.pvalue > 0.05 else AGREES if a.value > b.value else DIFFERS
            self.assertEqual(together(above("u", "a", "b"), made), expected)
            seen.add(expected)
        self.assertEqual(seen, {AGREES, DIFFERS, CANNOT_TELL})

    def test_of_a_trend(self):
        rows = {name: {"u": spread(mean, 0.1)} for name, mean in (("a", 1.0), ("b", 1.4), ("c", 1.3))}
        made, where = self.made_up(rows), {"a": 0.0, "b": 1.0, "c": 2.0}
        self.assertEqual(together(trend("u", where), made), AGREES)
        self.assertEqual(together(trend("u", where, -1), made), DIFFERS)
        self.assertEqual(together(trend("u", {**where, "c": float("nan")}), made), CANNOT_TELL)
        self.assertEqual(together(trend("u", dict.fromkeys(where, 1.0)), made), CANNOT_TELL)

    def test_of_what_is_alike(self):
        """None 1, one 2, other 2 + x: half of the effect is 0.5 + x/4, so that the border is x = 2/3."""
        for x, deviation, expected in ((0.1, 0.01, AGREES), (0.6, 0.01, AGREES), (0.75, 0.01, DIFFERS),
                                       (-0.35, 0.01, AGREES), (-0.45, 0.01, DIFFERS), (0.1, 1.0, CANNOT_TELL)):
            made = self.made_up({"none": {"u": spread(1.0, deviation)}, "one": {"u": spread(2.0, deviation)},
                                 "other": {"u": spread(2.0 + x, deviation)}})
            self.assertEqual(together(alike("u", "one", "other", "none", "none"), made), expected, x)

    def test_of_falls_that_are_alike(self):
        """As the rises, with both signs turned."""
        for x, expected in ((0.6, AGREES), (0.75, DIFFERS), (-0.35, AGREES), (-0.45, DIFFERS)):
            made = self.made_up({"none": {"u": spread(3.0, 0.01)}, "one": {"u": spread(2.0, 0.01)},
                                 "other": {"u": spread(2.0 - x, 0.01)}})
            self.assertEqual(together(alike("u", "one", "other", "none", "none", sense=-1), made), expected, x)
            self.assertEqual(together(alike("u", "one", "other", "none", "none"), made), DIFFERS, x)

    def test_of_effects_of_two_kinds(self):
        """Effects 1 and 1.1 over 1 and 3 are alike, over 1 and 1 they are 1 and 3.1."""
        made = self.made_up({"none": {"u": spread(1.0, 0.01)}, "rest": {"u": spread(3.0, 0.01)},
                             "one": {"u": spread(2.0, 0.01)}, "other": {"u": spread(4.1, 0.01)}})
        self.assertEqual(together(alike("u", "one", "other", "none", "rest"), made), AGREES)
        self.assertEqual(together(alike("u", "one", "other", "none", "none"), made), DIFFERS)

    def test_of_less_than_half_a_fall(self):
        """Of a fall by 2 over the range: 0.8 in either direction is, 1.2 is not."""
        where = {"a": 0.0, "b": 1.0}
        for change, expected in ((0.8, AGREES), (-0.8, AGREES), (1.2, DIFFERS), (-1.2, DIFFERS)):
            made = self.made_up({"a": {"u": spread(3.0, 0.01)}, "b": {"u": spread(1.0, 0.01)},
                                 "c": {"u": spread(5.0, 0.01)}, "d": {"u": spread(5.0 + change, 0.01)}})
            claims = less_than_half("u", trend("u", {"c": 0.0, "d": 1.0}), trend("u", where, -1))
            self.assertEqual(together(claims, made), expected, change)

    def test_without_figures_seeds_or_spread(self):
        made = self.made_up({"a": {"u": [1.0]}, "b": {"u": [2.0, 2.0]}, "c": {"u": [3.0, 3.0]}, "d": {"u": []},
                             "e": {"u": [float("nan")] * 3}, "f": {"u": [2.0, 2.0]}})
        for row in ("a", "d", "e", "missing"):
            self.assertEqual(together(above("u", "c", row), made), CANNOT_TELL, row)
        for one, other, expected in (("c", "b", CANNOT_TELL), ("b", "c", CANNOT_TELL), ("b", "f", NOT_SEEN)):
            self.assertEqual(together(above("u", one, other), made), expected)
        # Six digits are printed: what their rounding may have made is no difference.
        rounded = self.made_up({"a": {"u": [1.00000490, 1.00000491]}, "b": {"u": [1.00000510, 1.00000511]}})
        self.assertEqual(together(above("u", "b", "a"), rounded), CANNOT_TELL)
        self.assertEqual(together([], made), CANNOT_TELL)

    def test_all_claims_must_hold(self):
        made = self.made_up({"a": {"u": spread(1, 0.1)}, "b": {"u": spread(2, 0.1)}, "c": {"u": spread(2, 0.1)}})
        yes, no, unclear = Claim("u", {"b": 1, "a": -1}), Claim("u", {"a": 1, "b": -1}), Claim("u", {"b": 1, "c": -1})
        for claims, expected in (([yes, yes], AGREES), ([yes, unclear], CANNOT_TELL), ([yes, no, unclear], DIFFERS)):
            self.assertEqual(together(claims, made), expected)


class Statements(Made):
    def verdicts(self, of, made):
        found = {statement.text: together(statement.claims, made) for statement in of(made)}
        _, _, *lines = statements.table(of(made), made).splitlines()
        shown = [line.strip("| ").split(" | ") for line in lines]
        self.assertEqual({text: verdict for text, _, verdict in shown}, found)
        for _, figures, _ in shown:
            self.assertRegex(figures, r"^(\S+: [-+.\de]+ \+- [.\de-]+ \(3\)(; |$))+$")
        return found

    def test_of_levels(self):
        agree, oppose, noisy = (self.verdicts(statements.of_levels, self.level_study(*numbers))
                                for numbers in ((1, 0.01), (-1, 0.01), (1, 3.0)))
        self.assertEqual(set(agree.values()), {AGREES})
        self.assertEqual({text: verdict for text, verdict in oppose.items() if verdict != DIFFERS}, {})
        self.assertEqual(set(noisy.values()), {CANNOT_TELL})
        # Velocities, mixing and movement: two slopes and three levels; overshoot and plugs of two laws; schemes.
        self.assertEqual(len(agree), 2 * (5 * (2 + 3) + 2 * 2) + 3 * 2 * 3)

    def test_of_mechanisms(self):
        agree = self.verdicts(statements.of_mechanisms, self.mechanism_study(lambda x: x, 0.005))
        self.assertEqual(set(agree.values()), {AGREES})
        oppose = self.verdicts(statements.of_mechanisms, self.mechanism_study(lambda x: 0.5 - x, 0.005))
        self.assertEqual(set(oppose.values()), {DIFFERS})
        noisy = self.verdicts(statements.of_mechanisms, self.mechanism_study(lambda x: x, 2.0))
        self.assertEqual(set(noisy.values()), {CANNOT_TELL})

    def test_one_seed_tells_nothing(self):
        made = self.level_study(1, 0.0, 1)
        self.assertEqual({together(s.claims, made) for s in statements.of_levels(made)}, {CANNOT_TELL})
        self.assertIn("| none: 0.7 (1); well-1e-11: 0.", statements.table(statements.of_levels(made), made))

    def test_rows_that_are_missing_are_named(self):
        made = self.made_up({"none": {"U_mf_df": [0.7, 0.8]}})
        shown = statements.table(statements.of_levels(made), made)
        self.assertIn("| none: 0.75 +- 0.05 (2); well-1e-11: unknown; ", shown)

    def test_pictures(self):
        width = {row: {"width": given["width"]} for row, given in study.rows(TABLES["mechanisms"]).items()}
        forces = ("overshoot", "overshoot_over_plateau", "sides_at_maximum", "plate_at_maximum",
                  "plate_pull_at_maximum", "gain_at_maximum")
        for seeds in (3, 1):
            mechanisms = self.made_up({row: {figure: spread(0.2, 0.01, seeds) for figure in forces} for row in width},
                                      width)
            for room, made in (("overshoot-mechanisms", mechanisms),
                               ("defluidisation-cycle", self.level_study(1, 0.01, seeds))):
                picture(room).draw(made, self.folder / f"{room}.png")
                self.assertGreater((self.folder / f"{room}.png").stat().st_size, 10000)


if __name__ == "__main__":
    unittest.main()
