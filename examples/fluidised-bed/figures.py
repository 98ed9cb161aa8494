# SPDX-License-Identifier: BSD-3-Clause
"""Prints what is read of one finished case of the fluidised bed, what of it is one number.

    figures.py CASE"""

from math import nan

from cohesion_studies import program
from cohesion_studies.bed.figures import evaluate, single
from cohesion_studies.case_entries import EntryError
from cohesion_studies.study_table import aligned, with_deviation


def main():
    case, = program.words(__doc__, 1)
    print(aligned([(name, with_deviation(value, nan, ".6g")) for name, value in single(evaluate(case)).items()]))


if __name__ == "__main__":
    program.run(main, OSError, EntryError)
