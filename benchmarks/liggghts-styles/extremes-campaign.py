#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The cohesion models at the ends of their parameters, through LIGGGHTS.

  extremes-campaign.py LIGGGHTS_COHESION [--table FILE] [--points N] [--seed N] [--jobs N] [--scheme NAME] [--law NAME]
  extremes-campaign.py --remake FILE      the page FILE from the tables beside it, without runs

What is done, and what the verdicts mean: tests/support/cohesion_tests/liggghts_scenes/extremes.py. Tables with
all numbers of the page stand beside FILE.
"""
import argparse
import concurrent.futures
import pathlib
import sys

import numpy

from cohesion_tests.launcher import given_program
from cohesion_tests.liggghts_scenes import extremes, extremes_page
from cohesion_tests.liggghts_scenes.extremes_points import CORNERS, INTEGRATED, LAWS, random_point
from cohesion_tests.progress import Progress


def main():
    if sys.argv[1:2] == ["--remake"]:
        return extremes_page.remake(pathlib.Path(sys.argv[2]))
    words = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    words.add_argument("launcher", type=given_program)
    words.add_argument("--table", metavar="FILE", help="where to write the page as well")
    words.add_argument("--points", type=int, default=100, help="random ones of each law")
    words.add_argument("--seed", type=int, default=4711)
    words.add_argument("--jobs", type=int, default=1, help="runs at a time")
    words.add_argument("--scheme", choices=extremes.SCHEMES, action="append", help="both, if not given")
    words.add_argument("--law", choices=(*LAWS, *INTEGRATED), help="all, if not given")
    words = words.parse_args()
    random = numpy.random.default_rng(words.seed)
    of_laws = [(law, values, corner) for law in LAWS
               for values, corner in [(c, True) for c in CORNERS[law]]
               + [(random_point(law, random), False) for _ in range(words.points)]]
    schemes = words.scheme or extremes.SCHEMES
    starts = [random.uniform(0.2, 1.2) for _ in of_laws] * len(schemes)
    points = [(law, scheme, values, corner) for scheme in schemes for law, values, corner in of_laws]
    for law in INTEGRATED if "exact" in schemes else ():
        drawn = [(c, True) for c in CORNERS[law]] + [(random_point(law, random), False) for _ in range(words.points)]
        starts += [random.uniform(0.2, 1.2) for _ in drawn]
        points += [(law, "exact", values, corner) for values, corner in drawn]
    if words.law:
        starts, points = zip(*((s, p) for s, p in zip(starts, points) if p[0] == words.law))

    def judge(point, start):
        law, scheme, values, _ = point
        results = [extremes.judge_two(words.launcher, law, scheme, values, start, wall) for wall in (False, True)]
        return results + [extremes.judge_three(words.launcher, law, scheme, values, start)]

    progress, rows = Progress(len(points)), []
    pool = concurrent.futures.ThreadPoolExecutor(words.jobs)
    for (law, scheme, values, corner), results in zip(points, pool.map(judge, points, starts)):
        rows.append((f"{law}, {scheme}", values, corner, results))
        progress.add(1)
    print(file=sys.stderr)
    counts, points = extremes_page.outcomes(rows), extremes_page.listed(rows)
    print(extremes_page.page(counts, points, "extremes"))
    if words.table:
        extremes_page.write(pathlib.Path(words.table), counts, points)


if __name__ == "__main__":
    main()
