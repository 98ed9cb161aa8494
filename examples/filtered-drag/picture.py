# SPDX-License-Identifier: BSD-3-Clause
"""The picture of the boxes: grains in fine cells at the end, and the slip of all against time."""

import analyse
from cohesion_studies.drawing import circles, pyplot, save


def draw(file, jobs):
    """jobs: finished boxes of run.py, of which the first of each kind is shown."""
    first = {}
    for job in jobs:
        first.setdefault(job.kind, job)
    shown = [job for kind, job in first.items() if not kind.startswith("filtered")]
    figure, axes = pyplot.subplots(1, len(shown) + 1, figsize=(2.1 * len(shown) + 5, 4), constrained_layout=True,
                                   width_ratios=[1] * len(shown) + [2.4])
    for place, job in zip(axes, shown):
        grains(place, job)
    for number, (kind, job) in enumerate(first.items()):
        times, gas, velocity = analyse.Box(job.folder).velocities()
        look = "--" if kind.startswith("filtered") else "-"
        axes[-1].plot(times, gas - velocity, look, linewidth=1, color=f"C{number}", label=kind)
    axes[-1].set(xlabel="time [s]", ylabel="mean slip [m/s]", ylim=(0, None))
    axes[-1].legend(frameon=False, fontsize=8)
    save(figure, file, dpi=85)


def grains(axes, job):
    """Of a box at its last written time, with its cells."""
    box = analyse.Box(job.folder)
    time, places = box.places()[-1]
    of = box.is_of
    size = of["width"], of["height"]
    circles(axes, 1e3 * (places[:, :2] % size), 1e3 * of["diameter"], facecolor="C0", edgecolor="none", alpha=0.6)
    for length, count, line in ((size[0], of["columns"], axes.axvline), (size[1], of["rows"], axes.axhline)):
        for n in range(int(count) + 1):
            line(1e3 * length * n / count, color="k", linewidth=0.2)
    axes.set(xlim=(0, 1e3 * size[0]), ylim=(0, 1e3 * size[1]), title=f"{job.kind}, {time:g} s", xlabel="mm")
    axes.title.set_fontsize(8)
