# SPDX-License-Identifier: BSD-3-Clause
"""Starts a program of the examples.

    cohesion-studies                             lists the examples and their programs
    cohesion-studies EXAMPLE [PROGRAM] [WORDS]   starts one, `run` unless another is named

Results go to the current folder, unless --out names another."""

import os
import re
import sys

from cohesion_studies.package_tree import EXAMPLES


def programs(scene):
    """Names of the programs of an example."""
    return sorted(file.stem for file in scene.glob("*.py") if re.search("^if __name__", file.read_text(), re.M))


def scenes():
    """Programs by example."""
    found = {folder.name: programs(folder) for folder in sorted(EXAMPLES.iterdir()) if (folder / "README.md").exists()}
    return {name: names for name, names in found.items() if names}


def listed():
    width = max(map(len, scenes()))
    return "\n".join(f"    {name:{width}}  {', '.join(names)}" for name, names in scenes().items())


def chosen(words):
    """Example, program and the words for it; ends with a text when there is none such."""
    known = scenes()
    name, rest = words[0], words[1:]
    if name not in known:
        sys.exit(f"cohesion-studies: no example '{name}'; there are\n{listed()}")
    if rest and rest[0] in known[name]:
        return name, rest[0], rest[1:]
    if "run" not in known[name]:
        sys.exit(f"cohesion-studies: example '{name}' has no program 'run'; it has {', '.join(known[name])}, and a "
                 f"table for `cohesion-studies fluidised-bed study {name}/TABLE.csv`")
    return name, "run", rest


def main():
    words = sys.argv[1:]
    if not words or words[0] in ("-h", "--help"):
        print(f"{__doc__}\n\n{listed()}\n\nin {EXAMPLES}")
        return
    name, program, rest = chosen(words)
    command = [sys.executable, str(EXAMPLES / name / f"{program}.py"), *rest]
    os.execve(sys.executable, command, {**os.environ, "PYTHONDONTWRITEBYTECODE": "1"})
