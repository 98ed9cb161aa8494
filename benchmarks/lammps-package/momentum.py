#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What scheme exact of pair_style gran/hamaker keeps of momentum and angular momentum.

  momentum.py LMP_WITH_PLUGIN_COMMAND PLUGIN [--seeds N]

A ball of spheres that turns, falls on its middle and flies apart, so that spheres have several contacts
at once: changes from before the first contact to after the last, over the sum of the spheres' own, the
worst of all seeds. "stops": the step is beyond the stability limit (docs/theory/contact_steps.md).
"""
import numpy

from cohesion_tests import measuring_program
from cohesion_tests.lammps_scenes import turning_ball

DIVISIONS = (4, 10, 20, 40)
ELASTIC = {}
ROUGH = {"mu": 0.3, "e": 0.9, "A": 5e-19}
CASES = (("8 spheres, elastic", 2, ELASTIC), ("64 spheres, elastic", 4, ELASTIC),
         ("64 spheres, friction 0.3, restitution 0.9, A = 5e-19 J", 4, ROUGH))


def main():
    words = measuring_program.words(__doc__, ("--seeds", {"type": int, "default": 3}))

    print("".join(f"{f't_c/{division}':>20s}" for division in DIVISIONS)
          + "\n" + len(DIVISIONS) * "  momentum   angular")
    for name, side, contact in CASES:
        print(name, flush=True)
        for division in DIVISIONS:
            try:
                worst = numpy.max([turning_ball.momentum_change(side, division, seed, **contact)
                                   for seed in range(words.seeds)], axis=0)
            except RuntimeError as error:
                if "several contacts unstable" not in str(error):
                    raise
                print(f"{'stops':>20s}", end="", flush=True)
                continue
            print("{:10.0e}{:10.0e}".format(*worst), end="", flush=True)
        print()


if __name__ == "__main__":
    main()
