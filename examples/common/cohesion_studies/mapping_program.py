# SPDX-License-Identifier: BSD-3-Clause
"""cohesion-mapping, the program of the package that knows escape velocities (docs/tools/cohesion-mapping.md)."""

import csv

from cohesion_studies.tool_program import ToolError, ToolProgram


class MappingError(ToolError):
    """cohesion-mapping is missing or refused."""


class MappingProgram(ToolProgram):
    """cohesion-mapping of a build folder."""

    name = "cohesion-mapping"
    Error = MappingError

    def table(self, way, values, *pair):
        """Rows (dict of numbers by column) for Hamaker constants (way to-well) or depths (to-hamaker); `pair`:
        what its command line says of particles, contact and schemes. Raises MappingError."""
        output = self.call(way, *pair, "--csv", "--hamaker" if way == "to-well" else "--depth", *values)
        return [{name: float(x) for name, x in row.items()} for row in csv.DictReader(output.splitlines())]
