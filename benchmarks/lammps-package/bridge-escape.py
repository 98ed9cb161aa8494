#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Speeds over the exact escape velocity at which spheres with a liquid bridge part or stick head-on with scheme sampled,
against the time step.

  bridge-escape.py LMP_WITH_PLUGIN_COMMAND PLUGIN [--divisions N ...] [--csv FILE]

Three bridges; pairs of graded speed approach with the touch at eight positions within the step. Printed for each number of
steps in a contact time: the slowest pair that parted and the fastest that stayed."""
import numpy

from cohesion_tests import csv_table, measuring_program
from cohesion_tests.lammps_scenes import couples
from cohesion_tests.progress import Progress
from cohesion_tests.theory.liquid_bridge import escape_velocity
from cohesion_tests.theory.pair_motion import CONTACT_TIME, DAMPING, DIAMETER, STIFFNESS

BRIDGES = {(1e-5, 1e-5): "1e-5 N, 0.01 mm", (1e-4, 5e-5): "1e-4 N, 0.05 mm", (1e-3, 2e-6): "1e-3 N, 0.002 mm"}  # F_b, h_r
POSITIONS = 8
FACTORS = numpy.delete(numpy.round(numpy.arange(0.7, 1.301, 0.01), 2), 30)  # without 1, which rounding decides
TABLES = "sampled: slowest escape over v_esc", "sampled: fastest capture over v_esc"


def limits(division):
    """For each bridge the smallest factor of the escape velocity with a pair that parted and the largest with one that
    stayed."""
    dt, atoms = CONTACT_TIME / division, []
    for kind, bridge in enumerate(BRIDGES, 1):
        for factor in FACTORS:
            speed = factor * escape_velocity(*bridge)
            for position in range(POSITIONS):
                atoms += couples.couple(len(atoms) // 2, 1e-7 + speed * dt * position / POSITIONS, (0.0, speed, 0.0),
                                        types=(kind, kind))
    coefficients = [f"{kind} {kind} stiffness {STIFFNESS:.17g} damping {DAMPING:.17g} bridge {force:.17g} {gap:.17g}"
                    for kind, (force, gap) in enumerate(BRIDGES, 1)]
    # As in tests/lammps-package/gran_liquid_bridge_test.py: up the bridge and back takes less than 60 contact times.
    path = couples.run(atoms, coefficients, dt, 120 * division, types=len(BRIDGES), skin=4e-4, every=12 * division,
                       style="gran/liquidbridge scheme sampled")[0]
    late = path[len(path) // 2:]
    gaps = numpy.linalg.norm(late[:, :, 1, :3] - late[:, :, 0, :3], axis=-1) - DIAMETER
    widths = numpy.repeat([gap for _, gap in BRIDGES], len(FACTORS) * POSITIONS)
    parted = (gaps > widths + 1e-9).all(axis=0).reshape(len(BRIDGES), len(FACTORS), POSITIONS)
    return [(FACTORS[own.any(axis=1)].min(), FACTORS[~own.all(axis=1)].max()) for own in parted]


def main():
    words = measuring_program.words(
        __doc__, ("--divisions", {"type": int, "nargs": "+", "default": [4, 10, 50, 200], "metavar": "N"}),
        csv_table.OPTION)
    progress = Progress(sum(words.divisions))
    for division in words.divisions:
        for bridge, (slowest, fastest) in zip(BRIDGES, limits(division)):
            print(f"\rt_c/{division}, {BRIDGES[bridge]}: slowest escape {slowest:.2f}, fastest capture {fastest:.2f}",
                  flush=True)
            for table, factor in zip(TABLES, (slowest, fastest)):
                csv_table.enter_quantities(words.csv, table, f"{BRIDGES[bridge]} ({escape_velocity(*bridge):.3g} m/s)",
                                           {f"t_c/{division}": f"{factor:.2f}"})
        progress.add(division)


if __name__ == "__main__":
    main()
