# SPDX-License-Identifier: BSD-3-Clause
"""Error against seconds, a panel for each quantity."""

import compare
from cohesion_studies.drawing import MARKERS, label_between_decades, pyplot, save


def draw(file, panels):
    """`panels`: [(title, unit of the step, rows, wished error)]."""
    figure, axes = pyplot.subplots(1, len(panels), figsize=(5.2 * len(panels), 4.2), squeeze=False,
                                   constrained_layout=True)
    for axis, words in zip(axes[0], panels):
        panel(axis, *words)
    save(figure, file)


def shown(row):
    """An error that is no more than chance is drawn at what it is below."""
    return row.error if compare.resolved(row) else compare.upper(row)


def panel(axis, title, unit, rows, wish):
    good = [row for row in rows if not row.failure and 0 < shown(row) < float("inf")]
    if not good:
        axis.set(title=title)
        axis.text(0.5, 0.5, "no error above zero that is known", ha="center", transform=axis.transAxes)
        return
    for (name, own), marker in zip(sorted(compare.by_scheme(good).items()), MARKERS):
        own = sorted(own, key=lambda row: row.setting.step)
        line, = axis.plot([row.seconds[1] for row in own], [shown(row) for row in own], "-", label=name, alpha=0.5)
        for row in own:
            known = compare.resolved(row)
            axis.errorbar(row.seconds[1], shown(row), color=line.get_color(), marker=marker, capsize=2,
                          mfc=line.get_color() if known else "white",
                          yerr=[[min(row.margin, 0.9 * row.error)], [row.margin]] if known and row.margin else None)
            axis.annotate(f"{row.setting.step:.3g} {unit}", (row.seconds[1], shown(row)), fontsize=6, rotation=40,
                          textcoords="offset points", xytext=(3, 5))
    best = [row for row in compare.front(rows) if row in good]
    axis.step([row.seconds[1] for row in best], [shown(row) for row in best], where="post", color="grey",
              linewidth=0.8, linestyle=":", label="front")
    axis.axhline(wish, color="black", linewidth=0.6)
    axis.text(0.99, wish, "wished", fontsize=7, ha="right", va="bottom", transform=axis.get_yaxis_transform())
    axis.set(xscale="log", yscale="log", xlabel="processor seconds", ylabel="error", title=title)
    axis.margins(x=0.12, y=0.15)
    label_between_decades(axis.yaxis)
    axis.legend(fontsize=7, title="open: below this, at 95 %", title_fontsize=6)
