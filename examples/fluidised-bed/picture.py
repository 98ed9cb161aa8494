# SPDX-License-Identifier: BSD-3-Clause
"""The picture of the fluidised bed: fluidisation curves and two snapshots."""

from cohesion_studies.bed import analyse
from cohesion_studies.drawing import circles, pyplot, save
from cohesion_studies.foam_results import read_cloud, written_times

COLOURS = {"non-cohesive": "#1f6f8b", "Hamaker": "#c8553d"}


def draw(out, results):
    """Writes result.png to `out`; results as from run.py's evaluate(), by case."""
    figure = pyplot.figure(figsize=(11, 5.6), constrained_layout=True)
    curve, *beds = figure.subplots(1, 3, gridspec_kw={"width_ratios": [2.4, 1, 1]})
    draw_curves(curve, results)
    for axes, name in zip(beds, results):
        draw_snapshot(axes, out / name, name)
    save(figure, out / "result.png", dpi=130)


def draw_curves(axes, results):
    for name, result in results.items():
        for rising, style in ((False, "o-"), (True, "^--")):
            steps = [s for s in result["steps"] if s.rising == rising]
            axes.errorbar([s.velocity for s in steps], [s.ratio for s in steps],
                          [s.ratio_error for s in steps], fmt=style, color=COLOURS[name],
                          markersize=4.5, linewidth=1.2, capsize=2,
                          label=f"{name}, {'rising' if rising else 'falling'}")
        axes.axvline(result["velocities"].rising[0], color=COLOURS[name], linewidth=0.8,
                     linestyle=":")
    axes.axhline(1.0, color="0.4", linewidth=0.8)
    axes.set_xlabel("superficial gas velocity [m/s]")
    axes.set_ylabel("pressure drop x area / weight above the lowest node [1]")
    axes.set_xlim(left=0)
    axes.set_ylim(bottom=0)
    axes.legend(frameon=False, loc="lower right")
    axes.set_title("fluidisation curve (dotted: U_mf,th)", fontsize=10)


def draw_snapshot(axes, case, name):
    time, folder = max(written_times(case).items())
    positions, velocities = read_cloud(folder)
    bed = analyse.Bed.read(case)
    particles = circles(axes, positions[:, :2] * 1e3, bed.diameter * 1e3, array=velocities[:, 1], cmap="coolwarm")
    particles.set_clim(-0.5, 0.5)
    axes.set_xlim(0, bed.width * 1e3)
    axes.set_ylim(0, 130)
    axes.set_xlabel("[mm]")
    axes.set_title(f"{name}, {time:.2f} s", fontsize=10)
    pyplot.colorbar(particles, ax=axes, location="bottom", shrink=0.8, ticks=(-0.5, 0, 0.5),
                    label="vertical velocity [m/s]")
