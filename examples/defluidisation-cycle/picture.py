# SPDX-License-Identifier: BSD-3-Clause
"""Velocities of the fluidisation curve, mixing and movement against the escape velocity between particles.

    picture.py SUMMARY.csv PICTURE.png"""

import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "fluidised-bed"))

from statements import LAWS, LEVELS, SCHEMES  # noqa: E402
from verdict import Study  # noqa: E402

PANELS = {"U_mf_df": "U_mf,df [m/s]", "U_mf_th": "U_mf,th [m/s]", "U_mf_in": "U_mf,in [m/s]",
          "mixing": "mixing [1/s]", "movement": "movement [m]", "plugging": "share of time with a plug [1]"}
COLOURS = {"well": "#1f6f8b", "hamaker": "#c8553d"}
STYLES = {"event": "o-", "sampled": "s--"}


def draw(study, file):
    figure, panels = plt.subplots(2, 3, figsize=(11, 6.5), constrained_layout=True)
    for axes, (column, label) in zip(panels.flat, PANELS.items()):
        for law, colour in COLOURS.items():
            for suffix, scheme in SCHEMES.items():
                rows = [f"none{suffix}", *(f"{law}-{level}{suffix}" for level in LEVELS)]
                found = [(1e3 * study.number(row, "v_esc"), *mean) for row in rows
                         if (mean := study.with_error(row, column))]
                if found:
                    axes.errorbar(*zip(*found), fmt=STYLES[scheme], color=colour, markersize=4.5, capsize=2,
                                  label=f"{LAWS[law]}, {scheme}")
        axes.set_xlabel("escape velocity between particles [mm/s]")
        axes.set_ylabel(label)
    if panels[0, 0].lines:
        panels[0, 0].legend(frameon=False, fontsize=8)
    figure.savefig(file, dpi=110)
    plt.close(figure)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    draw(Study(sys.argv[1]), sys.argv[2])
