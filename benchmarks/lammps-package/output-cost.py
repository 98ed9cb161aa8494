#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What the outputs of sheared runs cost: instructions per particle and step, with and without each.

  output-cost.py LMP_WITH_PLUGIN_COMMAND PLUGIN [--steps N] [--scene soft|hard] [--csv FILE]

A dense sheared gas of 864 spheres of gran/hamaker, and one of 900 discs of hard/squarewell, each made once.
From there every output runs for N and 2 N steps; the difference of both counts is free of the start.
Valgrind counts, so the numbers do not depend on what else the machine does; one rank.
`not read` is an output that nothing asks for: the totals of gran/stress and hard/stress are summed all the
same.
"""
import shutil
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from cohesion_tests import csv_table, lammps as engine, measuring_program
from cohesion_tests.instruction_count import per_step
from cohesion_tests.progress import Progress

EVERY_STEP = "fix out all ave/time 1 10 10 c_out[*] mode vector file out.txt\n"
VECTOR = EVERY_STEP.replace(" mode vector", "")
PROFILE = "compute out all shear/profile\n"
AGGLOMERATES = {"agglomerates 1": "fix out all agglomerates 1\n",
                "agglomerates 10": "fix out all agglomerates 10\n"}
OUTPUTS = {
    "soft": {"none": "", "shear/profile, not read": PROFILE,
             "shear/profile, every step": PROFILE + VECTOR,
             "shear/profile, every 10": PROFILE + VECTOR.replace("1 10 10", "10 1 10"),
             "gran/stress, not read": "compute out all gran/stress\n",
             "gran/stress, every step": "compute out all gran/stress\n" + EVERY_STEP,
             **AGGLOMERATES},
    "hard": {"none": "", "shear/profile, not read": PROFILE,
             "shear/profile, every step": PROFILE + VECTOR,
             "hard/stress, not read": "compute out all hard/stress\n",
             "hard/stress, every step": "compute out all hard/stress\n" + EVERY_STEP,
             "hard/events, every step": "compute out all hard/events\n" + VECTOR, **AGGLOMERATES},
}
CASES = {"soft": "864 spheres of gran/hamaker", "hard": "900 discs of hard/squarewell"}  # of sheared_spheres.csv
PARTICLES = {"soft": 864, "hard": 900}
MAKING = {"soft": 10000, "hard": 1000}  # steps: a strain of 2


def main():
    words = measuring_program.words(
        __doc__, ("--steps", {"type": int, "default": 100, "help": "a multiple of 10"}),
        ("--scene", {"choices": tuple(OUTPUTS), "action": "append"}), csv_table.OPTION)
    if words.steps < 10 or words.steps % 10:
        sys.exit(f"--steps {words.steps}: a multiple of 10, 10 or more")

    scenes = words.scene or list(OUTPUTS)
    progress = Progress(sum(len(OUTPUTS[scene]) for scene in scenes))

    def count(scene, name, start):
        with engine.temporary_folder() as folder:
            shutil.copy(start, folder)
            (Path(folder) / "output.txt").write_text(OUTPUTS[scene][name])
            found = per_step("in.output_cost", folder, words.steps, scene=scene, start="restart")
        progress.add(1)
        return found / PARTICLES[scene]

    for scene in scenes:
        with engine.temporary_folder() as folder, ThreadPoolExecutor(2) as pool:
            (Path(folder) / "output.txt").write_text("")
            engine.run("in.output_cost", folder, scene=scene, start="lattice", steps=MAKING[scene])
            start = Path(folder) / "dense.restart"
            counts = list(pool.map(lambda name: count(scene, name, start), OUTPUTS[scene]))
        print(f"\n{scene}: instructions per particle and step{'':10s}more    share")
        for name, found in zip(OUTPUTS[scene], counts):
            print(f"  {name:28s}{found:14.0f}{found - counts[0]:14.0f}"
                  f"{100 * (found / counts[0] - 1):8.1f} %", flush=True)
            if name != "none":
                csv_table.enter_quantities(words.csv, "cost of outputs in LAMMPS", f"{CASES[scene]}: {name}", {
                    "additional instructions [%]": f"{100 * (found / counts[0] - 1):.1f}"})


if __name__ == "__main__":
    main()
