# SPDX-License-Identifier: BSD-3-Clause
"""What a case of cohesiveBedFoam says of itself, as numbers: entries of its dictionaries, variables of its particles'
script. What stands there as a macro or a formula is not read."""

import re
from pathlib import Path

COUPLING = "constant/couplingProperties"
NUMBER = r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?"


def numbers(text):
    """{name: value} of the entries in a dictionary's text, those of dictionaries inside it too."""
    return {name: float(value) for name, value in re.findall(rf"^\s*(\w+)\s+({NUMBER})\s*;", text, re.M)}


def entries(file):
    """numbers() of a dictionary."""
    return numbers(Path(file).read_text())


def gravity(case):
    """Of constant/g, which is against y [m/s2]."""
    text = (Path(case) / "constant/g").read_text()
    return -float(re.search(rf"^value\s+\(\s*{NUMBER}\s+({NUMBER})\s+{NUMBER}\s*\)\s*;", text, re.M)[1])


def engine_block(case):
    """Text of the dictionary of the particle engine that the case names."""
    text = (Path(case) / COUPLING).read_text()
    engine = re.search(r"^demEngine\s+(\w+)\s*;", text, re.M)[1]
    return re.search(rf"^{engine}Coeffs\s*\{{(.*?)^\}}", text, re.M | re.S)[1]


def script_numbers(file):
    """{name: value} of the variables that a particles' script begins with or calculates with."""
    text = Path(file).read_text()
    found = re.findall(rf"^variable\s+(\w+)\s+(?:index|equal)\s+({NUMBER})(?:\s|$)", text, re.M)
    return {name: float(value) for name, value in found}


def particle_variables(case):
    """{name: value} of the variables of the particles' script that the case runs: those that the case sets, and those of
    the script itself."""
    block = engine_block(case)
    script = re.search(r'^\s*script\s+"?([^";]+)"?\s*;', block, re.M)[1]
    script = Path(case) / re.sub(r"\$\{?FOAM_CASE\}?", ".", script)
    return {**script_numbers(script), **numbers(block)}
