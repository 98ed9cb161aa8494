# SPDX-License-Identifier: BSD-3-Clause
"""Runs LIGGGHTS on the input scripts of this folder and reads what it dumps.

The programs come from the environment: COHESION_LAUNCHER, COHESION_PRELOAD, COHESION_STOCK and, for
tests on several ranks, COHESION_MPIEXEC.
"""

import os
import pathlib
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
sys.path.append(str(HERE.parent / "lammps-package"))

from short_start import HERE_ONLY, short_start  # noqa: E402

EPSILON = 2.0**-52


def program(name):
    return os.environ["COHESION_" + name]


def environment_of(ranks):
    return {**os.environ, **(HERE_ONLY if ranks else short_start())}


class Run:
    """One run in a folder of its own: returncode, printed text, and the text of the files left."""

    def __init__(self, script, how="launcher", ranks=0, inputs=None, **variables):
        """inputs: further files, name and text, that the script reads."""
        text = script if "\n" in script else (HERE / script).read_text()
        command = [program("LAUNCHER" if how == "launcher" else "STOCK"), "-in", "in.script"]
        for name, value in variables.items():
            command += ["-var", name, repr(float(value)) if isinstance(value, float) else str(value)]
        environment = environment_of(ranks)
        preload = "LD_PRELOAD=" + program("PRELOAD") if how == "preload" else None
        if ranks:
            given = ["-x", preload] if preload else []
            command = [program("MPIEXEC"), "--oversubscribe", "-n", str(ranks)] + given + command
        elif preload:
            command = ["env", preload] + command
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            for file, content in {"in.script": text, **(inputs or {})}.items():
                (folder / file).write_text(content)
            # One error in five the engine ends with bytes from memory that it has freed.
            done = subprocess.run(command, cwd=folder, env=environment, timeout=500, text=True,
                                  errors="replace", stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
            self.files = {file.name: file.read_text(errors="replace")
                          for file in folder.iterdir() if file.is_file()}
        self.returncode, self.printed = done.returncode, done.stdout

    def frames(self, dump):
        """One dict {id: list of the numbers after it} per dumped step."""
        if self.returncode:
            raise AssertionError("LIGGGHTS failed:\n" + self.printed)
        found = []
        for frame in self.files[dump].split("ITEM: TIMESTEP")[1:]:
            rows = frame.split("ITEM: ATOMS")[1].strip().split("\n")[1:]
            numbers = ([float(word) for word in row.split()] for row in rows)
            found.append({int(row[0]): row[1:] for row in numbers})
        return found


def assert_refused(case, run, *messages, begun=False):
    """Ended with an error, before the first step unless it has `begun`, and said all of `messages`."""
    case.assertNotEqual(run.returncode, 0, "accepted:\n" + run.printed[-2000:])
    if not begun:
        case.assertNotIn("Loop time", run.printed)
    for message in messages:
        case.assertIn(message, run.printed)


def script_without(name, word):
    """The script without the line that holds `word`; fails when there is none."""
    lines = (HERE / name).read_text().split("\n")
    kept = [line for line in lines if word not in line]
    assert len(kept) == len(lines) - 1, f"{word} is not in one line of {name}"
    return "\n".join(kept)
