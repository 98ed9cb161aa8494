# SPDX-License-Identifier: BSD-3-Clause
"""cohesion-powder, the program of the package that makes a run of a powder's data (docs/tools/cohesion-powder.md)."""

import csv
import subprocess

from cohesion_studies import package_tree
from cohesion_studies.build_summary import missing


class PowderError(RuntimeError):
    """cohesion-powder is missing or refused."""


class PowderProgram:
    """cohesion-powder of a build folder. Options: {word: value, or a list of values}."""

    def __init__(self, build):
        build = package_tree.tree(build)
        self.file = build / "tools/cohesion-powder"
        reason = missing(build, "tools/cohesion-powder", "tools")
        if reason:
            raise PowderError(reason)

    def values(self, options):
        """Its numbers by name, in SI units. Raises PowderError."""
        done = self._call(options, "--csv")
        return {row["name"]: float(row["value"]) for row in csv.DictReader(done.stdout.splitlines())}

    def write(self, folder, options):
        """A case into the new folder. Raises PowderError."""
        self._call(options, "--write", folder)

    def _call(self, options, *more):
        command = [self.file]
        for word, value in options.items():
            command += [word, *(value if isinstance(value, (list, tuple)) else [value])]
        done = subprocess.run([str(word) for word in (*command, *more)], capture_output=True, text=True)
        if done.returncode != 0:
            raise PowderError(done.stderr.strip())
        return done
