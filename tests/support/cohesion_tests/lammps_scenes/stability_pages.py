# SPDX-License-Identifier: BSD-3-Clause
"""Main page of the stability campaign; stability_corners.py has those of corner points. `rows` everywhere: name of the
law -> [(number, Point, Result)], corner points first. A point is correct if all its cases are."""
import csv
from collections import Counter

from cohesion_tests.lammps_scenes import stability_laws
from cohesion_tests.lammps_scenes.stability_judge import COARSE, kind

STEPS = (2, 3, 4, 5, 10, 15, 20)
# Kinds of cases (stability_judge.kind) with the headings of their columns.
COLUMNS = {"right": "correct", "warned": "incorrect, warned", "elsewhere": "incorrect, warned for other contacts",
           "silent": "incorrect, no warning", "marginal": "marginal", "not judged": "not judged"}
INCORRECT = ("warned", "elsewhere", "silent")
# Rows of the table of random points by their time step.
FIGURES = ("correct/judged", "unwarned", "stopped/all")
PROGRAM = "benchmarks/lammps-package/stability-campaign.py"
HEAD = f"""# Stability at the ends of all parameters

This page shows how far the [time-step check](../lammps-package/time_step_check.md) can be relied on. A campaign runs
the contact laws at the ends of their parameters and at random points between, and compares each result with a
reference. It covers neither liquid bridges nor *sampled* walls of gran/hamaker, and Hertz and JKR only with *exact*.
`{PROGRAM}` writes this page and [stability.csv](stability.csv).
""".splitlines()
TERMS = """
## Points and outcomes

A corner point sets one or a few parameters of a base point to an extreme value. A random point draws all parameters.
Each point has two cases: two spheres collide, and a sphere strikes two spheres in contact. At walls a sphere hits a
wall, and a sphere flies into an edge. The larger sphere has a diameter of 1 mm and a density of 2650 kg/m^3.

The reference of soft contacts is *exact* at a sixteenth of the step, that of hard spheres (*rest off*) a program
without a time step. The error is that of the final velocities over s, the largest speed of the point. For particles in
contact it is that of the positions over s/w, with the contact frequency w.

| outcome | meaning |
|---|---|
| incorrect | the error is above the tolerance, or other particles are in contact |
| warned | the run warned of the step, the cut-off, the well, rounding or a collapse |
| warned for other contacts | warnings concern only contacts that do not occur |
| marginal | incorrect, but an error of the tolerance in the initial state does as much |
| not judged | rounding decides, references disagree, or the time levels are too coarse |

The tolerance is 0.1 for *sampled* and 1e-9, or 100 times the effect of rounding, for hard spheres. For *exact* it is
1e-6 for one contact without friction. Otherwise it is (w dt)^2, at most 0.1, plus the
[errors](../theory/exact_contacts.md) of rotation and of friction with several contacts. For Hertz and JKR it is of
second order in all cases; w is that of an elastic impact at s.
""".splitlines()
STEPS_TITLE = "Random points by time step"
BY_STEPS = f"""
## {STEPS_TITLE}

For each law and range of t_c/dt, up to 20, [stability.csv](stability.csv) lists correct over judged cases. It also
lists incorrect cases without a warning for their contact, and stopped over all points. A
[picture](../what-to-choose.md) shows the shares.
"""


def table(*rows):
    head, *lines = (f"| {' | '.join(map(str, row))} |" for row in rows)
    return [head, "|" + len(rows[0]) * "---|", *lines]


def split(results):
    """Rows of corner points and of random ones."""
    limit = len(results[0][1].law.corners)
    return [row for row in results if row[0] < limit], [row for row in results if row[0] >= limit]


def kinds_of(results):
    return Counter(kind(v, r.said) for _, _, r in results for v in r.verdicts.values())


def stops(result):
    return "refused" in result.verdicts.values()


def correct(result):
    return set(result.verdicts.values()) == {"right"}


def summary(rows):
    """Cases of each law by their outcome."""
    energies = {law: [r.exact for _, _, r in results if r.exact is not None] for law, results in rows.items()}
    points = {law: Counter(kind(r.verdicts["first"], r.said) for _, _, r in results) for law, results in rows.items()}
    crashes = any(found["crashed"] for found in points.values())
    heads = ["law", "points", *COLUMNS.values(), "points: stops"] + ["points: crashes or hangs"] * crashes
    lines = []
    for law, results in rows.items():
        cases, exact = kinds_of(results), energies[law]
        lines.append([law, len(results), *(cases[name] for name in COLUMNS), points[law]["refused"]]
                     + [points[law]["crashed"]] * crashes
                     + ([f"{max(exact):.1e} of {len(exact)}" if exact else ""] if any(energies.values()) else []))
    if any(energies.values()):
        heads.append("energy error, head-on")
    coarse = sum(v == COARSE for results in rows.values() for _, _, r in results for v in r.verdicts.values())
    note = ["", f"Of the cases not judged, the time levels are too coarse in {coarse}."] if coarse else []
    return table(heads, *lines) + note


def by_steps(rows):
    """Rows of the table of random points by contact times over the time step; hard spheres have no contact time."""
    spans = list(zip(STEPS, STEPS[1:]))
    lines = []
    for law, results in rows.items():
        if results[0][1].law.hard:
            continue
        parts = [[row for row in split(results)[1] if low <= row[1].values["steps"] < high] for low, high in spans]
        cases = [kinds_of(part) for part in parts]
        judged = [sum(found[name] for name in ("right", *INCORRECT)) for found in cases]
        figures = ([f"{found['right']}/{number}" for found, number in zip(cases, judged)],
                   [found["elsewhere"] + found["silent"] for found in cases],
                   [f"{sum(stops(r) for _, _, r in part)}/{len(part)}" for part in parts])
        lines += [[law, name, *values] for name, values in zip(FIGURES, figures)]
    return [["law", "t_c/dt", *(f"{low} to {high}" for low, high in spans)], *lines]


def write_steps(file, rows):
    """The table of random points, beside the page `file`."""
    with open(file.with_suffix(".csv"), "w", newline="") as opened:
        csv.writer(opened, lineterminator="\n").writerows(by_steps(rows))


def missing(rows):
    names = [law.name for law in stability_laws.LAWS if law.name not in rows]
    return ["", "Results are missing for:", "", *(f"- {name}" for name in names)] if names else []


def main_page(rows, links):
    """`links`: name of a page of corner points -> its address."""
    lines = [*HEAD, *TERMS, "", "## Results", "",
             "Cases by outcome; columns that begin with *points* count points:", "", *summary(rows),
             *missing(rows)]
    if links:
        lines += ["", "Corner points: " + ", ".join(f"[{what}]({where})" for what, where in links.items()) + "."]
    return "\n".join(lines + BY_STEPS.splitlines()) + "\n"
