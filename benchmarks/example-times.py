#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Processor time of the commands of the examples.

  example-times.py BUILD CSV [COMMAND ...]

Runs each COMMAND, such as shear/run.py, one after another (all of them by default), in an empty folder and on all cores.
Writes a row for each to CSV, which keeps the rows of other commands; scripts/page-tables puts them on
examples/README.md. Unlike elapsed time, processor time hardly depends on what else the machine does.
"""
import argparse
import os
import resource
import subprocess
import sys
import tempfile
from pathlib import Path

from printed_table import read_csv, write_csv

EXAMPLES = Path(__file__).resolve().parents[1] / "examples"
#: Commands that the README of an example lists beside its run.py.
OTHERS = ["array-drag/beside_openfoam.py", "discrete-bubbles/sizes.py", "geldart-a-two-fluid/grains.py",
          "shear/run.py --thesis"]


def commands():
    return sorted([f"{file.parent.name}/run.py" for file in EXAMPLES.glob("*/run.py")] + OTHERS)


def processor_seconds():
    """Of all processes that this one has waited for, and of theirs."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def row(build, command):
    program, *options = command.split()
    with tempfile.TemporaryDirectory(prefix="cohesion-") as folder:
        before = processor_seconds()
        subprocess.run([sys.executable, EXAMPLES / program, *options, "--build", build, "--out", Path(folder) / "out"],
                       check=True)
        seconds = processor_seconds() - before
    return {"command": command, "processor [s]": round(seconds), "cores": len(os.sched_getaffinity(0))}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=Path)
    parser.add_argument("csv", type=Path)
    parser.add_argument("commands", nargs="*", metavar="COMMAND", help=", ".join(commands()))
    words = parser.parse_args()
    for unknown in set(words.commands) - set(commands()):
        parser.error(f"{unknown}: no command of an example")
    for command in words.commands or commands():
        rows = {old["command"]: old for old in read_csv(words.csv)} if words.csv.exists() else {}
        rows[command] = row(words.build.resolve(), command)
        write_csv(words.csv, [rows[key] for key in sorted(rows)])


if __name__ == "__main__":
    main()
