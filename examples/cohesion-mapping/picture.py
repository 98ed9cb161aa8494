# SPDX-License-Identifier: BSD-3-Clause
"""The picture of run.py."""

from cohesion_studies.drawing import pyplot, save


def draw(file, constants, families, steps, rows, exact):
    """constants [J], families {family: {label: depths [J]}}; steps over the contact time, and at each the
    row of escape velocities of scheme sampled, `exact` [m/s]."""
    figure, axes = pyplot.subplots(1, len(families) + 1, figsize=(4 * len(families) + 5, 3.8),
                                   constrained_layout=True)
    for axis, (family, members) in zip(axes, families.items()):
        for label, depths in members.items():
            axis.loglog(constants, depths, label=label)
        axis.set_xlabel("Hamaker constant A [J]")
        axis.legend(title=family, fontsize=8)
        axis.grid(alpha=0.3)
    axes[0].set_ylabel("depth D of equal escape velocity [J]")
    sampled = axes[-1]
    for law, name, colour in (("hamaker", "Hamaker", "tab:red"), ("well", "square well", "tab:blue")):
        mean, low, high = ([row[f"{law}_{k}"] / exact for row in rows]
                           for k in ("mean", "slowest_parted", "fastest_stuck"))
        sampled.fill_between(steps, low, high, color=colour, alpha=0.2)
        sampled.plot(steps, mean, color=colour, label=f"{name}: mean, range")
    sampled.axhline(1.0, color="black", linewidth=0.8, label="scheme exact")
    sampled.set_xscale("log")
    sampled.set_xlabel("time step over contact time, scheme sampled")
    sampled.set_ylabel("escape velocity over the exact one")
    sampled.legend(fontsize=8, loc="lower left")
    save(figure, file, dpi=90)
