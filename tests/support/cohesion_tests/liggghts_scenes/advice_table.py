# SPDX-License-Identifier: BSD-3-Clause
"""Runs of two spheres that are there to print the table before their first step, and the numbers of that."""
import math

from cohesion_tests.liggghts import Run
from cohesion_tests.liggghts_scenes.scene import script, sphere

A, CUT, OUT = 7.49e-19, 4e-10, 1e-7
SPEED, DT = 0.1, 1e-6
LINEAR = "model hooke/stiffness tangential off cohesion hamaker"
ABSOLUTE = " absolute_damping on"
FLOOR = "primitive type 2 zplane -5e-3"
# Three significant digits are printed, of overlaps two.
THREE, TWO = 0.006, 0.06


def rows(run):
    """Name of contact -> its numbers, of all tables printed."""
    found = {}
    for line in run.output.split("\n"):
        words = line.split()
        if len(words) >= 11 and words[1:2] == ["-"]:
            found[" ".join(words[:-8])] = dict(zip(
                ("speed", "steps", "cutoff", "static", "impact", "bond", "escape", "ratio"),
                (math.nan if w == "none" else float(w) for w in words[-8:])))
    return found


def go(models, properties, spheres=None, **options):
    options.setdefault("dt", DT)
    return Run(script(spheres or [sphere((0, 0, 0), (SPEED, 0, 0)), sphere((3e-3, 0, 0))], models, properties,
                      **options))
