# SPDX-License-Identifier: BSD-3-Clause
"""How a step and the memory grow with the number of spheres, beside the stock engines."""
import os
import statistics
import sys

import scenes
from progress import Progress
from scenes import gran, hamaker, hooke, ours

TITLE = "Growth with the number of particles"
GRAN = "model hooke/stiffness tangential history"
WAYS = {
    "LAMMPS, gran/hooke/history (stock)": ("lammps", hooke()),
    "LAMMPS, gran/hamaker *event*": ("lammps+", ours(cohesion=hamaker())),
    "LAMMPS, gran/hamaker *sampled*": ("lammps+", ours(scheme="sampled", cohesion=hamaker())),
    "LIGGGHTS, hooke/stiffness (stock)": ("liggghts", gran()),
    "LIGGGHTS, cohesion hamaker": (
        "liggghts+", gran(GRAN + " cohesion hamaker", scenes.hamaker_properties())),
}
SPARE = 6e9  # memory that has to be free before the largest runs [byte]; one takes a third of it


def add_words(parser):
    parser.add_argument("--sizes", type=lambda text: [int(float(n)) for n in text.split(",")],
                        default=[1000, 10000, 100000, 1000000])
    parser.add_argument("--way", help="those alone whose name has this in it", default="")
    parser.add_argument("--work", type=float, default=1e7, help="particle steps of a run, at least 40 steps")
    parser.add_argument("--turns", type=int, default=3)
    parser.add_argument("--counted", type=int, default=100000, help="largest number with instructions")


def small(words):
    words.sizes, words.turns, words.counted, words.work = [1000, 10000, 100000], 1, 10000, 4e6


def free_memory():
    return os.sysconf("SC_AVPHYS_PAGES") * os.sysconf("SC_PAGE_SIZE")


def steps(words, number):
    """Of a run, multiples of what is between two lists."""
    return max(2, round(words.work / number / scenes.REBUILD)) * scenes.REBUILD


class Found:
    def __init__(self):
        self.nanoseconds, self.instructions, self.memory = [], None, 0


def measure(programs, words, ways, progress):
    found = {(name, wished): Found() for name in ways for wished in words.sizes}
    for turn in range(words.turns):
        for name, wished in list(found)[::-1] if turn % 2 else found:
            way, pair = ways[name]
            if wished >= 1e6 and free_memory() < SPARE:
                sys.exit(f"less than {SPARE / 1e9:g} GB of memory are free: leave {wished} out (--sizes)")
            cells = scenes.cells_for("gas", wished)
            number = scenes.particles("gas", cells)
            text = scenes.text(way.startswith("liggghts"), "gas", cells, pair, load=way == "lammps+")
            here, first, more = found[name, wished], 2 * scenes.REBUILD, steps(words, wished)
            start, end = (programs.run(way, text, n) for n in (first, first + more))
            here.nanoseconds.append(1e9 * (end.seconds - start.seconds) / more / number)
            here.memory = max(here.memory, end.memory)
            if turn == 0 and wished <= words.counted:
                here.instructions = programs.count_per_step(way, text, first, scenes.REBUILD) / number
            progress.add(1)
    return found


def rows(programs, words):
    ways = {name: way for name, way in WAYS.items() if words.way in name and programs.has(way[0])}
    if not ways or len(words.sizes) < 2:
        sys.exit("nothing to compare: two sizes and an engine that is built are needed")
    found = measure(programs, words, ways, Progress(len(ways) * len(words.sizes) * words.turns))
    base = 10000 if 10000 in words.sizes else words.sizes[0]
    yield f"| style | particles | ns per particle and step | over {base}: median (least to most) | instructions | byte per particle |"
    yield "|---|---|---|---|---|---|"
    for (name, wished), here in found.items():
        number = scenes.particles("gas", scenes.cells_for("gas", wished))
        smallest = found[name, words.sizes[0]]
        few = scenes.particles("gas", scenes.cells_for("gas", words.sizes[0]))
        ratios = [a / b for a, b in zip(here.nanoseconds, found[name, base].nanoseconds)]
        memory = f"{(here.memory - smallest.memory) / (number - few):.0f}" if number > few else ""
        count = "" if here.instructions is None else f"{here.instructions:.0f}"
        yield (f"| {name} | {number} | {statistics.median(here.nanoseconds):.1f} | "
               f"{statistics.median(ratios):.2f} ({min(ratios):.2f} to {max(ratios):.2f}) | {count} | {memory} |")
