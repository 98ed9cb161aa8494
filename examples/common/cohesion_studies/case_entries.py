# SPDX-License-Identifier: BSD-3-Clause
"""What a case of cohesiveBedFoam says of itself, as numbers: entries of its dictionaries, variables of its particles'
script. What stands there as a macro or a formula is not read."""

import re
from pathlib import Path

COUPLING = "constant/couplingProperties"
NUMBER = r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?"


class EntryError(LookupError):
    """A file of the case lacks what is read of it."""


class Numbers(dict):
    """{name: value}, of a file."""

    def __init__(self, found, file):
        super().__init__({name: float(value) for name, value in found})
        self.file = file

    def __missing__(self, name):
        raise EntryError(f"{self.file}: no number '{name}'")


def in_text(pattern, file, text, what):
    """The group of the pattern in the text of a file. Raises EntryError, which says `what` is missing."""
    found = re.search(pattern, text, re.M | re.S)
    if not found:
        raise EntryError(f"{file}: no {what}")
    return found[1]


def numbers(text, file):
    """Of the entries in a dictionary's text, those of dictionaries inside it too."""
    return Numbers(re.findall(rf"^\s*(\w+)\s+({NUMBER})\s*;", text, re.M), file)


def entries(file):
    """numbers() of a dictionary, those of the files that it includes before its own."""
    file = Path(file)
    text = file.read_text()
    found = numbers(text, file)
    names = re.findall(r'^#include\s+"(\w[\w.-]*)"', text, re.M)
    included = [entries(file.parent / name) for name in names if (file.parent / name).is_file()]
    return Numbers([pair for part in (*included, found) for pair in part.items()], file)


def gravity(case):
    """Of constant/g, which is against y [m/s2]."""
    file = Path(case) / "constant/g"
    vector = rf"^value\s+\(\s*{NUMBER}\s+({NUMBER})\s+{NUMBER}\s*\)\s*;"
    return -float(in_text(vector, file, file.read_text(), "vector 'value'"))


def engine_block(case):
    """File and text of the dictionary of the particle engine that the case names."""
    file = Path(case) / COUPLING
    text = file.read_text()
    engine = in_text(r"^demEngine\s+(\w+)\s*;", file, text, "entry 'demEngine'")
    return file, in_text(rf"^{engine}Coeffs\s*\{{(.*?)^\}}", file, text, f"dictionary '{engine}Coeffs'")


def particle_step(case):
    """Time step [s] of the particle engine that the case names."""
    file, block = engine_block(case)
    return numbers(block, file)["dt"]


def script_numbers(file):
    """Of the variables of a particles' script."""
    text = Path(file).read_text()
    return Numbers(re.findall(rf"^variable\s+(\w+)\s+(?:index|equal)\s+({NUMBER})(?:\s|$)", text, re.M), file)


def particle_variables(case):
    """Of the variables of the particles' script that the case runs: those of the script itself, and those that the case
    sets."""
    file, block = engine_block(case)
    script = in_text(r'^\s*script\s+"?([^";]+)"?\s*;', file, block, "entry 'script'")
    found = script_numbers(Path(case) / re.sub(r"\$\{?FOAM_CASE\}?", ".", script))
    found.update(numbers(block, file))
    return found
