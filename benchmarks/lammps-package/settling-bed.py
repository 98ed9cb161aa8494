#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""2028 spheres with damping and friction that settle under gravity, adhesion 0, 1 and 20 weights.

  settling-bed.py LMP_WITH_PLUGIN_COMMAND PLUGIN [--side N] [--layers N] [--seconds S] [--exact N ...]
                  [--seed N] [--beds N] [--law linear|hertz|dmt|jkr] [--csv FILE]
  settling-bed.py LIGGGHTS_COHESION [the same words without --law]

Printed per scheme and step: kinetic energy (rotation included) over that of the start, mean over each
fifth of the run; what of it the liveliest sphere has at the end; the largest speed there; what the energy
tally does not account for, over the largest kinetic energy, in all of the run and in its second half, when
the bed rests; seconds of processor time, which LIGGGHTS does not report ('-'). Of several beds (--beds), of
seeds from --seed on: what they have in the last fifth, median, quartiles, least and most, since what is left
differs from bed to bed by far more than from scheme to scheme. --law: contacts and adhesion of theory/hertzian_laws.py, scheme exact only; with
adhesion a rolling friction of 0.01, since spheres that hang in one contact roll on without loss. In LIGGGHTS scheme
exact only.
"""
import sys

import numpy

from cohesion_tests import csv_table, lammps as engine, measuring_program
from cohesion_tests.lammps_scenes import settling_spheres as settling
from cohesion_tests.progress import Progress
from cohesion_tests.theory import hertzian_laws
from cohesion_tests.thermo import shown_seconds

SAMPLED = 50  # steps per contact time
WEIGHTS = 0, 1, 20


def fifths(table):
    """Means of the kinetic energy over that of the start."""
    return (table[1:, 1] / table[0, 1]).reshape(5, -1).mean(axis=1)


def show_bed(run, words, ratio):
    with engine.temporary_folder() as folder:
        settling.write(folder, words.side, words.layers, seed=words.seed)
        table, seconds = follow(folder, run, words, ratio)
        liveliest = settling.liveliest_share(engine.dump(folder, "end.txt"))
    residual = table[:, 3] / table[:, 1].max()
    at_rest = residual[-1] - residual[len(residual) // 2]
    if run[0] == "exact":
        last = {"kinetic energy in the last fifth over that of the start": fifths(table)[-1]} if words.law != "linear" else {}
        for quantity, value in {"whole run": residual[-1], "at rest": at_rest, **last}.items():
            csv_table.enter(words.csv, row(f"settling, {quantity}", run[1], words, ratio), value=f"{value:.1e}")
    return ("".join(f"{k:10.1e}" for k in fifths(table)) + f"{liveliest:12.3f}{table[-1, 2]:13.1e}"
            + (f"{residual[-1]:11.1e}{at_rest:11.1e}" if run[0] == "exact" else f"{'':22s}")
            + shown_seconds(seconds, 9, 1))


def row(quantity, division, words, ratio):
    """Of contact_energies.csv."""
    return {"quantity": quantity, "engine": "LAMMPS" if words.plugin else "LIGGGHTS", "scheme": "exact", "law": words.law,
            "adhesion over weight": f"{ratio:g}" if words.law == "linear" else "", "restitution": "0.9",
            "friction": "0.3", "step": f"t_c/{division}"}


def show_beds(run, words, ratio):
    last, seconds = [], 0.0
    for seed in range(words.seed, words.seed + words.beds):
        with engine.temporary_folder() as folder:
            settling.write(folder, words.side, words.layers, seed=seed)
            table, took = follow(folder, run, words, ratio)
        last.append(fifths(table)[-1])
        seconds += took
    least, low, median, high, most = numpy.quantile(last, [0, 0.25, 0.5, 0.75, 1])
    return "".join(f"{k:10.1e}" for k in (median, low, high, least, most)) + shown_seconds(seconds, 9, 1)


def follow(folder, run, words, ratio):
    return settling.follow(folder, run[1], words.seconds, scheme=run[0], A=settling.hamaker_constant(ratio),
                           law=words.law, roll=0.01 if words.law in ("dmt", "jkr") else 0.0)


def main():
    words = measuring_program.words(
        __doc__, ("--side", {"type": int, "default": 13, "help": "spheres per edge of a layer"}),
        ("--layers", {"type": int, "default": 12}),
        ("--seconds", {"type": float, "default": 0.5, "help": "of the scene's time"}),
        ("--exact", {"type": int, "nargs": "+", "default": [5, 10], "metavar": "N",
                     "help": "steps per contact time of the exact scheme"}),
        ("--law", {"choices": hertzian_laws.LAWS, "default": "linear"}),
        ("--seed", {"type": int, "default": 1}), ("--beds", {"type": int, "default": 1, "metavar": "N"}),
        csv_table.OPTION, liggghts=True)
    csv_table.require_published(words, side=5, layers=5, seconds=0.5, seed=1, beds=1)

    linear = words.law == "linear"
    if not words.plugin and not linear:
        sys.exit(f"--law {words.law}: of LAMMPS only")
    runs = [("exact", n) for n in words.exact] + [("sampled", SAMPLED)] * bool(linear and words.plugin)
    weights = WEIGHTS if linear else (0,)
    # A step of the exact scheme costs about two and a half of the sampled one's.
    work = {run: run[1] * (2.5 if run[0] == "exact" else 1.0) for run in runs}
    progress = Progress(len(weights) * sum(work.values()))
    show, heading = ((show_beds, "last fifth  quartiles            least     most       seconds") if words.beds > 1 else
                     (show_bed, "kinetic energy in each fifth                   liveliest  speed [m/s]   residual"
                                "    at rest  seconds"))
    for ratio in weights:
        print(f"\r{f'adhesion {ratio} times the weight' if linear else words.law}{'':30s}\n  scheme   step      {heading}")
        for run in runs:
            line = show(run, words, ratio)
            progress.add(work[run])
            print(f"\r  {run[0]:8s} t_c/{run[1]:<4d}{line}", flush=True)


if __name__ == "__main__":
    main()
