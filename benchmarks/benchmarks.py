#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What each feature costs, and how cost grows, against the stock engines.

  benchmarks.py BUILD NAME [options]            one of the tables below
  benchmarks.py BUILD NAME --help               its options
  benchmarks.py BUILD NAME --small              the same in a minute or two
  benchmarks.py BUILD NAME --table FILE.csv     writes the table; scripts/page-tables puts it on a page
  benchmarks.py BUILD NAME --picture FILE       of dense and growth: a picture of the table

BUILD is a build folder of the package. Prints the load of the machine, and a table as it is measured. Instructions are
counted by valgrind and do not depend on what else the machine does; times do, and are of processors, taken in turns.
"""
import argparse
import importlib
import os
import sys
from pathlib import Path

import picture
from build_folder import Missing, Programs
from printed_table import read, write_csv
from scenes import REBUILD

NAMES = {"features": "feature x cost when off x cost when on, LAMMPS and LIGGGHTS",
         "coupling": "the same of the gas: cohesiveBedFoam",
         "dense": "a step with cohesion of 32,000 spheres, beside the stock engines",
         "growth": "a step of 1000 to 1,000,000 spheres, and memory per sphere",
         "account": "which parts of a step grow, by the engines' own account",
         "traffic": "what a step fetches from beyond caches, and how fast memory is",
         "scaling": "one rank and two: the same scene, and twice the scene",
         "deliverables": "size, and time to load, of what is built"}
PICTURES = ("dense", "growth")  # picture.py draws them


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build")
    commands = parser.add_subparsers(dest="name", required=True)
    for name, what in NAMES.items():
        one = commands.add_parser(name, help=what)
        importlib.import_module(name).add_words(one)
        one.add_argument("--lammps", choices=("stock", "current", "newest"), default="stock")
        one.add_argument("--small", action="store_true")
        one.add_argument("--table", type=Path)
        if name in PICTURES:
            one.add_argument("--picture", type=Path)
    words = parser.parse_args()
    table = importlib.import_module(words.name)
    if words.name in ("dense", "features") and words.steps % REBUILD:
        parser.error(f"--steps {words.steps}: a multiple of {REBUILD}, what is between two lists")
    if words.small:
        table.small(words)
    print(f"load of the machine {os.getloadavg()[0]:.1f} on {len(os.sched_getaffinity(0))} processors")
    lines = []
    try:
        for line in table.rows(Programs(words.build, words.lammps), words):
            lines.append(line)
            print(line, flush=True)
    except Missing as error:
        sys.exit(str(error))
    if words.table:
        write_csv(words.table, read(lines))
    if getattr(words, "picture", None):
        picture.draw(words.name, read(lines), words.picture)


if __name__ == "__main__":
    main()
