# SPDX-License-Identifier: BSD-3-Clause
"""Overshoot by mechanism and by width, and what carries the bed at the maximum of the pressure drop.

    picture.py SUMMARY.csv PICTURE.png"""

from cohesion_studies import program
from cohesion_studies.bed.statements import WIDTHS
from cohesion_studies.bed.verdict import Study
from cohesion_studies.drawing import pyplot, save

COLOURS = {"none": "0.5", "well": "#1f6f8b", "hamaker": "#c8553d"}
FORCES = {"sides_at_maximum": ("side walls", "#7a5195"), "plate_at_maximum": ("plate", "#ef8354"),
          "plate_pull_at_maximum": ("attraction of the plate", "#ffb997"),
          "gain_at_maximum": ("gain of momentum", "0.6")}


def draw(study, file):
    figure, (bars, budget, widths) = pyplot.subplots(1, 3, figsize=(12, 4.6), constrained_layout=True)
    rows = [row for row in study.rows if study.number(row, "width") == 0.08]
    places = range(len(rows))
    for place, row in zip(places, rows):
        if mean := study.with_error(row, "overshoot"):
            bars.barh(place, mean[0], xerr=mean[1], color=COLOURS[row.split("-")[0]], capsize=2)
    bars.set_xlabel("overshoot over the weight [1]")
    for share, (name, (label, colour)) in enumerate(FORCES.items()):
        found = [(place + 0.2 * (share - 1.5), mean) for place, row in zip(places, rows)
                 if (mean := study.with_error(row, name))]
        budget.barh([place for place, _ in found], [value for _, (value, _) in found], 0.2,
                    xerr=[error for _, (_, error) in found], color=colour, label=label, capsize=1)
    budget.set_xlabel("upward force over the weight\nat the pressure maximum [1]")
    budget.legend(frameon=False, fontsize=8)
    for axes in (bars, budget):
        axes.set_yticks(list(places), rows if axes is bars else [""] * len(rows))
        axes.invert_yaxis()
        axes.axvline(0, color="black", linewidth=0.6)
    for beside, (law, colour) in enumerate(COLOURS.items(), -1):
        # A little apart, else their bars hide each other.
        found = [(width + beside, *mean) for suffix, width in WIDTHS.items()
                 if (mean := study.with_error(law + suffix, "overshoot"))]
        if found:
            widths.errorbar(*zip(*found), fmt="o-", color=colour, capsize=2, label=law)
            widths.legend(frameon=False)
    widths.set_xticks(sorted(WIDTHS.values()))
    widths.set_xlabel("width of the bed [mm]")
    widths.set_ylabel("overshoot over the weight [1]")
    save(figure, file, dpi=110)


if __name__ == "__main__":
    summary, to = program.words(__doc__, 2)
    program.run(lambda: draw(Study(summary), to), OSError)
