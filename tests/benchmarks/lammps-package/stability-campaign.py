#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""All laws and schemes at the ends of their parameters and at random points between, through the engine: two
spheres that meet and a third that strikes two; with walls a sphere that meets one and one that flies into the edge
of two. stability_judge.py says what is compared, and what the verdicts mean.

  stability-campaign.py LMP_WITH_PLUGIN_COMMAND PLUGIN [--table FILE.md] [--points N] [--law TEXT] [--together N]
  stability-campaign.py LMP_WITH_PLUGIN_COMMAND PLUGIN --law NAME --point K     one point, with all that was said

Points are the same in every run: number K of a law is drawn with seeds of its own. `silent` in the table is a case
that is wrong, or has another outcome, in a run that printed no warning about the step, the cut-off, the well, rounding
or a collapse: warnings that the material is softer than it should be do not count.
"""
import re
import sys
from collections import Counter
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy

from cohesion_tests import lammps as engine, measuring_program
from cohesion_tests.lammps_scenes import stability_laws
from cohesion_tests.lammps_scenes.stability_judge import COARSE, judge, kind
from cohesion_tests.lammps_scenes.stability_points import Point, text
from cohesion_tests.progress import Progress

HEAD = ("| point | first | error | second | error | said |", "|---|---|---|---|---|---|")
STEPS = (2, 3, 4, 5, 10, 15, 20)
# What stands apart, by what comes behind the name of the page
APART = {"_pairs": "pairs", "_walls": "walls"}
PAGE = """# Stability at the ends of all parameters

Written by `tests/benchmarks/lammps-package/stability-campaign.py`, on the stock engine. Laws and schemes of
the table below, which are all but liquid bridges and *sampled* walls of Hamaker's law, at corners of their parameters,
one at a time, and at random points between, the same in every run. *first*: two spheres that meet,
with walls a sphere that meets one; *second*: a sphere that strikes two that touch, with walls one that flies into the
edge of two. Spheres of 1 mm and 2650 kg/m^3 and smaller ones; *depth*: speed that the well adds, over the speed of
impact; *width*: of the well, over the flight within it in a contact time (hard: over the sum of radii).

Soft laws are compared with *scheme event* at a sixteenth of the step and, head-on, with the closed form; hard ones
with an event-driven program without steps. An error is that of the velocities at the end over the largest speed s of
the point, while together that of the places over s/w, w the frequency of a contact. *right*: one contact without
friction below 1e-6, for spheres plus u V dt^2/d^2, by which their line of centres may turn wrongly in a contact; with
friction or several contacts below (w dt)^2 (both with what a place on the grid may differ from the motion while
together, and with rounding), none above 0.1; sampled forces below 0.1; hard spheres below 1e-9
or 100 times what the last digits of the start do. *marginal*: wrong, but the outcome hangs on less than
the allowed error: the reference with speeds changed by that much, up and down, is as far off or ends otherwise, once as
the run does; *not judged*: rounding decides, references of different steps do not agree, or hard spheres collapse;
*not judged: coarse*: off by more than 0.1 while together, but by no more than a place on so coarse a grid may differ
from the motion.
*warned*, *silent*: wrong, or another outcome, with or without a warning about the step, the cut-off, the well,
rounding or a collapse; warnings of an overlap do not count. *other types warned*: with such a warning, but of contacts
alone that do not occur, as of two small spheres; these are named in brackets behind what was said.
""".splitlines() + [""]


def make(law, number):
    """Point `number` of a law, the corners first."""
    random = numpy.random.default_rng([4711, stability_laws.LAWS.index(law), number])
    values = law.corners[number] if number < len(law.corners) else law.random(random)
    return Point(law, values, random)


def changed(point):
    """The values of a corner that differ from the base point."""
    other = {name: value for name, value in point.values.items() if value != point.law.base[name]}
    return text(point.law, other) or "base point"


def base_text(law):
    return text(law, law.base)


def summary(rows):
    """Lines of the table: law, cases by what became of them."""
    lines = ["| law | points | cases right | wrong, warned | wrong, other types warned | wrong, silent | marginal | "
             "not judged | points refused | crashed or hangs | head-on energy, largest error |", "|" + 11 * "---|"]
    for law, results in rows.items():
        cases = Counter(kind(v, r.said) for _, _, r in results for v in r.verdicts.values())
        points = Counter(kind(v, r.said) for _, _, r in results for v in [r.verdicts["first"]])
        exact = [r.exact for _, _, r in results if r.exact is not None]
        lines.append(f"| {law} | {len(results)} | {cases['right']} | {cases['warned']} | "
                     f"{cases['elsewhere']} | {cases['silent']} | {cases['marginal']} | {cases['not judged']} | "
                     f"{points['refused']} | {points['crashed']} | "
                     + (f"{max(exact):.1e} of {len(exact)}" if exact else "") + " |")
    coarse = sum(v == COARSE for results in rows.values() for _, _, r in results for v in r.verdicts.values())
    return lines + ["", f"Of the cases not judged {coarse} are {COARSE.split(': ')[1]}."]


def reasons(results):
    """Refusals by reason, numbers in them left out."""
    said = Counter(re.sub(r"[-+]?\d+(\.\d+)?(e[-+]?\d+)?", "#", r.said) for _, _, r in results
                   if r.verdicts["first"] == "refused")
    return [f"- {count} x {reason}" for reason, count in said.most_common()]


def cells(result):
    return " | ".join(f"{result.verdicts.get(name, 'not set up')} | "
                      + (f"{result.errors[name]:.1e}" if name in result.errors else "")
                      for name in ("first", "second")) + f" | {result.said} |"


def corners(results):
    lines = ["", "Base point: " + base_text(results[0][1].law) + ". One parameter at a time:", "", *HEAD]
    return lines + [f"| {changed(p)} | {cells(r)}" for _, p, r in results]


def by_steps(results):
    """Cases of the random points by contact times over the time step."""
    lines = ["", "| t_c/dt | points | refused | cases right | wrong, warned | wrong, other types warned | "
             "wrong, silent | marginal or not judged |", "|" + 8 * "---|"]
    for low, high in zip(STEPS, STEPS[1:]):
        part = [r for _, p, r in results if low <= p.values["steps"] < high]
        kinds = Counter(kind(v, r.said) for r in part for v in r.verdicts.values())
        refused = sum("refused" in r.verdicts.values() for r in part)
        lines.append(f"| {low} to {high} | {len(part)} | {refused} | {kinds['right']} | {kinds['warned']} | "
                     f"{kinds['elsewhere']} | {kinds['silent']} | {kinds['marginal'] + kinds['not judged']} |")
    return lines


def words_of(*kinds):
    return [{"elsewhere": "other types warned"}.get(kind, kind) for kind in kinds]


def details(law, results):
    """Corners, what was wrong at the random points, and refusals."""
    limit = len(results[0][1].law.corners)
    first, inner = [row for row in results if row[0] < limit], [row for row in results if row[0] >= limit]
    lines = ["", f"## {law}", *(corners(first) if first else [])]
    # Of sampled forces many are wrong, and say so.
    shown = ("silent", "elsewhere", "crashed") + (() if results[0][1].law.scheme == "sampled" else ("warned",))
    bad = [(n, p, r) for n, p, r in inner if any(kind(v, r.said) in shown for v in r.verdicts.values())]
    if bad:
        lines += ["", f"Wrong of the random points ({', '.join(words_of(*shown))}), with their numbers:", "", *HEAD]
        lines += [f"| {n}: {p.text()} | {cells(r)}" for n, p, r in bad]
    refused = reasons(results)
    return lines + (["", "Refused:", "", *refused] if refused else [])


def steps_of(law, results):
    """Section of the random points by their step; hard spheres know none."""
    inner = [row for row in results if row[0] >= len(row[1].law.corners)]
    return [] if results[0][1].law.hard else ["", f"## {law}", "", f"{len(inner)} random points:", *by_steps(inner)]


def report(rows, name):
    """File name -> text: the page `name` (without .md), and the pages of APART."""
    lines = [*PAGE, *summary(rows), "", "Corners, what was wrong and why points were refused: of "
             + ", of ".join(f"[{what}]({name}{end}.md)" for end, what in APART.items()) + "."]
    for law, results in rows.items():
        lines += steps_of(law, results)
    pages = {f"{name}.md": lines}
    for end, what in APART.items():
        own = [details(law, results) for law, results in rows.items()
               if law.startswith("fix wall/") == (what == "walls")]
        if own:
            pages[f"{name}{end}.md"] = [f"# Stability of {what}: corners, and what was wrong", "",
                                        f"[Stability]({name}.md) says what the words mean.", *sum(own, [])]
    return {file: "\n".join(text) + "\n" for file, text in pages.items()}


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
        __doc__, ("--table", {"metavar": "FILE.md", "type": Path, "help": "where to write the page as well; beside it, "
                              "with _pairs and _walls behind its name, what stands apart"}),
        ("--points", {"type": int, "default": 250, "help": "random ones of each law"}),
        ("--law", {"default": "", "help": "only those whose name has this"}),
        ("--point", {"type": int, "help": "only this one"}),
        ("--together", {"type": int, "default": 6, "help": "runs at a time; most of a run is waiting"}))
    laws = [law for law in stability_laws.LAWS if words.law in law.name]
    if not laws:
        sys.exit(f"--law '{words.law}': there are " + "; ".join(law.name for law in stability_laws.LAWS))
    if words.point is not None:
        for law in laws:
            point = make(law, words.point)
            print(law.name, point.text(), judge(point, engine), sep="\n")
        return
    page = words.table or Path("stability.md")
    for file, text_of_page in report(campaign(laws, words.points, words.together, engine), page.stem).items():
        print(text_of_page)
        if words.table:
            (page.parent / file).write_text(text_of_page)


if __name__ == "__main__":
    main()
