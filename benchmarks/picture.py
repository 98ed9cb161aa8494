#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of the tables of the benchmarks and of the stability campaign.

  picture.py dense|growth|steps TABLE.csv FILE.png

TABLE: step_costs.csv of docs/verification for dense, growth.csv for growth, stability.csv for steps, or another file
that benchmarks.py --table or stability-campaign.py --table has written.
"""
import re
import sys
from pathlib import Path

import dense
import growth
from cohesion_studies import program
from cohesion_studies.drawing import pyplot, save
from cohesion_tests.lammps_scenes import stability_pages
from printed_table import read_csv

BAR = "#4477aa"


def spread(text):
    """Least, median and most of "median (least to most)", or of one number."""
    values = sorted(float(number) for number in re.findall(r"[-+.\de]+", text))
    return values[0], values[len(values) // 2], values[-1]


def spread_words(name):
    """What the column `name` tells of turns."""
    return ", least to most" if "least" in name else ", one turn"


def column(rows, start):
    return next((name for name in rows[0] if name.startswith(start)), None)


def draw_dense(rows):
    """Cost over the stock engine without cohesion: bars of instructions, points of time."""
    tables = {}
    for row in rows:
        tables.setdefault((row["engine"], row["scene"]), []).append(row)
    turns = column(rows, "over stock, same turn")
    heights = [len(own) for own in tables.values()]
    figure, axes = pyplot.subplots(len(tables), 1, figsize=(7.5, 0.6 * len(tables) + 0.25 * sum(heights)),
                                   squeeze=False, constrained_layout=True, height_ratios=heights)
    for axis, ((engine, scene), own) in zip(axes[:, 0], tables.items()):
        counted = [float(row["over stock"] or "nan") for row in own]
        axis.barh(range(len(own)), counted, color=BAR, alpha=0.5, label="instructions")
        timed = [(n, spread(row[turns])) for n, row in enumerate(own) if turns and row[turns]]
        for n, (low, middle, high) in timed:
            axis.errorbar(middle, n, xerr=[[middle - low], [high - middle]], fmt="ko", ms=3, capsize=2,
                          label="time" + spread_words(turns) if n == timed[0][0] else None)
        axis.axvline(1, color="black", linewidth=0.6)
        limit = dense.ASKED * next(value for row, value in zip(own, counted) if "cohesive" in row["style"])
        axis.axvline(limit, color="black", linewidth=0.6, linestyle=":",
                     label=f"{dense.ASKED} of stock with cohesion, instructions")
        axis.set_yticks(range(len(own)), [row["style"] for row in own], fontsize=7)
        axis.invert_yaxis()
        axis.set_title(f"{engine}, {scene} spheres: cost of a step over that of the first style", fontsize=8)
        axis.tick_params(axis="x", labelsize=7)
    # Below all: bars fill the panels.
    axes[-1, 0].legend(*axes[0, 0].get_legend_handles_labels(), fontsize=7, ncols=3, loc="upper center",
                       bbox_to_anchor=(0.4, -0.2))
    return figure


def draw_growth(rows):
    """Nanoseconds, and these over those of few spheres."""
    over = column(rows, "over ")
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(10, 4), constrained_layout=True)
    for n, name in enumerate(dict.fromkeys(row["style"] for row in rows)):
        own = [row for row in rows if row["style"] == name]
        x = [float(row["particles"]) for row in own]
        left.plot(x, [float(row["ns per particle and step"]) for row in own], "o-", ms=4, label=name)
        low, middle, high = zip(*(spread(row[over]) for row in own))
        # Drawn a little apart, else their bars hide each other.
        right.errorbar([value * 1.06**n for value in x], middle, fmt="o-", ms=4, capsize=2,
                       yerr=[[b - a for a, b in zip(low, middle)], [b - a for a, b in zip(middle, high)]])
    right.axhline(growth.ASKED, color="black", linewidth=0.6)
    right.text(0.01, growth.ASKED, f"{growth.ASKED}", fontsize=7, va="bottom", transform=right.get_yaxis_transform())
    left.set(xscale="log", xlabel="spheres", ylabel="ns per sphere and step")
    left.set_ylim(bottom=0)
    right.set(xscale="log", xlabel="spheres", ylabel=over.split(":")[0] + " spheres" + spread_words(over))
    left.legend(fontsize=7)
    return figure


def draw_steps(tables):
    """Share of correct cases by the steps of a contact; `tables`: law -> rows of its random points."""
    names = [name for name in next(iter(tables.values()))[0] if re.match(r"\d+ to ", name)]
    figure, axis = pyplot.subplots(figsize=(7.5, 0.8 + 0.45 * len(tables)), constrained_layout=True)
    shares, words = [], {}
    for n, rows in enumerate(tables.values()):
        found = {row["t_c/dt"]: row for row in rows}
        for m, name in enumerate(names):
            cases, unwarned, points = (found[figure_name][name] for figure_name in stability_pages.FIGURES)
            right, judged = map(int, cases.split("/"))
            shares.append(right / judged if judged else float("nan"))
            words[m, n] = (f"{right} of {judged}" + (f"\n{unwarned} unwarned" if int(unwarned) else "")
                           + f"\n{points.replace('/', ' of ')} stop")
    image = axis.imshow([shares[n * len(names):(n + 1) * len(names)] for n in range(len(tables))], vmin=0, vmax=1,
                        cmap="RdYlBu", aspect="auto", alpha=0.7)
    for (m, n), text in words.items():
        axis.text(m, n, text, ha="center", va="center", fontsize=6)
    axis.set_xticks(range(len(names)), names)
    axis.set_yticks(range(len(tables)), tables, fontsize=8)
    axis.set_xlabel("steps of a contact, t_c/dt; random points of all parameters")
    figure.colorbar(image, label="share of correct cases")
    return figure


def data_of(name, file):
    """What the picture `name` is drawn from: the rows of a file, of `steps` by law."""
    rows = read_csv(file)
    if name != "steps":
        return rows
    tables = {}
    for row in rows:
        tables.setdefault(row["law"], []).append(row)
    return tables


DRAWN = {"dense": draw_dense, "growth": draw_growth, "steps": draw_steps}


def draw(name, data, file):
    save(DRAWN[name](data), file, dpi=90)


def main():
    name, table, file = program.words(__doc__, 3)
    if name not in DRAWN:
        sys.exit(__doc__)
    draw(name, data_of(name, Path(table)), file)


if __name__ == "__main__":
    main()
