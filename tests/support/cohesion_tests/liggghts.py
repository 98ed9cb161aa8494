# SPDX-License-Identifier: BSD-3-Clause
"""Runs LIGGGHTS on the scripts of liggghts_scenes and reads what it dumps.

The programs come from the environment: COHESION_LAUNCHER, COHESION_PRELOAD, COHESION_STOCK and, for
tests on several ranks, COHESION_MPIEXEC.
"""

import os
import tempfile
from pathlib import Path

from cohesion_tests import dumps, launcher, refusals

SCENES = Path(__file__).resolve().parent / "liggghts_scenes"
EPSILON = 2.0**-52


def program(name):
    return os.environ["COHESION_" + name]


def as_lammps():
    """Environment in which lammps.py runs LIGGGHTS, on the scripts of liggghts_scenes."""
    return {"COHESION_LMP": program("LAUNCHER"), "COHESION_SCRIPTS": str(SCENES),
            "COHESION_MPIEXEC": " ".join(mpiexec())}


def mpiexec(*words):
    """Words that start ranks, whose number follows; `words`: more of them."""
    return [program("MPIEXEC"), "--oversubscribe", *words, "-n"]


class Run:
    """One run in a folder of its own: code, output, and the text of the files left."""

    def __init__(self, script, how="launcher", ranks=0, inputs=None, **variables):
        """`script`: name of one of the scenes, or text; `how`: by our launcher, preloaded or stock; `ranks`: under
        mpiexec, 0 without it; `inputs`: further files, name and text, that the script reads."""
        text = script if "\n" in script else (SCENES / script).read_text()
        preload = "LD_PRELOAD=" + program("PRELOAD") if how == "preload" else None
        words = launcher.command(program("LAUNCHER" if how == "launcher" else "STOCK"), "in.script", ranks,
                                 mpiexec(*(["-x", preload] if preload else [])) if ranks else (), variables)
        if preload and not ranks:
            words = ["env", preload, *words]
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            for file, content in {"in.script": text, **(inputs or {})}.items():
                (folder / file).write_text(content)
            ended = launcher.run(words, folder, ranks)
            self.files = {file.name: file.read_text(errors="replace")
                          for file in folder.iterdir() if file.is_file()}
        self.code, self.output = ended.code, ended.output

    def frames(self, dump):
        """One dict {id: list of the numbers after it} per dumped step."""
        if self.code:
            raise AssertionError("LIGGGHTS failed:\n" + self.output)
        return [snapshot.by_number() for snapshot in dumps.parse(self.files[dump])]


def assert_refused(test, run, *parts, begun=False):
    """As refusals.assert_refused(), of a Run."""
    refusals.assert_refused(test, run.code, run.output, *parts, begun=begun)


def script_without(name, word):
    """The script without the line that holds `word`; fails when there is none."""
    lines = (SCENES / name).read_text().split("\n")
    kept = [line for line in lines if word not in line]
    assert len(kept) == len(lines) - 1, f"{word} is not in one line of {name}"
    return "\n".join(kept)
