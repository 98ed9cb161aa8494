#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What a sheared gas and its agglomerates cost: instructions per particle and step, and how many lists of
neighbours are made.

  liggghts-shear-cost.py LAUNCHER [--steps N] [--csv FILE]

240 spheres with friction and Hamaker attraction, solid fraction 0.19, rate 200/s. Each case runs for N and for
5 N steps; the difference of both counts is free of the start. Valgrind counts (--tool=cachegrind), so the
numbers do not depend on what else the machine does; one rank.
"""
import argparse
import pathlib
import re
import tempfile

from cohesion_tests import csv_table, instruction_count, launcher
from cohesion_tests.liggghts_scenes.sheared_scene import LAWS, gas, sheared

CASES = {"rebuild nonaffine": ("yes", ""), "rebuild engine": ("yes rebuild engine", ""),
         "with fix agglomerates 1": ("yes", "fix set all agglomerates 1\n"),
         "with fix agglomerates 10": ("yes", "fix set all agglomerates 10\n")}


def counted(program, steps, profile, extra):
    """Instructions, and the number of lists that were made after the first."""
    text = sheared(gas(), *LAWS["hamaker"], rate=200.0, profile=profile, extra=extra, dt=5e-6, skin=2e-4,
                   every=steps, steps=steps)
    with tempfile.TemporaryDirectory() as folder:
        (pathlib.Path(folder) / "in.script").write_text(text)
        count = instruction_count.of_command(launcher.command(program, "in.script"), folder)
        lists = re.search(r"Neighbor list builds = (\d+)", (pathlib.Path(folder) / "log.liggghts").read_text())
    return count, int(lists[1])


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("launcher", type=launcher.given_program, help="liggghts-cohesion")
    parser.add_argument("--steps", type=int, default=500)
    csv_table.add_to(parser)
    words = parser.parse_args()
    for name, case in CASES.items():
        (short, _), (long, lists) = (counted(words.launcher, n * words.steps, *case) for n in (1, 5))
        count = f"{(long - short) / (4 * words.steps * len(gas())):.0f}"
        print(f"{name}: {count} instructions, {lists} lists in {5 * words.steps} steps", flush=True)
        csv_table.enter_quantities(words.csv, "cost in LIGGGHTS", name, {
            "instructions": count, f"lists in {5 * words.steps} steps": lists})


if __name__ == "__main__":
    main()
