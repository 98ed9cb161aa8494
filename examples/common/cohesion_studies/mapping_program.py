# SPDX-License-Identifier: BSD-3-Clause
"""cohesion-mapping, the program of the package that knows escape velocities (docs/tools/cohesion-mapping.md)."""

import csv
import subprocess

from cohesion_studies import package_tree
from cohesion_studies.build_summary import missing


class MappingError(RuntimeError):
    """cohesion-mapping is missing or refused."""


class MappingProgram:
    """cohesion-mapping of a build folder."""

    def __init__(self, build):
        build = package_tree.tree(build)
        self.file = build / "tools/cohesion-mapping"
        reason = missing(build, "tools/cohesion-mapping", "tools")
        if reason:
            raise MappingError(reason)

    def table(self, way, values, *pair):
        """Rows (dict of numbers by column) for Hamaker constants (way to-well) or depths (to-hamaker); `pair`:
        what its command line says of particles, contact and schemes. Raises MappingError."""
        command = [self.file, way, *pair, "--csv", "--hamaker" if way == "to-well" else "--depth", *values]
        done = subprocess.run([str(word) for word in command], capture_output=True, text=True)
        if done.returncode != 0:
            raise MappingError(done.stderr.strip())
        return [{name: float(x) for name, x in row.items()}
                for row in csv.DictReader(done.stdout.splitlines())]
