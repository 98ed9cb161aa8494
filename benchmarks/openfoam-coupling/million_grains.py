#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What a coupled bed takes per grain and step, and of memory, up to a million grains and on several ranks: the case of
cohesion-powder with a lattice of grains that touch six others at rest on its plate, through which the gas blows below
minimum fluidisation, for some gas steps.

    million_grains.py BUILD WORK [--numbers N ...] [--ranks R ...] [--steps GAS_STEPS] [--engine lammps]

Numbers are rounded to cubes of a whole number of cells. A program and no test: a time has no right value."""

import argparse
import re
import shutil
import subprocess
import tempfile
from pathlib import Path

from cohesion_studies.case_entries import entries
from cohesion_studies.foam_case import FoamCase, environment
from cohesion_studies.powder_program import PowderProgram

DIAMETER, CELL = 5e-4, 1.5e-3
SPACING = 0.999 * DIAMETER
BEADS = {"--diameter": DIAMETER, "--density": 2500, "--stiffness": 50, "--hamaker": 6.5e-20, "--asperity": 1e-7,
         "--grains": 1e8}


def make(powder, env, folder, number, engine, steps, ranks):
    """The case with a lattice of about `number` grains, as wide as high; and how many there are."""
    cells = max(2, 2 * round((number / 27)**(1 / 3) / 2))
    edge = cells * CELL
    with tempfile.TemporaryDirectory() as scratch:
        written = Path(scratch) / "case"
        powder.write(written, {**BEADS, "--engine": engine, "--width": edge, "--depth": edge, "--height": edge})
        case = FoamCase(written, folder, env, overwrite=True)
    size = entries(folder / "constant/powder")
    across = int(edge / SPACING)
    begin = (edge - (across - 1) * SPACING) / 2
    head = (folder / "grains.data").read_text().split("Atoms")[0]
    rows = [f"{n + 1} 1 {DIAMETER} {BEADS['--density']} {begin + n % across * SPACING:.9g} "
            f"{begin + n // across % across * SPACING:.9g} {(n // across**2 + 0.4995) * SPACING:.9g}"
            for n in range(across**3)]
    (folder / "grains.data").write_text(re.sub(r"\d+ atoms", f"{across**3} atoms", head) + "Atoms\n\n"
                                        + "\n".join(rows) + "\n")
    # At rest from the first: no time to settle.
    grains = folder / "constant/grains"
    grains.write_text(re.sub(r"(settle\s+)\S+;", r"\g<1>0;", grains.read_text()))
    for script in folder.glob("grains.l*"):
        script.write_text(script.read_text().replace("floor(${settle}/${dt}/1000+1)*1000", "1"))
    case.set("constant/powder", "velocity", 0.1)
    case.set("system/controlDict", "endTime", steps * size["gasStep"])
    case.set("system/controlDict", "writeControl", "none")
    case.set("system/decomposeParDict", "coeffs/n", f"({ranks} 1 1)")
    case.mesh()
    return case, across**3, round(size["gasStep"] / entries(grains)["dt"])


def run(case, ranks):
    """The solver's log, and the largest resident sizes of its processes together [bytes]."""
    sizes = case.folder.resolve() / "resident"  # a line of each rank: what mpirun passes on may run together
    command = ["/usr/bin/time", "-a", "-o", str(sizes), "-f", "%M", "cohesiveBedFoam"]
    if ranks > 1:
        case.set("system/decomposeParDict", "numberOfSubdomains", ranks)
        case.run("decomposePar", "-force")
        command = ["mpirun", "--oversubscribe", "-np", str(ranks), *command, "-parallel"]
    done = subprocess.run(command, cwd=case.folder, env=case.env, capture_output=True, text=True)
    if done.returncode != 0:
        raise SystemExit(done.stdout[-2000:] + done.stderr[-2000:])
    return done.stdout, 1024 * sum(int(size) for size in sizes.read_text().split())


def seconds(log, what):
    return float(re.search(rf"^    {what} +(\S+) s", log, re.M)[1])


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("build")
    parser.add_argument("work", type=Path)
    parser.add_argument("--numbers", type=float, nargs="+", default=[1e4, 1e5, 1e6])
    parser.add_argument("--ranks", type=int, nargs="+", default=[1, 2])
    parser.add_argument("--steps", type=int, default=6, help="of the gas, of which the first is not counted (%(default)s)")
    parser.add_argument("--engine", choices=("lammps", "liggghts"), default="lammps")
    args = parser.parse_args()
    env, powder = environment(args.build, [args.engine]), PowderProgram(args.build)
    args.work.mkdir(parents=True, exist_ok=True)
    print("grains, ranks; seconds of a gas step by the clock; nanoseconds per grain: particles' step, gas step, exchange;"
          " bytes per grain")
    for number in args.numbers:
        for ranks in args.ranks:
            folder = args.work / f"{number:g}-{ranks}"
            case, grains, sub_steps = make(powder, env, folder, number, args.engine, args.steps, ranks)
            log, memory = run(case, ranks)
            passed = [float(t) for t in re.findall(r"^Time = .*%, (\S+) s elapsed", log, re.M)]
            step = (passed[-1] - passed[0]) / (len(passed) - 1)
            per = [1e9 * seconds(log, part) / len(passed) / grains for part in ("particles", "gas", "exchange")]
            print(f"{grains}, {ranks}; {step:.3g}; {per[0] / sub_steps:.4g} (of {sub_steps} in a gas step), {per[1]:.4g},"
                  f" {per[2]:.4g}; {memory / grains:.4g}", flush=True)
            shutil.rmtree(folder)


if __name__ == "__main__":
    main()
