#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Sheared discs over 1e7 steps and a strain of 200 box lengths: is anything lost, does anything drift?

  shear-long.py LMP_WITH_PLUGIN_COMMAND PLUGIN [--steps N] [--strain G] [--side N] [--mpiexec COMMAND]

N^2 hard discs with a square well (fix deform/shear, pair_style hard/squarewell) run on one rank, on two,
and from the restart file of the middle on two ranks and on one. Printed for each run: seconds of LAMMPS'
loop, discs lost, the largest net momentum seen, by how many standard errors the mean velocity of the
layer that is worst is off the straight line, and a sum over all events of the second half (which,
when, who): it must be the same for all. Ends with code 1 when something is not as it must be.
Two ranks exchange news in every step: they need two cores that nobody else uses.
"""
import os
import sys

import numpy

from cohesion_tests import lammps as engine, measuring_program
from cohesion_tests.lammps_scenes import long_shear
from cohesion_tests.progress import Progress

SAMPLES = 200


def main():
    words = measuring_program.words(
        __doc__, ("--steps", {"type": int, "default": 10000000, "help": "a multiple of 4000"}),
        ("--strain", {"type": float, "default": 200.0}), ("--side", {"type": int, "default": 8}),
        ("--mpiexec", {"default": "mpiexec --oversubscribe -np"}))
    if words.steps < 4000 or words.steps % 4000:
        sys.exit(f"--steps {words.steps}: a multiple of 4000, 4000 or more")
    os.environ["COHESION_MPIEXEC"] = words.mpiexec

    progress = Progress(3 * words.steps)
    with engine.temporary_folder() as folder:
        done = long_shear.all_runs(folder, words.side, words.steps, words.strain, SAMPLES,
                                   progress.add)
    print(f"\n{words.side**2} discs, {words.steps} steps, strain {words.strain:g}", file=sys.stderr)
    return 0 if report(done, words.side, words.strain) else 1


def report(done, side, strain):
    print(f"{'':20s}{'seconds':>9s}{'lost':>6s}{'momentum':>12s}{'may be':>10s}{'profile':>9s}"
          f"{'events':>9s}  sum of events   ends")
    good = True
    for run in done:
        lost = side**2 - run.table["Atoms"].min()
        momentum = max(abs(run.table[f"c_sums[{k}]"]).max() for k in (1, 2))
        room = long_shear.momentum_room(2 * run.count, side**2)
        crooked, _ = long_shear.crooked(run.profile, long_shear.length(side))
        same = numpy.array_equal(run.end, done[0].end) and run.events == done[0].events
        strained = abs(run.table["f_shear"][-1] / strain - 1) < 1e-14
        good = good and lost == 0 and momentum < room and crooked < 5 and same and strained
        print(f"{run.name:20s}{run.seconds:9.1f}{lost:6.0f}{momentum:12.1e}{room:10.1e}{crooked:9.1f}"
              f"{run.count:9d}  {run.events}    {'the same' if same else 'DIFFERENT'}", flush=True)
    return good


if __name__ == "__main__":
    sys.exit(main())
