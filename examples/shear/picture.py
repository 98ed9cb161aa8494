# SPDX-License-Identifier: BSD-3-Clause
"""The picture of the sheared discs: stress, its parts, agglomerates, both regimes."""

import numpy as np

import analyse
import sweep
from cohesion_studies.drawing import circles, label_between_decades, pyplot, save

DEPTHS = (*sweep.MILD, *sweep.TRANSITION)
COLOURS = dict(zip(DEPTHS, pyplot.get_cmap("viridis")(np.linspace(0, 0.9, len(DEPTHS)))))
KIND_COLOURS = dict(zip(analyse.KINDS, ("#1f6f8b", "#7a5195", "#ef8354", "#c8553d", "0.5")))
SNAPSHOTS = ((0.4, 2), (0.4, 16))  # phi, D


def draw(out, raw):
    """Writes result.png to `out`; raw: finished runs as from run.py."""
    results = analyse.Results(raw)
    figure = pyplot.figure(figsize=(13, 11.5), constrained_layout=True)
    axes = figure.subplots(3, 3)
    against_fraction(axes[0, 0], results, "normal", "normal stress / rho_s rate^2 r^2", sweep.MILD)
    against_fraction(axes[0, 1], results, "stress_xy", "shear stress / rho_s rate^2 r^2", sweep.MILD)
    by_kind(axes[0, 2], results, 0.4)
    against_fraction(axes[1, 0], results, "size", "mean size of agglomerates", DEPTHS[1:], log=True)
    against_fraction(axes[1, 1], results, "duration", "mean duration x rate", DEPTHS[1:], log=True)
    against_width(axes[1, 2], results)
    largest(axes[2, 0], results)
    for cell, (phi, D) in zip(axes[2, 1:], SNAPSHOTS):
        snapshot(cell, out, results.run(phi, D))
    axes[0, 0].legend(frameon=False, fontsize=8, loc="lower left")
    axes[1, 0].legend(frameon=False, fontsize=8)
    save(figure, out / "result.png", dpi=75)


def against_fraction(axes, results, quantity, label, depths, log=False):
    for D in depths:
        phi, mean, error = results.curve(quantity, D)
        axes.errorbar(phi, mean, error, fmt="o-", color=COLOURS[D], markersize=4, linewidth=1.2,
                      capsize=2, label=f"D = {D} m rate^2 r^2")
    axes.set_xlabel("area fraction")
    axes.set_ylabel(label)
    if log:
        axes.set_yscale("log")
        label_between_decades(axes.yaxis)
    else:
        axes.set_ylim(bottom=0)


def by_kind(axes, results, phi):
    for kind in analyse.KINDS:
        points = [results.at(f"{kind}_xx", phi, D) for D in sweep.MILD]
        axes.errorbar(sweep.MILD, [p[0] for p in points], [p[1] for p in points], fmt="o-",
                      color=KIND_COLOURS[kind], markersize=4, linewidth=1.2, capsize=2, label=kind)
    axes.axhline(0, color="0.6", linewidth=0.8)
    axes.set_ylim(top=14)
    axes.set_xlabel("D / m rate^2 r^2")
    axes.set_ylabel(f"parts of tau_xx / rho_s rate^2 r^2, phi = {phi}")
    axes.legend(frameon=False, fontsize=8, ncol=2, loc="upper center")


def against_width(axes, results):
    for phi, style in zip(sweep.AT_WIDTHS, ("o-", "s--")):
        for quantity, colour in (("size", "#1f6f8b"), ("duration", "#c8553d")):
            points = [results.at(quantity, phi, sweep.WIDTHS_DEPTH, w) for w in sweep.WIDTHS]
            axes.errorbar([w - 1 for w in sweep.WIDTHS], [p[0] for p in points], [p[1] for p in points],
                          fmt=style, color=colour, markersize=4, linewidth=1.2, capsize=2,
                          label=f"{quantity}, phi = {phi}")
    axes.set_xscale("log")
    axes.set_yscale("log")
    label_between_decades(axes.yaxis)
    axes.set_xlabel("r_out/r - 1")
    axes.set_ylabel(f"mean size, mean duration x rate, D = {sweep.WIDTHS_DEPTH}")
    axes.legend(frameon=False, fontsize=8)


def largest(axes, results):
    for D in sweep.TRANSITION:
        phi, mean, error = results.curve("largest", D)
        axes.errorbar(phi, mean, error, fmt="o-", color=COLOURS[D], markersize=4, linewidth=1.2,
                      capsize=2, label=f"D = {D}")
        at = analyse.transition(results, D)
        if at:
            axes.axvspan(at[0] - at[1], at[0] + at[1], color=COLOURS[D], alpha=0.25)
    axes.axhline(analyse.LARGE, color="0.6", linewidth=0.8)
    axes.set_yscale("log")
    axes.set_xlabel("area fraction")
    axes.set_ylabel("largest agglomerate / all discs")
    axes.legend(frameon=False, fontsize=8, title="shaded: transition", title_fontsize=8)


def snapshot(axes, out, result):
    """Discs by the size of their agglomerate, folded back into an upright box."""
    run = sweep.Run(*(result["settings"][k] for k in sweep.Run._fields))
    rows = np.loadtxt(out / "runs" / run.name / "discs.txt", skiprows=9)
    length = result["box"][0]
    discs = circles(axes, np.stack([rows[:, 1] % length, rows[:, 2]], axis=1), 2.0, array=np.log10(rows[:, 3]),
                    cmap="inferno_r")
    discs.set_clim(0, 3)
    axes.set_xlim(0, length)
    axes.set_ylim(0, length)
    axes.set_xlabel("x / r")
    axes.set_title(f"phi = {run.phi:g}, D = {run.D}", fontsize=10)
    pyplot.colorbar(discs, ax=axes, shrink=0.8, label="log10 of agglomerate size")
