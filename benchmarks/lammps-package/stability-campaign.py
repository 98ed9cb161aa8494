#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The stability campaign: all laws and schemes at the ends of their parameters and at random points between. Two
spheres collide and a third strikes two; with walls a sphere hits one and another flies into the edge of two.
stability_judge.py describes the comparison and its verdicts; stability_pages.py and stability_corners.py write the
pages.

  stability-campaign.py LMP_WITH_PLUGIN_COMMAND PLUGIN [--table FILE.md] [--details FOLDER] [--points N] [--law TEXT]
  stability-campaign.py LMP_WITH_PLUGIN_COMMAND PLUGIN --law NAME --point K     one point with all its warnings
  stability-campaign.py --remake docs/verification     pages of corner points from their CSV files, without runs

The pages of the documentation: --table docs/verification/stability.md --details docs/verification. Points are the
same in every run: number K of a law is drawn with its own seeds.
"""
import os
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy

from cohesion_tests import lammps as engine, measuring_program
from cohesion_tests.lammps_scenes import stability_corners, stability_laws, stability_pages
from cohesion_tests.lammps_scenes.stability_judge import judge
from cohesion_tests.lammps_scenes.stability_points import Point
from cohesion_tests.progress import Progress


def make(law, number):
    """Point `number` of a law, the corners first."""
    random = numpy.random.default_rng([4711, stability_laws.LAWS.index(law), number])
    values = law.corners[number] if number < len(law.corners) else law.random(random)
    return Point(law, values, random)


def campaign(laws, count, together, engine):
    """Law's name -> [(number, Point, Result)]."""
    points = [(law, n, make(law, n)) for law in laws for n in range(len(law.corners) + count)]
    progress, rows = Progress(len(points)), {law.name: [] for law in laws}
    with ThreadPoolExecutor(together) as pool:
        for (law, n, point), result in zip(points, pool.map(lambda p: judge(p[2], engine), points)):
            rows[law.name].append((n, point, result))
            progress.add(1)
    print(file=sys.stderr)
    return rows


def corner_pages(parts, details, back):
    """Writes table and page of each part in the folder `details`, if there is one; returns their texts."""
    texts = {what: stability_corners.page(what, lines, back) for what, lines in parts.items()}
    for what, text in texts.items() if details else ():
        stability_corners.write(details / f"stability_{what}.csv", parts[what])
        (details / f"stability_{what}.md").write_text(text)
    return texts


def remake(details):
    files = {what: details / f"stability_{what}.csv" for what in stability_corners.SUBJECTS}
    corner_pages({what: stability_corners.read(file) for what, file in files.items()}, details, "stability.md")


def link(folder, file):
    return Path(os.path.relpath(file, folder)).as_posix()


def main():
    if sys.argv[1:2] == ["--remake"]:
        return remake(Path(sys.argv[2]))
    words = measuring_program.words(
        __doc__, ("--table", {"metavar": "FILE.md", "type": Path, "help": "where to write the main page, too, with a .csv file"}),
        ("--details", {"metavar": "FOLDER", "type": Path, "help": "where to write the pages of corner points "
                       "and their tables, stability_pairs and stability_walls; with --table"}),
        ("--points", {"type": int, "default": 250, "help": "random points of each law"}),
        ("--law", {"default": "", "help": "only laws whose name contains this"}),
        ("--point", {"type": int, "help": "only this point"}),
        ("--together", {"type": int, "default": 6, "help": "runs at a time; most of a run is waiting"}))
    laws = [law for law in stability_laws.LAWS if words.law in law.name]
    if not laws:
        sys.exit(f"--law '{words.law}': there are " + "; ".join(law.name for law in stability_laws.LAWS))
    if words.point is not None:
        for law in laws:
            point = make(law, words.point)
            print(law.name, point.text(), judge(point, engine), sep="\n")
        return
    if words.details and not words.table:
        sys.exit("--details needs --table: the pages link to each other")
    rows = campaign(laws, words.points, words.together, engine)
    parts, details = stability_corners.parts(rows), words.details
    texts = corner_pages(parts, details, link(details, words.table) if details else "stability.md")
    links = {what: link(words.table.parent, details / f"stability_{what}.md") for what in texts} if details else {}
    main_page = stability_pages.main_page(rows, links)
    if words.table:
        words.table.write_text(main_page)
        stability_pages.write_steps(words.table, rows)
    print(main_page, *texts.values(), sep="\n")


if __name__ == "__main__":
    main()
