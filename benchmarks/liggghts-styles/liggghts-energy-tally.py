#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What compute gran/energy does not account for in gases with damping and friction in LIGGGHTS, scheme exact.

  liggghts-energy-tally.py LIGGGHTS_COHESION [--side N] [--collisions N] [--scheme exact|sampled]

N^3 spheres (512), 20 collisions per particle (Enskog's rate): entry 10 at the end, over the kinetic energy of the
start, against the step. `unstable`: the engine stops with the largest stable step.
"""
import argparse
import os

from cohesion_tests.lammps_scenes.cohesive_gas import collision_rate
from cohesion_tests.launcher import given_program
from cohesion_tests.liggghts_scenes.elastic_gas import CONTACT_TIME, tallied_gas
from cohesion_tests.progress import Progress

DIVISIONS = (5, 10, 20)
GASES = ((0.1, 0.0, 0.1), (0.5, 0.0, 0.1), (0.1, 2e-18, 0.02), (0.5, 2e-18, 0.02))  # fraction, A [J], speed [m/s]
CONTACTS = ((1.0, 0.0), (0.9, 0.0), (0.5, 0.0), (1.0, 0.3), (0.9, 0.3), (0.5, 0.3))  # restitution, friction


def main():
    words = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    words.add_argument("launcher", type=given_program)
    words.add_argument("--side", type=int, default=8, metavar="N", help="spheres per edge of the box")
    words.add_argument("--collisions", type=float, default=20.0, help="per particle")
    words.add_argument("--scheme", choices=("exact", "sampled"), default="exact")
    words = words.parse_args()
    os.environ["COHESION_LAUNCHER"] = words.launcher
    durations = [words.collisions / collision_rate(fraction, speed) for fraction, _, speed in GASES]
    progress = Progress(len(CONTACTS) * sum(DIVISIONS) * sum(durations))
    print("fraction     A [J]  restitution  friction" + "".join(f"{f't_c/{n}':>10s}" for n in DIVISIONS))
    for (fraction, constant, speed), duration in zip(GASES, durations):
        for restitution, friction in CONTACTS:
            cells = []
            for division in DIVISIONS:
                rows = tallied_gas(words.side, fraction, constant, speed, restitution, friction,
                                   dt=CONTACT_TIME / division, duration=duration, scheme=words.scheme)
                cells.append(f"{rows[-1][11] / rows[0][2]:10.1e}" if rows else f"{'unstable':>10s}")
                progress.add(division * duration)
            print(f"\r{fraction:8g}{constant:10g}{restitution:13g}{friction:10g}" + "".join(cells), flush=True)


if __name__ == "__main__":
    main()
