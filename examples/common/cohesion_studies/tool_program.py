# SPDX-License-Identifier: BSD-3-Clause
"""A program of tools/ in a build folder."""

import subprocess

from cohesion_studies import package_tree
from cohesion_studies.build_summary import missing


class ToolError(RuntimeError):
    """The program is missing or refused."""


class ToolProgram:
    """`name`: of the program; what it refuses is raised as `Error`."""

    name = ""
    Error = ToolError

    def __init__(self, build):
        build = package_tree.tree(build)
        self.file = build / "tools" / self.name
        reason = missing(build, f"tools/{self.name}", "tools")
        if reason:
            raise self.Error(reason)

    def call(self, *words):
        """Its standard output. Raises Error."""
        done = subprocess.run([str(word) for word in (self.file, *words)], capture_output=True, text=True)
        if done.returncode != 0:
            raise self.Error(done.stderr.strip())
        return done.stdout
