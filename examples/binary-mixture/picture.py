# SPDX-License-Identifier: BSD-3-Clause
"""The picture of the beds of two sizes: the spheres at some times in three dimensions, and how segregated they are."""

import numpy as np

import analyse
from cohesion_studies import vtk_spheres
from cohesion_studies.drawing import pyplot, save
from cohesion_studies.foam_results import written_times

SNAPSHOTS = 4
SHOWN = 2.5  # of the height at rest
COLOURS = (0.90, 0.62, 0.12), (0.13, 0.36, 0.62)  # of small and of large spheres
PIXELS = 420, 640


def draw(file, jobs):
    """A row of snapshots for the first job of each kind, and below them the curves of all."""
    first = list({job.kind: job for job in reversed(jobs)}.values())[::-1]
    figure = pyplot.figure(figsize=(11, 4.2 * len(first) + 3.2), constrained_layout=True)
    parts = figure.subfigures(len(first) + 1, 1, height_ratios=[4.2] * len(first) + [3.2])
    for part, job in zip(parts, first):
        snapshots(part, job)
    curves(parts[-1], jobs)
    save(figure, file, dpi=80)


def snapshots(part, job):
    bed = analyse.Bed(job.folder)
    times = written_times(job.folder)
    chosen = np.array(sorted(times))[np.linspace(0, len(times) - 1, SNAPSHOTS).astype(int)]
    shown = min(bed.height, SHOWN * analyse.rest_height(bed))
    scenes = [scene(bed, analyse.Spheres.read(times[time])) for time in chosen]
    part.suptitle(f"{bed.velocity:g} m/s ({job.name})", fontsize=10)
    for axes, time, image in zip(part.subplots(1, SNAPSHOTS), chosen,
                                 vtk_spheres.images(scenes, (bed.width, shown, bed.thickness), PIXELS)):
        axes.imshow(image)
        axes.set_title(f"{time:.1f} s", fontsize=9)
        axes.axis("off")


def scene(bed, spheres):
    """What vtk_spheres draws."""
    return [(spheres.places[kind], diameter / 2, colour)
            for kind, diameter, colour in zip((~spheres.large, spheres.large), bed.diameters, COLOURS)]


def curves(part, jobs):
    kinds = list(dict.fromkeys(job.kind for job in jobs))
    apart, halves, mixed = part.subplots(1, 3)
    for job in jobs:
        bed = analyse.Bed(job.folder)
        times, (segregation, small, large, lacey) = analyse.mixing_history(bed)
        look = {"color": f"C{kinds.index(job.kind)}", "linewidth": 0.9,
                "label": f"{bed.velocity:g} m/s" if job is next(j for j in jobs if j.kind == job.kind) else None}
        apart.plot(times, segregation, **look)
        halves.plot(times, large, **look)
        halves.plot(times, small, **{**look, "label": None, "linestyle": "--"})
        mixed.plot(times, lacey, **look)
    apart.set_ylabel("segregation [1]")
    halves.set_ylabel("share in the lower half [1]\nlarge: full, small: broken")
    mixed.set_ylabel("Lacey index [1]")
    for axes in (apart, halves, mixed):
        axes.set_xlabel("time [s]")
        axes.grid(alpha=0.3)
    apart.legend(fontsize=8)
