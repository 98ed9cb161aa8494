# SPDX-License-Identifier: BSD-3-Clause
"""Fluidisation curves of a study in one picture: a panel for each kind of change, which is what the names of its rows
begin with up to the hyphen, the row `base` in all of them; with processor seconds.

    curves.py STUDY_FOLDER PICTURE.png"""

import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402

import analyse  # noqa: E402
from verdict import Study  # noqa: E402

BASE = "base"


def mean_curve(folder, row):
    """[(velocities, pressure drop over weight)] of the falling and the rising branch, in the mean over the seeds that
    have a result; None without any."""
    runs = [analyse.curve(run.parent) for run in sorted(folder.glob(f"runs/{row}-*/result.json"))
            if run.parent.name.rpartition("-")[0] == row]
    if not runs:
        return None
    mean = np.mean([[step.ratio for step in steps] for steps in runs], axis=0)
    rising = np.array([step.rising for step in runs[0]])
    velocity = np.array([step.velocity for step in runs[0]])
    return [(velocity[branch], mean[branch]) for branch in (~rising, rising)]


def draw(folder, file):
    study = Study(folder / "summary.csv")
    kinds = list(dict.fromkeys(row.split("-")[0] for row in study.rows if row != BASE))
    figure, panels = plt.subplots(1, len(kinds), figsize=(3.4 * len(kinds), 3.8), sharey=True, squeeze=False,
                                  constrained_layout=True)
    for axes, kind in zip(panels[0], kinds):
        rows = [row for row in study.rows if row == BASE or row.split("-")[0] == kind]
        for row, colour in zip(rows, plt.rcParams["axes.prop_cycle"].by_key()["color"]):
            for style, branch in zip(("o-", "^--"), mean_curve(folder, row) or ()):
                axes.plot(*branch, style, color=colour, markersize=3, linewidth=1, label=None if style == "^--" else
                          f"{row}: {study.number(row, 'processor_seconds'):.0f} s")
        axes.axhline(1.0, color="0.5", linewidth=0.7)
        axes.set_xlabel("superficial velocity [m/s]")
        axes.legend(frameon=False, fontsize=7, loc="lower right")
    panels[0, 0].set_ylabel("pressure drop x area / weight [1]")
    figure.savefig(file, dpi=110)
    plt.close(figure)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    draw(Path(sys.argv[1]), sys.argv[2])
