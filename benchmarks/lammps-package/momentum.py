#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What scheme exact of pair_style gran/hamaker keeps of momentum and angular momentum.

  momentum.py LMP_WITH_PLUGIN_COMMAND PLUGIN [--seeds N] [--csv FILE]

A ball of spheres that turns, falls on its middle and flies apart, so that spheres have several contacts
at once: changes from before the first contact to after the last, over the sum of the spheres' own, the
worst of all seeds; "stops" where the step is not stable.
"""
import numpy

from cohesion_tests import csv_table, measuring_program
from cohesion_tests.lammps_scenes import turning_ball

DIVISIONS = (4, 10, 20, 40)
LIMIT = "unstable, so that they gain energy"
ELASTIC = {}
ROUGH = {"mu": 0.3, "e": 0.9, "A": 5e-19}
CASES = (("8 spheres, elastic", 2, ELASTIC), ("64 spheres, elastic", 4, ELASTIC),
         ("64 spheres, friction 0.3, restitution 0.9, A = 5e-19 J", 4, ROUGH))


def main():
    words = measuring_program.words(__doc__, ("--seeds", {"type": int, "default": 3}), csv_table.OPTION)
    csv_table.require_published(words, seeds=3)

    print("".join(f"{f't_c/{division}':>20s}" for division in DIVISIONS)
          + "\n" + len(DIVISIONS) * "  momentum   angular")
    for name, side, contact in CASES:
        print(name, flush=True)
        for division in DIVISIONS:
            try:
                worst = numpy.max([turning_ball.momentum_change(side, division, seed, **contact)
                                   for seed in range(words.seeds)], axis=0)
                cells = [f"{change:.0e}" for change in worst]
            except RuntimeError as error:
                if LIMIT not in str(error):
                    raise
                cells = ["stops", "stops"]
            print("{:>10s}{:>10s}".format(*cells), end="", flush=True)
            for what, cell in zip(("momentum", "angular momentum"), cells):
                csv_table.enter(words.csv, {"measurement": "momentum in LAMMPS", "case": name, "step": f"t_c/{division}",
                                            "quantity": f"change of {what}"}, value=cell)
        print()


if __name__ == "__main__":
    main()
