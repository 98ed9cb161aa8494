# SPDX-License-Identifier: BSD-3-Clause
"""A step with cohesion of many spheres on one core, each way that there is, beside the stock engines."""
import statistics
import sys

import scenes
from cohesion_tests.progress import Progress
from scenes import LIGGGHTS_CONTACT, gran, granular, hamaker, hooke, ours, overlay, spread, spread_words, well

WAYS = {
    "LAMMPS": {
        "gran/hooke/history (stock)": ("lammps", hooke()),
        "granular hooke (stock)": ("lammps", granular()),
        "granular dmt (stock, cohesive)": ("lammps", granular(cohesive=True)),
        "hooke/history + hamaker": ("lammps+", overlay(f"hamaker cutoff {scenes.CUT} {scenes.OUT}", f"hamaker {scenes.HAMAKER}")),
        "hooke/history + squarewell": ("lammps+", overlay("squarewell", f"well {scenes.DEPTH} {scenes.RATIO}")),
        "gran/hamaker *sampled*": ("lammps+", ours(scheme="sampled", cohesion=hamaker())),
        "gran/hamaker *exact*": ("lammps+", ours(cohesion=hamaker())),
        "gran/hamaker *exact*, no friction": ("lammps+", ours(friction="", cohesion=hamaker())),
        "gran/squarewell *sampled*": ("lammps+", ours("gran/squarewell", "sampled", cohesion=well())),
        "gran/squarewell *exact*": ("lammps+", ours("gran/squarewell", cohesion=well())),
    },
    "LIGGGHTS": {
        "hooke/stiffness (stock)": ("liggghts", gran()),
        "hooke/stiffness, sjkr (stock, cohesive)": (
            "liggghts", gran(LIGGGHTS_CONTACT + " cohesion sjkr", scenes.SJKR_PROPERTIES)),
        "cohesion hamaker *sampled*": ("liggghts+", scenes.LIGGGHTS_HAMAKER),
        "cohesion hamaker *exact*": ("liggghts+", scenes.LIGGGHTS_EXACT),
        "cohesion square_well *sampled*": (
            "liggghts+", gran(LIGGGHTS_CONTACT + " cohesion square_well scheme sampled", scenes.well_properties())),
        "cohesion square_well *exact*": (
            "liggghts+", gran(LIGGGHTS_CONTACT + " cohesion square_well scheme exact", scenes.well_properties())),
    },
}

ASKED = 1.15  # of the engine's own style with cohesion
COUNTED = 5  # counting takes as long as so many turns of timing, about


def add_words(parser):
    parser.add_argument("--engine", choices=WAYS, action="append")
    parser.add_argument("--scene", choices=scenes.LATTICE, action="append")
    parser.add_argument("--particles", type=int, default=32000)
    parser.add_argument("--first", type=int, default=100, help="steps before what is measured")
    parser.add_argument("--steps", type=int, default=40, help="that are counted, and a quarter of those that are "
                        "timed; a multiple of 20")
    parser.add_argument("--turns", type=int, default=3, help="0: instructions alone")
    parser.add_argument("--times", action="store_true", help="times alone")


def small(words):
    words.particles, words.steps, words.turns, words.scene = 4000, 20, 1, ["gas"]


def measure(programs, words, engine, scene, progress):
    """Number of spheres; per way instructions per particle and step, and of each turn nanoseconds."""
    cells = scenes.cells_for(scene, words.particles)
    number = scenes.particles(scene, cells)
    runs = {name: (way, scenes.text(engine == "LIGGGHTS", scene, cells, pair, load=way == "lammps+"))
            for name, (way, pair) in WAYS[engine].items()}
    counts = {}
    for name, (way, text) in runs.items():
        counts[name] = None if words.times else programs.count_per_step(
            way, text, words.first, words.steps) / number
        progress.add(0 if words.times else COUNTED)
    turns = {name: [] for name in runs}
    for turn in range(words.turns):
        for name in list(runs)[::-1] if turn % 2 else runs:
            turns[name].append(1e9 / number * programs.seconds_per_step(
                *runs[name], words.first, 4 * words.steps))
            progress.add(1)
    return number, counts, turns


def rows(programs, words):
    # The scene of all engines first: who stops early has seen each engine.
    tables = [(e, scene) for scene in words.scene or scenes.LATTICE for e in words.engine or WAYS
              if programs.has(e.lower() + "+")]
    if not tables:
        sys.exit("no engine of these is built in " + str(programs.build))
    progress = Progress(sum(len(WAYS[e]) for e, _ in tables) * (words.turns + (0 if words.times else COUNTED)))
    yield ("| engine | scene | style | instructions | over stock | over stock with cohesion | ns | over stock, same "
           f"turn{spread_words(words.turns)} | over stock with cohesion, same turn |")
    yield "|---|---|---|---|---|---|---|---|---|"
    against = {}
    for engine, scene in tables:
        number, counts, turns = measure(programs, words, engine, scene, progress)
        stock = next(iter(counts))
        beside = (stock, next(name for name in counts if "cohesive" in name))
        for name, count in counts.items():
            found = ["" if count is None else f"{count:.0f}"]
            found += ["" if count is None else f"{count / counts[other]:.2f}" for other in beside]
            found.append(f"{statistics.median(turns[name]):.0f}" if turns[name] else "")
            found += [spread([own / its for own, its in zip(turns[name], turns[other])]) if turns[name] else ""
                      for other in beside]
            yield f"| {engine} | {scene}, {number} | {name} | " + " | ".join(found) + " |"
        against[f"{engine}, {scene}"] = over_cohesive(WAYS[engine], counts, turns, beside[1])
    yield ""
    yield from verdict(against)


def over_cohesive(ways, counts, turns, cohesive):
    """{what: {style of this package: over the engine's own style with cohesion}}, of what was measured."""
    own = [name for name, (way, _) in ways.items() if way.endswith("+")]
    found = {}
    if counts[cohesive] is not None:
        found["instructions"] = {name: counts[name] / counts[cohesive] for name in own}
    if turns[cohesive]:
        found["time"] = {name: statistics.median(mine / its for mine, its in zip(turns[name], turns[cohesive]))
                         for name in own}
    return found


def told(ratio):
    """With two digits, near ASKED with as many as tell on which side it is."""
    text = f"{ratio:.2f}"
    return f"{ratio:.4f}" if text == f"{ASKED:.2f}" else text


def verdict(against):
    """Lines of a table: which styles are within ASKED and which beyond; {engine and scene: over_cohesive()}."""
    yield f"| over stock with cohesion | by | within {ASKED} | beyond |"
    yield "|---|---|---|---|"
    for where, measured in against.items():
        for what, ratios in measured.items():
            sides = ("; ".join(f"{name} {told(ratio)}" for name, ratio in ratios.items() if (ratio <= ASKED) == within)
                     for within in (True, False))
            yield f"| {where} | {what} | " + " | ".join(side or "none" for side in sides) + " |"
