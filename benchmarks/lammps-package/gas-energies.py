#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Energy balance of gases of 1000 spheres with linear springs against the time step.

  gas-energies.py LMP_WITH_PLUGIN_COMMAND PLUGIN [--csv FILE] [--steps N ...]
  gas-energies.py LIGGGHTS_COHESION [--csv FILE] [--steps N ...] [--scheme exact|sampled]

Elastic gases have 100 collisions per particle (Enskog's rate of the start), others 20. At t_c/10 elastic gases also
have 1000, except for the dilute cohesive one. The error is entry 10 of compute gran/energy, the largest of 50 samples.
The column `over` names what divides it: the kinetic energy of the start, or the dissipated energy. `lost` is the
dissipated energy over the kinetic energy of the start, at t_c/10. Runs at t_c/5 are those that are unstable at t_c/4;
`unstable`: the engine stops with the largest stable step. A star on the output marks an error above the expected one.

--csv: what is measured replaces the cells of the same gas in FILE, as soon as it is there. --steps: measures only these
of 4, 5, 10 and 20 steps per contact time; 5 where 4 is unstable or not among them.
"""
import csv
import os
import sys
import time
from pathlib import Path

from cohesion_tests import lammps as engine, measuring_program
from cohesion_tests.lammps_scenes import cohesive_gas
from cohesion_tests.liggghts_scenes.elastic_gas import tallied_gas
from cohesion_tests.progress import Progress

GASES = ((0.1, 0.0, 0.1), (0.5, 0.0, 0.1), (0.5, 2e-18, 0.02), (0.1, 2e-18, 0.02))  # fraction, A [J], speed [m/s]
RESTITUTIONS, FRICTIONS = (1.0, 1 - 1e-7, 0.99, 0.9, 0.5), (0.0, 0.3)
STEPS = (4, 5, 10, 20)  # per contact time
KINETIC, LOST = "kinetic energy", "dissipated energy"
EXPECTED = {(KINETIC, 100): 5e-5, (KINETIC, 1000): 4e-4, (LOST, 20): 1e-3}  # at t_c/10
CASE = ("engine", "scheme", "solid fraction", "A [J]", "restitution", "friction", "collisions")
COLUMNS = (*CASE, "over", "lost", *(f"t_c/{n}" for n in STEPS))
LIMIT = "unstable, so that they gain energy"


def elastic(restitution, friction):
    return restitution > 0.999 and friction == 0.0


def cases(scheme, steps):
    """Gas, restitution, friction, collisions per particle and steps per contact time of each row."""
    if scheme == "sampled":
        return [(gas, 1.0, 0.0, 100, steps) for gas in GASES]
    rows = []
    for gas in GASES:
        rows += [(gas, restitution, friction, 100 if elastic(restitution, friction) else 20, steps)
                 for friction in FRICTIONS for restitution in RESTITUTIONS]
        rows += [(gas, 1.0, 0.0, 1000, (10,))] * (gas != GASES[-1] and 10 in steps)
    return rows


def samples(words, gas, restitution, friction, division, duration):
    """Total energy, error of the balance and kinetic energy at each sample; none where the step is not stable."""
    fraction, constant, speed = gas
    if words.plugin is None:
        rows = tallied_gas(words.side, fraction, constant, speed, restitution, friction, scheme=words.scheme,
                           dt=cohesive_gas.CONTACT_TIME / division, duration=duration, samples=50)
        return [(row[1], row[11], row[2] + row[3]) for row in rows]
    with engine.temporary_folder() as folder:
        cohesive_gas.write(folder, words.side, fraction, speed, seed=4711)
        try:
            table, _ = cohesive_gas.follow(folder, division, duration, A=constant, e=restitution, mu=friction)
        except RuntimeError as error:
            if LIMIT in str(error):
                return []
            raise
    return table[:, 1:4]


def measure(words, gas, restitution, friction, collisions, steps):
    """Cells of COLUMNS behind those of CASE."""
    duration = collisions / cohesive_gas.collision_rate(gas[0], gas[2])
    cells, lost, over = {}, 0.0, KINETIC if elastic(restitution, friction) else LOST
    for division in steps:
        if division == 5 and cells.get(4, "unstable") != "unstable":
            continue
        rows = samples(words, gas, restitution, friction, division, duration)
        if len(rows) == 0:
            cells[division] = "unstable"
            continue
        start, part = rows[0][2], (rows[0][0] - rows[-1][0]) / rows[0][2]
        lost = part if division == 10 else lost
        error = max(abs(row[1]) for row in rows) / start
        cells[division] = f"{error / (1.0 if over == KINETIC else part):.1e}"
    return [over, f"{lost:.3f}" if lost and over == LOST else "", *(cells.get(n, "") for n in STEPS)]


def star(row):
    most = EXPECTED.get((row["over"], int(row["collisions"])))
    cell = row["t_c/10"]
    return "*" if most and cell and (cell == "unstable" or float(cell) > most) else ""


def put(file, row):
    """Puts the cells of the row into that of the same case in the .csv file, or a new row at the end."""
    rows = list(csv.DictReader(file.open(newline=""))) if file.exists() else []
    same = [other for other in rows if all(other[k] == row[k] for k in CASE)]
    if same:
        same[0].update({name: cell for name, cell in row.items() if cell})
    else:
        rows.append(row)
    with file.open("w", newline="") as opened:
        writer = csv.DictWriter(opened, COLUMNS, lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


def main():
    words = measuring_program.words(
        __doc__, ("--csv", {"type": Path, "metavar": "FILE"}),
        ("--scheme", {"choices": ("exact", "sampled"), "default": "exact", "help": "sampled: elastic gases"}),
        ("--steps", {"type": int, "nargs": "+", "choices": STEPS, "default": STEPS, "metavar": "N"}),
        ("--side", {"type": int, "default": 10, "metavar": "N", "help": "spheres per edge of the box"}), liggghts=True)
    if words.plugin and words.scheme == "sampled":
        sys.exit("--scheme sampled: of LIGGGHTS only")
    os.environ["COHESION_LAUNCHER"] = words.lmp
    name = "LAMMPS" if words.plugin else "LIGGGHTS"
    rows = cases(words.scheme, sorted(words.steps))
    work = [n / cohesive_gas.collision_rate(gas[0], gas[2]) * sum(steps) for gas, _, _, n, steps in rows]
    progress = Progress(sum(work))
    begin = time.perf_counter()
    print(*COLUMNS, sep=",")
    for (gas, restitution, friction, collisions, steps), part in zip(rows, work):
        key = (name, words.scheme, *(f"{number:.10g}" for number in (*gas[:2], restitution, friction)), str(collisions))
        row = dict(zip(COLUMNS, (*key, *measure(words, gas, restitution, friction, collisions, steps))))
        print("\r" + ",".join(row.values()) + star(row), flush=True)
        if words.csv:
            put(words.csv, row)
        progress.add(part)
    print(f"\r{time.perf_counter() - begin:.0f} s, {sum(os.times()[:4]):.0f} s of processor time")


if __name__ == "__main__":
    main()
