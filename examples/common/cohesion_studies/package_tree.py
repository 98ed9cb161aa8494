# SPDX-License-Identifier: BSD-3-Clause
"""Where the programs of the package are: a build folder, or an installation, whose programs lie in a folder of the
same shape. And where the examples are, of which this is the part common to all."""

from pathlib import Path

EXAMPLES = Path(__file__).resolve().parents[2]  # in the repository and installed
POINTER = "tree"  # of an installation, beside the examples: names the folder of programs, relative to its own
SUMMARY = "summary.txt"  # in a build folder and in that of an installation's programs


def programs_beside(share):
    """Of an installation with data in the folder `share`; None when that is none."""
    pointer = share / POINTER
    return (share / pointer.read_text().strip()).resolve() if pointer.is_file() else None


def tree(folder):
    """The folder of programs: `folder` itself, unless it is the prefix of an installation."""
    folder = Path(folder).resolve()
    if (folder / SUMMARY).is_file():
        return folder
    return programs_beside(folder / "share/cohesion") or folder


def own_tree():
    """That of the installation or repository which this file belongs to."""
    return programs_beside(EXAMPLES.parent) or EXAMPLES.parent / "build"


def results(build, name):
    """Folder for the results `name`: in the build folder; with an installation, which stays as it is, in the current
    one."""
    return (build if (build / "CMakeCache.txt").is_file() else Path.cwd()) / name


def example(file):
    """`file` as it is given, or, where there is none, that of the examples."""
    file = Path(file)
    return EXAMPLES / file if not file.exists() and (EXAMPLES / file).exists() else file
