# SPDX-License-Identifier: BSD-3-Clause
"""The picture of the pouring: the bed with the window of the area fraction, where the energy is, and the error of
its balance."""

import numpy as np
from matplotlib.patches import Rectangle

import analyse
from cohesion_studies.drawing import circles, pyplot, save

PARTS = {"height": "#1f6f8b", "motion": "#ef8354", "lost": "0.5"}


def draw(file, jobs):
    """jobs: finished runs of run.py."""
    figure = pyplot.figure(figsize=(12, 4.6), constrained_layout=True)
    bed, energy, error = figure.subplots(1, 3)
    shown = jobs[len(jobs) // 2]
    draw_bed(bed, shown)
    found = analyse.energy(shown.log(), shown.dt)
    for name, colour in PARTS.items():
        energy.plot(found["time"], found[name], color=colour, label=name)
    energy.set_xlabel("time [s]")
    energy.set_ylabel("energy over that at the start [1]")
    energy.legend(frameon=False)
    kinds = list(dict.fromkeys(job.kind for job in jobs))
    colours = dict(zip(kinds, pyplot.get_cmap("viridis")(np.linspace(0, 0.85, len(kinds)))))
    labelled = set()
    for job in jobs:
        found = analyse.energy(job.log(), job.dt)
        error.plot(found["time"], 100 * found["error"], color=colours[job.kind], linewidth=1,
                   label=None if job.kind in labelled else job.kind)
        labelled.add(job.kind)
    error.axhspan(-0.005, 0.005, color="0.85", zorder=0)
    error.set_xlabel("time [s]")
    error.set_ylabel("error of the energy [% of that at the start]")
    error.set_title("shaded: 0.005 %", fontsize=10)
    error.legend(frameon=False)
    save(figure, file, dpi=90)


def draw_bed(axes, job):
    places = analyse.spheres(job.folder)
    circles(axes, places * 1e3, analyse.DIAMETER * 1e3, facecolor="#8fb8c8", edgecolor="0.3", linewidth=0.4)
    left, right, bottom, top = (1e3 * a for a in analyse.window(places, job.width))
    axes.add_patch(Rectangle((left, bottom), right - left, top - bottom, fill=False, color="#c8553d"))
    axes.set_xlim(0, job.width * 1e3)
    axes.set_ylim(0, 1.1e3 * analyse.surface(places, job.width))
    axes.set_xlabel("[mm]")
    axes.set_title("red: window of the area fraction", fontsize=10)
