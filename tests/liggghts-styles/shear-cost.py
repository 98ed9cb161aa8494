#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What a sheared gas and its agglomerates cost: instructions per particle and step, and how many lists of
neighbours are made.

  shear-cost.py LAUNCHER [--steps N]

240 spheres with friction and Hamaker attraction, solid fraction 0.19, rate 200/s. Each case runs for N and for
5 N steps; the difference of both counts is free of the start. Valgrind counts (--tool=cachegrind), so the
numbers do not depend on what else the machine does; one rank.
"""
import argparse
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

from sheared_scene import LAWS, gas, sheared

CASES = {"rebuild nonaffine": ("yes", ""), "rebuild engine": ("yes rebuild engine", ""),
         "with fix agglomerates 1": ("yes", "fix set all agglomerates 1\n"),
         "with fix agglomerates 10": ("yes", "fix set all agglomerates 10\n")}


def instructions(launcher, steps, profile, extra):
    """Also the number of lists that were made after the first."""
    text = sheared(gas(), *LAWS["hamaker"], rate=200.0, profile=profile, extra=extra, dt=5e-6, skin=2e-4,
                   every=steps, steps=steps)
    with tempfile.TemporaryDirectory() as folder:
        (pathlib.Path(folder) / "in.script").write_text(text)
        done = subprocess.run(["valgrind", "--tool=cachegrind", "--cache-sim=no",
                               "--cachegrind-out-file=/dev/null", launcher, "-in", "in.script"],
                              cwd=folder, text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    if done.returncode:
        sys.exit(done.stdout + done.stderr)
    count = re.search(r"I\s+refs:\s+([\d,]+)", done.stderr)[1].replace(",", "")
    return int(count), int(re.search(r"Neighbor list builds = (\d+)", done.stdout)[1])


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("launcher", help="liggghts-cohesion")
    parser.add_argument("--steps", type=int, default=500)
    words = parser.parse_args()
    if not shutil.which("valgrind"):
        sys.exit("shear-cost.py counts with valgrind, which is not installed")
    for name, case in CASES.items():
        (short, _), (long, lists) = (instructions(words.launcher, n * words.steps, *case) for n in (1, 5))
        print(f"{name}: {(long - short) / (4 * words.steps * len(gas())):.0f} instructions, {lists} lists in "
              f"{5 * words.steps} steps", flush=True)


if __name__ == "__main__":
    main()
