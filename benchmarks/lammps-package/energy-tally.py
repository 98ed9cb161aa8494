#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What the energy tally of pair_style gran/hamaker misses in a dense gas with damping and friction.

  energy-tally.py LMP_WITH_PLUGIN_COMMAND PLUGIN

512 spheres, solid fraction 0.5, 20 collisions per particle (Enskog's rate): residual of compute
gran/energy at the end, over the kinetic energy of the start, against the step.
"""
from cohesion_tests import lammps as engine, measuring_program
from cohesion_tests.lammps_scenes import cohesive_gas as gas
from cohesion_tests.progress import Progress

DIVISIONS = (5, 10, 20, 40)
GASES = ((0.0, 0.1), (2e-18, 0.02))             # A [J], speed of each component [m/s]
CONTACTS = ((0.9, 0.0), (0.5, 0.0), (1.0, 0.3), (0.9, 0.3))  # restitution, friction


def main():
    measuring_program.words(__doc__)

    durations = [20 / gas.collision_rate(0.5, speed) for _, speed in GASES]
    progress = Progress(len(CONTACTS) * sum(DIVISIONS) * sum(durations))
    print("    A [J]  restitution  friction" + "".join(f"{f't_c/{n}':>10s}" for n in DIVISIONS))
    for (constant, speed), duration in zip(GASES, durations):
        with engine.temporary_folder() as folder:
            gas.write(folder, 8, 0.5, speed, seed=4711)
            for restitution, friction in CONTACTS:
                cells = []
                for division in DIVISIONS:
                    table, _ = gas.follow(folder, division, duration, A=constant, e=restitution,
                                          mu=friction, skin=4e-4 if division < 4 else 2e-4)
                    cells.append(f"{table[-1, 2] / table[0, 3]:10.1e}")
                    progress.add(division * duration)
                print(f"\r{constant:9g}{restitution:13g}{friction:10g}" + "".join(cells), flush=True)


if __name__ == "__main__":
    main()
