#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Error of the energy balance of gases with Hertz, DMT and JKR contacts; gas-energies.py has linear springs.

  energy-tally.py LMP_WITH_PLUGIN_COMMAND PLUGIN [--law hertz|dmt|jkr] [--side N] [--collisions N] [--elastic]
                  [--csv FILE]

512 spheres at solid fractions of 0.1 and 0.5 have 20 collisions each (Enskog's rate). The error is the largest value of
entry 10 of compute gran/energy, over the dissipated energy, and of gases that dissipate none over the kinetic energy at
the start. `unstable`: the engine stops with the largest stable step. The last column is the dissipated energy over the
kinetic energy at the start; a star marks an error above the expected one. Laws and expected errors:
theory/hertzian_laws.py. --elastic: only restitution 1 without friction.
"""
from cohesion_tests import csv_table, lammps as engine, measuring_program
from cohesion_tests.lammps_scenes import cohesive_gas as gas
from cohesion_tests.progress import Progress
from cohesion_tests.theory import hertzian_laws


def measure(words, contacts, gases, divisions):
    durations = [words.collisions / gas.collision_rate(fraction, speed) for fraction, _, speed in gases]
    progress = Progress(len(contacts) * sum(divisions) * sum(durations))
    head = "fraction     A [J]  restitution  friction"
    print(head + "".join(f"{f't_c/{n}':>10s}" for n in divisions) + "      lost")
    for (fraction, constant, speed), duration in zip(gases, durations):
        with engine.temporary_folder() as folder:
            gas.write(folder, words.side, fraction, speed, seed=4711)
            for restitution, friction in contacts:
                cells, lost = [], 0.0
                for division in divisions:
                    progress.add(division * duration)
                    row = csv_table.energy("LAMMPS", words.law, (fraction, constant, speed), (restitution, friction),
                                           division, words.collisions)
                    try:
                        table, _ = gas.follow(folder, division, duration, A=constant, e=restitution, mu=friction,
                                              skin=4e-4 if division < 4 else 2e-4, law=words.law,
                                              time=gas.contact_time(words.law, speed))
                    except RuntimeError as error:
                        if "unstable, so that they gain energy" not in str(error):
                            raise
                        cells.append(f"{'unstable':>10s}")
                        csv_table.enter(words.csv, row, value="stops")
                        continue
                    lost = (table[0, 1] - table[-1, 1]) / table[0, 3]
                    error = abs(table[:, 2]).max() / table[0, 3]
                    cells.append(f"{hertzian_laws.error_cell(division, error, lost):>10s}")
                    csv_table.enter(words.csv, row, value=cells[-1].strip(" *"))
                print(f"\r{fraction:8g}{constant:10g}{restitution:13g}{friction:10g}" + "".join(cells) + f"{lost:10.3f}",
                      flush=True)


def main():
    words = measuring_program.words(
        __doc__, ("--law", {"choices": hertzian_laws.LAWS[1:], "default": "hertz"}),
        ("--side", {"type": int, "default": 8, "metavar": "N", "help": "spheres per edge of the box"}),
        ("--collisions", {"type": float, "default": 20.0, "help": "per particle"}),
        ("--elastic", {"action": "store_true", "help": "only restitution 1 without friction"}),
        ("--fraction", {"type": float, "help": "only this solid fraction"}), csv_table.OPTION)
    csv_table.require_published(words, side=10)
    contacts = ((1.0, 0.0),) if words.elastic else hertzian_laws.CONTACTS
    gases = hertzian_laws.gases(words.law, words.fraction)
    return measure(words, contacts, gases, hertzian_laws.DIVISIONS)


if __name__ == "__main__":
    main()
