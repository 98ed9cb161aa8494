#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Error of the energy balance of gases with Hertz, DMT and JKR contacts in LIGGGHTS.

  liggghts-energy-tally.py LIGGGHTS_COHESION [--side N] [--collisions N] [--scheme exact|sampled]
      [--law hertz|dmt|jkr] [--elastic] [--fraction N] [--csv FILE]

As lammps-package/energy-tally.py, with entry 10 at the end of the run.
"""
import argparse
import os

from cohesion_tests import csv_table
from cohesion_tests.lammps_scenes.cohesive_gas import collision_rate, contact_time
from cohesion_tests.launcher import given_program
from cohesion_tests.liggghts_scenes.elastic_gas import tallied_gas
from cohesion_tests.progress import Progress
from cohesion_tests.theory import hertzian_laws


def main():
    words = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    words.add_argument("launcher", type=given_program)
    words.add_argument("--side", type=int, default=8, metavar="N", help="spheres per edge of the box")
    words.add_argument("--collisions", type=float, default=20.0, help="per particle")
    words.add_argument("--scheme", choices=("exact", "sampled"), default="exact")
    words.add_argument("--law", choices=hertzian_laws.LAWS[1:], default="hertz")
    words.add_argument("--elastic", action="store_true", help="only restitution 1 without friction")
    words.add_argument("--fraction", type=float, help="only this solid fraction")
    words.add_argument(csv_table.OPTION[0], **csv_table.OPTION[1])
    words = words.parse_args()
    csv_table.require_published(words, scheme="exact", side=10)
    os.environ["COHESION_LAUNCHER"] = words.launcher
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
                cells.append(f"{cell(division, rows, lost) if rows else 'unstable':>10s}")
                csv_table.enter(words.csv, csv_table.energy("LIGGGHTS", words.law, (fraction, constant, speed),
                                                            (restitution, friction), division, words.collisions),
                                value=cells[-1].strip(" *") if rows else "stops")
                progress.add(division * duration)
            print(f"\r{fraction:8g}{constant:10g}{restitution:13g}{friction:10g}" + "".join(cells) + f"{lost:10.3f}",
                  flush=True)


def cell(division, rows, lost):
    return hertzian_laws.error_cell(division, rows[-1][11] / rows[0][2], lost)


if __name__ == "__main__":
    main()
