#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What a cohesion costs per contact and step, against the engine's own `cohesion sjkr`, in one run.

  cohesion-cost.py LAUNCHER [--turns N] [--cells N] [--steps N]

Spheres at rest on the sites of a periodic fcc lattice, each in contact with twelve others; and the same with
the contacts opened to gaps within the range of the attraction. Runs take turns; times are those of the
processor, less those of the same script without steps; each turn gives one ratio to sjkr, and printed are
medians. `own`: more than without cohesion.
"""
import argparse
import os
import resource
import statistics
import subprocess
import tempfile

from scene import contact, hamaker, square_well

COHESION = {
    "none": ("", ""),
    "sjkr": (" cohesion sjkr", "fix k all property/global cohesionEnergyDensity peratomtypepair 2 "
             "1e4 1e4 1e4 1e4\n"),
    "hamaker": (" cohesion hamaker", hamaker(1e-14)),
    "square_well": (" cohesion square_well", square_well(1e-11, ratio=1.02))}
SCRIPT = """units si
atom_style granular
atom_modify map array
boundary p p p
newton off
communicate single vel yes
lattice fcc {lattice!r}
region box block 0 {cells} 0 {cells} 0 {cells} units lattice
create_box 2 box
neighbor 5e-5 bin
neigh_modify delay 0
create_atoms 1 box
set group all diameter 1e-3 density 2650
{properties}pair_style gran model hertz tangential history{cohesion}
pair_coeff * *
fix move all nve/sphere
timestep 1e-7
thermo 1000000
run {steps}
"""


def seconds(launcher, cohesion, distance, cells, steps):
    words, properties = COHESION[cohesion]
    text = SCRIPT.format(lattice=distance * 2**0.5, cells=cells, steps=steps, cohesion=words,
                         properties=contact() + properties)
    with tempfile.TemporaryDirectory() as folder:
        before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
        done = subprocess.run([launcher, "-in", "/dev/stdin"], input=text, cwd=folder, text=True,
                              errors="replace", stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              env={**os.environ, "OMP_NUM_THREADS": "1"})
    if done.returncode:
        raise SystemExit(done.stdout)
    return resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before


def main():
    words = argparse.ArgumentParser(description=__doc__,
                                    formatter_class=argparse.RawDescriptionHelpFormatter)
    words.add_argument("launcher")
    words.add_argument("--turns", type=int, default=7)
    words.add_argument("--cells", type=int, default=12)
    words.add_argument("--steps", type=int, default=200)
    words = words.parse_args()
    contacts = 4 * words.cells**3 * 6
    for place, distance in (("in contact", 0.9995e-3), ("at a gap of 0.005 d", 1.005e-3)):
        print(f"{4 * words.cells**3} spheres, {contacts} pairs {place}, {words.steps} steps")
        times = {name: [] for name in COHESION}
        for turn in range(words.turns):
            for name in list(COHESION) if turn % 2 == 0 else list(COHESION)[::-1]:
                start, end = (seconds(words.launcher, name, distance, words.cells, steps)
                              for steps in (0, words.steps))
                times[name].append((end - start) / (contacts * words.steps) * 1e9)
        print(f"{'':14}{'ns/pair/step':>13}{'own':>8}{'over sjkr':>11}")
        for name, spent in times.items():
            own = statistics.median(a - b for a, b in zip(spent, times["none"]))
            ratio = statistics.median(a / b for a, b in zip(spent, times["sjkr"]))
            print(f"{name:14}{statistics.median(spent):13.2f}{own:8.2f}{ratio:11.3f}", flush=True)


if __name__ == "__main__":
    main()
