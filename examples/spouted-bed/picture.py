# SPDX-License-Identifier: BSD-3-Clause
"""The picture of the spouted beds: views of each in three dimensions, pressure drop against gas velocity, and the void
fraction on the axis against time."""

import analyse
from cohesion_studies.drawing import pyplot, save
from cohesion_studies.vtk_section import Section

SPEEDS = {"spheres": 1.5, "gas": 20.0}  # where the colours end [m/s]


def moments(bed):
    """Times of the views, with what they show: the bed before it opens, in steady gas, and at the end."""
    times = list(bed.times)
    rising = bed.schedule[0][bed.schedule[1].argmax()] / 3
    wanted = {"rising gas": rising, "spouting": bed.spouting[1], "at the end": times[-1]}
    return {min(times, key=lambda time: abs(time - near)): name for name, near in wanted.items()}


def draw(file, folders):
    """A row of views for each case of `folders`, and their curves."""
    beds = [analyse.Bed(folder) for folder in folders]
    figure = pyplot.figure(figsize=(11, 4.9 * len(beds) + 3.4), constrained_layout=True)
    *rows, curves = figure.subfigures(len(beds) + 1, 1, height_ratios=[4.9] * len(beds) + [3.4])
    for part, bed in zip(rows, beds):
        draw_views(part, bed)
    drops, open_axis = curves.subplots(1, 2)
    for bed in beds:
        draw_curves(drops, open_axis, bed)
    drops.set_xlabel("superficial gas velocity in the inlet [m/s]")
    drops.set_ylabel("pressure drop over that of\na column of the bed [1]")
    drops.legend(fontsize=8)
    open_axis.set_xlabel("time [s]")
    open_axis.set_ylabel("least void fraction on the axis,\nup to the resting surface [1]")
    open_axis.legend(fontsize=8)
    save(figure, file, dpi=90)


def draw_views(figure, bed):
    chosen = moments(bed)
    height, _ = analyse.resting(bed)
    top = min(bed.vessel["height"], 3.2 * height)
    section = Section(bed.case / "wall.stl", "y", bed.spheres["d"] / 2, top, SPEEDS, (460, 800))
    images = section.images(bed.case, {time: bed.times[time] for time in chosen})
    places = figure.subplots(1, len(images), squeeze=False)[0]
    for axes, image, (time, name) in zip(places, images, chosen.items()):
        axes.imshow(image)
        axes.set_axis_off()
        axes.set_title(f"{bed.case.name}, {name}: {time:.2f} s, {bed.velocity(time):.1f} m/s", fontsize=9)
    section.colour_bars(figure, places)


def draw_curves(drops, open_axis, bed):
    name = bed.case.name
    height, void = analyse.resting(bed)
    time, drop = analyse.pressure_drop(bed)
    drop = drop / analyse.column(bed, height, void)
    begin, end = bed.steady
    line, = drops.plot(bed.velocity(time[time < begin]), drop[time < begin], linewidth=0.8, label=f"{name}, rising")
    drops.plot(bed.velocity(time[time > end]), drop[time > end], linewidth=0.8, alpha=0.6, linestyle="--",
               color=line.get_color(), label=f"{name}, falling")
    correlation = analyse.olazar(bed, height)
    drops.axvline(correlation, color=line.get_color(), linestyle=":", linewidth=0.8)
    when, heights, values = analyse.axis(bed)
    open_axis.plot(when, values[:, heights < height].min(axis=1), linewidth=0.6, label=name)
    open_axis.axhline(analyse.OPEN, color="grey", linewidth=0.5)
