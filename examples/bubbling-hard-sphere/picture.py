# SPDX-License-Identifier: BSD-3-Clause
"""The picture of the hard-sphere beds: the spheres at some times, and the pressure trace of each bed."""

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402
from matplotlib.collections import EllipseCollection  # noqa: E402

import analyse  # noqa: E402
from foam_results import read_cloud, written_times  # noqa: E402

SNAPSHOTS = 5
SHOWN = 2.5  # of the height at rest


def draw(file, folders):
    """A row for each case of `folders`: snapshots, and pressure over weight per area against time."""
    figure = plt.figure(figsize=(15, 3.9 * len(folders)), constrained_layout=True)
    rows = figure.subplots(len(folders), SNAPSHOTS + 1, squeeze=False,
                           gridspec_kw={"width_ratios": SNAPSHOTS * [1] + [2.4]})
    for row, folder in zip(rows, folders):
        bed = analyse.Bed(folder)
        times = written_times(folder)
        chosen = np.array(sorted(t for t in times if t > 0))
        chosen = chosen[np.linspace(0, len(chosen) - 1, SNAPSHOTS + 1).astype(int)[1:]]
        for axes, time in zip(row, chosen):
            draw_bed(axes, bed, times[time])
            axes.set_title(f"{folder.name}, {time:.2f} s", fontsize=9)
        time, pressure = analyse.pressure_trace(bed)
        row[-1].plot(time, pressure / bed.weight, linewidth=0.8)
        row[-1].set_xlabel("time [s]")
        row[-1].set_ylabel("pressure over weight per area")
        row[-1].set_title(f"{folder.name}: {100 * bed.trace:g} cm above the plate", fontsize=9)
        row[-1].set_ylim(-0.5, 2)
    figure.savefig(file, dpi=55)
    plt.close(figure)


def draw_bed(axes, bed, folder):
    places, velocities = read_cloud(folder)
    size = np.full(len(places), bed.diameter * 1e3)
    spheres = EllipseCollection(size, size, 0 * size, units="xy", offsets=places[:, :2] * 1e3,
                                transOffset=axes.transData, array=velocities[:, 1], cmap="coolwarm")
    spheres.set_clim(-1, 1)
    axes.add_collection(spheres)
    axes.set_xlim(0, bed.width * 1e3)
    axes.set_ylim(0, min(bed.height, SHOWN * analyse.heights(bed)[1][0]) * 1e3)
    axes.set_aspect("equal")
    axes.tick_params(labelsize=7)
