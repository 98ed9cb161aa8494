#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Time of a granular run with the plugin loaded and not used, over its time without.

  unused-plugin-ratio.py LMP LMP_WITH_PLUGIN_COMMAND PLUGIN [--pairs N] [--side N] [--steps N]

Runs take turns, and each turn gives one ratio; printed are all of them and their median, so that a
machine that gets slower on the way does not decide. The time is that of LAMMPS' own loop.
"""
import argparse
import os
import statistics

from cohesion_tests import lammps as engine
from cohesion_tests.launcher import given_program
from cohesion_tests.thermo import loop_seconds


def main():
    words = argparse.ArgumentParser(description=__doc__,
                                    formatter_class=argparse.RawDescriptionHelpFormatter)
    words.add_argument("lmp", type=given_program)
    words.add_argument("with_command", type=given_program)
    words.add_argument("plugin", type=given_program)
    words.add_argument("--pairs", type=int, default=15)
    words.add_argument("--side", type=int, default=20, help="spheres per edge")
    words.add_argument("--steps", type=int, default=4000)
    words = words.parse_args()
    os.environ.update(COHESION_LMP=words.with_command, COHESION_PLUGIN=words.plugin,
                      OMP_NUM_THREADS="1")

    def seconds(lmp, load):
        with engine.temporary_folder() as folder:
            output = engine.run("in.granular", folder, lmp=lmp, load=load, side=words.side,
                                steps=words.steps)
        return loop_seconds(output, 0)

    ratios = []
    print(f"{words.side**3} spheres, {words.steps} steps\n without [s]  with [s]  ratio")
    for turn in range(words.pairs):
        first = (words.lmp, "no"), (words.with_command, "yes")
        times = {load: seconds(lmp, load) for lmp, load in (first if turn % 2 == 0 else first[::-1])}
        ratios.append(times["yes"] / times["no"])
        print(f"{times['no']:12.3f} {times['yes']:9.3f} {ratios[-1]:6.3f}", flush=True)
    print(f"median {statistics.median(ratios):.3f}, from {min(ratios):.3f} to {max(ratios):.3f}")


if __name__ == "__main__":
    main()
