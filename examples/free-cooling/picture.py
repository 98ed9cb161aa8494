# SPDX-License-Identifier: BSD-3-Clause
"""The picture of the gas that cools: temperature against Haff's law, the rate over it, agglomerates, and slices."""

import numpy as np

import analyse
import theory
from cohesion_studies.drawing import circles, pyplot, save

COLOURS = {"e 0.9": "#1f6f8b", "D 0.02": "#ef8354", "D 0.2": "#7a5195", "phi 0.02": "0.5",
           "phi 0.02, D 0.02": "#c8553d"}
SLICE = 1.0  # thickness, in diameters, of centres that a slice shows


def draw(file, jobs):
    """jobs: finished runs of run.py."""
    kinds = {}
    for job in jobs:
        kinds.setdefault(job.kind, []).append(job)
    figure = pyplot.figure(figsize=(13, 8.4), constrained_layout=True)
    axes = figure.subplots(2, 3)
    temperature(axes[0, 0], kinds)
    over_haff(axes[0, 1], kinds)
    largest(axes[0, 2], kinds)
    for cell, kind, moment in zip(axes[1], ("D 0.02", "D 0.02", "D 0.2"), ("half", "end", "end")):
        draw_slice(cell, kinds[kind][0], moment)
    save(figure, file, dpi=85)


def gas_of(job):
    return theory.Gas(job.given["phi"], job.given["e"])


def course(jobs, quantity):
    """t/tau, mean over the seeds and its standard error."""
    found = [analyse.cooling(job.log()) for job in jobs]
    values = np.array([run[quantity] for run in found])
    error = values.std(axis=0, ddof=1) / np.sqrt(len(values)) if len(values) > 1 else 0 * values[0]
    return found[0]["time"] / gas_of(jobs[0]).tau, values.mean(axis=0), error


def temperature(axes, kinds):
    for kind in ("e 0.9", "D 0.02", "D 0.2"):
        t, T, _ = course(kinds[kind], "temperature")
        axes.plot(1 + t, T, "o-", markersize=3, linewidth=1, color=COLOURS[kind], label=kind)
        if D := kinds[kind][0].given["D"]:
            axes.axhline(D, color=COLOURS[kind], linewidth=0.8, linestyle=":")
    axes.plot(1 + t, (1 + t)**-2, color="k", linewidth=1, label="Haff")
    axes.set(xscale="log", yscale="log", xlabel="1 + t/tau", ylabel="temperature/that at the start")
    axes.set_title("dotted: T = D", fontsize=10)
    axes.legend(frameon=False)


def over_haff(axes, kinds):
    """1/sqrt(T) - 1 over t/tau: 1 is Haff's law of kinetic theory."""
    for kind, colour in COLOURS.items():
        jobs = kinds[kind]
        rates = []
        for job in jobs:
            found = analyse.cooling(job.log())
            t = found["time"][1:] / gas_of(job).tau
            rates.append((found["temperature"][1:]**-0.5 - 1) / t)
        rates = np.array(rates)
        error = rates.std(axis=0, ddof=1) / np.sqrt(len(rates)) if len(rates) > 1 else None
        axes.errorbar(1 + t, rates.mean(axis=0), error, fmt="o-", markersize=3, linewidth=1, color=colour, label=kind)
        if job.given["phi"] == 0.02 and (D := job.given["D"]):
            dilute = gas_of(job).with_wells(t * gas_of(job).tau, D)
            axes.plot(1 + t, (dilute**-0.5 - 1) / t, "--", linewidth=1, color=colour, label="few spheres, 1 + D/T")
    axes.axhline(1, color="k", linewidth=1)
    axes.set(xscale="log", ylim=(0.95, 1.4), xlabel="1 + t/tau", ylabel="rate of cooling since the start/Haff's")
    axes.legend(frameon=False, fontsize=8)


def largest(axes, kinds):
    for kind in ("D 0.02", "D 0.2", "phi 0.02, D 0.02"):
        _, T, _ = course(kinds[kind], "temperature")
        _, share, _ = course(kinds[kind], "largest")
        axes.plot(T[1:] / kinds[kind][0].given["D"], share[1:], "o-", markersize=3, linewidth=1, color=COLOURS[kind],
                  label=kind)
    axes.axhline(analyse.LARGE, color="0.7", linewidth=0.8)
    axes.set(xscale="log", yscale="log", xlabel="T/D", ylabel="largest agglomerate/all spheres")
    axes.invert_xaxis()
    axes.legend(frameon=False)


def draw_slice(axes, job, moment):
    """Spheres whose centres are in a slice, by the size of their agglomerate."""
    rows = np.loadtxt(job.folder / f"spheres-{moment}.txt", skiprows=9)
    side = gas_of(job).side(len(rows))
    rows = rows[abs(rows[:, 3] - side / 2) < SLICE / 2]
    found = circles(axes, rows[:, 1:3] % side, 1.0, cmap="viridis_r", edgecolor="0.3", linewidth=0.3)
    found.set_array(np.log10(np.maximum(rows[:, 4], 1)))
    found.set_clim(0, 3.4)
    axes.set(xlim=(0, side), ylim=(0, side), xticks=[], yticks=[])
    step = job.given["half"] if moment == "half" else job.given["intervals"]
    T = analyse.cooling(job.log())["temperature"][step]
    axes.set_title(f"{job.kind}, T/D = {T / job.given['D']:.3g}; darker: larger agglomerates", fontsize=10)
