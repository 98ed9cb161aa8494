#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A pair that sticks, struck by a third sphere: error of the velocities against the step.

  struck-pairs.py LMP_WITH_PLUGIN_COMMAND PLUGIN [--scheme exact|sampled] [--finest N] [--law linear|hertz|dmt|jkr] [--rows]
                  [--csv FILE]
  struck-pairs.py LIGGGHTS_COHESION [--scheme exact|sampled] [--finest N] [--law linear|hertz|dmt|jkr] [--rows]
                  [--csv FILE]

Sampled, and in LIGGGHTS, as in in.head_on: without friction, of which the engines have different laws.

100 triples (triples.py) against t_c/N, 1000 unless said otherwise, after 30 t_c. Printed: how many end
otherwise (which spheres stick), and, of the others, the root mean square of the error of the velocities over the
speed of the third sphere; a star where one is above the number expected of the law. --rows: the third strikes two that
touch head-on, at 50 places in the step and two speeds, with restitution 1 and 0.9; t_c is that at 0.1 m/s.
"""
import numpy

from cohesion_tests import csv_table, lammps as engine, measuring_program
from cohesion_tests.lammps_scenes import triples
from cohesion_tests.theory import hertzian_laws

# Expected of a law and a step: number of other outcomes and root mean square error of triples, of a prototype of one force a
# step for the same triples, with a fifth of room; largest error of rows at 0.03 and 0.1 m/s, of that for a row of four.
TRIPLES = {("hertz", 10): (0, 8.3e-4), ("hertz", 20): (0, 2.9e-4), ("dmt", 10): (0, 0.144), ("dmt", 20): (0, 0.036),
           ("jkr", 10): (0, 0.018), ("jkr", 20): (0, 4.3e-3)}
ROWS = {("hertz", 10): (8.7e-3, 8.7e-3), ("hertz", 20): (2.3e-3, 2.3e-3), ("dmt", 10): (0.1, 2.5e-2),
        ("dmt", 20): (4.1e-2, 6.1e-3), ("jkr", 10): (2.2e-2, 2.2e-2), ("jkr", 20): (4.2e-3, 5.1e-3)}
DIVISIONS = {"exact": (5, 10, 20, 40), "sampled": (4, 10, 20, 50, 200, 1000)}
NAMES = {"hertz": "Hertz", "dmt": "DMT", "jkr": "JKR"}  # in contact_motion.csv


def compare(found, reference, speeds=triples.SPEEDS):
    """Number of other outcomes, and of the others the errors of the velocities over the speed of the third sphere."""
    same = (found[1] == reference[1]).all(axis=0)
    error = numpy.linalg.norm(found[0] - reference[0], axis=2) / speeds[:, None]
    return int((~same).sum()), error[same]


def enter(words, friction, division, number, mean):
    """Into contact_motion.csv. `mean` is None where the run stops."""
    step = f"t_c/{division}"
    if words.law != "linear":
        engines = f"LAMMPS, friction {friction:g}" if friction else "both engines"
        quantity = f"{NAMES[words.law]}, {engines}, other outcomes; root mean square error of the velocities"
        row = {"measurement": "struck pairs of Hertz DMT and JKR", "quantity": quantity, "step": step}
        csv_table.enter(words.csv, row, value="stops" if mean is None else f"{number}; {mean:.2g}")
        return
    name = "sampled" if words.scheme == "sampled" else f"{'LAMMPS' if words.plugin else 'LIGGGHTS'}, exact"
    name += f", friction {friction:g}" if friction else ""
    values = ("stops", "stops") if mean is None else (f"{number}", f"{mean:#.2g}")
    for what, value in zip(("other outcomes of 100", "error of velocities"), values):
        csv_table.enter(words.csv, {"measurement": "struck pairs", "quantity": f"{name}: {what}", "step": step},
                        value=value)


def enter_row(words, restitution, speed, division, worst):
    """The largest error of rows into contact_motion.csv, infinite where outcomes differ."""
    quantity = (f"{NAMES[words.law]}, both engines, restitution {restitution:g}, {speed:g} m/s, "
                "largest error of the velocities")
    csv_table.enter(words.csv, {"measurement": "rows of three", "quantity": quantity, "step": f"t_c/{division}"},
                    value=f"{worst:.1e}" if numpy.isfinite(worst) else "other outcomes")


def measure_triples(folder, words):
    triples.write(folder, words.law)
    for friction in (0.0, 0.3) if words.scheme == "exact" and words.plugin else (0.0,):
        run = lambda division: triples.outcome(folder, division, friction, words.scheme, words.law)
        reference = run(words.finest)
        print(f"friction {friction:g}")
        for division in DIVISIONS[words.scheme]:
            try:
                number, error = compare(run(division), reference)
            except RuntimeError as stopped:
                print(f"  t_c/{division:<4d} stops: {str(stopped).split('ERROR')[-1][:150].splitlines()[0]}")
                enter(words, friction, division, 0, None)
                continue
            mean = numpy.sqrt((error**2).mean())
            most = TRIPLES.get((words.law, division), (100, numpy.inf))
            print(f"  t_c/{division:<4d} other outcome {number:3d}   root mean square {mean:.2g}"
                  f"{' *' if number > most[0] or mean > most[1] else ''}", flush=True)
            enter(words, friction, division, number, mean)


def measure_rows(folder, words):
    speeds = numpy.unique(triples.ROW_SPEEDS)
    for restitution in (1.0, 0.9):
        print(f"restitution {restitution:g}: largest error at {speeds[0]:g}, {speeds[1]:g} m/s")
        for division in DIVISIONS["exact"]:
            triples.write_rows(folder, words.law, division)
            run = lambda n: triples.outcome(folder, n, 0.0, "exact", words.law, restitution, 10)
            number, error = compare(run(division), run(words.finest), triples.ROW_SPEEDS)
            cells, error = "", error.max(axis=1, initial=0)
            for speed, most in zip(speeds, ROWS.get((words.law, division), (numpy.inf, numpy.inf))):
                worst = error[triples.ROW_SPEEDS == speed].max() if number == 0 else numpy.inf
                cells += f"{worst:9.1e}{'*' if worst > most else ' '}"
                enter_row(words, restitution, speed, division, worst)
            print(f"  t_c/{division:<4d} {cells} other outcome {number:3d}", flush=True)


def main():
    words = measuring_program.words(
        __doc__, ("--scheme", {"choices": tuple(DIVISIONS), "default": "exact"}),
        ("--finest", {"type": int, "default": 1000}), ("--law", {"choices": hertzian_laws.LAWS, "default": "linear"}),
        ("--rows", {"action": "store_true", "help": "two that touch are struck head-on"}),
        csv_table.OPTION, liggghts=True)
    if words.csv and words.law != "linear" and not words.plugin:
        raise SystemExit("--csv: rows of Hertz, DMT and JKR are entered from LAMMPS")
    if words.csv and words.rows and words.law == "linear":
        raise SystemExit("--csv: of rows with --law hertz, dmt or jkr")
    with engine.temporary_folder() as folder:
        (measure_rows if words.rows else measure_triples)(folder, words)


if __name__ == "__main__":
    main()
