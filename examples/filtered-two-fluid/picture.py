# SPDX-License-Identifier: BSD-3-Clause
"""picture.py FILE FROM CASE...: drag over the law's by the size of the squares, of boxes from FROM [s] on, and where
their particles are at the end."""

import sys
from pathlib import Path

import analyse
from cohesion_studies.drawing import MARKERS, pyplot, save


def draw(file, start, cases):
    figure, axes = pyplot.subplots(1, 1 + len(cases), figsize=(5 + 2.6 * len(cases), 3.6), constrained_layout=True,
                                   gridspec_kw={"width_ratios": [1.6, *[1] * len(cases)]})
    for case, mark, shown in zip(cases, MARKERS, axes[1:]):
        sizes, ratios, errors = zip(*analyse.by_size(case, start))
        axes[0].errorbar(sizes, ratios, errors, marker=mark, capsize=2, label=Path(case).name)
        *_, (solid, _, _) = analyse.snapshots(case, start)
        edge = sizes[0] * len(solid)
        image = shown.imshow(solid, origin="lower", extent=(0, edge, 0, edge), cmap="Greys", vmin=0)
        figure.colorbar(image, ax=shown, shrink=0.7)
        shown.set_title(f"{Path(case).name}, solid fraction", fontsize=8)
        shown.set_xticks([])
        shown.set_yticks([])
    axes[0].set(xlabel="edge of the squares [m]", ylabel="drag / the law's at mean values", xscale="log")
    axes[0].legend(fontsize=8)
    save(figure, file)


if __name__ == "__main__":
    draw(sys.argv[1], float(sys.argv[2]), sys.argv[3:])
