#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What compute gran/energy does not account for in gases with damping and friction in LIGGGHTS, scheme exact.

  liggghts-energy-tally.py LIGGGHTS_COHESION [--side N] [--collisions N] [--scheme exact|sampled]
      [--law linear|hertz|dmt|jkr] [--elastic] [--fraction N] [--csv FILE]

N^3 spheres (512), 20 collisions per particle (Enskog's rate): entry 10 at the end, over the kinetic energy of the
start, against the step. `unstable`: the engine stops with the largest stable step. With --law as energy-tally.py, at the
end.
"""
import argparse
import os

from cohesion_tests import csv_table
from cohesion_tests.lammps_scenes.cohesive_gas import collision_rate, contact_time
from cohesion_tests.launcher import given_program
from cohesion_tests.liggghts_scenes.elastic_gas import tallied_gas
from cohesion_tests.progress import Progress
from cohesion_tests.theory import hertzian_laws

DIVISIONS = (5, 10, 20)
GASES = ((0.1, 0.0, 0.1), (0.5, 0.0, 0.1), (0.1, 2e-18, 0.02), (0.5, 2e-18, 0.02))  # fraction, A [J], speed [m/s]
CONTACTS = ((1.0, 0.0), (0.9, 0.0), (0.5, 0.0), (1.0, 0.3), (0.9, 0.3), (0.5, 0.3))  # restitution, friction


def main():
    words = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    words.add_argument("launcher", type=given_program)
    words.add_argument("--side", type=int, default=8, metavar="N", help="spheres per edge of the box")
    words.add_argument("--collisions", type=float, default=20.0, help="per particle")
    words.add_argument("--scheme", choices=("exact", "sampled"), default="exact")
    words.add_argument("--law", choices=hertzian_laws.LAWS, default="linear")
    words.add_argument("--elastic", action="store_true", help="only restitution 1 without friction")
    words.add_argument("--fraction", type=float, help="only this solid fraction")
    words.add_argument(csv_table.OPTION[0], **csv_table.OPTION[1])
    words = words.parse_args()
    if words.csv and words.scheme != "exact":
        raise SystemExit("--csv: of scheme exact")
    os.environ["COHESION_LAUNCHER"] = words.launcher
    if words.law == "linear":
        return measure(words, CONTACTS, GASES, DIVISIONS)
    contacts = ((1.0, 0.0),) if words.elastic else hertzian_laws.CONTACTS
    return measure(words, contacts, hertzian_laws.gases(words.law, words.fraction), hertzian_laws.DIVISIONS)


def measure(words, contacts, gases, divisions):
    durations = [words.collisions / collision_rate(fraction, speed) for fraction, _, speed in gases]
    progress = Progress(len(contacts) * sum(divisions) * sum(durations))
    print("fraction     A [J]  restitution  friction" + "".join(f"{f't_c/{n}':>10s}" for n in divisions) + "      lost")
    for (fraction, constant, speed), duration in zip(gases, durations):
        for restitution, friction in contacts:
            cells, lost = [], 0.0
            for division in divisions:
                rows = tallied_gas(words.side, fraction, constant, speed, restitution, friction,
                                   dt=contact_time(words.law, speed) / division, duration=duration, scheme=words.scheme,
                                   law=words.law)
                lost = (rows[0][1] - rows[-1][1]) / rows[0][2] if rows else lost
                cells.append(f"{cell(words.law, division, rows, lost) if rows else 'unstable':>10s}")
                csv_table.enter(words.csv, csv_table.energy("LIGGGHTS", words.law, (fraction, constant, speed),
                                                            (restitution, friction), division, words.collisions),
                                value=cells[-1].strip(" *") if rows else "stops")
                progress.add(division * duration)
            print(f"\r{fraction:8g}{constant:10g}{restitution:13g}{friction:10g}" + "".join(cells) + f"{lost:10.3f}",
                  flush=True)


def cell(law, division, rows, lost):
    error = rows[-1][11] / rows[0][2]
    return f"{error:.1e}" if law == "linear" else hertzian_laws.error_cell(division, error, lost)


if __name__ == "__main__":
    main()
