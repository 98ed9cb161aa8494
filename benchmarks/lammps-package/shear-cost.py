#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A sheared run with fix deform/shear against the same with the engine's own fix deform.

  shear-cost.py LMP_WITH_PLUGIN_COMMAND PLUGIN [--side N] [--steps N] [--turns N] [--skin S] [--csv FILE]
  shear-cost.py LIGGGHTS_COHESION [--side N] [--steps N] [--turns N] [--skin S]

4 N^3 spheres (32,000) at solid fraction 0.55, in contact with friction. First both start from the
same lattice: the largest difference of positions and velocities after 600 steps, to show that they are
the same motion. fix deform gets a tilt that is a step ahead, for the box that it shows the particles
is that of the step before. Then both take turns from the same state in developed flow: nanoseconds per
particle and step, lists made, and the ratio of the times of each turn. Times are those the processor
spent in a run less those of one of no steps, on one rank. `rebuild engine` is fix deform/shear with the engine's
own rule for new lists. LIGGGHTS' own fix deform runs in liggghts-cohesion, which mends the engine's tilted boxes;
in the stock program it loses spheres.
"""
import math
import re
import resource
import statistics

import numpy

from cohesion_tests import csv_table, lammps as engine, measuring_program

ENGINE = "deform 1 xy erate 2.0 remap v"
OURS = "deform/shear rate 2.0 profile no"
RUNS = (("fix deform", ENGINE), ("deform/shear", OURS),
        ("rebuild engine", OURS + " rebuild engine"))


def write_lattice(engine, folder, side, height):
    """data.spheres, for LIGGGHTS, which has no random velocities of its own: fcc, in the flow."""
    random = numpy.random.default_rng(4711)
    cells = numpy.array(numpy.meshgrid(*3 * [range(side)])).reshape(3, -1).T
    base = numpy.array([[0, 0, 0], [0.5, 0.5, 0], [0.5, 0, 0.5], [0, 0.5, 0.5]])
    x = (cells[:, None, :] + base).reshape(-1, 3) * height / side
    v = random.normal(0, math.sqrt(2.0 / (math.pi / 6)), x.shape)
    v[:, 0] += 2.0 * (x[:, 1] - height / 2)
    engine.write_spheres(folder, [{"type": 1, "diameter": 1.0, "density": 1.0, "x": a, "v": b} for a, b in zip(x, v)],
                         3 * [(0.0, height)], 1, tilt=(0.0, 0.0, 0.0))


def enter(file, spheres, skin, lists, ratio):
    """Into sheared_spheres.csv."""
    case = f"{csv_table.grouped(spheres)} spheres, solid fraction 0.55, friction"
    for name, count, time in (("LAMMPS' fix deform", lists[0], 1), ("fix deform/shear", lists[1], f"{ratio:.2f}")):
        csv_table.enter_quantities(file, "LAMMPS", f"neighbour lists, {case}", {name: count})
        csv_table.enter_quantities(file, "LAMMPS", f"time, skin {skin:g}", {name: time})


def main():
    words = measuring_program.words(__doc__, ("--side", {"type": int, "default": 20}),
                                    ("--steps", {"type": int, "default": 600}),
                                    ("--turns", {"type": int, "default": 5}),
                                    ("--skin", {"type": float, "default": 0.1}), csv_table.OPTION, liggghts=True)
    if words.csv and not words.plugin:
        raise SystemExit("--csv: of LAMMPS")

    height = words.side * (4 / 1.0504226)**(1 / 3)
    with engine.temporary_folder() as folder:
        write_lattice(engine, folder, words.side, height)

        def run(shear, start, steps, **options):
            """Seconds of the processor, and lists made."""
            options = {"ahead": 0, "keep": "none", "dump": "no", **options}
            before = resource.getrusage(resource.RUSAGE_CHILDREN)
            output = engine.run("in.shear_cost", folder, load="yes", side=words.side, start=start,
                                steps=steps, shear=shear, skin=words.skin, **options)
            after = resource.getrusage(resource.RUSAGE_CHILDREN)
            return (after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime,
                    int(re.search(r"Neighbor list builds = (\d+)", output)[1]))

        def timed(shear):
            seconds, lists = run(shear, "developed", words.steps)
            seconds -= run(shear, "developed", 0)[0]
            return 1e9 * seconds / words.steps / (4 * words.side**3), lists

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
            if name == "deform/shear":
                csv_table.enter_quantities(words.csv, "LAMMPS", "positions after 600 steps before the first flip",
                                           {"fix deform/shear": f"within {numpy.abs(away).max():.0e} diameters"})

        run(OURS, "lattice", 5000, keep="developed")
        print(f"\n{4 * words.side**3} spheres, {words.steps} steps, skin {words.skin}; ns per particle "
              "and step (lists made)")
        print("".join(f"{name:>24s}" for name, _ in RUNS) + "   ratios")
        ratios = []
        for turn in range(words.turns):
            order = range(len(RUNS)) if turn % 2 == 0 else reversed(range(len(RUNS)))
            times = {k: timed(RUNS[k][1]) for k in order}
            ratios.append(times[1][0] / times[0][0])
            print("".join(f"{times[k][0]:18.1f} ({times[k][1]:3d})" for k in range(len(RUNS))) +
                  f"   {ratios[-1]:.3f}", flush=True)
        median = statistics.median(ratios)
        print(f"deform/shear over fix deform: median {median:.3f}, from {min(ratios):.3f} to {max(ratios):.3f}")
        enter(words.csv, 4 * words.side**3, words.skin, [times[k][1] for k in (0, 1)], median)


if __name__ == "__main__":
    main()
