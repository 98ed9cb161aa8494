#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Keyword `rest` of pair_style hard/squarewell: hard spheres that press on each other, in clusters and in columns.

  rest-of-hard-spheres.py LMP_WITH_PLUGIN_COMMAND PLUGIN [--gases N] [--columns N ...] [--csv FILE]

Gases: 100 spheres of diameter and mass 1 at a solid fraction of 0.03 and temperature 1, restitution 0.8, wells of depth 1
and r_out/r = 1.01, cool freely for a time of 50 in steps of 0.1 without the rule `collapse`. Means over the gases with
their standard errors, by `rest`; how many stop at `limit`. Two spheres belong to a cluster if they are in their well.
Columns: N spheres with a restitution of 0.9 on a floor, 500 steps of 0.01 (d/g)^(1/2) after 2000 of coming to rest, with
the default rules."""
import math

import numpy
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components
from scipy.spatial import cKDTree

from cohesion_tests import csv_table, lammps as engine, measuring_program
from cohesion_tests.lammps_scenes import hard_spheres as hard
from cohesion_tests.lammps_scenes.hard_extremes import follow
from cohesion_tests.lammps_scenes.hard_gas import Gas
from cohesion_tests.progress import Progress

RULES = ("off", "0.1", "0.3", "1", "3")
SPHERES, RATIO, STEP, STEPS = 100, 1.01, 0.1, 500
COLUMN_STEP, SETTLE = 0.01, 2000
QUANTITIES = ("energy of motion per sphere", "of that within clusters", "bound pairs per sphere",
              "clusters and single spheres, per sphere", "events per sphere")


def clusters(places, length):
    """Number of the cluster of each sphere."""
    pairs = cKDTree(places % length, boxsize=length).query_pairs(RATIO, output_type="ndarray")
    return connected_components(coo_matrix((numpy.ones(len(pairs)), pairs.T), shape=2 * [len(places)]), False)


def gas(rule, seed):
    """QUANTITIES at the end, or None where the run stops at the limit."""
    with engine.temporary_folder() as folder:
        start = Gas(SPHERES, 0.03, seed=seed)
        start.write(folder)
        try:
            path, table, _ = start.run(folder, [f"* * restitution 0.8 well 1 {RATIO}"], STEP, STEPS,
                                       style=f"rest {rule} collapse off", skin=1.0, every=STEPS)
        except RuntimeError as error:
            if "limit" not in str(error):
                raise
            return None
    velocity = path[-1, :, 4:7]
    count, of = clusters(path[-1, :, 1:4], start.length)
    sizes = numpy.bincount(of)
    mean = numpy.stack([numpy.bincount(of, velocity[:, axis]) / sizes for axis in range(3)], axis=1)
    within = ((velocity - mean[of])**2).sum() / 2
    return numpy.array([(velocity**2).sum() / 2, within, -table["PotEng"][-1], count,
                        sum(hard.counts(table).values())[-1]]) / SPHERES


def gases(words):
    progress = Progress(len(RULES) * words.gases)
    for rule in RULES:
        found = []
        for seed in range(1, words.gases + 1):
            found.append(gas(rule, seed))
            progress.add(1)
        ended = numpy.array([values for values in found if values is not None])
        row = {"stopped at limit": f"{len(found) - len(ended)}"}
        if len(ended) == len(found):
            error = ended.std(axis=0, ddof=1) / math.sqrt(len(ended))
            row.update({name: f"{mean:.3f} +- {of_mean:.3f}" for name, mean, of_mean in
                        zip(QUANTITIES, ended.mean(axis=0), error)})
            row[QUANTITIES[-1]] = f"{ended[:, -1].mean():.0f}"
        print(f"\rrest {rule}: " + "; ".join(f"{name} {value}" for name, value in row.items()), flush=True)
        csv_table.enter_quantities(words.csv, f"{words.gases} cooling gases", f"rest {rule}", row)


def column(number, style):
    """Root mean square of the speeds over g dt; collisions per sphere and step; the most of a sphere in a step."""
    more = ["fix down all gravity 1.0 vector 0 0 -1", "fix floor all wall/hard/squarewell restitution 0.9 zplane 0 NULL"]
    places, velocities = [(2, 2, 0.5 + n) for n in range(number)], number * [(0, 0, 0)]
    for steps in (SETTLE, STEPS):
        path, _, table, _ = follow([hard.atom(x, v) for x, v in zip(places, velocities)], ["* * restitution 0.9"],
                                   COLUMN_STEP, steps, style=style, more=more, every=50, boundary="p p f",
                                   box=[(0.0, 4.0), (0.0, 4.0), (0.0, number + 3.0)])
        places, velocities = path[-1, :, 1:4].tolist(), path[-1, :, 4:7].tolist()
    speed = math.sqrt((path[1:, :, 4:7]**2).sum(axis=-1).mean())
    collisions = table["c_events[1]"][-1]
    return speed / COLUMN_STEP, collisions / number / STEPS, table["c_events[18]"][-1]


def columns(words):
    cases = [(f"N {number}", number, "") for number in words.columns]
    for name, number, style in [*cases, (f"N {words.columns[-1]}, collapse off", words.columns[-1], "collapse off")]:
        speed, collisions, most = column(number, style)
        row = {"root mean square speed over g dt": csv_table.figures(speed),
               "collisions per sphere and step": csv_table.figures(collisions),
               "largest number of a sphere in a step": f"{most:.0f}"}
        print(f"{name}: " + "; ".join(f"{what} {value}" for what, value in row.items()), flush=True)
        csv_table.enter_quantities(words.csv, "columns at rest", name, row)


def main():
    words = measuring_program.words(
        __doc__, ("--gases", {"type": int, "default": 40, "help": "at least two"}),
        ("--columns", {"type": int, "nargs": "+", "default": [20, 100, 300], "metavar": "N"}), csv_table.OPTION)
    columns(words)
    gases(words)


if __name__ == "__main__":
    main()
