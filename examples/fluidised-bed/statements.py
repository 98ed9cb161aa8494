# SPDX-License-Identifier: BSD-3-Clause
"""Statements of M. Weber's thesis on cohesive beds (chapters 6 to 8), compared with the beds of a study, as a table.

    statements.py [--levels SUMMARY.csv] [--mechanisms SUMMARY.csv]

SUMMARY.csv: written by study.py for cohesion-levels.csv and mechanisms.csv."""

import argparse
from pathlib import Path

from cohesion_studies import program
from cohesion_studies.bed.statements import of_levels, of_mechanisms, table
from cohesion_studies.bed.verdict import Study


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--levels", type=Path, metavar="SUMMARY.csv", help="of cohesion-levels.csv")
    parser.add_argument("--mechanisms", type=Path, metavar="SUMMARY.csv", help="of mechanisms.csv")
    args = parser.parse_args()
    if not (args.levels or args.mechanisms):
        parser.error("give --levels, --mechanisms, or both")
    for file, statements in ((args.levels, of_levels), (args.mechanisms, of_mechanisms)):
        if file:
            study = Study(file)
            print(table(statements(study), study) + "\n")


if __name__ == "__main__":
    program.run(main, OSError)
