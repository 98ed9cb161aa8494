# SPDX-License-Identifier: BSD-3-Clause
"""The picture of run.py."""

import numpy as np

import law
from cohesion_studies.drawing import pyplot, save

KINDS = {"cooling": "o", "shear": "s", "ball": "^", "chain": "x"}


def by_kind(found, kind, quantity):
    rows = [row for name, row in found.items() if name.rsplit("-", 1)[0] == kind]
    return [row[quantity] for row in rows]


def seen(axis, places, title):
    """Spheres along z, those further up lighter."""
    for x, y, z in places[np.argsort(places[:, 2])]:
        shade = 0.35 + 0.6 * (z - places[:, 2].min()) / max(np.ptp(places[:, 2]), 1e-9)
        axis.add_patch(pyplot.Circle((x, y), 0.5, facecolor=str(shade), edgecolor="k", linewidth=0.3))
    axis.autoscale_view()
    axis.set_aspect("equal")
    axis.set_axis_off()
    axis.set_title(title)


def draw(file, found, places):
    """`found`: rows of law.figures(); `places`: centres of each agglomerate that was alone."""
    figure, (left, right, *looks) = pyplot.subplots(1, 4, figsize=(17, 4.2), constrained_layout=True)
    for kind, marker in KINDS.items():
        n, gyration, radius = (np.array(by_kind(found, kind, key)) for key in ("n", "gyration", "radius"))
        left.plot(law.radius_by(n, gyration, found["law"]["c"]), radius, marker, label=kind)
        right.plot(n, radius / n, marker, label=kind)
    most = max(row["radius"] for row in found.values() if "radius" in row)
    left.plot([1, most], [1, most], "k-", linewidth=0.8)
    left.set_xlabel(f"hydrodynamic radius by the law, c = {found['law']['c']:.3f}, radii of a sphere")
    left.set_ylabel("measured")
    right.set_xscale("log")
    right.set_yscale("log")
    right.set_xlabel("spheres of the agglomerate")
    right.set_ylabel("drag on one of them over that of a sphere alone")
    for axis in (left, right):
        axis.grid(alpha=0.3)
        axis.legend(fontsize=8)
    for axis, kind in zip(looks, ("cooling", "shear")):
        names = [name for name in places if name.startswith(kind)]
        axis.set_visible(bool(names))
        if names:
            largest = max(names, key=lambda name: len(places[name]))
            seen(axis, places[largest], largest)
    save(figure, file, dpi=90)
