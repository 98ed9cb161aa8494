# SPDX-License-Identifier: BSD-3-Clause
"""One run of a scene: started, timed, read."""

import csv
import os
import re
import subprocess
import sys
import tempfile
from collections import namedtuple
from pathlib import Path

import numpy as np

from cohesion_studies import lammps_run, thermo

# values: of each quantity, (value, standard error by blocks or None); seconds: of a processor [s];
# failures: by quantity why it has no value, which is NaN then.
Outcome = namedtuple("Outcome", "values seconds failures")
# Paths of LAMMPS, its plugin, and the build folder of the package.
Engine = namedtuple("Engine", "program plugin build")
BLOCKS = 10


def command(scene, setting, seed, engine):
    """Words of the command line; `engine`: an Engine."""
    values = {name: str(value) for name, value in scene.values(setting, seed).items()}
    program, plugin = str(engine.program), str(engine.plugin)
    if scene.script:
        words = [program, "-in", str(scene.folder / scene.script), "-log", "none", "-var", "plugin", plugin]
        for name, value in values.items():
            words += ["-var", name, value]
        return words
    values.update(scene=str(scene.folder), lmp=program, plugin=plugin, build=str(engine.build),
                  python=sys.executable)
    return [re.sub(r"\{(\w+)\}", lambda m: values.get(m[1], m[0]), str(word)) for word in scene.command]


def run(scene, setting, seed, engine):
    """Runs it in a folder of its own, which is removed; gives the Outcome."""
    with tempfile.TemporaryDirectory(prefix="cohesion-") as folder:
        before = os.times()
        try:
            done = subprocess.run(command(scene, setting, seed, engine), cwd=folder, text=True,
                                  stdout=subprocess.PIPE, stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL,
                                  env={**os.environ, "OMP_NUM_THREADS": "1"})
        except OSError as problem:
            return failed(scene, 0.0, str(problem))
        after = os.times()
        process = after.children_user + after.children_system - before.children_user - before.children_system
        seconds = lammps_run.loop_seconds(done.stdout)
        seconds = process if seconds is None else seconds
        if done.returncode != 0:
            return failed(scene, seconds, reason(done))
        outcome = Outcome({}, seconds, {})
        for q in scene.quantities:
            try:
                outcome.values[q.name] = read(q, done.stdout, Path(folder))
                if not np.isfinite(outcome.values[q.name][0]):
                    outcome.failures[q.name] = "not a number"
            except LookupError as problem:
                outcome.values[q.name] = np.nan, None
                outcome.failures[q.name] = problem.args[0]
        return outcome


def failed(scene, seconds, why):
    return Outcome({q.name: (np.nan, None) for q in scene.quantities}, seconds,
                   {q.name: why for q in scene.quantities})


def reason(done):
    """What a run that failed said."""
    error = re.search(r"ERROR[^:]*: (.*?)( \(\S+:\d+\))?$", done.stdout, re.M)
    last = done.stdout.strip().splitlines()[-1:] or ["no output"]
    return f"ended with code {done.returncode}: {error[1] if error else last[0]}"


def read(quantity, log, folder):
    """Value and standard error by blocks of a quantity; raises LookupError."""
    tables = [columns(folder / quantity.file)] if quantity.file else lammps_run.tables(log)
    rows = next((table[quantity.column] for table in reversed(tables) if quantity.column in table), None)
    if rows is None or len(rows) == 0:
        names = ", ".join(dict.fromkeys(name for table in tables for name in table)) or "none"
        raise LookupError(f"no column '{quantity.column}' in {quantity.file or 'the thermo output'}; there are "
                          + names)
    return reduce(rows[int(quantity.start * len(rows)):], quantity.take)


def columns(file):
    """Columns by name of a table, with commas or spaces, whose first line names them."""
    if not file.is_file():
        raise LookupError(f"the run wrote no file '{file.name}'")
    lines = file.read_text().lstrip("# ").splitlines()
    rows = list(csv.reader(lines)) if lines and "," in lines[0] else [line.split() for line in lines]
    names = [word.strip() for word in rows[0]] if rows else []
    body = [[thermo.number(word) for word in row] for row in rows[1:] if len(row) == len(names)]
    return dict(zip(names, np.array(body, float).reshape(-1, len(names)).T))


def reduce(rows, take):
    """One number of a column, and the standard error of a mean from that of blocks, None where there is none."""
    if take == "mean":
        whole = len(rows) // BLOCKS * BLOCKS
        blocks = rows[:whole].reshape(BLOCKS, -1).mean(axis=1) if whole else None
        error = None if blocks is None else blocks.std(ddof=1) / BLOCKS**0.5
        return float(rows.mean()), error
    value = {"last": lambda: rows[-1], "first": lambda: rows[0], "change": lambda: rows[-1] - rows[0],
             "max": rows.max, "min": rows.min, "rms": lambda: (rows**2).mean() ** 0.5}[take]()
    return float(value), None
