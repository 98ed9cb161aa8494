# SPDX-License-Identifier: BSD-3-Clause
"""One rank and two: the same scene on both (strong), and twice the scene on two (weak)."""
import statistics

import scenes
from cohesion_tests.progress import Progress
from cohesion_tests.thermo import loop_seconds
from scenes import WAYS, spread



def add_words(parser):
    parser.add_argument("--particles", type=int, default=32000)
    parser.add_argument("--steps", type=int, default=400)
    parser.add_argument("--turns", type=int, default=5)
    parser.add_argument("--way", help="those alone whose name has this in it", default="")


def small(words):
    words.particles, words.turns, words.steps = 4000, 2, 200


def loop(programs, way, pair, cells, steps, ranks):
    """Seconds of the engine's own loop, by the clock."""
    text = scenes.text(way.startswith("liggghts"), "gas", cells, pair, load=way == "lammps+")
    return loop_seconds(programs.run(way, text, steps, ranks).output)


def rows(programs, words):
    ways = {name: way for name, way in WAYS.items() if words.way in name and programs.has(way[0])}
    cells = scenes.cells_for("gas", words.particles)
    one, two = (cells, cells, cells), (2 * cells, cells, cells)
    progress = Progress(len(ways) * words.turns)
    yield (f"| style, {scenes.particles('gas', one)} particles | 1 rank [s] | 2 ranks [s] | strong: 1 rank over 2 "
           "ranks | weak: 1 rank over 2 ranks with twice the particles |")
    yield "|---|---|---|---|---|"
    for name, (way, pair) in ways.items():
        times = []
        for _ in range(words.turns):
            times.append([loop(programs, way, pair, box, words.steps, ranks)
                          for box, ranks in ((one, 1), (one, 2), (two, 2))])
            progress.add(1)
        alone, shared = (statistics.median(t[k] for t in times) for k in (0, 1))
        yield (f"| {name} | {alone:.2f} | {shared:.2f} | {spread([t[0] / t[1] for t in times])} | "
               f"{spread([t[0] / t[2] for t in times])} |")
