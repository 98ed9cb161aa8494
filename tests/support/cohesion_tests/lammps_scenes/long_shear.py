# SPDX-License-Identifier: BSD-3-Clause
"""Sheared discs over very many steps (in.shear_long): what shear-long.py and its test share.

Discs of mass and diameter 1 with a square well, at area fraction 0.3, rate 1, on one rank, on two, and
continued from the middle by two ranks and by one. What must come out: the same events, bit for bit; no
disc lost; momentum that only rounding moves; a linear profile."""
import hashlib
import math
import shutil
from collections import namedtuple
from pathlib import Path

import numpy

from cohesion_tests import dumps, lammps as engine
from cohesion_tests.lammps_scenes import hard_spheres as hard
from cohesion_tests.theory import sheared_discs as theory
from cohesion_tests.thermo import loop_seconds, thermo_columns

FRACTION, RESTITUTION, LAYERS = 0.3, 0.9, 8

# events: SHA-256 of the lines after the middle, count: how many, where events are written; end: the final positions
# and velocities.
Done = namedtuple("Done", "name seconds table profile events count end")


def length(side):
    return side * math.sqrt(math.pi / 4 / FRACTION)


def write_start(folder, side):
    """On a square lattice, with the profile, the speeds that kinetic theory has without the well."""
    random = numpy.random.default_rng(11)
    box, count = length(side), side**2
    places = (numpy.array(numpy.meshgrid(range(side), range(side))).reshape(2, -1).T + 0.5) * box / side
    v = numpy.zeros((count, 3))
    v[:, :2] = random.normal(0, math.sqrt(theory.steady(FRACTION, RESTITUTION).temperature), (count, 2))
    # Ranks would add the momentum up in another order: the profile is laid here.
    v[:, 0] += places[:, 1] - box / 2
    v -= v.mean(axis=0)
    atoms = [hard.atom((x, y, 0.0), w) for (x, y), w in zip(places, v)]
    engine.write_spheres(folder, atoms, [(0.0, box), (0.0, box), (-0.5, 0.5)], 1, tilt=(0.0, 0.0, 0.0))


def run(name, folder, ranks, start, steps, strain, samples, step_done, lines_from, variables):
    """Runs to step `steps`; keeps a restart file of the middle. Calls step_done(steps) on the way.
    `lines_from`: the first step whose events count for the comparison; `variables`: more of the script's."""
    last = 0 if start == "data" else steps // 2

    def each_line(line):
        nonlocal last
        words = line.split()
        if len(words) >= 6 and words[1].isdigit() and words[0].isdigit() and int(words[0]) > last:
            step_done(int(words[0]) - last)
            last = int(words[0])

    code, output = engine.start("in.shear_long", folder, ranks=ranks, each_line=each_line, start=start,
                                dt=strain / steps, end=steps, every=steps // samples, keep=steps // 2, **variables)
    if code != 0:
        raise RuntimeError(f"{name} ended with code {code}:\n{output[-3000:]}")
    digest, count, events = hashlib.sha256(), 0, Path(folder) / "events.txt"
    if events.exists():
        with open(events, "rb") as file:
            for line in file:
                if int(line.split(None, 1)[0]) >= lines_from:
                    digest.update(line)
                    count += 1
    end = dumps.read(Path(folder) / "end.txt")[-1].table
    return Done(name, loop_seconds(output, 0), thermo_columns(output), layers(folder), digest.hexdigest()[:12], count, end)


def layers(folder):
    """Array (samples, layers, 2): height, velocity."""
    rows = [line.split() for line in (Path(folder) / "layers.txt").read_text().splitlines()
            if not line.startswith("#")]
    rows = [[float(word) for word in row[1:3]] for row in rows if len(row) == 4]
    return numpy.array(rows).reshape(-1, LAYERS, 2)


def all_runs(folder, side, steps, strain, samples, step_done, write=write_start, **variables):
    """One rank, two, and two and one from the restart file of the middle. `write`: what writes data.spheres, of
    folder and side; `variables`: more of the script's."""
    if steps % (10 * samples) or samples % 2:
        raise ValueError(f"{steps} steps, {samples} samples of the mean of ten, one at the middle")
    done = []
    for name, ranks, start in (("1 rank", 1, "data"), ("2 ranks", 2, "data"),
                               ("restart on 2 ranks", 2, "1 rank"),
                               ("restart on 1 rank", 1, "2 ranks")):
        here = Path(folder) / name
        here.mkdir()
        if start == "data":
            write(here, side)
        else:
            shutil.copy(Path(folder) / start / f"middle.{steps // 2}.restart", here / "half.restart")
            start = "restart"
        done.append(run(name, here, ranks, start, steps, strain, samples, step_done, steps // 2 + 1,
                        variables))
    return done


def momentum_room(events, count):
    """Largest momentum per component that rounding leaves, at five standard deviations: each event and
    each passage through a sheared face rounds velocities of up to the box's own, 16 or so, by 2^-53 of
    it. A disc passes less often than it meets others."""
    return 5 * math.sqrt(2 * events + count) * 16 * 2.0**-53


def crooked(profile, box):
    """The largest deviation of a layer's mean velocity from the line of rate 1, in standard errors of
    the mean, and that standard error, from ten blocks. The first fifth is left out. (Waves of the flow
    live for (box/2 pi)^2/viscosity, a strain of about 4 in a box of 13.)"""
    kept = profile[len(profile) // 5:]
    kept = kept[len(kept) % 10:]
    away = kept[:, :, 1] - (kept[:, :, 0] - box / 2)
    blocks = away.reshape(10, -1, LAYERS).mean(axis=1)
    error = blocks.std(axis=0, ddof=1) / math.sqrt(len(blocks))
    return abs(blocks.mean(axis=0) / error).max(), error.max()
