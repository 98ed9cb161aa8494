# SPDX-License-Identifier: BSD-3-Clause
"""The picture of run.py."""

import csv

import numpy as np

from cohesion_studies.drawing import pyplot, save

LAWS = ("beetstra", "hillKochLadd", "tenneti", "tang", "ergunWenYu")


def equal_spheres(table, re):
    """Names of the rows of equal spheres at random at a Reynolds number, by fraction; the first of each fraction."""
    rows = {}
    for name, row in table.items():
        if row["array"] == "random" and row["re"] == re and str(row["sizes"]) == "1":
            rows.setdefault(row["phi"], name)
    return [rows[phi] for phi in sorted(rows)]


def beside_laws(axis, names, results, title):
    """Drag over that of Beetstra, with two standard errors, beside the other laws."""
    if not names:
        return
    phi = [results[name]["phi"] for name in names]
    over = np.array([results[name]["F_beetstra"] for name in names])
    measured = np.array([results[name]["F"] for name in names])
    errors = np.array([2 * results[name].get("F_error", 0.0) for name in names])
    axis.errorbar(phi, measured / over, errors / over, fmt="ko", capsize=3, label="measured")
    for law in LAWS:
        axis.plot(phi, [results[name][f"F_{law}"] for name in names] / over, ".-", label=law)
    axis.set_xlabel("fraction of solid")
    axis.set_ylabel("F over F of beetstra")
    axis.set_title(title)
    axis.grid(alpha=0.3)
    axis.legend(fontsize=8)


def slice_of(axis, file, title):
    """Speed in a plane, spheres in grey."""
    with open(file, newline="") as lines:
        rows = np.array([[float(cell) for cell in row] for row in list(csv.reader(lines))[1:]])
    width = int(rows[:, 0].max()) + 1
    speed = np.ma.masked_equal(rows[:, 2].reshape(-1, width), 0.0)
    image = axis.imshow(speed, origin="lower", cmap="viridis", vmax=np.percentile(speed.compressed(), 99))
    axis.set_facecolor("0.75")
    axis.set_xticks([])
    axis.set_yticks([])
    axis.set_title(title)
    axis.figure.colorbar(image, ax=axis, label="speed over U", shrink=0.8)


def draw(file, table, results, out):
    """`table`: rows by name; `results`: of array-drag by name; `out`: folder of folders with slice.csv."""
    slow = equal_spheres(table, 0)
    fast = [(re, equal_spheres(table, re)) for re in sorted({row["re"] for row in table.values()} - {0})]
    shown = [names[len(names) // 2] for names in [slow, *(names for _, names in fast[-1:])] if names]
    panels = 1 + len(fast) + len(shown)
    down = 1 if panels < 4 else 2
    across = -(-panels // down)
    figure, axes = pyplot.subplots(down, across, figsize=(4.6 * across, 4.2 * down), constrained_layout=True,
                                   squeeze=False)
    axes = axes.ravel()
    for axis in axes[panels:]:
        axis.set_visible(False)
    beside_laws(axes[0], slow, results, "slow flow")
    for axis, (re, names) in zip(axes[1:], fast):
        beside_laws(axis, names, results, f"Re {re}")
    for axis, name in zip(axes[1 + len(fast):], shown):
        slice_of(axis, out / name / "slice.csv", name)
    save(figure, file, dpi=90)
