# SPDX-License-Identifier: BSD-3-Clause
"""How a step and the memory grow with the number of spheres, beside the stock engines."""
import re
import statistics
import sys
from pathlib import Path

import scenes
from programs import whole_numbers
from progress import Progress
from scenes import WAYS, spread

TITLE = "Growth with the number of particles"
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


def measure(programs, words, ways, progress):
    found = {(name, wished): Found() for name in ways for wished in words.sizes}
    for turn in range(words.turns):
        for name, wished in list(found)[::-1] if turn % 2 else found:
            way, pair = ways[name]
            cells = scenes.cells_for("gas", wished)
            number = scenes.particles("gas", cells)
            text = scenes.text(way.startswith("liggghts"), "gas", cells, pair, load=way == "lammps+")
            here, times = found[name, wished], max(1, round(words.work / number / STEPS))
            seconds = 0.0
            for _ in range(times):
                start, end = (programs.run(way, text, n) for n in (FIRST, FIRST + STEPS))
                seconds += (end.seconds - start.seconds) / times
                here.memory = max(here.memory, end.memory)
            here.nanoseconds.append(1e9 * seconds / STEPS / number)
            if turn == 0 and wished <= words.counted:
                here.instructions = programs.count_per_step(way, text, FIRST, STEPS) / number
            progress.add(1)
    return found


def rows(programs, words):
    ways = {name: way for name, way in WAYS.items() if words.way in name and programs.has(way[0])}
    if max(words.sizes) >= 1e6 and free_memory() < SPARE:
        words.sizes = [size for size in words.sizes if size < 1e6]
        print(f"less than {SPARE / 1e9:g} GB of memory are free: 1e6 and more are left out", file=sys.stderr)
    if not ways or len(words.sizes) < 2:
        sys.exit("nothing to compare: two sizes and an engine that is built are needed")
    found = measure(programs, words, ways, Progress(len(ways) * len(words.sizes) * words.turns))
    base = 10000 if 10000 in words.sizes else words.sizes[0]
    yield (f"| style | particles | ns per particle and step | over {base}: median (least to most) | instructions | "
           "byte per particle |")
    yield "|---|---|---|---|---|---|"
    for (name, wished), here in found.items():
        number = scenes.particles("gas", scenes.cells_for("gas", wished))
        smallest = found[name, words.sizes[0]]
        few = scenes.particles("gas", scenes.cells_for("gas", words.sizes[0]))
        ratios = [a / b for a, b in zip(here.nanoseconds, found[name, base].nanoseconds)]
        memory = f"{(here.memory - smallest.memory) / (number - few):.0f}" if number > few else ""
        count = "" if here.instructions is None else f"{here.instructions:.0f}"
        yield (f"| {name} | {number} | {statistics.median(here.nanoseconds):.1f} | {spread(ratios)} | {count} | "
               f"{memory} |")
