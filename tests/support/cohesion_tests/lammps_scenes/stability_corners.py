# SPDX-License-Identifier: BSD-3-Clause
"""Corner points of the stability campaign: a table (CSV) with a line for each group of points, and the page that is
made from it. `rows` as in stability_pages.py; `lines`: dictionaries with the names COLUMNS."""
import csv
import re
import textwrap
from collections import Counter

from cohesion_tests.lammps_scenes import stability_laws
from cohesion_tests.lammps_scenes.stability_judge import kind
from cohesion_tests.lammps_scenes.stability_pages import PROGRAM, correct, split, stops, table
from cohesion_tests.lammps_scenes.stability_points import NAMES, text

CASES = ("first", "second")
COLUMNS = ("law", "points", "varied", "number", "first case", "second case", "largest error", "reported")
SUBJECTS = {"pairs": "Contacts between spheres", "walls": "Contacts with walls"}
LAWS = {law.name: law for law in stability_laws.LAWS}
NUMBER = re.compile(r"[-+]?\d+(\.\d+)?(e[-+]?\d+)?")
NEITHER = "marginal, incorrect or not judged"
WRITTEN = ("[Stability]({back}#points-and-outcomes) defines points, cases and outcomes. `{program}` writes this page "
           "and [{file}]({file}), which lists all corner points and the random points of this page.")
OTHER = f"""
## Points that are {NEITHER}

Cells have the outcome and the error of a case. Random points are listed where incorrect, those of *sampled* laws only
without a warning for their contact. The last column states whether the run warned of this contact (yes), only of
contacts that do not occur (of others), or not (no).
"""
# Below the points of walls, if some random points of *exact* laws are incorrect and do not warn.
EDGES = """
## Incorrect cases without a warning

In these a sphere touches two walls with a friction of 1, whose error is of
[first order](../theory/exact_contacts.md#errors) in the step.
"""
WARNED = {"warned": "yes", "elsewhere": "of others", "silent": "no"}
STOPPED = """
## Points that stop with an error

Cells have the numbers of corner points and of random points. The sign # stands for a number.
"""
BASE = """
## Base points
"""


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


def first_words(message):
    """Of an error that stops a run."""
    return re.split(r"[;.] ", message)[0]


def line(law, points, varied, number, first, second, error="", reported=""):
    return dict(zip(COLUMNS, (law, points, varied, str(number), first, second, error, str(reported))))


def correct_lines(law, corners):
    """Numbers of correct corner points by what they vary, and of all."""
    own = [row for row in corners if correct(row[2])]

    def count(name, part, reported=""):
        errors = [error for _, _, r in part for error in r.errors.values()]
        return line(law, "corner", name, len(part), "correct", "correct", f"{max(errors):.1e}" if errors else "",
                    reported)

    names = sorted({parameter(p): None for _, p, _ in own}, key=lambda name: name == "several")
    warned = sum(kind("wrong", r.said) != "silent" for _, _, r in own)
    return [*(count(name, [row for row in own if parameter(row[1]) == name]) for name in names),
            count("all", own, f"{warned} with a warning")]


def lines_of(law, results):
    """All lines of a law. Random points that stop are counted by the error."""
    corners, inner = split(results)
    shown = ("silent", "elsewhere", "crashed") + (() if LAWS[law].scheme == "sampled" else ("warned",))
    found = correct_lines(law, corners)
    for _, p, r in corners:
        if not correct(r):
            said = first_words(r.said) if stops(r) else r.said
            found.append(line(law, "corner", text(p.law, changed(p)) or "base point", 1,
                              *(cell(r, case) for case in CASES), reported=said))
    for number, p, r in inner:
        if any(kind(v, r.said) in shown for v in r.verdicts.values()):
            name = f"random {number}: " + text(p.law, {"steps": p.values["steps"]})
            found.append(line(law, "random", name, 1, *(cell(r, case) for case in CASES), reported=r.said))
    said = Counter(NUMBER.sub("#", first_words(r.said)) for _, _, r in inner if r.verdicts["first"] == "refused")
    return found + [line(law, "random", "all", count, "stops", "stops", reported=reason)
                    for reason, count in said.most_common()]


def read(file):
    with open(file, newline="") as opened:
        return list(csv.DictReader(opened))


def write(file, lines):
    with open(file, "w", newline="") as opened:
        writer = csv.DictWriter(opened, COLUMNS, lineterminator="\n")
        writer.writeheader()
        writer.writerows(lines)


def by_law(lines):
    found = {}
    for one in lines:
        found.setdefault(one["law"], []).append(one)
    return found


def total(lines):
    """The line of all correct corner points of a law."""
    return next(one for one in lines if one["points"] == "corner" and one["varied"] == "all")


def is_counted(one):
    """Whether a line is a number of correct corner points."""
    return one["first case"] == one["second case"] == "correct"


def is_other(one):
    """Whether a point neither stops nor is correct."""
    return "stops" not in (one["first case"], one["second case"]) and not is_counted(one)


def is_silent(one):
    """Whether a random point of an exact law is incorrect and does not warn."""
    return (one["points"] == "random" and LAWS[one["law"]].scheme == "exact" and is_other(one)
            and kind("wrong", one["reported"]) == "silent")


def numbers(law, lines):
    """Of the corner points of a law: all, correct, stop, others."""
    corners = [one for one in lines if one["points"] == "corner" and not is_counted(one)]
    others = sum(map(is_other, corners))
    return len(LAWS[law].corners), int(total(lines)["number"]), len(corners) - others, others


def summary(lines):
    """Numbers of the corner points of each law."""
    found = []
    for law, own in by_law(lines).items():
        one = total(own)
        found.append([law, *numbers(law, own), one["largest error"], one["reported"].split()[0]])
    return table(["law", "corner points", "correct", "stop", NEITHER, "largest error of correct ones",
                  "correct with a warning"], *found)


def of_warnings(lines):
    """Whether runs of incorrect corner points warn of their contact."""
    wrong = [one for one in lines if one["points"] == "corner"
             and re.search("incorrect|other outcome", one["first case"] + one["second case"])]
    silent = sum(kind("wrong", one["reported"]) != "warned" for one in wrong)
    return f"Incorrect corner points without a warning: {silent}."


def conclusion(what, lines):
    """What was compared, and the number of silent errors."""
    subject = (f"{SUBJECTS[what]} are run at extreme values of their parameters, and compared with finer or "
               "event-driven runs.")
    return f"{subject} {of_warnings(lines)}"


def paragraph(words):
    return textwrap.wrap(words, 120, break_long_words=False, break_on_hyphens=False)


def of_errors(lines, case):
    """Largest error of a case of several points."""
    errors = [float(one[case].split("(")[1].rstrip(")")) for one in lines if "(" in one[case]]
    return f"errors up to {max(errors):.1e}" if errors else ""


def warned(lines):
    """Whether runs warned of their contact."""
    return ", ".join(dict.fromkeys(WARNED[kind("wrong", one["reported"])] for one in lines))


def other_points(lines):
    """Cells of the points that neither stop nor are correct; random ones of a sampled law share a line."""
    found = []
    for law, own in by_law(filter(is_other, lines)).items():
        inner = [one for one in own if one["points"] == "random" and LAWS[law].scheme == "sampled"]
        grouped = len(inner) > 1
        found += [[*(one[name] for name in ("law", "varied", "first case", "second case")), warned([one])]
                  for one in own if not (grouped and one in inner)]
        if grouped:
            steps = sorted(float(one["varied"].split("t_c/dt ")[1]) for one in inner)
            found.append([law, f"{len(inner)} random points: t_c/dt {steps[0]:g} to {steps[-1]:g}",
                          *(of_errors(inner, case) for case in ("first case", "second case")), warned(inner)])
    return found


def reasons(lines):
    """Errors that stop runs, by law: numbers of corner points and of random points."""
    laws = list(by_law(lines))
    found = {}
    for one in lines:
        if "stops" in (one["first case"], one["second case"]):
            reason = re.split(": |, at ", NUMBER.sub("#", one["reported"]))[0]
            counts = found.setdefault(reason, {law: [0, 0] for law in laws})[one["law"]]
            counts[one["points"] == "random"] += int(one["number"])
    cells = [[reason, *(f"{a}, {b}" if a or b else "" for a, b in counts.values())] for reason, counts in found.items()]
    return table(["error", *laws], *cells) if found else []


def base_points(laws):
    """Values of all laws, and those of each; laws with the same ones share a line."""
    values = {law: text(LAWS[law], LAWS[law].base).split(", ") for law in laws}
    common = [value for value in next(iter(values.values())) if all(value in own for own in values.values())]
    found = {}
    for law, own in values.items():
        found.setdefault(", ".join(value for value in own if value not in common), []).append(law)
    return table(["laws", "base point"], ["all", ", ".join(common)],
                 *(["; ".join(names), own] for own, names in found.items() if own))


def page(what, lines, back):
    """Page of `what` (pairs, walls); `back`: address of the main page."""
    written = WRITTEN.format(back=back, program=PROGRAM, file=f"stability_{what}.csv")
    result = [f"# Stability of {what}: corner points", "", *paragraph(conclusion(what, lines)), "",
              *paragraph(written), "", "## Corner points", "", *summary(lines)]
    others = other_points(lines)
    if others:
        result += [*OTHER.splitlines(), "", *table(["law", "point", "first case", "second case", "warned"], *others)]
    if what == "walls" and any(is_silent(one) for one in lines):
        result += EDGES.splitlines()
    stopped = reasons(lines)
    if stopped:
        result += [*STOPPED.splitlines(), "", *stopped]
    return "\n".join([*result, *BASE.splitlines(), "", *base_points(by_law(lines))]) + "\n"


def parts(rows):
    """Name (pairs, walls) -> lines of its table."""
    laws = {what: [law for law in rows if law.startswith("fix wall/") == (what == "walls")] for what in SUBJECTS}
    found = {what: [one for law in names for one in lines_of(law, rows[law])] for what, names in laws.items()}
    return {what: lines for what, lines in found.items() if lines}
