# SPDX-License-Identifier: BSD-3-Clause
"""Velocities of the fluidisation curve, mixing, movement and overshoot against the escape velocity between particles.

    picture.py SUMMARY.csv PICTURE.png"""

from cohesion_studies import program
from cohesion_studies.bed.statements import LAWS, SCHEMES, by_level
from cohesion_studies.bed.verdict import Study
from cohesion_studies.drawing import pyplot, save

PANELS = {"U_mf_df": "U_mf,df [m/s]", "U_mf_th": "U_mf,th [m/s]", "U_mf_in": "U_mf,in [m/s]",
          "mixing": "mixing [1/s]", "movement": "movement [mm]",
          "overshoot_over_plateau": "overshoot over the plateau [1]"}
SCALES = {"movement": 1e3}
COLOURS = {"well": "#1f6f8b", "hamaker": "#c8553d"}
APART = 0.06  # mm/s, between lines
STYLES = {"exact": "o-", "sampled": "s--"}


def draw(study, file):
    figure, panels = pyplot.subplots(2, 3, figsize=(11, 6.5), constrained_layout=True)
    for axes, (column, label) in zip(panels.flat, PANELS.items()):
        lines = [(law, suffix) for law in COLOURS for suffix in SCHEMES]
        for beside, (law, suffix) in enumerate(lines):
            # A little apart, else their bars hide each other.
            found = [(1e3 * study.number(row, "v_esc") + APART * (beside - 1.5),
                      *(SCALES.get(column, 1) * number for number in mean))
                     for row in by_level(law, suffix) if (mean := study.with_error(row, column))]
            if found:
                axes.errorbar(*zip(*found), fmt=STYLES[SCHEMES[suffix]], color=COLOURS[law], markersize=4.5,
                              capsize=2, label=f"{LAWS[law]}, {SCHEMES[suffix]}")
        axes.set_xlabel("escape velocity between particles [mm/s]")
        axes.set_ylabel(label)
    if panels[0, 0].lines:
        panels[0, 0].legend(frameon=False, fontsize=8)
    save(figure, file, dpi=110)


if __name__ == "__main__":
    summary, to = program.words(__doc__, 2)
    program.run(lambda: draw(Study(summary), to), OSError)
