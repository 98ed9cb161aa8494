# SPDX-License-Identifier: BSD-3-Clause
"""The picture of the hard-sphere beds: the spheres at some times, and the pressure trace of each bed."""

import numpy as np

import analyse
from cohesion_studies.drawing import circles, pyplot, save
from cohesion_studies.foam_results import read_cloud, written_times

SNAPSHOTS = 5
SHOWN = 2.5  # of the height at rest


def draw(file, folders):
    """A row for each case of `folders`: snapshots, and pressure over weight per area against time."""
    figure = pyplot.figure(figsize=(11, 3.2 * len(folders)), constrained_layout=True)
    rows = figure.subplots(len(folders), SNAPSHOTS + 1, squeeze=False,
                           gridspec_kw={"width_ratios": SNAPSHOTS * [1] + [3.6]})
    for row, folder in zip(rows, folders):
        bed = analyse.Bed(folder)
        times = written_times(folder)
        chosen = np.array(sorted(t for t in times if t > 0))
        chosen = chosen[np.linspace(0, len(chosen) - 1, SNAPSHOTS + 1).astype(int)[1:]]
        for axes, time in zip(row, chosen):
            spheres = draw_bed(axes, bed, times[time])
            axes.set_title(f"{time:.2f} s", fontsize=9)
            if axes is not row[0]:
                axes.set_yticklabels([])
        row[0].set_ylabel(f"{folder.name} [mm]")
        figure.colorbar(spheres, ax=row[SNAPSHOTS - 1], ticks=(-1, 0, 1)).set_label("velocity up [m/s]", fontsize=8)
        time, pressure = analyse.pressure_trace(bed)
        row[-1].plot(time, pressure / bed.weight, linewidth=0.8)
        row[-1].set_xlabel("time [s]")
        row[-1].set_ylabel("pressure over weight per area [1]")
        row[-1].set_title(f"{100 * bed.trace:g} cm above the plate", fontsize=9)
        row[-1].set_ylim(-0.5, 2)
    save(figure, file, dpi=80)


def draw_bed(axes, bed, folder):
    places, velocities = read_cloud(folder)
    spheres = circles(axes, places[:, :2] * 1e3, bed.diameter * 1e3, array=velocities[:, 1], cmap="coolwarm")
    spheres.set_clim(-1, 1)
    axes.set_xlim(0, bed.width * 1e3)
    axes.set_ylim(0, min(bed.height, SHOWN * analyse.heights(bed)[1][0]) * 1e3)
    axes.tick_params(labelsize=7)
    return spheres
