# SPDX-License-Identifier: BSD-3-Clause
"""Whether a statement agrees with the means over the seeds of a study. A statement is a sum of means, each times a
number, that must be positive. It agrees if the sum exceeds Student's t of 95 %, two-sided, times its standard error.
It differs if the sum is as far below zero. Otherwise the seeds cannot tell. Welch's degrees of freedom allow for rows
of unequal errors. A sum that is 0 in every seed is not seen."""

import csv
from collections import namedtuple
from dataclasses import dataclass
from math import isfinite, sqrt

from scipy.special import stdtrit

CONFIDENCE = 0.95
ROUNDING = 5e-6  # of the six digits of a mean
AGREES, DIFFERS, CANNOT_TELL, NOT_SEEN = "agrees", "differs", "cannot tell", "not seen"

Mean = namedtuple("Mean", "value deviation seeds")  # the deviation is that of one run


class Study:
    """The rows of a summary.csv, as study_table.write_summary() leaves it."""

    def __init__(self, file):
        with open(file, newline="") as lines:
            self.rows = {row["name"]: row for row in csv.DictReader(lines)}

    def number(self, row, column):
        """nan where there is none."""
        try:
            return float(self.rows[row][column])
        except (KeyError, ValueError):
            return float("nan")

    def mean(self, row, figure):
        """Mean, or None without a number and a deviation of two seeds or more."""
        seeds = self.number(row, "seeds")
        found = Mean(self.number(row, figure), self.number(row, f"{figure}_sd"), seeds)
        return found if seeds >= 2 and isfinite(found.value) and isfinite(found.deviation) else None

    def with_error(self, row, figure):
        """(mean, its standard error), the error 0 of one seed; None without a number."""
        value, deviation, seeds = (self.number(row, column) for column in (figure, f"{figure}_sd", "seeds"))
        return (value, deviation / sqrt(seeds) if seeds > 1 else 0.0) if isfinite(value) else None


@dataclass
class Claim:
    """That the sum of `shares`, {row: number}, times the means of `figure` is positive."""

    figure: str
    shares: dict

    def means(self, study):
        return {row: study.mean(row, self.figure) for row in self.shares}

    def verdict(self, study):
        means = self.means(study)
        if None in means.values() or not all(isfinite(share) for share in self.shares.values()):
            return CANNOT_TELL
        value = sum(share * means[row].value for row, share in self.shares.items())
        parts = [((share * means[row].deviation) ** 2 / means[row].seeds, means[row].seeds - 1)
                 for row, share in self.shares.items()]
        variance = sum(part for part, _ in parts)
        if variance == 0:
            return NOT_SEEN if value == 0 and any(self.shares.values()) else CANNOT_TELL
        margin = ROUNDING * sum(abs(share * means[row].value) for row, share in self.shares.items())
        freedom = variance**2 / sum(part**2 / of for part, of in parts)
        margin += stdtrit(freedom, (1 + CONFIDENCE) / 2) * sqrt(variance)
        return AGREES if value > margin else DIFFERS if value < -margin else CANNOT_TELL


def together(claims, study):
    """Of claims that must all hold."""
    verdicts = [claim.verdict(study) for claim in claims]
    for one in (DIFFERS, NOT_SEEN):
        if one in verdicts:
            return one
    return AGREES if verdicts and set(verdicts) == {AGREES} else CANNOT_TELL


def above(figure, one, other):
    """That `one` has more than `other`."""
    return [Claim(figure, {one: 1.0, other: -1.0})]


def trend(figure, where, sign=1):
    """That it rises, with sign -1 falls: the slope of the straight line through the means at `where`, {row: x}."""
    middle = sum(where.values()) / len(where)
    return [Claim(figure, {row: sign * (x - middle) for row, x in where.items()})]


def alike(figure, one, other, none, other_none, sense=1):
    """That the effects of `one` and `other`, their differences from `none` and `other_none`, differ by less than half
    of their mean, and that this mean is a rise, with `sense` -1 a fall; both ways round."""
    claims, half = [], 0.25 * sense
    for sign in (1, -1):
        shares = {one: half + sign, other: half - sign, none: 0.0}
        shares[none] -= half + sign
        shares[other_none] = shares.get(other_none, 0.0) - half + sign
        claims.append(Claim(figure, shares))
    return claims


def less_than_half(figure, one, other):
    """That the trend of `one`, either way, is less than half of that of `other`, a fall: both are trend()s of one
    claim."""
    (flat,), (fall,) = one, other
    return [Claim(figure, {**{row: 0.5 * share for row, share in fall.shares.items()},
                           **{row: sign * share for row, share in flat.shares.items()}}) for sign in (1, -1)]
