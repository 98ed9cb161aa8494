# SPDX-License-Identifier: BSD-3-Clause
"""Fluidisation curves of a study in one picture: a panel for each kind of change, which is what the names of its rows
begin with up to the hyphen, the row `base` in all of them; means over the seeds in bands from their least to their
most, with processor seconds.

    curves.py STUDY_FOLDER PICTURE.png"""

import json
from pathlib import Path

import numpy as np

from cohesion_studies import program
from cohesion_studies.bed import analyse
from cohesion_studies.bed.verdict import Study
from cohesion_studies.case_entries import EntryError
from cohesion_studies.drawing import pyplot, save
from cohesion_studies.job_pool import RESULT, UNREAD
from cohesion_studies.study_table import number

BASE = "base"
BRANCHES = {"o-": "falling", "^--": "rising"}


class CurvesError(RuntimeError):
    """The runs are not those of the summary."""


def runs(folder, study, row):
    """Folders of the runs that the line of summary.csv is of: with its parameters, of one build of the programs, with
    figures, as many as it has seeds. Others may lie beside them, of earlier parameters or builds. Raises CurvesError
    when no build has as many, or more than one has."""
    given, seeds, of_build = study.rows[row], study.number(row, "seeds"), {}
    for file in sorted(folder.glob(f"runs/{row}-*/{RESULT}")):
        result = json.loads(file.read_text())
        if result.get(UNREAD):
            continue
        settings = result["settings"]
        build, seed = settings.pop("fingerprint"), settings.pop("seed")
        if file.parent.name == f"{row}-{seed}" and all(number(given.get(name, "")) == value
                                                       for name, value in settings.items()):
            of_build.setdefault(build, []).append(file.parent)
    found = [cases for cases in of_build.values() if len(cases) == seeds]
    if len(found) != 1 and seeds:
        raise CurvesError(f"{folder}: the {seeds:.0f} runs of row '{row}' in summary.csv are not known: run "
                          "study.py again with the seeds that are meant")
    return found[0] if seeds else []


def curves(folder, study, row):
    """[(velocities, pressure drops over the weight, a line for each seed that has a result)] of the falling and the
    rising branch; None without any."""
    found = [analyse.curve(case) for case in runs(folder, study, row)]
    if not found:
        return None
    drops = np.array([[step.ratio for step in steps] for steps in found])
    rising = np.array([step.rising for step in found[0]])
    velocity = np.array([step.velocity for step in found[0]])
    return [(velocity[branch], drops[:, branch]) for branch in (~rising, rising)]


def draw_row(axes, found, colour, label):
    """`found`: of curves()."""
    for style, (velocity, drops) in zip(BRANCHES, found):
        if len(drops) > 1:
            axes.fill_between(velocity, drops.min(axis=0), drops.max(axis=0), color=colour, alpha=0.2, linewidth=0)
        axes.plot(velocity, drops.mean(axis=0), style, color=colour, markersize=3, linewidth=1, label=label)
        label = None


def draw(folder, file):
    study = Study(folder / "summary.csv")
    kinds = list(dict.fromkeys(row.split("-")[0] for row in study.rows if row != BASE))
    figure, panels = pyplot.subplots(1, len(kinds), figsize=(3.6 * len(kinds), 4), sharey=True, squeeze=False,
                                     constrained_layout=True)
    for axes, kind in zip(panels[0], kinds):
        rows = [row for row in study.rows if row == BASE or row.split("-")[0] == kind]
        for row, colour in zip(rows, pyplot.rcParams["axes.prop_cycle"].by_key()["color"]):
            if found := curves(folder, study, row):
                draw_row(axes, found, colour, f"{row}: {study.number(row, 'processor_seconds'):.0f} s, "
                         f"{len(found[0][1])} seed{'s' * (len(found[0][1]) > 1)}")
        axes.axhline(1.0, color="0.5", linewidth=0.7)
        axes.set_xlabel("superficial velocity [m/s]")
        axes.set_title(kind, fontsize=10)
        axes.set_xlim(left=0)
        axes.legend(frameon=False, fontsize=7, loc="lower right")
    panels[0, 0].set_ylim(bottom=0)
    panels[0, 0].set_ylabel("pressure drop x area / weight [1]\n"
                            + ", ".join(f"{'triangles' if '^' in style else 'circles'}: {name}"
                                        for style, name in BRANCHES.items()))
    save(figure, file, dpi=110)


if __name__ == "__main__":
    of, to = program.words(__doc__, 2)
    program.run(lambda: draw(Path(of), to), OSError, CurvesError, EntryError)
