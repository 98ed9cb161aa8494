# SPDX-License-Identifier: BSD-3-Clause
"""The picture of coarse graining: pressure drop and height against the gas, and what a run takes."""

import numpy as np

from cohesion_studies import raised_gas
from cohesion_studies.drawing import MARKERS, pyplot, save
from cohesion_studies.foam_results import function_table


def draw(file, jobs):
    """jobs: finished runs of run.py."""
    figure, (drops, heights, times) = pyplot.subplots(1, 3, figsize=(13, 4), constrained_layout=True)
    seen = {}
    for job in jobs:
        look = {"color": f"C{list(seen).index(job.kind) if job.kind in seen else len(seen)}", "linewidth": 1}
        label = None if job.kind in seen else job.kind
        seen.setdefault(job.kind, job)
        time, velocity, drop = raised_gas.course(job.folder)
        rising = time < job.course["ramp"]
        drops.plot(velocity[rising], raised_gas.smoothed(time, drop)[rising], label=label, **look)
        table = np.loadtxt(function_table(job.folder, "height", "bedHeight.dat"))
        heights.plot(table[:, 0], table[:, 1] / table[0, 1], label=label, **look)
        times.plot(job.options["--coarse-graining"], job.result()["processor_seconds"], MARKERS[0], color=look["color"])
    drops.axhline(1, color="k", linewidth=0.8)
    drops.set(xlabel="superficial velocity [m/s]", ylabel="pressure drop/weight")
    drops.legend(frameon=False)
    heights.set(xlabel="time [s]", ylabel="height/height at rest")
    ratios = np.array(sorted({job.options["--coarse-graining"] for job in jobs}))
    first = jobs[0].result()["processor_seconds"] * jobs[0].options["--coarse-graining"]**4
    times.plot(ratios, first / ratios**4, "k:", linewidth=1, label="l$^{-4}$")
    times.set(xscale="log", yscale="log", xlabel="l", ylabel="processor seconds")
    times.set_xticks(ratios, [f"{ratio:g}" for ratio in ratios])
    times.set_xticks([], minor=True)
    times.legend(frameon=False)
    save(figure, file, dpi=85)
