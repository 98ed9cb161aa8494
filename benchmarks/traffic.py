# SPDX-License-Identifier: BSD-3-Clause
"""What a step fetches from beyond the caches, by valgrind's model of them, and how fast this machine copies: why a
step of many spheres takes longer than of few."""
import time

import numpy

import scenes
from build_folder import whole_numbers
from cohesion_tests.progress import Progress

# A list of neighbours is made once in the steps that are counted, as it is once in so many.
FIRST, STEPS = scenes.REBUILD, scenes.REBUILD
LINE = 64  # bytes
COPIES = (1, 5, 50, 500)  # [MB], source and copy
COPIED = 2e9  # bytes in each of the turns of a copy


def add_words(parser):
    parser.add_argument("--sizes", type=whole_numbers, default=[10000, 100000])
    parser.add_argument("--caches", type=whole_numbers, default=[2, 32],
                        help="of the last cache, MB, powers of two")
    parser.add_argument("--way", help="those alone whose name has this in it", default="")


def small(words):
    words.sizes, words.way = [1000, 10000], "hamaker"


def copied(megabytes, turns=5):
    """Bytes read and written per second, the best of the turns."""
    source = numpy.ones(int(megabytes * 1e6 / 2 / 8))
    copy, best = numpy.zeros_like(source), float("inf")
    times = max(1, int(COPIED / (2 * source.nbytes)))
    for _ in range(turns):
        start = time.process_time()
        for _ in range(times):
            numpy.copyto(copy, source)
        best = min(best, (time.process_time() - start) / times)
    return 2 * source.nbytes / best


def rows(programs, words):
    runs = list(scenes.gases(programs, words))
    progress = Progress(sum(run.wished for run in runs) * len(words.caches))
    yield "| what | particles | " + " | ".join(f"beyond {cache} MB" for cache in words.caches) + " |"
    yield "|---|---|" + "---|" * len(words.caches)
    for run in runs:
        bytes_of = []
        for cache in words.caches:
            lines = programs.missed_per_step(run.way, run.text, FIRST, STEPS, cache << 20)
            bytes_of.append(LINE * lines / run.particles)
            progress.add(run.wished)
        yield f"| {run.name}, byte | {run.particles} | " + " | ".join(f"{round(found)}" for found in bytes_of) + " |"
    for megabytes in COPIES:
        yield (f"| a copy of {megabytes} MB, source and copy: {copied(megabytes) / 1e9:.0f} byte per ns read and "
               "written |" + " |" * (1 + len(words.caches)))
