#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Speed of pair_style hard/squarewell on one core: events per second and seconds of a run against the
size of the step, and what a step without events costs beside LAMMPS' own gran/hooke.

  hard-event-rate.py LMP_WITH_PLUGIN_COMMAND PLUGIN [--discs N] [--flights N] [--turns N] [--csv FILE]

Elastic discs at an area fraction of 0.5, wells of depth m v^2/10 (v: a component's standard deviation),
r_out/r = 1.001 and 1.1 and none; the same stretch of time, in mean free times, for every step. The
last table: discs at rest, apart, every step of both styles, in turns; printed is their ratio. The times
are those of LAMMPS' own loop.
"""
import math
import statistics

from cohesion_tests import csv_table, lammps as engine, measuring_program
from cohesion_tests.lammps_scenes import hard_spheres as hard
from cohesion_tests.lammps_scenes.hard_gas import Gas
from cohesion_tests.thermo import loop_seconds

STEPS = (1.0, 0.3, 0.1, 0.03, 0.01)  # of a mean free time
FRACTION, DEPTH = 0.5, 0.1


def free_time(gas):
    """Mean, of the start, by the event-driven reference [s]."""
    start = gas.reference()
    start.run(math.inf, most=len(gas.x))
    return start.now * len(gas.x) / 2 / len(start.events)


def rates(gas, free, ratio, flights):
    """Rows: step over mean free time, events, seconds."""
    words = f"* * restitution 1 well {DEPTH} {ratio}" if ratio else "* * restitution 1"
    fastest = 2 * math.sqrt(2 * math.log(len(gas.x)))
    for step in STEPS:
        with engine.temporary_folder() as folder:
            gas.write(folder)
            # Room for the flight of the fastest, and for some steps between two lists.
            skin = 0.3 + 2.5 * fastest * step * free
            _, table, output = gas.run(folder, [words], step * free, round(flights / step), skin=skin)
            yield step, sum(hard.counts(table).values())[-1], loop_seconds(output, 0)


def idle(gas, style, steps):
    """Seconds of steps in which nothing happens."""
    with engine.temporary_folder() as folder:
        gas.write(folder)
        hard.script(folder, ["* * restitution 1 well 0.1 1.001"], dimension=2)
        return loop_seconds(engine.run("in.hard_idle", folder, style=style, steps=steps), 0)


def main():
    words = measuring_program.words(
        __doc__, ("--discs", {"type": int, "default": 2292}),
        ("--flights", {"type": float, "default": 30.0, "help": "length in mean free times"}),
        ("--turns", {"type": int, "default": 5}), csv_table.OPTION)
    csv_table.require_published(words, flights=30.0)

    gas = Gas(words.discs, FRACTION, 2)
    free = free_time(gas)
    print(f"{words.discs} discs, area fraction {FRACTION}, {words.flights:g} mean free times of "
          f"{free:.4g} each")
    for ratio in (1.001, 1.1, None):
        name = f"r_out/r = {ratio}, D = {DEPTH}" if ratio else "no well"
        print(f"{name}\nstep/free time     events    [s]  events/s  steps/s")
        for step, events, seconds in rates(gas, free, ratio, words.flights):
            print(f"{step:14g} {events:10.0f} {seconds:6.2f} {events / seconds:9.3g} "
                  f"{words.flights / step / seconds:8.3g}", flush=True)
            case = f"{name.split(',')[0]}, step {step:g} mean free times"
            csv_table.enter_quantities(words.csv, f"{words.discs} discs", case, {
                "seconds": f"{seconds:.2f}", "events/s": csv_table.power(events / seconds)})

    gas = Gas(words.discs, FRACTION, 2)
    gas.v[:] = 0.0
    steps, ratios = 4000, []
    print(f"steps without events, {words.discs} discs at rest\n"
          "gran/hooke [us]  hard/squarewell [us]  ratio")
    for turn in range(words.turns):
        styles = ("gran/hooke", "hard/squarewell")
        times = {style: idle(gas, style, steps) for style in (styles if turn % 2 == 0
                                                              else styles[::-1])}
        ratios.append(times["hard/squarewell"] / times["gran/hooke"])
        print(f"{times['gran/hooke'] / steps * 1e6:15.1f} "
              f"{times['hard/squarewell'] / steps * 1e6:22.1f} {ratios[-1]:6.3f}", flush=True)
    print(f"median {statistics.median(ratios):.3f}, from {min(ratios):.3f} to {max(ratios):.3f}")


if __name__ == "__main__":
    main()
