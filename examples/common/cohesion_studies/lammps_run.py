# SPDX-License-Identifier: BSD-3-Clause
"""The package's LAMMPS: where a build folder has it, a run of a script by itself, and what its log says."""

import json
import os
import re
import subprocess

import numpy as np

from cohesion_studies import package_tree, thermo
from cohesion_studies.build_summary import missing
from cohesion_studies.job_pool import Job, dies_with_us
from cohesion_studies.mpi_start import short_start

MARK = "settings.json"  # in the folder of a run that was started here: it may be made anew


class NotBuilt(RuntimeError):
    """The build folder has no LAMMPS with the package."""


def launcher(build):
    """Program and plugin of the build folder; raises NotBuilt when it has not been built."""
    build = package_tree.tree(build)
    files = "lammps/stock/lmp-cohesion", "lammps/stock/cohesionplugin.so"
    for file in files:
        reason = missing(build, file, "LAMMPS package", "stock LAMMPS")
        if reason:
            raise NotBuilt(reason)
    return tuple(build / file for file in files)


class ScriptRun(Job):
    """A run of `script` with the program and plugin `engine`, of launcher(); what they print is the file `log` in
    `folder`. Words of Job besides. To be defined by a kind of run: variables(), figures(), share()."""

    def __init__(self, folder, script, engine, settings, **words):
        super().__init__(folder, settings, **words)
        self.script, self.engine = script, engine

    def variables(self):
        """Those of the script, without the plugin."""
        raise NotImplementedError

    def start(self):
        self.folder.mkdir(parents=True, exist_ok=True)
        (self.folder / MARK).write_text(json.dumps(self.settings))
        program, plugin = self.engine
        command = [program, "-in", self.script, "-log", "none", "-var", "plugin", plugin]
        for name, value in self.variables().items():
            command += ["-var", name, value]
        with open(self.folder / "log", "w") as log:
            return subprocess.Popen(dies_with_us(command), cwd=self.folder, stdout=log, stderr=log,
                                    stdin=subprocess.DEVNULL, env={**short_start(), **os.environ, "OMP_NUM_THREADS": "1"})

    def log(self):
        return (self.folder / "log").read_text()

    def last_row(self, columns):
        """Numbers of the last row of the thermo output so far, which has so many columns; None before the first."""
        rows = [words for words in map(str.split, self.log().splitlines()[-4:])
                if len(words) == columns and words[0].isdigit()]
        return [thermo.number(word) for word in rows[-1]] if rows else None

    def tail(self):
        return "\n".join(self.log().splitlines()[-15:])


def tables(log):
    """Thermo output of each `run`, in order: dict of column name to numbers."""
    return [dict(zip(names, np.array(lines, float).reshape(-1, len(names)).T)) for names, lines in thermo.runs(log)]


def loop_seconds(log):
    """Processor seconds that all loops of the log took, None when it has none. [s]"""
    loops = re.findall(r"^Loop time of (\S+)", log, re.M)
    shares = re.findall(r"^(\S+)% CPU use", log, re.M)
    if not loops or len(shares) != len(loops):
        return None
    return sum(float(loop) * float(share) / 100 for loop, share in zip(loops, shares))
