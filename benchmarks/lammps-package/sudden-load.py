#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Largest load that an adhesive contact at rest holds in LAMMPS when all of it acts at once, over F_ad, as a table of the
restitution and of the steps per contact.

  sudden-load.py LMP_COHESION PLUGIN [--stiffness K] [--restitution E ...] [--division N ...]

A grain of 75 um and 1500 kg/m3 at a plane begins at the overlap F_ad/K. Under a load L its lowest overlap is
(1 - L - e L) F_ad/K, so that it holds below 1/(1 + e). Bisection to 0.002.
"""
import argparse
import os

from cohesion_tests import lammps
from cohesion_tests.lammps_scenes import pull_off
from cohesion_tests.launcher import given_program
from cohesion_tests.theory.slow_ramp import Grain

CONTACT_TIMES = 50


def holds(grain, division, load):
    text = pull_off.script(grain, division, "exact", "addforce")
    ramp = next(line for line in text.splitlines() if line.startswith("variable down"))
    head = text.replace(ramp, f"variable down equal {-load * grain.force!r}").rpartition("run ")[0]
    with lammps.temporary_folder() as folder:
        code, output = lammps.run_text(f"{head}run {CONTACT_TIMES * division}\nprint \"ENDED $(v_gap)\"\n", folder)
    if code != 0:
        raise RuntimeError(output[-3000:])
    return float(output.rpartition("ENDED ")[2].split()[0]) < grain.overlap_at_rest


def largest_load(grain, division):
    low, high = 0.0, 1.05
    while high - low > 0.002:
        load = 0.5 * (low + high)
        low, high = (load, high) if holds(grain, division, load) else (low, load)
    return low


def main():
    words = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    words.add_argument("lmp", type=given_program)
    words.add_argument("plugin", type=given_program)
    words.add_argument("--stiffness", type=float, default=50.0)
    words.add_argument("--restitution", type=float, nargs="+", default=[0.9, 0.5, 0.3, 0.1])
    words.add_argument("--division", type=int, nargs="+", default=[5, 10, 20, 100])
    words = words.parse_args()
    os.environ["COHESION_LMP"], os.environ["COHESION_PLUGIN"] = words.lmp, words.plugin
    print(f"{'e':>5} {'1/(1+e)':>8}" + "".join(f"  t_c/{d:<4}" for d in words.division))
    for e in words.restitution:
        grain = Grain(words.stiffness, e)
        print(f"{e:5g} {1 / (1 + e):8.3f}", end="", flush=True)
        for division in words.division:
            print(f"  {largest_load(grain, division):7.3f}", end="", flush=True)
        print()


if __name__ == "__main__":
    main()
