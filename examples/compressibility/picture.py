# SPDX-License-Identifier: BSD-3-Clause
"""The picture of run.py: compressibility over Carnahan and Starling's, restitution, freezing, cohesion, viscosity."""

import numpy as np

import laws
import theory
from cohesion_studies.drawing import MARKERS, pyplot, save


def draw(file, found, table):
    """found: figures of the rows; table: the rows."""
    figure = pyplot.figure(figsize=(13, 8.4), constrained_layout=True)
    axes = figure.subplots(2, 3)
    elastic(axes[0, 0], found, table)
    restitution(axes[0, 1], found, table)
    frozen(axes[0, 2], found, table)
    few(axes[1, 0], found, table)
    plane(axes[1, 1], found, table)
    viscosity(axes[1, 2], found, table)
    for axis in axes.flat:
        axis.set_xlabel("fraction of solid")
        axis.grid(alpha=0.3)
        axis.legend(fontsize=7, frameon=False)
    save(figure, file, dpi=85)


def points(axis, found, rows, value, factor=1.0, **look):
    """With two standard errors. rows: {name: row}."""
    if not rows:
        return
    names = sorted(rows, key=lambda name: rows[name]["phi"])
    y = np.array([found[name][value] for name in names]) * factor
    errors = np.array([2 * found[name].get(f"{value}_error", 0.0) for name in names]) * factor
    axis.errorbar([rows[name]["phi"] for name in names], y, errors, capsize=2, markersize=4, linewidth=1, **look)


def of(table, beginning, **wanted):
    return {name: row for name, row in table.items() if name.startswith(beginning)
            and all(row[key] == value for key, value in wanted.items())}


def elastic(axis, found, table):
    hard = of(table, "hard-", e=1)
    points(axis, found, hard, "y_over_cs", fmt="ko", label="hard, virial")
    soft = {name: row for name, row in of(table, "soft-", e=1).items()}
    points(axis, found, soft, "y_over_cs", fmt="s", color="#ef8354", label="soft, at their own diameter")
    phi = np.linspace(0.01, 0.63, 200)
    axis.plot(phi, theory.ma_ahmadi(phi) / theory.carnahan_starling(phi), color="#1f6f8b", label="Ma, Ahmadi")
    axis.axhline(1, color="k", linewidth=0.8, label="Carnahan, Starling")
    axis.set(ylim=(0.96, 1.6), yscale="log", ylabel="y over Carnahan, Starling", title="e = 1")
    axis.set_yticks([1, 1.1, 1.2, 1.4], ["1", "1.1", "1.2", "1.4"])
    axis.minorticks_off()


def restitution(axis, found, table):
    for marker, e in zip(MARKERS, sorted({row["e"] for row in of(table, "hard-").values()} - {1}, reverse=True)):
        driven = {name: row for name, row in of(table, "hard-", e=e, by="random").items()
                  if "over_elastic" in found[name]}
        points(axis, found, driven, "over_elastic", fmt=marker + "-", label=f"e {e}, random accelerations")
    rescaled = {name: row for name, row in of(table, "hard-", by="rescale").items() if "over_elastic" in found[name]}
    points(axis, found, rescaled, "over_elastic", fmt="kx", label="e 0.9, rescaled")
    axis.axhline(1, color="k", linewidth=0.8)
    axis.set(ylabel="y(e)/y(1) over (1 + e)/2", title="restitution")


def frozen(axis, found, table):
    points(axis, found, of(table, "fcc-"), "y", fmt="ks", label="from the crystal")
    points(axis, found, {n: r for n, r in of(table, "hard-", e=1).items() if r["phi"] > 0.44}, "y", fmt="o",
           color="#ef8354", label="from the fluid")
    fluid, solid = np.linspace(0.44, 0.61, 100), np.linspace(0.5, 0.66, 100)
    axis.plot(fluid, theory.y_of(theory.ma_ahmadi, fluid), color="#ef8354", linewidth=1, label="Ma, Ahmadi")
    axis.plot(solid, theory.crystal(solid), "k", linewidth=1, label="crystal, Speedy")
    for phi in (theory.FREEZING, theory.MELTING):
        axis.axvline(phi, color="0.6", linewidth=0.8, linestyle=":")
    axis.set(ylim=(5, 50), yscale="log", ylabel="y", title="freezing; dotted: fluid and crystal in balance")


def few(axis, found, table):
    for marker, base in zip(MARKERS, sorted({name.rpartition("-")[0] for name in [*of(table, "well-"),
                                                                                *of(table, "hamaker-")]})):
        rows = {name: row for name, row in of(table, base + "-").items() if row["scheme"] == "exact"}
        points(axis, found, rows, "y_over_cs", fmt=marker, label=base)
        colour = axis.lines[-1].get_color() if axis.lines else None
        first = next(iter(rows), None)
        if first:
            axis.plot(0, found[first]["b"], marker, markersize=8, fillstyle="none", color=colour)
    axis.set(xlim=(-0.005, None), ylabel="y over that of hard spheres", title="few spheres; open: second virial coefficient")


def plane(axis, found, table):
    phi = np.linspace(0.01, 0.5, 100)
    colours = {}
    for name, row in of(table, laws.WELLS).items():
        colours.setdefault(row["D"], f"C{len(colours)}")
    for D, colour in colours.items():
        for e, look in ((1, "o"), (0.9, "s")):
            rows = of(table, laws.WELLS, D=D, e=e)
            points(axis, found, rows, "y_over_cs", fmt=look, color=colour, label=f"D/T {D}, e {e}")
            law = found.get(f"plane e {e} law")
            if rows and law:
                axis.plot(phi, laws.cohesive(law, phi, D, 1.05), "-" if e == 1 else "--", color=colour, linewidth=1)
    axis.axhline(1, color="k", linewidth=0.8)
    axis.set(ylabel="y over (1 + e)/2 of hard spheres", title="wells of r_out/r 1.05; lines: the law")


def viscosity(axis, found, table):
    points(axis, found, of(table, "still-"), "over_enskog", fmt="ko", label="at rest (Helfand)")
    points(axis, found, of(table, "sheared-"), "over_enskog", fmt="s", color="#ef8354", label="sheared (Lees, Edwards)")
    axis.axhline(1, color="k", linewidth=0.8)
    axis.set(ylabel="viscosity over Enskog's", title="viscosity, e = 1")
