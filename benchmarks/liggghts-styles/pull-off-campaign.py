#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Load at which an adhesive contact parts under a slow ramp in LIGGGHTS, over F_ad, as a table of the steps per contact.

  pull-off-campaign.py LIGGGHTS_COHESION [--scheme exact|sampled] [--stiffness K ...] [--restitution E ...] [--diameter D ...]
                       [--csv FILE]

Grains of 1500 kg/m3 under a plate, in a cylinder, below another grain and under a mesh, pulled by gravity, a force or,
those under a plate, by a second plate of triangles that moves away; the lag of the ramp is 0.15 % of F_ad. Left out (-)
are steps that need more than --steps in a run, and grains below 20 um at triangles, which the engine refuses as too small.
"""
import argparse
import os
from collections import defaultdict

from cohesion_tests import csv_table
from cohesion_tests.launcher import given_program
from cohesion_tests.liggghts_scenes.pull_off import LOADS, PARTNERS, Grain
from cohesion_tests.theory.slow_ramp import DIVISIONS

SMALLEST_ON_MESHES = 20e-6  # [m]


def main():
    words = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    words.add_argument("launcher", type=given_program)
    words.add_argument("--scheme", choices=("exact", "sampled"), default="exact")
    words.add_argument("--stiffness", type=float, nargs="+", default=[10.0, 50.0, 500.0, 8e4])
    words.add_argument("--restitution", type=float, nargs="+", default=[0.99, 0.9, 0.5, 0.3])
    words.add_argument("--diameter", type=float, nargs="+", default=[10e-6, 75e-6, 1e-3])
    words.add_argument("--partner", choices=PARTNERS, nargs="+", default=list(PARTNERS))
    words.add_argument("--steps", type=float, default=2e6, help="most steps of a run")
    csv_table.add_to(words)
    words = words.parse_args()
    csv_table.require_published(words, scheme="exact", stiffness=[10.0, 50.0, 500.0], diameter=[75e-6], partner=["plane"],
                                steps=2e6)
    loads = {"plane": LOADS, "pair": ("addforce",)}
    os.environ["COHESION_LAUNCHER"] = words.launcher
    print(f"{'d [m]':>8} {'K [N/m]':>8} {'e':>5} {'partner':>9} {'load':>9}" + "".join(f"  t_c/{d:<4}" for d in DIVISIONS))
    separations = defaultdict(list)
    for diameter in words.diameter:
        for stiffness in words.stiffness:
            for restitution in words.restitution:
                for partner in words.partner:
                    for load in loads.get(partner, ("addforce", "gravity")):
                        grain = Grain(stiffness, restitution, diameter, partner)
                        print(f"{diameter:8g} {stiffness:8g} {restitution:5g} {partner:>9} {load:>9}", end="", flush=True)
                        meshes = partner == "mesh" or load == "wall"
                        for division in DIVISIONS:
                            runs = grain.steps(division) <= words.steps and not (meshes and diameter < SMALLEST_ON_MESHES)
                            found = grain.load_at_parting(division, words.scheme, load) if runs else None
                            separations[restitution] += [found] if found else []
                            print("       - " if found is None else f"  {found:7.4f}", end="", flush=True)
                        print()
    for restitution, found in separations.items():
        csv_table.enter_pull_off(words.csv, "LIGGGHTS", restitution, found)


if __name__ == "__main__":
    main()
