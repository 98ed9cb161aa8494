#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Load at which an adhesive contact parts under a slow ramp in LAMMPS, over F_ad, as a table of the steps per contact.

  pull-off-ramp.py LMP_COHESION PLUGIN [--scheme exact|sampled] [--stiffness K ...] [--restitution E ...] [--diameter D ...]
                   [--csv FILE]

Grains of 1500 kg/m3 at a plane, in a cylinder and beside another grain, pulled by a force, by gravity and, at a plane, by
another wall that adheres more strongly; the lag of the ramp is 0.15 % of F_ad. Steps that need more than --steps in a run
are left out (-).
"""
import argparse
import os
from collections import defaultdict

from cohesion_tests import csv_table
from cohesion_tests.lammps_scenes import pull_off
from cohesion_tests.launcher import given_program
from cohesion_tests.theory.slow_ramp import DIVISIONS, Grain


def main():
    words = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    words.add_argument("lmp", type=given_program)
    words.add_argument("plugin", type=given_program)
    words.add_argument("--scheme", choices=("exact", "sampled"), default="exact")
    words.add_argument("--stiffness", type=float, nargs="+", default=[10.0, 50.0, 500.0, 8e4])
    words.add_argument("--restitution", type=float, nargs="+", default=[0.99, 0.9, 0.5, 0.3])
    words.add_argument("--diameter", type=float, nargs="+", default=[10e-6, 75e-6, 1e-3])
    words.add_argument("--partner", choices=pull_off.PARTNERS, nargs="+", default=list(pull_off.PARTNERS))
    words.add_argument("--steps", type=float, default=2e6, help="most steps of a run")
    csv_table.add_to(words)
    words = words.parse_args()
    csv_table.require_published(words, scheme="exact", stiffness=[10.0, 50.0, 500.0], diameter=[75e-6], partner=["plane"],
                                steps=2e6)
    os.environ["COHESION_LMP"], os.environ["COHESION_PLUGIN"] = words.lmp, words.plugin
    loads = {"plane": pull_off.LOADS, "cylinder": ("addforce", "gravity"), "pair": ("addforce",)}
    print(f"{'d [m]':>8} {'K [N/m]':>8} {'e':>5} {'partner':>9} {'load':>9}" + "".join(f"  t_c/{d:<4}" for d in DIVISIONS))
    separations = defaultdict(list)
    for diameter in words.diameter:
        for stiffness in words.stiffness:
            for restitution in words.restitution:
                for partner in words.partner:
                    for load in loads[partner]:
                        grain = Grain(stiffness, restitution, diameter, partner)
                        print(f"{diameter:8g} {stiffness:8g} {restitution:5g} {partner:>9} {load:>9}", end="", flush=True)
                        for division in DIVISIONS:
                            runs = grain.steps(division) <= words.steps
                            found = pull_off.load_at_parting(grain, division, words.scheme, load) if runs else None
                            separations[restitution] += [found] if found else []
                            print("       - " if found is None else f"  {found:7.4f}", end="", flush=True)
                        print()
    for restitution, found in separations.items():
        csv_table.enter_pull_off(words.csv, "LAMMPS", restitution, found)


if __name__ == "__main__":
    main()
