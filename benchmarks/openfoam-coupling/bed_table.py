#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Results of examples/fluidised-bed as rows of docs/verification/fluidised_bed.csv, of the study of kernels as rows of
void_fraction.csv.

    bed_table.py FOLDER --csv FILE

FOLDER: of study.py, which has summary.csv and the name of its table, steps, sensitivity or kernels; or of run.py, which has
result.txt, with `liggghts` in its name for that engine."""
import argparse
import re
from pathlib import Path

from cohesion_studies.study_table import with_deviation
from cohesion_tests import csv_table
from cohesion_tests.csv_table import enter_quantities

VELOCITIES = {"U_mf_df": ("U_mf,df", ".3f"), "U_mf_th": ("U_mf,th", ".3f"), "U_mf_in": ("U_mf,in", ".3f"),
              "overshoot": ("overshoot", ".3f"), "processor_seconds": ("processor seconds", ".0f")}
#: Of a study: the table, its figures with their names and digits, and the cases by the names of the study's rows.
STUDIES = {
    "steps": ("step and scheme", {**VELOCITIES, "void_fraction": ("void fraction at rest", ".3f")}, {
        "exact-6": "exact, t_c/6.2", "exact-8": "exact, t_c/8.2", "sampled-4": "sampled, t_c/4.1",
        "sampled-8": "sampled, t_c/8.2"}),
    "sensitivity": ("sensitivity", VELOCITIES, {
        "base": "none: 27 x 30 cells", "K-200": "spring, a quarter", "K-3200": "spring, four times",
        "e-0.80": "restitution 0.80", "e-0.99": "restitution 0.99", "dt-half": "particle step, half",
        "dt-double": "particle step, double: t_c/4.1", "gas-half": "gas step, half", "gas-double": "gas step, double",
        "cells-13": "13 x 15 cells", "cells-19": "19 x 21 cells", "cells-33": "33 x 37 cells",
        "cells-41": "41 x 45 cells"}),
    "kernels": ("fluidised bed", {"U_mf_df": ("U_mf [m/s]", ".3f")}, {
        "centre": "particleCentre", "overlap": "sphereOverlap",
        "overlap-2d": "sphereOverlap, smoothed over two diameters"})}
#: Of the lines of result.txt, by their beginnings.
LINES = {"U_mf,df": "U_mf,df, falling branch [m/s]", "U_mf,th": "U_mf,th, rising branch [m/s]",
         "U_mf,in": "U_mf,in, pressure maximum [m/s]", "overshoot": "overshoot of the pressure drop",
         "pressure drop": "pressure drop over weight, fluidised", "same with": "the same, plate and walls added",
         "void fraction": "void fraction of the bed at rest", "Ergun": "Ergun's U_mf for it [m/s]"}


def of_study(folder, file):
    table, figures, cases = STUDIES[folder.name]
    for row in csv_table.rows(folder / "summary.csv"):
        if row["name"] in cases:
            enter_quantities(file, table, cases[row["name"]], {
                name: with_deviation(float(row[figure]), float(row[f"{figure}_sd"]), digits)
                for figure, (name, digits) in figures.items()})


def of_run(folder, file):
    engine = "LIGGGHTS" if "liggghts" in folder.name else "LAMMPS"
    head, *lines = (folder / "result.txt").read_text().splitlines()
    columns = [slice(found.start(), found.start() + 20) for found in re.finditer(r"\S+", head)][:2]
    for line in lines:
        name = next((name for start, name in LINES.items() if line.startswith(start)), None)
        for kind, column in zip(("no cohesion", "Hamaker"), columns) if name else ():
            enter_quantities(file, "engines", f"{engine}, {kind}", {name: line[column].split("  ")[0].strip()})


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path)
    csv_table.add_to(parser)
    words = parser.parse_args()
    (of_study if words.folder.name in STUDIES else of_run)(words.folder, words.csv)


if __name__ == "__main__":
    main()
