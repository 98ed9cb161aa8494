# SPDX-License-Identifier: BSD-3-Clause
"""A program of tools/, named by a variable of the environment, and what it prints with --csv."""
import csv
import os
import subprocess


class CsvProgram:
    def __init__(self, variable):
        self.file = os.environ[variable]

    def call(self, *words):
        """Exit code, standard output and error."""
        done = subprocess.run([self.file, *map(str, words)], capture_output=True, text=True)
        return done.returncode, done.stdout, done.stderr

    def values(self, *words):
        """Numbers by name."""
        code, output, error = self.call(*words, "--csv")
        if code != 0:
            raise RuntimeError(f"{self.file} ended with code {code}: {error}")
        return {row["name"]: float(row["value"]) for row in csv.DictReader(output.splitlines())}
