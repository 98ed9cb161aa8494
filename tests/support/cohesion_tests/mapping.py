# SPDX-License-Identifier: BSD-3-Clause
"""Runs cohesion-mapping (named by the environment, COHESION_MAPPING) and reads what it prints."""
import csv
import os
import subprocess

PROGRAM = os.environ["COHESION_MAPPING"]


def call(*words):
    """Exit code, standard output and error."""
    done = subprocess.run([PROGRAM, *map(str, words)], capture_output=True, text=True)
    return done.returncode, done.stdout, done.stderr


def text(*words):
    code, output, error = call(*words)
    if code != 0:
        raise RuntimeError(f"cohesion-mapping ended with code {code}: {error}")
    return output


def table(*words):
    """Rows of numbers by the names of the columns."""
    return [{name: float(value) for name, value in row.items()}
            for row in csv.DictReader(text(*words, "--csv").splitlines())]


def script_lines(*words):
    """Lines for a LAMMPS script: for each row that of the Hamaker law and of the well, as dicts of
    the words after their first (pair_style, pair_coeff, fix)."""
    found = []
    for block in text(*words).split("\n\n")[2:]:
        lines = [line.split(None, 1) for line in block.splitlines()]
        found.append([line[1] for line in lines])
    return found
