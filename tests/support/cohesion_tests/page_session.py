# SPDX-License-Identifier: BSD-3-Clause
"""A page as a session: a block whose first line is a comment with the name of a file is that file, and the lines of the
shell run in order, in one folder. Rules: docs/contributing.md, Code blocks of pages."""
import os
import re
import subprocess
import sys

from cohesion_tests import SOURCE
from cohesion_tests.page_blocks import blocks, kind_of, shell_lines
from cohesion_tests.page_scripts import programs

NAME = re.compile(r"(?://|#) ([\w./-]*[\w-])\n")
#: Lines that prepare the shell of the reader; the test has a build and its environment.
PREPARATION = re.compile(r"scripts/setup|source \S*environment\.sh")


class Session:
    """page: relative to the repository."""

    def __init__(self, page, section=None):
        text = (SOURCE / page).read_text()
        self.page = page
        self.pictures = re.findall(r"!\[[^\]]*\]\(([^)]+)\)", text)
        self.blocks = [(block, kind_of(block, programs())) for block in blocks(page, text)
                       if section in (None, block.section)]

    def files(self):
        """Text of each file by its name."""
        named = [(NAME.match(block.text), block.text) for block, _ in self.blocks]
        return {name[1]: text for name, text in named if name}

    def write(self, folder):
        for name, text in self.files().items():
            (folder / name).parent.mkdir(parents=True, exist_ok=True)
            (folder / name).write_text(text)

    def commands(self):
        lines = [line for block, kind in self.blocks if kind == "shell" for line in shell_lines(block.text)]
        return [line for line in lines if not PREPARATION.fullmatch(line)]

    def printed(self):
        """Lines of output that the page shows, without the widths of blanks."""
        return [" ".join(line.split()) for block, kind in self.blocks if kind == "printed"
                for line in block.text.splitlines() if line.strip()]

    def run(self, folder, environment):
        """Writes the files into an empty folder and runs the commands with this Python; gives exit code and output."""
        self.write(folder)
        python = folder.parent / f"python-of-{folder.name}"
        python.mkdir(exist_ok=True)
        (python / "python3").unlink(missing_ok=True)
        (python / "python3").symlink_to(sys.executable)
        path = os.pathsep.join([str(python), environment["PATH"]])
        done = subprocess.run(["bash", "-e"], input="\n".join(self.commands()), cwd=folder, text=True,
                              env={**environment, "PATH": path}, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        return done.returncode, done.stdout
