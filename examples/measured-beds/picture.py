# SPDX-License-Identifier: BSD-3-Clause
"""The picture of the measured beds: spheres at the end, and the profiles beside the measured ones."""

import numpy as np

import analyse
from cohesion_studies.drawing import MARKERS, circles, pyplot, save
from cohesion_studies.foam_results import read_cloud

LABELS = {"void_fraction": "void fraction [1]", "velocity": "velocity of the spheres, up [m/s]"}


def draw(file, table, folders):
    """A row for each gas velocity of `folders`, {gas: cases}: its first bed, and each quantity across the bed, lines
    for the cases and points for the measurement in the file `table`."""
    measured = analyse.measured(table)
    figure = pyplot.figure(figsize=(11, 3.4 * len(folders)), constrained_layout=True)
    rows = figure.subplots(len(folders), 3, squeeze=False, gridspec_kw={"width_ratios": [1, 2, 2]})
    for row, (gas, cases) in zip(rows, folders.items()):
        beds = [analyse.Bed(case) for case in cases]
        draw_spheres(row[0], beds[0])
        row[0].set_title(f"gas {gas} m/s", fontsize=9)
        for axes, quantity in zip(row[1:], LABELS):
            heights = [height for of, what, height in measured if (of, what) == (gas, quantity)]
            for number, height in enumerate(heights):
                draw_profile(axes, beds, quantity, height, measured[gas, quantity, height], number)
            axes.set_xlabel("x [mm]")
            axes.set_ylabel(LABELS[quantity])
            axes.legend(fontsize=7)
    save(figure, file, dpi=80)


def draw_spheres(axes, bed):
    """Those in the front half, coloured by their velocity."""
    places, velocities = read_cloud(bed.times[max(bed.times)])
    front = places[:, 1] < bed.size["thickness"] / 2
    spheres = circles(axes, places[front][:, [0, 2]] * 1e3, bed.size["diameter"] * 1e3, array=velocities[front, 2],
                      cmap="coolwarm")
    spheres.set_clim(-0.5, 0.5)
    axes.set_xlim(0, bed.size["width"] * 1e3)
    axes.set_ylim(0, bed.size["height"] * 1e3)
    axes.figure.colorbar(spheres, ax=axes, ticks=(-0.5, 0, 0.5)).set_label("velocity up [m/s]", fontsize=8)


def draw_profile(axes, beds, quantity, height, measurement, number):
    """The mean over the beds as a line, each of them thin, the measurement as points."""
    colour = f"C{number}"
    profiles = [bed.profile(quantity, height) for bed in beds]
    for x, values in profiles:
        axes.plot(1e3 * x, values, linewidth=0.5, color=colour)
    x = profiles[0][0]
    axes.plot(1e3 * x, np.mean([np.interp(x, *profile) for profile in profiles], axis=0), color=colour,
              label=f"{height} mm above the plate")
    axes.plot(1e3 * measurement[0], measurement[1], MARKERS[number], color=colour, markersize=4, markerfacecolor="none",
              label="... measured")
