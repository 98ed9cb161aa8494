# SPDX-License-Identifier: BSD-3-Clause
"""The package's LAMMPS: where a build folder has it, and what its log says."""

import re
from pathlib import Path

import numpy as np


class NotBuilt(RuntimeError):
    """The build folder has no LAMMPS with the package."""


def launcher(build):
    """Program and plugin of the build folder; raises NotBuilt when it has not been built."""
    folder = Path(build).resolve() / "lammps/stock"
    program, plugin = folder / "lmp-cohesion", folder / "cohesionplugin.so"
    if not program.is_file() or not plugin.is_file():
        raise NotBuilt(f"'{program}' does not exist: build the package first (scripts/setup does)")
    return program, plugin


def tables(log):
    """Thermo output of each `run`, in order: dict of column name to numbers; warnings in between are
    skipped."""
    found, names, rows = [], None, []
    for line in log.splitlines():
        words = line.split()
        if words[:1] == ["Step"]:
            names, rows = words, []
        elif line.startswith("Loop time") and names:
            found.append(dict(zip(names, np.array(rows, float).reshape(-1, len(names)).T)))
            names = None
        elif names and len(words) == len(names) and words[0].isdigit():
            rows.append([number(word) for word in words])
    return found


def number(word):
    try:
        return float(word)
    except ValueError:
        return float("nan")


def loop_seconds(log):
    """Processor seconds that all loops of the log took, None when it has none. [s]"""
    loops = re.findall(r"^Loop time of (\S+)", log, re.M)
    shares = re.findall(r"^(\S+)% CPU use", log, re.M)
    if not loops or len(shares) != len(loops):
        return None
    return sum(float(loop) * float(share) / 100 for loop, share in zip(loops, shares))
