#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Events per second of pair_style hard/squarewell in one build beside another, turn about.

  hard-events-beside.py LMP_WITH_PLUGIN_COMMAND PLUGIN [--beside LMP_WITH_PLUGIN_COMMAND PLUGIN] [options]
  hard-events-beside.py LMP_WITH_PLUGIN_COMMAND PLUGIN --ranks 2 --beside-ranks 1 [options]

Spheres of diameter and mass 1 at number density 0.5 (a solid fraction of 0.26): at temperature 1 elastic with wells of
depth 1 and r_out/r = 1.5 or 1.001, and without wells sheared at rate 1 with restitution 0.9. The first build makes the
state of each scene, from an fcc lattice; all runs begin with it. Each step with each skin runs the same stretch of
time in both builds. Printed are the medians of the turns; a dash where LAMMPS refuses, as flights longer than its list
allows; then the best of each build, and the ratio of these two in each turn: median, and the quarter and three quarter
points. The times are those of LAMMPS' own loop; `of a processor` tells whether others took it meanwhile. --growth:
microseconds per event of the first build alone against the number of spheres, at the best of the steps and skins.
Builds that are made anew meanwhile are no builds to measure: copy them.
"""
import os
import re
import statistics
import sys
from collections import defaultdict, namedtuple

from cohesion_tests import csv_table, lammps as engine, measuring_program
from cohesion_tests.lammps_scenes import hard_spheres as hard
from cohesion_tests.launcher import given_program
from cohesion_tests.progress import Progress
from cohesion_tests.spread import spread
from cohesion_tests.thermo import loop_seconds, processor_seconds, thermo_columns

Scene = namedtuple("Scene", "law rate")
SCENES = {"wide": Scene("restitution 1 well 1 1.5", 0), "narrow": Scene("restitution 1 well 1 1.001", 0),
          "sheared": Scene("restitution 0.9", 1)}
# Of hard_spheres.csv
CASES = {"wide": "r_out/r = 1.5, D = 1", "narrow": "r_out/r = 1.001, D = 1", "sheared": "no well, e = 0.9, sheared at rate 1"}
STEPS, SKINS = [0.01, 0.02, 0.03], [0.3, 0.4, 0.6]  # a mean free time is 0.13
MAKING, STAGES = {"dt": 0.005, "skin": 0.6}, 10
LONGEST = 3600  # s, of one run

Side = namedtuple("Side", "lmp plugin ranks")
# temperature: at the end; share: that it had of a processor. Of a run that was refused: 0, and the message.
Run = namedtuple("Run", "events seconds temperature share message")


def numbers(kind):
    return lambda words: [kind(float(word)) for word in words.split(",")]


def cells(spheres):
    """Along an edge of the lattice."""
    side = round((spheres / 4)**(1 / 3))
    if side < 1 or 4 * side**3 != spheres:
        sys.exit(f"{spheres} spheres: 4 N^3 make an fcc lattice, such as {4 * max(side, 3)**3}")
    return side


def variables(side, scene, dt, steps, skin):
    return {"lmp": side.lmp, "plugin": side.plugin, "law": scene.law, "rate": scene.rate, "dt": dt, "steps": steps,
            "skin": skin, "timeout": LONGEST}


def make(folder, side, scene, spheres, time):
    stage = max(1, round(time / STAGES / MAKING["dt"]))
    engine.run("in.hard_beside", folder, start="lattice", cells=cells(spheres), stage=stage,
               **variables(side, scene, steps=STAGES * stage, **MAKING))


def measure(folder, side, scene, dt, skin, words):
    code, output = engine.start("in.hard_beside", folder, ranks=side.ranks, start="data",
                                **variables(side, scene, dt, max(1, round(words.time / dt)), skin))
    refusal = re.search(r"ERROR.*", output)
    if code == 0:
        table = thermo_columns(output)
        events = sum(values[-1] - values[0] for values in hard.counts(table).values())
        seconds = loop_seconds(output)
        return Run(events, seconds, table["c_flow[3]"][-1], processor_seconds(output) / seconds, "")
    if not refusal:
        raise RuntimeError(f"LAMMPS ended with code {code}:\n{output[-3000:]}")
    return Run(0, 0.0, 0.0, 0.0, refusal[0][:200])


def in_turns(folder, sides, scene, words, progress):
    """Runs of each (step, skin): for each side a list of the turns, or of one that was refused."""
    found = defaultdict(lambda: [[] for _ in sides])
    for turn in range(words.turns):
        for dt in words.steps:
            for skin in words.skins:
                for k in range(len(sides))[::1 if turn % 2 == 0 else -1]:
                    runs = found[dt, skin][k]
                    if not runs or runs[-1].seconds:
                        runs.append(measure(folder, sides[k], scene, dt, skin, words))
                    progress.add(1)
    return {setting: [[runs[-1]] if not runs[-1].seconds else runs for runs in of_sides]
            for setting, of_sides in found.items()}


def rates(runs):
    """Events per second, of each turn; none where LAMMPS refused."""
    return [run.events / run.seconds for run in runs if run.seconds]


def least_share(runs):
    return min(run.share for run in runs)


def best(found, k):
    """Step and skin at which side `k` has most events per second, None where all were refused."""
    able = [setting for setting in found if rates(found[setting][k])]
    return max(able, key=lambda setting: statistics.median(rates(found[setting][k])), default=None)


def show(found, names, words):
    """Table of a scene, and the best of each side; of two sides the events per second of their best and the ratio."""
    print(f"{'step':>8s}{'skin':>7s}" + "".join(f"{name + ', events/s':>20s}" for name in names)
          + (f"{'ratio':>8s}" if len(names) > 1 else ""))
    for (dt, skin), of_sides in found.items():
        medians = [statistics.median(rates(runs)) if rates(runs) else None for runs in of_sides]
        print(f"{dt:8g}{skin:7g}" + "".join(f"{'-' if median is None else f'{median:.4g}':>20s}" for median in medians)
              + (f"{medians[0] / medians[1]:8.2f}" if len(names) > 1 and None not in medians else ""))
    for k, name in enumerate(names):
        show_side(found, k, name, words)
    settings = [best(found, k) for k in range(len(names))]
    if len(names) > 1 and None not in settings:
        of_sides = [rates(found[setting][k]) for k, setting in enumerate(settings)]
        ratio = spread([first / other for first, other in zip(*of_sides)])
        print(f"ratio of the best: {ratio}", flush=True)
        return [statistics.median(turns) for turns in of_sides], ratio
    return None


def show_side(found, k, name, words):
    refusals = [of_sides[k][-1].message for of_sides in found.values() if of_sides[k][-1].message]
    if refusals:
        print(f"{name} refused {len(refusals)}, the first: {refusals[0]}")
    setting = best(found, k)
    if setting:
        runs = found[setting][k]
        events = runs[-1].events
        print(f"best, {name}: {statistics.median(rates(runs)):.4g} events/s at step {setting[0]:g}, "
              f"skin {setting[1]:g}; {events:.0f} events, {events / words.spheres / words.time:.2f} per sphere and "
              f"unit of time; temperature at the end {runs[-1].temperature:.3f}; of a processor "
              f"{least_share(runs):.2f} or more")


def side_by_side(sides, words):
    names = ["first", "other"][:len(sides)]
    progress = Progress(len(words.steps) * len(words.skins) * words.turns * len(sides) * len(words.scenes))
    print(f"{words.spheres} spheres, time {words.time:g} in each run, turns {words.turns}, ranks "
          + ", ".join(str(side.ranks) for side in sides))
    for name in words.scenes:
        scene = SCENES[name]
        print(f"\n{name}: {scene.law}" + (f", sheared at rate {scene.rate}" if scene.rate else ""), flush=True)
        with engine.temporary_folder() as folder:
            make(folder, sides[0], scene, words.spheres, words.before)
            both = show(in_turns(folder, sides, scene, words, progress), names, words)
        if both and [side.ranks for side in sides] == [2, 1] and not words.beside:
            (two, one), ratio = both
            csv_table.enter_quantities(words.csv, f"two processes, {words.spheres} spheres", CASES[name], {
                "one process, events/s": csv_table.power(one, 2), "two processes, events/s": csv_table.power(two, 2),
                "two over one": ratio})


def growth(side, words):
    scenes = [SCENES[name] for name in words.scenes]
    progress = Progress(len(words.steps) * len(words.skins) * words.turns * len(scenes) * sum(words.growth))
    print("microseconds per event at the best step and skin\n" + f"{'spheres':>9s}"
          + "".join(f"{name + ' (step, skin)':>30s}" for name in words.scenes))
    least = 1.0
    for spheres in words.growth:
        line = f"{spheres:9d}"
        for name, scene in zip(words.scenes, scenes):
            with engine.temporary_folder() as folder:
                make(folder, side, scene, spheres, words.before)
                found = in_turns(folder, [side], scene, words, Part(progress, spheres))
            setting = best(found, 0)
            cell = "-"
            if setting:
                cost = 1e6 / statistics.median(rates(found[setting][0]))
                cell = f"{cost:.3f} ({setting[0]:g}, {setting[1]:g})"
                least = min(least, least_share(found[setting][0]))
                csv_table.enter_quantities(words.csv, "number of particles", f"{spheres} spheres, {CASES[name]}",
                                           {"microseconds per event": f"{cost:#.2g}"})
            line += f"{cell:>30s}"
        print(line, flush=True)
    print(f"of a processor these runs had {least:.2f} or more")


class Part:
    """Of a Progress: work in a unit of its own."""

    def __init__(self, progress, unit):
        self.progress, self.unit = progress, unit

    def add(self, work):
        self.progress.add(work * self.unit)


OPTIONS = (
    ("--beside", {"nargs": 2, "type": given_program, "metavar": ("LMP", "PLUGIN"), "help": "the other build"}),
    ("--spheres", {"type": int, "default": 1372, "help": "4 N^3"}),
    ("--scenes", {"nargs": "+", "choices": tuple(SCENES), "default": list(SCENES)}),
    ("--steps", {"type": numbers(float), "default": STEPS, "metavar": "T,T,..."}),
    ("--skins", {"type": numbers(float), "default": SKINS, "metavar": "S,S,..."}),
    ("--time", {"type": float, "default": 20.0, "help": "that each run follows"}),
    ("--before", {"type": float, "default": 10.0, "help": "time (and strain) from the lattice to the state"}),
    ("--turns", {"type": int, "default": 5}),
    ("--ranks", {"type": int, "default": 1, "help": "of each run"}),
    ("--beside-ranks", {"type": int, "metavar": "N", "help": "of the other build, or of the same one beside itself"}),
    ("--mpiexec", {"default": "mpiexec --oversubscribe -np"}),
    ("--growth", {"type": numbers(int), "metavar": "N,N,...", "help": "numbers of spheres"}), csv_table.OPTION)


def main():
    words = measuring_program.words(__doc__, *OPTIONS)
    os.environ["COHESION_MPIEXEC"] = words.mpiexec
    for spheres in words.growth or [words.spheres]:
        cells(spheres)
    sides = [Side(words.lmp, words.plugin, words.ranks)]
    if words.beside or words.beside_ranks:
        sides.append(Side(*(words.beside or (words.lmp, words.plugin)), words.beside_ranks or words.ranks))
    if words.growth:
        growth(sides[0], words)
    else:
        side_by_side(sides, words)


if __name__ == "__main__":
    main()
