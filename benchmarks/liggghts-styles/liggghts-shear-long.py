#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Sheared spheres in LIGGGHTS over 1e7 steps and a strain of 200 box lengths: is anything lost, does anything drift?

  liggghts-shear-long.py LIGGGHTS_COHESION [--steps N] [--strain G] [--side N] [--mpiexec COMMAND]

N^3 soft spheres with a dashpot (fix deform/shear, pair_style gran) run on one rank, on two, and from the restart file
of the middle on two ranks and on one. Printed for each run: seconds of LIGGGHTS' loop, spheres lost, the largest net
momentum seen and what rounding may leave, by how many standard errors the mean velocity of the layer that is worst is
off the straight line, granular temperature and shear stress (kinetic, contact) with their standard errors, and how far
they are from those of the first run in standard errors of the difference. Ends with code 1 when something is not as it
must be. Two ranks wait for each other in every step: they need two cores that nobody else uses.
"""
import os
import sys

from cohesion_tests import lammps as engine, measuring_program
from cohesion_tests.liggghts_scenes import long_spheres
from cohesion_tests.progress import Progress

SAMPLES = 200


def main():
    words = measuring_program.words(
        __doc__, ("--steps", {"type": int, "default": 10000000, "help": "4000 to 20000 by 4000, or by 20000"}),
        ("--strain", {"type": float, "default": 200.0}), ("--side", {"type": int, "default": 4}),
        ("--mpiexec", {"default": "mpiexec --oversubscribe -np"}), liggghts=True)
    if words.plugin:
        sys.exit("this program takes liggghts-cohesion alone; ../lammps-package/shear-long.py takes LAMMPS")
    # A sample is a multiple of ten steps, and of its hundredth rounded up (in.shear_long).
    if words.steps < 4000 or words.steps % (4000 if words.steps <= 20000 else 20000):
        sys.exit(f"--steps {words.steps}: 4000, 8000, 12000, 16000 or a multiple of 20000")
    os.environ["COHESION_MPIEXEC"] = words.mpiexec

    progress = Progress(3 * words.steps)
    with engine.temporary_folder() as folder:
        done = long_spheres.all_runs(folder, words.side, words.steps, words.strain, SAMPLES, progress.add)
    print(f"\n{words.side**3} spheres, {words.steps} steps, strain {words.strain:g}", file=sys.stderr)
    return 0 if report(done, words) else 1


def report(done, words):
    room = long_spheres.momentum_room(words.steps, words.strain, words.side)
    print(f"{'':20s}{'seconds':>9s}{'lost':>6s}{'momentum':>10s}{'may be':>9s}{'profile':>9s}  "
          + "".join(f"{column:20s}" for column in long_spheres.COLUMNS) + "apart")
    results = [long_spheres.Result(one, words.side, words.strain) for one in done]
    good = True
    for one in results:
        lost, apart = words.side**3 - one.atoms, long_spheres.apart(one, results[0])
        good = (good and lost == 0 and one.momentum < room and one.crooked < 5 and apart < 5
                and abs(one.strain / words.strain - 1) < 1e-14)
        means = "".join(f"{f'{mean:.4f} +- {error:.4f}':20s}" for mean, error in zip(one.means, one.errors))
        print(f"{one.name:20s}{one.seconds:9.1f}{lost:6.0f}{one.momentum:10.1e}{room:9.1e}{one.crooked:9.1f}  "
              f"{means}{apart:.1f}", flush=True)
    return good


if __name__ == "__main__":
    sys.exit(main())
