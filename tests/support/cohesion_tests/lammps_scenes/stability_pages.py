# SPDX-License-Identifier: BSD-3-Clause
"""Pages of the stability campaign. `rows` everywhere: name of the law -> [(number, Point, Result)], corner points
first. A point is correct if all its cases are."""
import re
from collections import Counter

from cohesion_tests.lammps_scenes import stability_laws
from cohesion_tests.lammps_scenes.stability_judge import COARSE, kind
from cohesion_tests.lammps_scenes.stability_points import NAMES, text

STEPS = (2, 3, 4, 5, 10, 15, 20)
CASES = ("first", "second")
# Kinds of cases (stability_judge.kind) with the headings of their columns.
COLUMNS = {"right": "correct", "warned": "incorrect, warned", "elsewhere": "incorrect, warned for other contacts",
           "silent": "incorrect, no warning", "marginal": "marginal", "not judged": "not judged"}
INCORRECT = ("warned", "elsewhere", "silent")
# Rows of the table of random points by their time step.
FIGURES = ("correct/judged", "unwarned", "stopped/all")
PROGRAM = "benchmarks/lammps-package/stability-campaign.py"
HEAD = f"""# Stability at the ends of all parameters

This page shows how far the [time-step check](time_step_check.md) can be relied on. A campaign runs the contact laws at
the ends of their parameters and at random points between, and compares each result with a reference. It covers neither
liquid bridges, nor JKR, nor *sampled* walls of gran/hamaker.
`{PROGRAM}` writes this page.
""".splitlines()
TERMS = """
## Points and outcomes

A corner point sets one or a few parameters of a base point to an extreme value. A random point draws all parameters.
Each point has two cases: two spheres collide, and a sphere strikes two spheres in contact; at walls a sphere hits a
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
1e-6 for one contact without friction, and otherwise (w dt)^2, at most 0.1, plus the
[errors](../theory/exact_contacts.md) of rotation and of friction with several contacts.
""".splitlines()
STEPS_TITLE = "Random points by time step"
BY_STEPS = f"""
## {STEPS_TITLE}

Rows are correct over judged cases, incorrect cases without a warning for their contact, and stopped over all points.
"""
CORNER_HEAD = f"""# Stability of {{what}}: corner points

`{PROGRAM}` writes this page.
[Stability]({{back}}) defines points, cases and outcomes.

## Base points
"""
CORRECT = """
## Correct corner points

Each cell shows the number of corner points at which all cases are correct, and their largest error. The row *several*
counts points that vary several parameters at once.
"""
OTHER = """
## Other points

This table lists the corner points that are not correct. It also lists the random points that are incorrect without a
warning for their contact; of laws that are not *sampled*, those with a warning too. The error of a case is in brackets
behind its outcome. Types in brackets mark warnings for contacts that do not occur. The option `--law NAME --point K`
prints all values of random point K.
"""
STOPPED = """
## Random points that stop with an error

The sign # stands for a number.
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


def changed(point):
    """The values of a corner point that differ from the base point."""
    return {name: value for name, value in point.values.items() if value != point.law.base[name]}


def parameter(point):
    """What a corner point varies, in a word."""
    names = {**NAMES, "steps": "steps"} if point.law.hard else NAMES
    varied = list(changed(point))
    return names.get(varied[0], varied[0]) if len(varied) == 1 else "several" if varied else "none"


def outcome(verdict):
    """A verdict in the words of the page; the size of an error stands beside it."""
    if verdict.startswith("wrong"):
        return "incorrect" + (verdict[len("wrong"):] if verdict.startswith("wrong:") else "")
    return {"right": "correct", "refused": "stops"}.get(verdict, verdict)


def cell(result, case):
    if case not in result.verdicts:
        return ""
    error = f" ({result.errors[case]:.1e})" if case in result.errors else ""
    return outcome(result.verdicts[case]) + error


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
    """Of random points, by contact times over the time step; hard spheres have no contact time."""
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
        # The law stands in the first of its rows.
        lines += [["" if n else law, name, *values] for n, (name, values) in enumerate(zip(FIGURES, figures))]
    return [*BY_STEPS.splitlines(), "", *table(["law", "t_c/dt", *(f"{low} to {high}" for low, high in spans)], *lines)
            ] if lines else []


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
    return "\n".join(lines + by_steps(rows)) + "\n"


def correct_corners(rows):
    """By what varies: number of correct corner points, and their largest error."""
    found = {law: [row for row in split(results)[0] if correct(row[2])] for law, results in rows.items()}

    def count(part):
        errors = [error for _, _, r in part for error in r.errors.values()]
        return f"{len(part)} ({max(errors):.1e})" if part else ""

    names = dict.fromkeys(parameter(p) for part in found.values() for _, p, _ in part)
    by_name = [[name, *(count([row for row in part if parameter(row[1]) == name]) for part in found.values())]
               for name in sorted(names, key=lambda name: name == "several")]
    total = ["all", *(count(part) for part in found.values())]
    warned = ["of these with a warning", *(sum(kind("wrong", r.said) != "silent" for _, _, r in part)
                                           for part in found.values())]
    listed = ["all corner points", *(len(split(results)[0]) for results in rows.values())]
    return table(["varied", *rows], *by_name, total, warned, listed)


def listed_points(results):
    """Corner points that are not correct, and random ones that are incorrect without a warning for the contact; of
    laws that are not sampled also those with one. Points with the same cells share a row."""
    first, inner = split(results)
    shown = ("silent", "elsewhere", "crashed") + (() if results[0][1].law.scheme == "sampled" else ("warned",))
    found = {}
    for _, p, r in first:
        if not correct(r):
            found.setdefault(outcomes(r), []).append(text(p.law, changed(p)) or "base point")
    for number, p, r in inner:
        if any(kind(v, r.said) in shown for v in r.verdicts.values()):
            found.setdefault(outcomes(r), []).append(f"random {number}: " + text(p.law, {"steps": p.values["steps"]}))
    return [["; ".join(names), *cells] for cells, names in found.items()]


def first_words(message):
    """Of an error that stops a run."""
    return re.split(r"[;.] ", message)[0]


def outcomes(result):
    """Cells of a point: its cases and what the run reported."""
    return (*(cell(result, case) for case in CASES), first_words(result.said) if stops(result) else result.said)


def reasons(results):
    """Errors that stop runs of random points, with their number; # stands for a number."""
    said = Counter(re.sub(r"[-+]?\d+(\.\d+)?(e[-+]?\d+)?", "#", first_words(r.said)) for _, _, r in split(results)[1]
                   if r.verdicts["first"] == "refused")
    return said.most_common()


def corner_page(what, rows, back):
    """Page of `what` (pairs, walls); `back`: address of the main page."""
    lines = [*CORNER_HEAD.format(what=what, back=back).splitlines(), "",
             *table(["law", "base point"], *([law, text(results[0][1].law, results[0][1].law.base)]
                                            for law, results in rows.items())),
             *CORRECT.splitlines(), "", *correct_corners(rows)]
    points = [[law, *row] for law, results in rows.items() for row in listed_points(results)]
    if points:
        lines += [*OTHER.splitlines(), "", *table(["law", "point", "first case", "second case", "reported"], *points)]
    stopped = [[law, reason, count] for law, results in rows.items() for reason, count in reasons(results)]
    if stopped:
        lines += [*STOPPED.splitlines(), "", *table(["law", "error", "points"], *stopped)]
    return "\n".join(lines) + "\n"


def corner_pages(rows, back):
    """Name (pairs, walls) -> text of its page."""
    parts = {what: {law: results for law, results in rows.items() if law.startswith("fix wall/") == (what == "walls")}
             for what in ("pairs", "walls")}
    return {what: corner_page(what, part, back) for what, part in parts.items() if part}
