#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Kinetic energy [J] of a bound cluster in the closest packing, displaced by up to 1 nm, after 20 contact times.

  cluster-steps.py LMP_WITH_PLUGIN_COMMAND PLUGIN [--steps N ...] [--csv FILE]

177 spheres of 1 mm bound by A = 1e-17 J; rows: restitution and friction; columns: steps in the contact time of the
undamped spring. "stopped": beyond the stability limit (docs/theory/contact_steps.md), with the largest step that the
message names, in the same unit.
"""
import re

from cohesion_tests import csv_table, lammps as engine, measuring_program
from cohesion_tests.lammps_scenes import cohesive_gas as gas, packed_cluster
from cohesion_tests.progress import Progress

CONTACTS = ((0.9, 0.0), (0.9, 0.3), (0.5, 0.0), (0.5, 0.3), (0.3, 0.0), (0.3, 0.3))
COEFFICIENTS = "stiffness {} restitution {} friction {} hamaker 1e-17 cutoff 4e-10 1e-7"


def cell(folder, restitution, friction, division):
    pull = 1e-17 * gas.DIAMETER / (24 * 4e-10**2)  # F_ad
    text = packed_cluster.script(lattice=2**0.5 * (gas.DIAMETER - pull / gas.STIFFNESS), box=6, radius=2.2,
                                 diameter=gas.DIAMETER, density=gas.DENSITY, dt=gas.CONTACT_TIME / division,
                                 steps=round(20 * division),
                                 coefficients=COEFFICIENTS.format(gas.STIFFNESS, restitution, friction))
    code, output = engine.run_text(text, folder)
    limit = re.search(r"several contacts unstable, .*reduce it to ([^ ,]+),", output)
    if limit:
        return f"stopped {gas.CONTACT_TIME / float(limit[1]):.1f}"
    if code != 0:
        raise RuntimeError(output[-1000:])
    rows = re.findall(r"^ +\d+ +(\S+) +(\S+) *$", output, re.M)
    return f"{sum(float(value) for value in rows[-1]):.0e}"


def enter(file, restitution, friction, division, words):
    """Into contacts.csv."""
    quantity = "required steps per contact" if words[0] == "stopped" else "kinetic energy after 20 t_c [J]"
    csv_table.enter(file, {"measurement": "cluster of 177 spheres at rest",
                           "case": f"restitution {restitution:g}, friction {friction:g}", "step": f"t_c/{division:g}",
                           "quantity": quantity}, value=words[-1])


def main():
    words = measuring_program.words(
        __doc__, ("--steps", {"type": float, "nargs": "+", "default": [3.3, 4, 5, 6, 8, 10, 12], "metavar": "N",
                              "help": "steps in a contact time"}), csv_table.OPTION)
    progress = Progress(len(CONTACTS) * sum(words.steps))
    print("restitution  friction" + "".join(f"{f't_c/{n:g}':>14s}" for n in words.steps))
    with engine.temporary_folder() as folder:
        for restitution, friction in CONTACTS:
            cells = []
            for division in words.steps:
                cells.append(f"{cell(folder, restitution, friction, division):>14s}")
                enter(words.csv, restitution, friction, division, cells[-1].split())
                progress.add(division)
            print(f"\r{restitution:11g}{friction:10g}" + "".join(cells), flush=True)


if __name__ == "__main__":
    main()
