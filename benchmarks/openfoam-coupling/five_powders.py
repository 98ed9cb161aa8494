#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The five powders of docs/verification/powders.md: their cases, as the program writes them, run unedited to their end.

    five_powders.py BUILD WORK [--engines lammps liggghts] [--powders NAME ...] [--grains N]
    five_powders.py BUILD WORK --plan [--csv FILE] [--powders NAME ...]

Prints of each: engine, grains, processor seconds, simulated time, mean pressure drop over weight from the middle of the
run on, height of the surface at first and at the end. Stops where Allrun does not end well or ends early. --plan:
what cohesion-powder plans for each, without a run."""

import argparse
import re
import resource
import subprocess
from pathlib import Path

import numpy as np

from cohesion_studies.foam_case import environment
from cohesion_studies.foam_results import function_table
from cohesion_studies.powder_program import PowderProgram, words
from cohesion_tests import csv_table

BED = {"--width": 0.05, "--depth": 0.05, "--height": 0.1}
ROUGH = {"--asperity": 1e-7, "--keep": "force"}
POWDERS = {
    "glass": {"--diameter": 5e-4, "--density": 2500, "--young": 63e9, "--poisson": 0.22, "--hamaker": 6.5e-20, **BED},
    "fcc": {"--diameter": 75e-6, "--density": 1500, "--young": 10e9, "--poisson": 0.25, "--hamaker": 1e-19, **ROUGH,
            "--void-fraction": 0.45, **BED},
    "alumina": {"--diameter": 80e-6, "--density": 1900, "--young": 100e9, "--poisson": 0.25, "--hamaker": 1.5e-19,
                **ROUGH, "--void-fraction": 0.45, **BED},
    # The smallest vessel is two cells wide: in cells of three diameters it has 6987 grains.
    "lactose": {"--diameter": [15e-6, 30e-6, 55e-6], "--density": 1540, "--young": 3e9, "--surface-energy": 0.04, **ROUGH,
                "--void-fraction": 0.55, **BED, "--cell": 2, "--grains": 2070},
    "thesis": {"--diameter": 1e-3, "--density": 2650, "--stiffness": 800, "--restitution": 0.9487, "--hamaker": 7.49e-19,
               "--void-fraction": 0.43, "--width": 0.08, "--depth": 0.08, "--height": 0.05}}
# Of powders.csv: the names of powders, and of numbers of cohesion-powder
NAMES = {"glass": "glass 500 um", "fcc": "FCC catalyst 75 um", "alumina": "alumina 80 um",
         "lactose": "lactose 15, 30, 55 um", "thesis": "spheres 1 mm"}
QUANTITIES = {"u_mf, Wen and Yu [m/s]": "u_mf_wen_yu", "terminal speed [m/s]": "terminal_speed",
              "Bond number, smallest grains": "bond", "stiffness of the material [N/m]": "material_stiffness",
              "stiffness of the springs [N/m]": "stiffness", "escape velocity over the material's": "escape_over_material",
              "pull-off force over the material's": "pull_off_over_material", "particle step [s]": "particle_step",
              "gas velocity of the case [m/s]": "gas_velocity", "grains of the bed": "grains"}
WELLS = {"glass": "glass", "fcc": "FCC catalyst", "lactose": "lactose"}
OF_WELLS = {"escape velocity of the material [m/s]": "material_escape", "depth, two of the smallest grains [J]": "well_depth",
            "depth, smallest grain at a wall [J]": "well_depth_wall",
            "depth over width and weight, ratio 1.01": "well_bond"}
END = 0.1  # s, of a written case


def run(powder, env, folder, options):
    """The row that main() prints of a powder in an engine."""
    subprocess.run(["rm", "-rf", str(folder)], check=True)
    powder.write(folder, options)
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run(["./Allrun"], cwd=folder, env=env, capture_output=True, text=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if done.returncode != 0:
        raise SystemExit(f"{folder}: Allrun ended with {done.returncode}\n{done.stdout[-2000:]}{done.stderr[-2000:]}")
    drop = np.loadtxt(function_table(folder, "drop", "bedPressureDrop.dat"))
    surface = np.loadtxt(function_table(folder, "height", "bedHeight.dat"))
    if drop[-1, 0] < END - drop[-1, 1]:
        raise SystemExit(f"{folder} ended at {drop[-1, 0]} s")
    late = drop[:, 0] > END / 2
    return {"grains": (folder / "grains.data").read_text().split(" atoms")[0].split()[-1],
            "seconds": f"{after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime:.0f}",
            "end [s]": f"{drop[-1, 0]:.4f}",
            "drop over weight": f"{np.average(drop[late, 5], weights=drop[late, 1]):.3f}",
            "surface [mm]": f"{1e3 * surface[0, 2]:.2f}, {1e3 * surface[-1, 2]:.2f}"}


def plan(powder, options):
    """{quantity: text} of powders.csv, of the whole bed."""
    options = {name: value for name, value in options.items() if name not in ("--grains", "--cell")}
    found = powder.values(options)
    closures = [value for name, value in found.items() if name.startswith("u_mf_") and name != "u_mf_wen_yu"]
    group = re.search(r"Geldart's group .*(\w)$", powder.call(*words(options)), re.M)[1]
    return {"Geldart's group": group, "u_mf, lowest to highest closure [m/s]":
            " to ".join(csv_table.figures(value) for value in (min(closures), max(closures))),
            **{quantity: csv_table.figures(found[name]) for quantity, name in QUANTITIES.items()}}


def wells(powder, options):
    """The same of square wells that keep the escape velocity."""
    options = {name: value for name, value in options.items() if name not in ("--grains", "--cell", "--keep")}
    found = powder.values({**options, "--law": "square_well"})
    return {quantity: csv_table.figures(found[name]) for quantity, name in OF_WELLS.items()}


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("build")
    parser.add_argument("work", type=Path)
    parser.add_argument("--engines", choices=("lammps", "liggghts"), nargs="+", default=["lammps", "liggghts"])
    parser.add_argument("--powders", choices=POWDERS, nargs="+", default=list(POWDERS))
    parser.add_argument("--grains", type=float, default=2000, help="at most, but of lactose (%(default)s)")
    parser.add_argument("--plan", action="store_true", help="no runs")
    csv_table.add_to(parser)
    args = parser.parse_args()
    if args.plan:
        for name in args.powders:
            row = plan(PowderProgram(args.build), POWDERS[name])
            print(f"{name}: " + "; ".join(f"{what} {value}" for what, value in row.items()))
            csv_table.enter_quantities(args.csv, "five powders", NAMES[name], row)
            if name in WELLS:
                csv_table.enter_quantities(args.csv, "square well", WELLS[name],
                                           wells(PowderProgram(args.build), POWDERS[name]))
        return
    env, powder = environment(args.build, args.engines), PowderProgram(args.build)
    args.work.mkdir(parents=True, exist_ok=True)
    for name in args.powders:
        for engine in args.engines:
            row = run(powder, env, args.work / f"{name}-{engine}",
                      {"--grains": args.grains, "--engine": engine, **POWDERS[name]})
            print(f"{name} in {engine}: " + "; ".join(f"{what} {value}" for what, value in row.items()), flush=True)


if __name__ == "__main__":
    main()
