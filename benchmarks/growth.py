# SPDX-License-Identifier: BSD-3-Clause
"""How a step and the memory grow with the number of spheres, beside the stock engines."""
import re
import statistics
import sys
from pathlib import Path

import scenes
from build_folder import whole_numbers
from cohesion_tests.progress import Progress
from scenes import spread, spread_words

# The same stretch for all sizes, as the scene changes while it runs: two contact times, lists made twice.
FIRST, STEPS = 5 * scenes.REBUILD, 2 * scenes.REBUILD
ASKED = 1.3  # of the time of a step of a million over that of ten thousand
SPARE = 6e9  # memory that has to be free for the largest runs [byte]; one takes a third of it


def add_words(parser):
    parser.add_argument("--sizes", type=whole_numbers, default=[1000, 10000, 100000, 1000000])
    parser.add_argument("--way", help="those alone whose name has this in it", default="")
    parser.add_argument("--work", type=float, default=4e6, help="particle steps of a turn: "
                        "small sizes are run more often")
    parser.add_argument("--turns", type=int, default=3)
    parser.add_argument("--counted", type=int, default=100000, help="largest number with instructions")


def small(words):
    words.sizes, words.turns, words.counted, words.work = [1000, 10000, 100000], 1, 10000, 2e6


def free_memory():
    """What a process may take before others have to give, [byte]; unknown: endless."""
    file = Path("/proc/meminfo")
    found = re.search(r"^MemAvailable:\s+(\d+) kB", file.read_text(), re.M) if file.is_file() else None
    return 1024 * int(found[1]) if found else float("inf")


class Found:
    def __init__(self):
        self.nanoseconds, self.instructions, self.memory = [], None, 0


def measure(programs, words, runs, progress):
    """Found of each name and number that was asked for."""
    found = {(run.name, run.wished): Found() for run in runs}
    for turn in range(words.turns):
        for run in runs[::-1] if turn % 2 else runs:
            here, times = found[run.name, run.wished], max(1, round(words.work / run.particles / STEPS))
            seconds = 0.0
            for _ in range(times):
                start, end = (programs.run(run.way, run.text, n) for n in (FIRST, FIRST + STEPS))
                seconds += (end.seconds - start.seconds) / times
                here.memory = max(here.memory, end.memory)
            here.nanoseconds.append(1e9 * seconds / STEPS / run.particles)
            if turn == 0 and run.wished <= words.counted:
                here.instructions = programs.count_per_step(run.way, run.text, FIRST, STEPS) / run.particles
            progress.add(1)
    return found


def rows(programs, words):
    if max(words.sizes) >= 1e6 and free_memory() < SPARE:
        words.sizes = [size for size in words.sizes if size < 1e6]
        print(f"less than {SPARE / 1e9:g} GB of memory are free: 1e6 and more are left out", file=sys.stderr)
    runs = list(scenes.gases(programs, words))
    if not runs or len(words.sizes) < 2:
        sys.exit("nothing to compare: two sizes and an engine that is built are needed")
    found = measure(programs, words, runs, Progress(len(runs) * words.turns))
    base = 10000 if 10000 in words.sizes else words.sizes[0]
    yield (f"| style | particles | ns per particle and step | over {base}{spread_words(words.turns)} | instructions | "
           "byte per particle |")
    yield "|---|---|---|---|---|---|"
    few = runs[0].particles
    for run in runs:
        here, smallest = (found[run.name, wished] for wished in (run.wished, words.sizes[0]))
        ratios = [a / b for a, b in zip(here.nanoseconds, found[run.name, base].nanoseconds)]
        more = run.particles - few
        memory = f"{(here.memory - smallest.memory) / more:.0f}" if more > 0 else ""
        count = "" if here.instructions is None else f"{here.instructions:.0f}"
        time = statistics.median(here.nanoseconds)
        yield (f"| {run.name} | {run.particles} | {time:.1f} | {spread(ratios)} | {count} | "
               f"{memory} |")
