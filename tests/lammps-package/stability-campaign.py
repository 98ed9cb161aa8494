#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""All laws and schemes at the ends of their parameters and at random points between, through the engine: two
spheres that meet and a third that strikes two; with walls a sphere that meets one and one that flies into the edge
of two. stability_judge.py says what is compared, and what the verdicts mean.

  stability-campaign.py LMP_WITH_PLUGIN_COMMAND PLUGIN [--table FILE] [--points N] [--law TEXT] [--together N]
  stability-campaign.py LMP_WITH_PLUGIN_COMMAND PLUGIN --law NAME --point K     one point, with all that was said

Points are the same in every run: number K of a law is drawn with seeds of its own. `silent` in the table is a case
that is wrong, or has another outcome, in a run that printed no warning about it: warnings that the material is
softer than it should be do not count.
"""
import re
import sys
from collections import Counter
from concurrent.futures import ThreadPoolExecutor

import numpy

import measuring_program
from progress import Progress
from stability_judge import GOOD, judge, kind

def make(law, number):
    """Point `number` of a law, the corners first."""
    import stability_laws
    from stability_points import Point
    random = numpy.random.default_rng([4711, stability_laws.LAWS.index(law), number])
    values = law.corners[number] if number < len(law.corners) else law.random(random)
    return Point(law, values, random)


def changed(point):
    """The values of a corner that differ from the base point."""
    return ", ".join(part for part, (name, value) in zip(point.text().split(", "), point.values.items())
                     if value != point.law.base[name]) or "base point"


def base_text(law):
    from stability_points import text
    return text(law.base)


def summary(rows):
    """Lines of the table: law, cases by what became of them."""
    lines = ["| law | points | cases right | wrong, warned | wrong, silent | marginal | not judged | points "
             "refused | crashed or hangs | head-on energy, largest error |", "|---|---|---|---|---|---|---|---|---|---|"]
    for law, results in rows.items():
        cases = Counter(kind(v, r.said) for _, _, r in results for v in r.verdicts.values())
        points = Counter(kind(v, r.said) for _, _, r in results for v in [r.verdicts["first"]])
        exact = [r.exact for _, _, r in results if r.exact is not None]
        lines.append(f"| {law} | {len(results)} | {cases['right']} | {cases['warned']} | {cases['silent']} | "
                     f"{cases['marginal']} | {cases['not judged']} | {points['refused']} | {points['crashed']} | "
                     + (f"{max(exact):.1e} of {len(exact)}" if exact else "") + " |")
    return lines


def reasons(results):
    """Refusals by reason, numbers in them left out."""
    said = Counter(re.sub(r"[-+]?\d+(\.\d+)?(e[-+]?\d+)?", "#", r.said) for _, _, r in results
                   if r.verdicts["first"] == "refused")
    return [f"- {count} x {text}" for text, count in said.most_common()]


def cells(result):
    return " | ".join(f"{result.verdicts.get(name, 'not set up')} | "
                      + (f"{result.errors[name]:.1e}" if name in result.errors else "")
                      for name in ("first", "second")) + f" | {result.said} |"


def details(law, results):
    head = ["| point | first | error | second | error | said |", "|---|---|---|---|---|---|"]
    inner = [(n, p, r) for n, p, r in results if n >= len(p.law.corners)]
    lines = ["", f"## {law}", ""]
    if results[0][0] < len(results[0][1].law.corners):
        lines += ["Base point: " + base_text(results[0][1].law) + ". One parameter at a time:", "", *head]
        lines += [f"| {changed(p)} | {cells(r)}" for n, p, r in results if n < len(p.law.corners)]
    bad = [(n, p, r) for n, p, r in inner if any(kind(v, r.said) not in GOOD for v in r.verdicts.values())]
    lines += ["", f"{len(inner)} random points; what was not right:", "", *head]
    lines += [f"| {n}: {p.text()} | {cells(r)}" for n, p, r in bad] or ["| none | | | | | |"]
    refused = reasons(results)
    return lines + (["", "Refused:", "", *refused] if refused else [])


def report(rows):
    lines = ["# Stability at the ends of all parameters", "",
             "Written by `tests/lammps-package/stability-campaign.py`; `stability_judge.py` there says what was compared",
             "and what the verdicts mean. Spheres of 1 mm and 2650 kg/m^3. depth: speed that the well adds, over the",
             "speed of impact; width: of the well, over the flight within it in a contact time (hard: over the sum of",
             "radii).", "", *summary(rows)]
    for law, results in rows.items():
        lines += details(law, results)
    return "\n".join(lines) + "\n"


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


def main():
    words = measuring_program.words(
        __doc__, ("--table", {"metavar": "FILE", "help": "where to write the page as well"}),
        ("--points", {"type": int, "default": 250, "help": "random ones of each law"}),
        ("--law", {"default": "", "help": "only those whose name has this"}),
        ("--point", {"type": int, "help": "only this one"}),
        ("--together", {"type": int, "default": 6, "help": "runs at a time; most of a run is waiting"}))
    import lammps_engine as engine
    import stability_laws
    laws = [law for law in stability_laws.LAWS if words.law in law.name]
    if not laws:
        sys.exit(f"--law '{words.law}': there are " + "; ".join(law.name for law in stability_laws.LAWS))
    if words.point is not None:
        for law in laws:
            point = make(law, words.point)
            print(law.name, point.text(), judge(point, engine), sep="\n")
        return
    text = report(campaign(laws, words.points, words.together, engine))
    print(text)
    if words.table:
        with open(words.table, "w") as file:
            file.write(text)


if __name__ == "__main__":
    main()
