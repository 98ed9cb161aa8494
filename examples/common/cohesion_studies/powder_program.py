# SPDX-License-Identifier: BSD-3-Clause
"""cohesion-powder, the program of the package that makes a run of a powder's data (docs/tools/cohesion-powder.md)."""

import csv

from cohesion_studies.tool_program import ToolError, ToolProgram


class PowderError(ToolError):
    """cohesion-powder is missing or refused."""


class PowderProgram(ToolProgram):
    """cohesion-powder of a build folder. Options: {word: value, or a list of values}."""

    name = "cohesion-powder"
    Error = PowderError

    def values(self, options):
        """Its numbers by name, in SI units. Raises PowderError."""
        output = self.call(*words(options), "--csv")
        return {row["name"]: float(row["value"]) for row in csv.DictReader(output.splitlines())}

    def write(self, folder, options):
        """A case into the new folder. Raises PowderError."""
        self.call(*words(options), "--write", folder)


def words(options):
    """Of the command line."""
    for word, value in options.items():
        yield word
        yield from value if isinstance(value, (list, tuple)) else [value]
