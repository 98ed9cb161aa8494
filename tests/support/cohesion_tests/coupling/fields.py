# SPDX-License-Identifier: BSD-3-Clause
"""Reads what cohesiveBedFoam has written of a case: fields, particles, tables of function objects."""

import re

import numpy as np


def field(case, time, name):
    """Values of all cells, one after the other."""
    text = (case.folder / time / name).read_text()
    values = re.search(r"internalField\s+nonuniform List<\w+>\s*\d+\s*\((.*?)\)\s*;", text, re.S)
    return np.array(values.group(1).replace("(", " ").replace(")", " ").split(), float)


def numbers(path, columns):
    """Of a list in a file of the cloud, an array with so many columns."""
    found = re.search(r"\n\d+\s*\n?\((.*)\)", path.read_text(), re.S)
    return np.array(re.sub(r"[()]", " ", found[1]).split(), float).reshape(-1, columns)


def particle_velocities(case, time):
    """z components, in the order of the file."""
    path = case.folder / time / "lagrangian/particles/U"
    same = re.search(r"\n(\d+)\{\(\S+ \S+ (\S+)\)\}", path.read_text())
    return np.full(int(same[1]), float(same[2])) if same else numbers(path, 3)[:, 2]


def cells(case, time, name):
    """Values of a field in all cells, of vectors the z component"""
    text = (case.folder / time / name).read_text()
    uniform = re.search(r"internalField\s+uniform (?:\(\S+ \S+ )?([^\s;)]+)", text)
    if uniform:
        return np.array([float(uniform[1])])
    values = field(case, time, name)
    return values.reshape(-1, 3)[:, 2] if "volVectorField" in text else values


def uniform(case, time, name):
    """Mean of a field that is the same in all cells but for rounding."""
    text = (case.folder / time / name).read_text()
    if "internalField   uniform" in text:
        return float(text.split("internalField   uniform ")[1].split(";")[0])
    return field(case, time, name).mean()


def table(case, name, kind, start="0"):
    """Rows of the table that the function object `name` of the type `kind` has written from a start on."""
    return np.loadtxt(case.folder / f"postProcessing/{name}/{start}/{kind}.dat", ndmin=2)
