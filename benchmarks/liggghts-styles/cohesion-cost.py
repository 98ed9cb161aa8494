#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What a cohesion costs per contact and step, against the engine's own `cohesion sjkr`, in one run.

  cohesion-cost.py LAUNCHER [--turns N] [--cells N] [--steps N]
  cohesion-cost.py LAUNCHER --count [--cells N] [--steps N] [--csv FILE]
                                                   instructions, with and without energy tally

Spheres at rest on the sites of a periodic fcc lattice, each in contact with twelve others; and the same with
the contacts opened to gaps within the range of the attraction. Runs take turns; times are those of the
processor, less those of the same script without steps; each turn gives one ratio to sjkr. Printed are medians, of
the ratio the quarter and three quarter points, too. `own`: more than without cohesion.
"""
import argparse
import os
import pathlib
import resource
import statistics
import tempfile

from cohesion_tests import csv_table, launcher
from cohesion_tests.instruction_count import per_step
from cohesion_tests.liggghts_scenes.scene import contact, hamaker, liquid_bridge, square_well
from cohesion_tests.spread import spread

COHESION = {
    "none": ("", ""),
    "sjkr": (" cohesion sjkr", "fix k all property/global cohesionEnergyDensity peratomtypepair 2 "
             "1e4 1e4 1e4 1e4\n"),
    "hamaker": (" cohesion hamaker scheme sampled", hamaker(1e-14)),
    "square_well": (" cohesion square_well scheme sampled", square_well(1e-11, ratio=1.02)),
    "liquid_bridge": (" cohesion liquid_bridge scheme sampled", liquid_bridge(1e-6, 2e-5))}
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
{tally}fix move all nve/sphere
timestep 1e-7
thermo 1000000
run {steps}
"""


def seconds(program, cohesion, distance, cells, steps):
    words, properties = COHESION[cohesion]
    text = SCRIPT.format(lattice=distance * 2**0.5, cells=cells, steps=steps, cohesion=words, tally="",
                         properties=contact() + properties)
    with tempfile.TemporaryDirectory() as folder:
        (pathlib.Path(folder) / "in.script").write_text(text)
        before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
        ended = launcher.run(launcher.command(program, "in.script"), folder, timeout=None)
    if ended.code:
        raise SystemExit(ended.output)
    return resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before


def counted(program, cohesion, distance, cells, steps, tally):
    """Instructions of one step."""
    os.environ.update(COHESION_LMP=program, OMP_NUM_THREADS="1")
    words, properties = COHESION[cohesion]
    with tempfile.TemporaryDirectory() as folder:
        script = pathlib.Path(folder) / "in.script"
        script.write_text(SCRIPT.format(
            lattice=distance * 2**0.5, cells=cells, steps="${steps}", cohesion=words, properties=contact() + properties,
            tally="compute tally all gran/energy\n" if tally else ""))
        return per_step(script, folder, steps)


def count(program, contacts, distance, cells, steps):
    """Prints, and gives {cohesion: instructions per pair and step}."""
    print(f"{'':24}instructions per pair and step")
    found = {}
    for name in COHESION:
        found[name] = counted(program, name, distance, cells, steps, False) / contacts
        print(f"{name:24}{found[name]:10.1f}", flush=True)
        if name in ("hamaker", "square_well"):
            print(f"{name + ', tally':24}{counted(program, name, distance, cells, steps, True) / contacts:10.1f}",
                  flush=True)
    return found


def enter(file, scene, found):
    """Into contact_costs.csv; the reference is sjkr, which has no force across a gap."""
    touching = scene == "pair in contact"
    for name, instructions in found.items():
        row = {"engine": "LIGGGHTS", "scene": scene, "style": f"cohesion {name}", "reference": "sjkr" * touching}
        over = {"instructions of the reference": f"{found['sjkr']:.1f}", "ratio": f"{instructions / found['sjkr']:.2f}"}
        csv_table.enter(file, row, **{name: value * touching for name, value in over.items()},
                        instructions=f"{instructions:.1f}")


def main():
    words = argparse.ArgumentParser(description=__doc__,
                                    formatter_class=argparse.RawDescriptionHelpFormatter)
    words.add_argument("launcher", type=launcher.given_program)
    words.add_argument("--turns", type=int, default=7)
    words.add_argument("--count", action="store_true", help="instructions in place of times; wants valgrind")
    words.add_argument("--cells", type=int, default=12)
    words.add_argument("--steps", type=int, default=200)
    csv_table.add_to(words)
    words = words.parse_args()
    if words.csv and not words.count:
        raise SystemExit("--csv: with --count")
    contacts = 4 * words.cells**3 * 6
    places = (("in contact", "pair in contact", 0.9995e-3), ("at a gap of 0.005 d", "pair across a gap", 1.005e-3))
    for place, scene, distance in places:
        print(f"{4 * words.cells**3} spheres, {contacts} pairs {place}, {words.steps} steps")
        if words.count:
            enter(words.csv, scene, count(words.launcher, contacts, distance, words.cells, words.steps))
            continue
        times = {name: [] for name in COHESION}
        for turn in range(words.turns):
            for name in list(COHESION) if turn % 2 == 0 else list(COHESION)[::-1]:
                start, end = (seconds(words.launcher, name, distance, words.cells, steps)
                              for steps in (0, words.steps))
                times[name].append((end - start) / (contacts * words.steps) * 1e9)
        print(f"{'':14}{'ns/pair/step':>13}{'own':>8}   over sjkr")
        for name, spent in times.items():
            own = statistics.median(a - b for a, b in zip(spent, times["none"]))
            ratio = spread(a / b for a, b in zip(spent, times["sjkr"]))
            print(f"{name:14}{statistics.median(spent):13.2f}{own:8.2f}   {ratio}", flush=True)


if __name__ == "__main__":
    main()
