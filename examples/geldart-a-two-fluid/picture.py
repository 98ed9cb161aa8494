# SPDX-License-Identifier: BSD-3-Clause
"""picture.py FILE CASE...: the expansion of the beds over time, the pressure under them, and where the grains are at
the end; cases of parcels dashed, in the colour of the two fluids of the same bed."""

import sys
from pathlib import Path

import analyse
from cohesion_studies.drawing import pyplot, save


def draw(file, cases, end=None):
    """`end`: to which time, [s]; that of the cases without."""
    figure, axes = pyplot.subplots(2, 1 + len(cases), figsize=(5 + 1.6 * len(cases), 5.5),
                                   gridspec_kw={"width_ratios": [3, *[1] * len(cases)]}, constrained_layout=True)
    beds = list(dict.fromkeys(Path(case).name.removeprefix("grains-") for case in cases))
    for column, case in enumerate(cases, 1):
        name = Path(case).name
        bed = name.removeprefix("grains-")
        look = {"color": f"C{beds.index(bed)}", "linestyle": "-" if name == bed else "--"}
        axes[0, 0].plot(*analyse.expansion(case), label=name, **look)
        axes[1, 0].plot(*analyse.pressure(case), linewidth=0.6, **look)
        columns, rows, height = analyse.mesh(case)
        times, solid = analyse.fractions(case)
        times = times[times <= (end or times[-1])]
        solid = solid[:len(times)]
        shown = (solid[-1], f"{times[-1]:.3g} s"), (solid[len(solid) // 3:].mean(axis=0), "mean")
        for row, (picture, when) in enumerate(shown):
            axes[row, column].imshow(picture, origin="lower", extent=(0, height * columns / rows, 0, height), vmin=0,
                                     vmax=0.62, cmap="Greys")
            axes[row, column].set_title(f"{name}\n{when}", fontsize=8)
            axes[row, column].set_ylim(0, 0.6)
            axes[row, column].set_xticks([])
    axes[0, 0].set(ylabel="expansion", xlabel="t [s]")
    axes[0, 0].legend(fontsize=8)
    axes[1, 0].set(ylabel="pressure drop / weight", xlabel="t [s]")
    for axis in axes[:, 0]:
        axis.set_xlim(0, end)
    save(figure, file)


if __name__ == "__main__":
    draw(sys.argv[1], sys.argv[2:])
