# SPDX-License-Identifier: BSD-3-Clause
"""The picture of the round column: each engine's beads and gas in three dimensions, and the pressure drop while the gas
rises."""

import tempfile
from pathlib import Path

import wall
from cohesion_studies import raised_gas
from cohesion_studies.case_entries import entries
from cohesion_studies.drawing import pyplot, save
from cohesion_studies.foam_results import written_times
from cohesion_studies.vtk_section import Section

SPEEDS = {"spheres": 0.2, "gas": 1.5}  # where the colours end [m/s]
SHOWN = 1.9  # of the height at rest


def draw(file, jobs):
    """jobs: finished runs of run.py."""
    first = list({job.kind: job for job in reversed(jobs)}.values())[::-1]
    figure = pyplot.figure(figsize=(9, 3.9 * len(first) + 3.3), constrained_layout=True)
    *rows, below = figure.subfigures(len(first) + 1, 1, height_ratios=[3.9] * len(first) + [3.3])
    for part, job in zip(rows, first):
        draw_views(part, job)
    draw_drops(below.subplots(), jobs)
    save(figure, file, dpi=85)


def views(job, folders):
    """Section, and its pictures of written times, {time: folder}."""
    size = entries(job.folder / "constant/grains")
    shown = SHOWN * job.options["--height"]
    with tempfile.TemporaryDirectory() as scratch:
        side = Path(scratch) / "column.stl"
        wall.write_stl(side, size["radius"], shown)
        section = Section(side, "z", job.options["--diameter"] / 2, shown, SPEEDS, (330, 560))
        return section, section.images(job.folder, folders)


def draw_views(part, job):
    """The first, the middle and the last time after the start."""
    times = [(time, folder) for time, folder in sorted(written_times(job.folder).items()) if time > 0]
    chosen = dict(times[i] for i in (0, len(times) // 2, -1))
    section, images = views(job, chosen)
    places = part.subplots(1, len(images))
    for axes, image, time in zip(places, images, chosen):
        axes.imshow(image)
        axes.set_axis_off()
        velocity = job.course["fastest"] * min(1, time / job.course["ramp"])
        axes.set_title(f"{job.name}: {time:.2f} s, {velocity:.2f} m/s", fontsize=9)
    section.colour_bars(part, places)


def draw_drops(axes, jobs):
    for job in jobs:
        time, velocity, drop = raised_gas.course(job.folder)
        rising = time < job.course["ramp"]
        axes.plot(velocity[rising], raised_gas.smoothed(time, drop)[rising], linewidth=1, label=job.name)
        axes.axvline(job.result()["U_mf_of_the_closure"], color="0.7", linewidth=0.8)
    axes.axhline(1, color="k", linewidth=0.8)
    axes.set(xlabel="superficial velocity [m/s]", ylabel="pressure drop/weight")
    axes.legend(frameon=False)
