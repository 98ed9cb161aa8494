# SPDX-License-Identifier: BSD-3-Clause
"""Runs cohesion-powder (named by the environment, COHESION_POWDER) and reads what it prints."""
import csv
import os
import subprocess

PROGRAM = os.environ["COHESION_POWDER"]


def call(*words):
    """Exit code, standard output and error."""
    done = subprocess.run([PROGRAM, *map(str, words)], capture_output=True, text=True)
    return done.returncode, done.stdout, done.stderr


def values(*words):
    """Numbers by name."""
    code, output, error = call(*words, "--csv")
    if code != 0:
        raise RuntimeError(f"cohesion-powder ended with code {code}: {error}")
    return {row["name"]: float(row["value"]) for row in csv.DictReader(output.splitlines())}
