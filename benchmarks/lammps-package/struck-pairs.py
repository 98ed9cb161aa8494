#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A pair that sticks, struck by a third sphere: error of Hamaker adhesion against the step.

  struck-pairs.py LMP_WITH_PLUGIN_COMMAND PLUGIN [--scheme exact|sampled] [--finest N]
  struck-pairs.py LIGGGHTS_COHESION [--scheme exact|sampled] [--finest N]

Sampled, and in LIGGGHTS, as in in.head_on: without friction, of which the engines have different laws.

100 triples (triples.py) against t_c/N, 1000 unless said otherwise, after 30 t_c. Printed: how many end
otherwise (which spheres stick), and, of the others, the root mean square of the error of the velocities over the
speed of the third sphere.
"""
import numpy

from cohesion_tests import lammps as engine, measuring_program
from cohesion_tests.lammps_scenes import triples

DIVISIONS = {"exact": (5, 10, 20, 40), "sampled": (4, 10, 20, 50, 200, 1000)}


def main():
    words = measuring_program.words(
        __doc__, ("--scheme", {"choices": tuple(DIVISIONS), "default": "exact"}),
        ("--finest", {"type": int, "default": 1000}), liggghts=True)
    scheme = words.scheme

    with engine.temporary_folder() as folder:
        triples.write(folder)
        for friction in (0.0, 0.3) if scheme == "exact" and words.plugin else (0.0,):
            exact, stuck, _ = triples.outcome(folder, words.finest, friction, scheme)
            print(f"friction {friction:g}")
            for division in DIVISIONS[scheme]:
                velocities, sticks, _ = triples.outcome(folder, division, friction, scheme)
                same = (sticks == stuck).all(axis=0)
                error = numpy.linalg.norm(velocities - exact, axis=2) / triples.SPEEDS[:, None]
                print(f"  t_c/{division:<4d} other outcome {(~same).sum():3d}   root mean square "
                      f"{numpy.sqrt((error[same]**2).mean()):.2g}", flush=True)


if __name__ == "__main__":
    main()
