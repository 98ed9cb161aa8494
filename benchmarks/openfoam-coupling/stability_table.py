#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""How far the coupling is off, over the stiffness of drag, void fraction, ratio of densities, cells per diameter and
the gas's Courant number: every row is runs of the solver. Two scenes, without gravity, in periodic boxes:

- uniform: gas blown through free spheres (free_spheres.py), against the exact solution;
- layer: the same spheres in the lower half of a box four times as high. The gas blows them along, through all cells,
  against the same with steps an eighth as long; and no energy may be gained. Drag is not linear here.

    stability_table.py BUILD WORK [--table FILE] [--only TEXT ...] [--together N]

A row takes some 5 seconds. --only: rows whose line has one of the texts, for instance '| 1e+06 |'; rows that were not
run stay as they are in the .csv file beside FILE, which has all rows. `--only none` remakes the page without runs.
"""

import csv
import re
import shutil
from collections import Counter
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np

from cohesion_studies.foam_case import CaseError
from cohesion_studies.progress_line import ProgressLine
from cohesion_tests import measuring_program
from cohesion_tests.coupling.cases import Columns
from cohesion_tests.coupling.fields import cells, particle_velocities
from cohesion_tests.coupling.free_spheres import RHO, U0, Setting, exact, run, solve, times

RIGHT = 0.01  # of the first slip
FINER = 8
# Of the uniform scene. More viscous gas throws light spheres about (docs/openfoam-coupling/stability.md). Its drag is
# above a linear one by 0.05 % (eps 0.3) to 0.44 % (eps 0.9999) at the first slip, by the closure; of a slip that falls
# as exp(-y) that is at most 0.0044 y exp(-y) < 0.0017: a sixth of RIGHT.
REYNOLDS = 0.1
PAGE = """# Errors of the coupling by drag, density and cells

Beds of at least 100 times the mass of their gas (R) are correct at any stiffness of the drag. Some are correct only
after the first steps. Light or dilute particles need `response free`, or gas steps shorter than m/b; the solver warns,
except in some rows (column *warned*). Do not use form A for light free spheres at a Courant number of 5.
[Stability](../openfoam-coupling/stability.md) lists and derives the limits.

```
benchmarks/openfoam-coupling/stability_table.py BUILD WORK --table FILE
```

Gas blows for 20 steps through free spheres in a periodic box, and through a layer of them in a higher box. Velocities
are compared with the exact solution, and those of the layer with steps an eighth as long. A row is correct if all
errors are below 0.01, and of first order if only the last one is. The solver stops below `minVoidFraction`.
"""
HEAD = ("| beta dt/(eps rho_g) | eps | rho_s/rho_g | cell/d | CFL | kernel | R | x | uniform: largest | end | layer:"
        " largest | end | energy | verdict |\n" + "|---" * 14 + "|")
LABEL = 8  # columns that name a row


def settings():
    """Keywords of Setting, one list per row: one quantity after the other, then corners."""
    rows = [{"stiffness": 10.0**k} for k in (-6, -4, -2, 0, 2, 4, 6, 9)]
    rows += [{"stiffness": 1e6, "kernel": "particleCentre", "eps": e} for e in (0.62, 0.3)]
    one = [{"eps": e} for e in (0.3, 0.45, 0.8, 0.9)]
    one += [{"eps": 0.99, "cell": 5}, {"eps": 0.999, "cell": 8}, {"eps": 0.9999, "cell": 17.4}]
    one += [{"ratio": r} for r in (1.0, 10.0, 100.0, 1e4)]
    one += [{"cell": 20, "eps": 0.99}, {"cell": 10, "eps": 0.9}, {"cell": 1, "eps": 0.8},
            {"cell": 0.5, "eps": 0.8}, {"cell": 0.5, "eps": 0.8, "width": 2}]
    one += [{"cfl": c} for c in (1.0, 5.0)]
    corners = [{"eps": e, "ratio": r, "cfl": c} for e in (0.3, 0.9) for r in (1.0, 1e4) for c in (0.2, 5.0)]
    corners += [{"ratio": 1.0, "cfl": 5.0, "cell": c, "eps": e} for c, e in ((10, 0.9), (1, 0.8))]
    rows += [{"stiffness": k, **row} for row in one for k in (1e-2, 1.0, 1e2, 1e6)]
    rows += [{"stiffness": k, **row} for row in corners for k in (1.0, 1e6)]
    rows += [{"stiffness": k, "ratio": r, "free": True} for r in (1.0, 10.0, 100.0) for k in (1e-2, 1.0, 1e2, 1e6)]
    rows += [{"stiffness": k, "eps": 0.9999, "cell": 17.4, "free": True} for k in (1e-2, 1.0, 1e2, 1e6)]
    rows += [{"stiffness": k, "eps": e, "form": "B"} for e in (0.3, 0.45, 0.62) for k in (1.0, 1e2, 1e6, 1e9)]
    return [{"kernel": "sphereOverlap", **row} for row in rows]


def label(s):
    kernel = s.kernel + (f", smoothed {s.width:g} d" if s.width else "") + (", response free" if s.free else "")
    kernel += ", form B" if s.form == "B" else ""
    x = s.stiffness / s.loading
    return (f"| {s.asked:.0e} | {s.eps:g} | {s.ratio:g} | {s.h / s.d:.2g} | {s.cfl:g} | {kernel} | {s.loading:.2g} |"
            f" {x:.1g} |")


def warned(log):
    said = ("the gas step is", "would grow by a factor", "would swing against the gas")
    return any(words in log for words in said)


class Refused(Exception):
    pass


def guarded(work, name, action):
    """What `action` finds; Refused with the solver's words when it stopped."""
    try:
        return action()
    except CaseError as error:
        text = " ".join(str(error).split())
        said = re.search(r"cells have a void fraction below minVoidFraction", text)
        said = said or re.search(r"FOAM FATAL.{,200}", text)
        logs = [Path(work, name, f"log.{program}") for program in ("cohesiveBedFoam", "lammps")]
        log, engine = (file.read_text() if file.exists() else "" for file in logs)
        # The reason of an engine that gives up stands in its own log; else the last words, whatever they are.
        reason = re.search(r"^ERROR.*", engine, re.M)
        ended = "stops: " + said[0] if said else "crashed: " + (reason[0] if reason else text[-200:])
        raise Refused(ended.replace("|", "/") + ", warned" * warned(log)) from None
    finally:
        shutil.rmtree(f"{work}/{name}", ignore_errors=True)


def uniform(column, name, keywords):
    """Errors in all steps, and whether it was said."""
    s = Setting(reynolds=REYNOLDS, **keywords)
    found, log = guarded(column.work, name, lambda: run(column, name, s))
    return np.abs(found - np.array(exact(s))).max(axis=0), warned(log)


def motion(column, name, s):
    """Of the layer after each step: the particles' mean velocity and the gas's mean flux; energies as shares of the
    first; the log."""
    case, log = solve(column, name, s)
    history, energies = [], []
    for time in times():
        v = particle_velocities(case, time)
        u, eps = cells(case, time, "U"), cells(case, time, "voidFraction")
        history.append((v.mean(), (eps * u).mean()))
        gas = 0.5 * RHO * (eps * u**2).mean() * s.box**2 * s.height
        energies.append(gas + 0.5 * s.ratio * RHO * s.volume * (v**2).sum())
    gas_alone = 0.5 * RHO * U0**2 * eps.mean() * s.box**2 * s.height
    return np.array(history), np.array(energies) / gas_alone, log


def layer(column, name, keywords):
    """Errors in all steps, the largest gains of energy, of the reference too, and whether it was said."""
    runs = [guarded(column.work, name, lambda s=Setting(layer=True, reynolds=100.0, finer=finer, **keywords):
                    motion(column, name, s)) for finer in (1, FINER)]
    (found, energies, log), (reference, finer, _) = runs
    gains = [np.maximum(e.max() - 1, 0) for e in (energies, finer)]
    return np.abs(found - reference).max(axis=1), gains, warned(log)


def verdict(errors, gains, said):
    """In words, of the errors in all steps of one run or more, and of gains of energy: its own, the reference's."""
    largest, end = (np.max([run[steps] for run in errors]) for steps in (slice(None), slice(-1, None)))
    if not np.isfinite([largest, end, *gains]).all() or gains[0] > RIGHT:
        word = "unstable"
    elif gains[1] > RIGHT:
        word = f"error {end:.1g}, reference unstable"
    elif largest < RIGHT:
        word = "correct"
    else:
        word = "first order" if end < RIGHT else f"error {end:.1g}"
    return word + ", warned" * said


def row(column, number, keywords):
    """A line of the table."""
    line = label(Setting(**keywords))
    try:
        alone, said = uniform(column, f"{number}-uniform", keywords)
    except Refused as refused:
        return f"{line} | | | | | {refused} |"
    line += f" {alone.max():.1g} | {alone[-1]:.1g} |"
    try:
        together, gains, also = layer(column, f"{number}-layer", keywords)
    except Refused as refused:
        return f"{line} | | | {verdict([alone], (0, 0), said)}; layer {refused} |"
    word = verdict([alone, together], gains, said or also)
    return f"{line} {together.max():.1g} | {together[-1]:.1g} | {gains[0]:.0g} | {word} |"


def cells(line):
    """Of a row of a table."""
    return [cell.strip() for cell in line.strip().strip("|").split("|")]


def merged(lines, file):
    """The rows of the program, as cells: these, and the others that the file had before."""
    known = {tuple(row[:LABEL]): row for row in csv.reader(open(file, newline=""))} if file.exists() else {}
    known.update({tuple(row[:LABEL]): row for row in map(cells, lines)})
    wanted = [tuple(cells(label(Setting(**keywords)))) for keywords in settings()]
    return [known[name] for name in wanted if name in known]


def is_right(row):
    return row[-1].removesuffix(", warned") in ("correct", "first order")


def worst(verdicts):
    """Verdicts of several rows in one cell: the largest error, and the others by their first words once each."""
    errors = [float(word.split()[1].rstrip(",")) for word in verdicts if word.startswith("error")]
    said = [f"error up to {max(errors):.1g}" if len(errors) > 1 else f"error {errors[0]:.1g}"] if errors else []
    parts = [part.removesuffix(", warned") for word in verdicts for part in word.split("; ")]
    others = [re.sub(r"^layer |:.*", "", part) for part in parts if not part.startswith("error")]
    unstable = ["reference unstable"] if any("reference unstable" in word for word in verdicts) else []
    others = [word for word in others if word not in ("correct", "first order")]
    return "; ".join(dict.fromkeys([*said, *unstable, *others]))


def groups(rows):
    """Cells of the rows that are not right: those of the same masses and response share a line."""
    found = {}
    for row in rows:
        if not is_right(row):
            found.setdefault((row[2], row[6], "free" if "free" in row[5] else "held"), []).append(row)
    return [[*name, span(row[0] for row in own), span(row[1] for row in own), worst([row[-1] for row in own]),
             f"{sum('warned' in row[-1] for row in own)} of {len(own)}"] for name, own in found.items()]


def span(numbers):
    """The least and the largest of numbers as they are written, or the only one."""
    ordered = sorted(set(numbers), key=float)
    return ordered[0] if len(ordered) == 1 else f"{ordered[0]} to {ordered[-1]}"


def page(rows, file):
    """Counts, and the rows that are not right; `file` has all."""
    counts = Counter(row[-1].removesuffix(", warned") for row in rows if is_right(row))
    missing = len(settings()) - len(rows)
    text = [f"{missing} of the {len(settings())} rows of the program are missing.", ""] if missing else []
    text += [f"Of {len(rows)} rows, {counts['correct']} are correct and {counts['first order']} of first order;"
             f" [{file.name}]({file.name}) lists all, with the", "errors and with x, the gas step over m/b. The others, by "
             "masses and response; *held* is explicit, *free* semi-implicit:", ""]
    names = ["rho_s/rho_g", "R", "response", "beta dt/(eps rho_g)", "eps", "verdict", "warned"]
    lines = ["| " + " | ".join(line) + " |" for line in (names, ["---"] * len(names), *groups(rows))]
    return "\n".join([PAGE, *text, *lines]) + "\n"


def main():
    parser = measuring_program.coupling_parser(__doc__)
    parser.add_argument("--table", help="file that the page is written to")
    parser.add_argument("--only", nargs="+", default=[""], help="rows whose line has one of these texts")
    parser.add_argument("--together", type=int, default=1, help="rows at a time")
    given = parser.parse_args()
    chosen = [k for k in settings() if any(text in label(Setting(**k)) for text in given.only)]
    print(HEAD, flush=True)
    column, line, lines = Columns(given.build, given.work), ProgressLine(), []
    with ThreadPoolExecutor(given.together) as pool:
        jobs = [pool.submit(row, column, n, k) for n, k in enumerate(chosen)]
        for done, job in enumerate(jobs, 1):
            lines.append(job.result())
            print(lines[-1], flush=True)
            line.show(line.elapsed * (len(jobs) - done) / done, f"{done} of {len(jobs)} rows")
    line.close()
    if given.table:
        table = Path(given.table)
        rows = merged(lines, table.with_suffix(".csv"))
        with open(table.with_suffix(".csv"), "w", newline="") as file:
            csv.writer(file, lineterminator="\n").writerows([cells(HEAD.splitlines()[0]), *rows])
        table.write_text(page(rows, table.with_suffix(".csv")))


if __name__ == "__main__":
    main()
