#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A sheared run with fix deform/shear against the same with the engine's own fix deform.

  shear-cost.py LMP_WITH_PLUGIN_COMMAND PLUGIN [--side N] [--steps N] [--turns N] [--skin S]

4 N^3 spheres (32,000) at solid fraction 0.55, in contact with friction. First both start from the
same lattice: the largest difference of positions and velocities after 600 steps, to show that they are
the same motion. fix deform gets a tilt that is a step ahead, for the box that it shows the particles
is that of the step before. Then both take turns from the same state in developed flow: nanoseconds per
particle and step, lists made, and the ratio of the times of each turn. Times are those the processor
spent in LAMMPS' loop, on one rank. `rebuild engine` is fix deform/shear with the engine's own rule for
new lists.
"""
import re
import statistics

import numpy

import measuring_program

ENGINE = "deform 1 xy erate 2.0 remap v"
OURS = "deform/shear rate 2.0 profile no"
RUNS = (("fix deform", ENGINE), ("deform/shear", OURS),
        ("rebuild engine", OURS + " rebuild engine"))


def main():
    words = measuring_program.words(__doc__, ("--side", {"type": int, "default": 20}),
                                    ("--steps", {"type": int, "default": 600}),
                                    ("--turns", {"type": int, "default": 5}),
                                    ("--skin", {"type": float, "default": 0.1}))
    import lammps_engine as engine

    height = words.side * (4 / 1.0504226)**(1 / 3)
    with engine.temporary_folder() as folder:
        def run(shear, start, steps, **options):
            options = {"ahead": 0, "keep": "none", "dump": "no", **options}
            output = engine.run("in.shear_cost", folder, load="yes", side=words.side, start=start,
                                steps=steps, shear=shear, skin=words.skin, **options)
            seconds = (float(re.search(r"Loop time of (\S+)", output)[1]) *
                       float(re.search(r"(\S+)% CPU use", output)[1]) / 100)
            return (1e9 * seconds / steps / (4 * words.side**3),
                    int(re.search(r"Neighbor list builds = (\d+)", output)[1]))

        ends = []
        for name, shear in RUNS:
            ahead = 2.0 * 1e-4 * height if shear == ENGINE else 0
            run(shear, "lattice", 600, ahead=ahead, dump="yes")
            ends.append(engine.dump(folder, "end.txt"))
        length = height
        for (name, _), end in zip(RUNS[1:], ends[1:]):
            away = end[:, 1:4] - ends[0][:, 1:4]
            count = numpy.rint(away[:, 1] / height)
            tilt = 2.0 * 600 * 1e-4 * height
            away -= count[:, None] * numpy.array([tilt, height, 0.0])
            away -= length * numpy.rint(away / length)
            faster = end[:, 7:10] - ends[0][:, 7:10]
            faster[:, 0] -= count * 2.0 * height
            print(f"{name}: after 600 steps from the lattice positions differ from those of fix deform "
                  f"by {numpy.abs(away).max():.1e}, velocities by {numpy.abs(faster).max():.1e}",
                  flush=True)

        run(OURS, "lattice", 5000, keep="developed")
        print(f"\n{4 * words.side**3} spheres, {words.steps} steps, skin {words.skin}; ns per particle "
              "and step (lists made)")
        print("".join(f"{name:>24s}" for name, _ in RUNS) + "   ratios")
        ratios = []
        for turn in range(words.turns):
            order = range(len(RUNS)) if turn % 2 == 0 else reversed(range(len(RUNS)))
            times = {k: run(RUNS[k][1], "developed", words.steps) for k in order}
            ratios.append(times[1][0] / times[0][0])
            print("".join(f"{times[k][0]:18.1f} ({times[k][1]:3d})" for k in range(len(RUNS))) +
                  f"   {ratios[-1]:.3f}", flush=True)
        print(f"deform/shear over fix deform: median {statistics.median(ratios):.3f}, from "
              f"{min(ratios):.3f} to {max(ratios):.3f}")


if __name__ == "__main__":
    main()
