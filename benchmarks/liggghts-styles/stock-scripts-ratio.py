#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Scripts of others, unchanged, under the launcher and preloaded, against the stock program: whether
they print the same numbers, and what they cost.

  stock-scripts-ratio.py STOCK LAUNCHER PRELOAD SCRIPT... [--pairs N] [--limit SECONDS]

A SCRIPT runs in a copy of its folder. Runs take turns, and each turn gives one ratio of times, those of the
engine's own loops by the clock and, which a busy machine changes less, processor time of the whole process;
printed are the medians with the quarter and three quarter points. A script that the stock program itself does not run
within the limit is named and left out.
"""
import argparse
import pathlib
import re
import resource
import shutil
import subprocess
import tempfile

from cohesion_studies import thermo
from cohesion_tests import launcher
from cohesion_tests.spread import spread


class Run:
    def __init__(self, script, program, preload, limit):
        script = pathlib.Path(script)
        command = launcher.command(program, script.name)
        if preload:
            command = ["env", "LD_PRELOAD=" + preload] + command
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name) / "case"
            shutil.copytree(script.parent, folder)
            (folder / "post").mkdir(exist_ok=True)  # where the engine's examples write
            before = resource.getrusage(resource.RUSAGE_CHILDREN)
            try:
                ended = launcher.run(command, folder, timeout=limit)
            except subprocess.TimeoutExpired:
                self.failed = f"longer than {limit:g} s"
                return
            self.failed = None if ended.code == 0 else ended.output.strip().split("\n")[-1]
            loops = re.findall(r"Loop time of (\S+)", ended.output)
            self.seconds = sum(map(float, loops))
            if not loops and not self.failed:
                self.failed = "runs nothing"
            after = resource.getrusage(resource.RUSAGE_CHILDREN)
            self.processor = (after.ru_utime - before.ru_utime) + (after.ru_stime - before.ru_stime)
            self.numbers = without_times(ended.output)


def without_times(output):
    """The thermo output without columns of time."""
    rows = []
    for names, lines in thermo.printed(output):
        kept = [k for k, name in enumerate(names) if name not in ("CPU", "cpu", "T/CPU", "S/CPU")]
        rows += [[words[k] for k in kept] for words in lines]
    return rows


def main():
    words = argparse.ArgumentParser(description=__doc__,
                                    formatter_class=argparse.RawDescriptionHelpFormatter)
    words.add_argument("stock", type=launcher.given_program)
    words.add_argument("launcher", type=launcher.given_program)
    words.add_argument("preload", type=launcher.given_program)
    words.add_argument("scripts", nargs="+")
    words.add_argument("--pairs", type=int, default=5)
    words.add_argument("--limit", type=float, default=300.0)
    words = words.parse_args()
    ways = {"stock": (words.stock, None), "launcher": (words.launcher, None),
            "preload": (words.stock, words.preload)}
    print(f"{'script':40} {'same numbers':>14}  {'time':52}processor time\n{'':40} {'launch preload':>14}  "
          + 2 * f"{'launch':26}{'preload':26}")
    for script in words.scripts:
        name = "/".join(pathlib.Path(script).parts[-2:])
        turns, failed = [], None
        for turn in range(words.pairs):
            order = list(ways) if turn % 2 == 0 else list(ways)[::-1]
            runs = {way: Run(script, *ways[way], words.limit) for way in order}
            if runs["stock"].failed:
                failed = f"not run by the stock program: {runs['stock'].failed}"
                break
            failed = next((f"{way} fails: {run.failed}" for way, run in runs.items() if run.failed), None)
            if failed:
                break
            turns.append(runs)
        if failed:
            print(f"{name:40} {failed}")
            continue
        same, times, cpu = [], [], []
        for way in ("launcher", "preload"):
            same.append("yes" if all(t[way].numbers == t["stock"].numbers for t in turns) else "NO")
            times.append(spread(t[way].seconds / t["stock"].seconds for t in turns))
            cpu.append(spread(t[way].processor / t["stock"].processor for t in turns))
        print(f"{name:40} {same[0]:>6} {same[1]:>7}  " + "  ".join(f"{s:24}" for s in (*times, *cpu)), flush=True)


if __name__ == "__main__":
    main()
