#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Hamaker constants with the escape velocities of square wells, of the bed's spheres: docs/verification/law_mapping.csv.

    law_mapping.py BUILD [--csv FILE]

By cohesion-mapping: speed and constant with scheme exact; with scheme sampled, at the step of the thesis and at t_c/4, the
mean and the range of the largest speeds at which pairs stick, over the exact escape velocity."""
import argparse

from cohesion_studies.mapping_program import MappingProgram
from cohesion_tests import csv_table
from cohesion_tests.theory.pair_motion import CONTACT_TIME, DAMPING

PAIR = ("--radius", 5e-4, 5e-4, "--density", 2650, "--stiffness", 800, "--damping", DAMPING, "--cutoff", 4e-10, 1e-7)
DEPTHS = ("1e-11", "5e-11", "1e-10")
MIDDLE = 1  # of DEPTHS, that of the bed
THESIS_STEP = 2.25e-5  # [s]
STEPS = {"2.25e-5 s, t_c/4.1": THESIS_STEP, "t_c/4": CONTACT_TIME / 4}
SAMPLED = "program and 6000 x 6000 encounters, over v_esc"


def spread(row, law, exact):
    """Mean, least and largest speed of a law over the exact escape velocity."""
    return [row[f"{law}_{name}"] / exact for name in ("mean", "slowest_parted", "fastest_stuck")]


def sampled(program, exact, step):
    """{law: spread() of each of DEPTHS}."""
    wells = program.table("to-hamaker", DEPTHS, *PAIR, "--well-scheme", "sampled", "--step", step)
    constants = [repr(row["hamaker_constant"]) for row in exact]
    hamaker = program.table("to-well", constants, *PAIR, "--hamaker-scheme", "sampled", "--step", step)
    return {law: [spread(row, law.split()[-1].lower(), one["hamaker_mean"]) for row, one in zip(rows, exact)]
            for law, rows in (("well", wells), ("Hamaker", hamaker))}


def rows(program):
    """Table, case and {quantity: text}."""
    exact = program.table("to-hamaker", DEPTHS, *PAIR)
    for depth, row in zip(DEPTHS, exact):
        yield "exact", f"D [J] {depth}", {"v_esc [m/s]": csv_table.power(row["hamaker_mean"], 3),
                                          "A [J]": csv_table.power(row["hamaker_constant"], 3)}
    cases = {"well": "square well, D = 1e-11 to 1e-10 J", "Hamaker": "Hamaker, A of the table"}
    for name, step in STEPS.items():
        for law, found in sampled(program, exact, step).items():
            mean, low, high = found[MIDDLE]
            yield SAMPLED, f"{name}, {law}", {"mean": f"{mean:.4f}", "range": f"{low:.3f} to {high:.3f}"}
            if step == THESIS_STEP:
                means, lows, highs = zip(*found)
                yield "step of the thesis", cases[law], {
                    "mean over v_esc": f"{sum(means) / len(means):.3f}",
                    "range over v_esc": f"{min(lows):.2f} to {max(highs):.2f}"}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", help="build folder of the package")
    csv_table.add_to(parser)
    words = parser.parse_args()
    for table, case, values in rows(MappingProgram(words.build)):
        print(f"{table}, {case}: " + "; ".join(f"{name} {value}" for name, value in values.items()))
        csv_table.enter_quantities(words.csv, table, case, values)


if __name__ == "__main__":
    main()
