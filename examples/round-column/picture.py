# SPDX-License-Identifier: BSD-3-Clause
"""The picture of the round column."""

from cohesion_studies import raised_gas
from cohesion_studies.drawing import pyplot, save


def draw(file, jobs):
    """jobs: finished runs of run.py."""
    figure, axes = pyplot.subplots(figsize=(6, 4), constrained_layout=True)
    for job in jobs:
        time, velocity, drop = raised_gas.course(job.folder)
        rising = time < job.course["ramp"]
        axes.plot(velocity[rising], raised_gas.smoothed(time, drop)[rising], linewidth=1, label=job.name)
        axes.axvline(job.result()["U_mf_of_the_closure"], color="0.7", linewidth=0.8)
    axes.axhline(1, color="k", linewidth=0.8)
    axes.set(xlabel="superficial velocity [m/s]", ylabel="pressure drop/weight")
    axes.legend(frameon=False)
    save(figure, file, dpi=85)
