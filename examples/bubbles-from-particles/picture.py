# SPDX-License-Identifier: BSD-3-Clause
"""The picture of the measured bubbles: a bed of each kind with the bubbles that are found in it, how fast they rise and
how large they are against the correlations."""

import numpy as np

import analyse
import tracking
from beds import KINDS
from cohesion_studies.drawing import MARKERS, circles, pyplot, save
from cohesion_studies.foam_results import read_cloud, written_times


def draw(file, jobs, lives):
    """`jobs`: one of each kind; `lives`: {kind: measured() of its bubbles}."""
    figure = pyplot.figure(figsize=(3.1 * len(jobs) + 5.2, 6.4), constrained_layout=True)
    views, panels = figure.subfigures(1, 2, width_ratios=[3.1 * len(jobs), 5.2])
    for axes, job in zip(views.subplots(1, len(jobs), squeeze=False)[0], jobs):
        draw_bed(axes, job)
    rise, size = panels.subplots(2, 1)
    for (kind, of), marker in zip(lives.items(), MARKERS):
        draw_lives(rise, size, kind, np.reshape(of, (-1, 5)), marker)
    d = np.linspace(0, max((life[0] for of in lives.values() for life in of), default=0.05) * 1.1)
    for k, name, style in ((analyse.THREE_D, "3-D", "-"), (analyse.TWO_D, "2-D", "--")):
        rise.plot(1e3 * d, k * np.sqrt(analyse.G * d), style, color="k", linewidth=0.8,
                  label=rf"{k:g} $\sqrt{{g\,d}}$, {name}")
    rise.set(xlabel="diameter [mm]", ylabel="rise velocity [m/s]")
    size.set(xlabel="height above the plate [mm]", ylabel="diameter [mm]", xlim=(0, None), ylim=(0, None))
    rise.legend(fontsize=7)
    size.legend(fontsize=7, title="lines: Darton et al., 3-D", title_fontsize=7)
    save(figure, file, dpi=80)


def fullest(times, job):
    """Time and folder of the picture in which most of the bed is free bubbles, and its bubbles and share of solids."""
    diameter, width, height = job.sizes()
    best = None
    for time in sorted(times)[len(times) // 3::4]:
        share = tracking.solid_share(read_cloud(times[time])[0][:, :2], diameter, width, height)
        found = tracking.bubbles(share, (width / share.shape[1], height / share.shape[0]), diameter)
        area = sum(bubble.area for bubble in found if bubble.free)
        if best is None or area > best[0]:
            best = area, time, found, share
    return best[1:]


def draw_bed(axes, job):
    diameter, width, height = job.sizes()
    times = {time: folder for time, folder in written_times(job.folder).items() if time > 0}
    time, found, share = fullest(times, job)
    places, velocities = read_cloud(times[time])
    circles(axes, 1e3 * places[:, :2], 1e3 * diameter, array=velocities[:, 1], cmap="coolwarm").set_clim(-1, 1)
    for bubble in found:
        inside = np.zeros(share.size)
        inside[list(bubble.cells)] = 1
        edges = [np.arange(n) + 0.5 for n in share.shape]
        axes.contour(edges[1] * 1e3 * width / share.shape[1], edges[0] * 1e3 * height / share.shape[0],
                     inside.reshape(share.shape), [0.5], colors="k" if bubble.free else "grey", linewidths=1.2)
    axes.set(xlim=(0, 1e3 * width), ylim=(0, 1.05e3 * np.percentile(places[:, 1], 99.5)))
    axes.set_title(f"{job.kind}, {time:.2f} s [mm]", fontsize=9)
    axes.tick_params(labelsize=7)


def draw_lives(rise, size, kind, of, marker):
    d, h, v = of[:, :3].T
    points = rise.plot(1e3 * d, v, marker, markersize=3, alpha=0.7, label=kind)[0]
    size.plot(1e3 * h, 1e3 * d, marker, markersize=3, alpha=0.7, color=points.get_color(), label=kind)
    velocity, minimum, plate, _ = KINDS[kind]
    heights = np.linspace(0, max(h, default=0.05))
    size.plot(1e3 * heights, 1e3 * analyse.darton(velocity - minimum, heights, plate), color=points.get_color(),
              linewidth=0.8)
