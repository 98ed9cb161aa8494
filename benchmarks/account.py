# SPDX-License-Identifier: BSD-3-Clause
"""The engines' own account of a step, by the clock: what of it grows with the number of spheres."""
import re
import statistics

import scenes
from build_folder import whole_numbers
from cohesion_tests.progress import Progress
from cohesion_tests.thermo import loop_seconds

PARTS = {"Pair": "pairs", "Neigh": "lists", "Comm": "ghosts", "Modify": "integration, fixes"}


def add_words(parser):
    parser.add_argument("--sizes", type=whole_numbers, default=[10000, 100000, 1000000])
    parser.add_argument("--way", help="those alone whose name has this in it", default="")
    parser.add_argument("--steps", type=int, default=140, help="from the first on")
    parser.add_argument("--turns", type=int, default=3)


def small(words):
    words.sizes, words.turns = [1000, 10000], 1


def seconds(output):
    """Of each of PARTS, None where the engine does not tell it, and of the whole loop."""
    found = (re.search(rf"^{part}\s+(?:\|[^|]*\||time \(%\) =)\s*([-+.\de]+)", output, re.M) for part in PARTS)
    return ([part and float(part[1]) for part in found],
            loop_seconds(output))


def rows(programs, words):
    runs = list(scenes.gases(programs, words))
    progress = Progress(words.turns * sum(run.wished for run in runs))
    yield (f"| style, ns by the clock per particle and step | particles | all | {' | '.join(PARTS.values())} | rest |")
    yield "|---|---|---|" + "---|" * len(PARTS) + "---|"
    for run in runs:
        turns = []
        for _ in range(words.turns):
            parts, whole = seconds(programs.run(run.way, run.text, words.steps).output)
            rest = whole - sum(part for part in parts if part is not None)
            turns.append([whole, *parts, rest])
            progress.add(run.wished)
        cells = ["" if None in values else f"{statistics.median(values) * 1e9 / words.steps / run.particles:.1f}"
                 for values in zip(*turns)]
        yield f"| {run.name} | {run.particles} | " + " | ".join(cells) + " |"
