# SPDX-License-Identifier: BSD-3-Clause
"""Tables and page of the campaign extremes.py. `rows`: name of the model, values, whether they are a corner, results of
CASES. The page is made from two tables (CSV): numbers of outcomes, and the points that it names."""
import collections
import csv
import textwrap

from cohesion_tests.liggghts_scenes.extremes import CASES, KINDS, SILENT, said_of
from cohesion_tests.liggghts_scenes.extremes_points import ALL, name_of

# Verdicts in the words of the page.
WORDS = {"right": "correct", "wrong, warned": "incorrect, warned", SILENT: "incorrect, no warning",
         "wrong, other types warned": "incorrect, warned for other contacts", "refused": "stops"}
COLUMNS = ("model", "points", "varied", *CASES, "reported")
SUBJECT = ("A campaign runs the models with *hooke/stiffness* and *hertz* contacts at extreme and at random values of "
           "their parameters. ")
PAGE = """# LIGGGHTS cohesion models at the ends of their parameters

{summary}

```
benchmarks/liggghts-styles/extremes-campaign.py LIGGGHTS --table FILE
benchmarks/liggghts-styles/extremes-campaign.py --remake FILE
```

There are three cases. The reference of *pair* (two spheres meet head-on) and *wall* is the closed form, for *hertz* a
run with a sixteenth of the step. In *three spheres* one strikes two in contact; at one of two times the run must agree
with one of a sixteenth of the step.

A case is correct if the same particles stick and speeds agree within 0.1 of the largest speed. Points that are not set
up would overlap by half a radius. Without a reference the finer run warned of rounding.

## Outcomes

Cells have the numbers of cases: pair, wall, three spheres.

{numbers}
"""
POINTS = """
## Points

{base}
"""
BASE = ("A corner point sets one or a few parameters of the base point to an extreme value. "
        "*depth* is the speed that the well adds over the impact speed, *width* is relative to the flight in a contact "
        "time.")
INCORRECT = """
These are corner points with an incorrect case, and random points with one that is incorrect without a warning, crashes,
hangs or has no reference:
"""


def word(verdict):
    """A verdict as the page has it."""
    start = next((known for known in WORDS if verdict.startswith(known)), "")
    return WORDS.get(start, "") + verdict[len(start):].replace("alone", "only")


def cell(result):
    return word(result[0]) + ("" if result[1] is None else f", {result[1]:.1e}")


def silent(verdict):
    """Whether it says that something went wrong and no run told so."""
    return verdict in (SILENT, "crashed", "hangs") or verdict.startswith("reference ")


def outcomes(rows):
    """Numbers of outcomes of each model and case, as text."""
    found = []
    for model in dict.fromkeys(row[0] for row in rows):
        for k, case in enumerate(CASES):
            count = collections.Counter("right" if r[k][0].startswith("right") else r[k][0]
                                        for name, _, _, r in rows if name == model)
            known = {word(kind): count[kind] for kind in (*KINDS, "not set up")}
            number = sum(count.values())
            numbers = {"points": number, **known, "no reference": number - sum(known.values())}
            found.append({"model": model, "case": case, **{name: str(number) for name, number in numbers.items()}})
    return found


def listed(rows):
    """Corner points with a case that is not right, and random points with a silent one."""
    found = []
    for model, values, corner, results in rows:
        if corner and not all(x[0].startswith("right") for x in results) or not corner and any(
                silent(x[0]) for x in results):
            found.append(dict(zip(COLUMNS, (model, "corner" if corner else "random", name_of(values),
                                            *map(cell, results), said_of(results)))))
    return found


def table(head, rows):
    return "\n".join(["| " + " | ".join(head) + " |", "|" + "---|" * len(head),
                      *("| " + " | ".join(row) + " |" for row in rows)])


def paragraph(words):
    return "\n".join(textwrap.wrap(words, 120, break_long_words=False, break_on_hyphens=False))


def of_numbers(counts):
    """The numbers of outcomes of each model, without the outcomes that there are none of."""
    names = [name for name in counts[0] if name not in ("model", "case") and any(row[name] != "0" for row in counts)]
    models = {}
    for row in counts:
        models.setdefault(row["model"], []).append(row)
    return table(["model", *names], [[model, *(", ".join(row[name] for row in own) for name in names)]
                                     for model, own in models.items()])


def of_silent(counts):
    """What the campaign found of runs that do not warn."""
    numbers = {name: sum(int(row[name]) for row in counts) for name in (word(SILENT), "crashed", "hangs")}
    if not any(numbers.values()):
        return "No case is incorrect without a warning, crashes or hangs."
    return "Cases by outcome: " + ", ".join(f"{name} {number}" for name, number in numbers.items()) + "."


def of_bases():
    """Values of the base points of all laws, and those of each."""
    values = {law: name_of(own).split(", ") for law, own in ALL.items()}
    common = [value for value in next(iter(values.values())) if all(value in own for own in values.values())]
    rest = [(law, ", ".join(value for value in own if value not in common)) for law, own in values.items()]
    return f"{paragraph(BASE)}\n\n{table(('model', 'base point'), [('all', ', '.join(common)), *rest])}"


def is_incorrect(point):
    return any("incorrect" in point[case] for case in CASES)


def page(counts, points, name):
    """`name`: of the file, without its suffix."""
    shown = {}
    for point in points:
        if point["points"] == "random":
            results = "; ".join(f"{case} {point[case]}" for case in CASES)
            shown.setdefault(point["model"], []).append(f"random: {point['varied']} ({results})")
        elif is_incorrect(point):
            shown.setdefault(point["model"], []).append(point["varied"])
    rows = [(model, "; ".join(names)) for model, names in shown.items()]
    incorrect = f"{INCORRECT}\n{table(('model', 'varied'), rows)}\n" if rows else ""
    files = paragraph(f"[Outcomes]({name}.csv) has all counts. [Points]({name}_points.csv) has the corner points that "
                      "are not correct, with errors and warnings.")
    return (PAGE.format(summary=paragraph(SUBJECT + of_silent(counts)), numbers=of_numbers(counts))
            + POINTS.format(base=of_bases()) + incorrect + f"\n{files}\n")


def write_table(file, columns, rows):
    with open(file, "w", newline="") as opened:
        writer = csv.DictWriter(opened, columns, lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


def read_table(file):
    with open(file, newline="") as opened:
        return list(csv.DictReader(opened))


def tables(file):
    """Files of the two tables beside a page."""
    return file.with_suffix(".csv"), file.with_name(file.stem + "_points.csv")


def write(file, counts, points):
    """The page and its tables."""
    for name, columns, rows in zip(tables(file), (list(counts[0]), COLUMNS), (counts, points)):
        write_table(name, columns, rows)
    file.write_text(page(counts, points, file.stem))


def remake(file):
    file.write_text(page(*map(read_table, tables(file)), file.stem))
