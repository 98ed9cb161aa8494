#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Seconds of the fluidised bed of examples/fluidised-bed with each particle engine, without and with
cohesion: poured, settled for 0.05 s, blown through for 0.045 s. On one core, alternately; processor time
with start and set-up, as the clock of a busy machine says little.

    speed_of_engines.py BUILD WORK [REPEATS]

A program and no test: a time has no right value."""

import itertools
import re
import statistics
import sys
from pathlib import Path

from cohesion_studies.foam_case import FoamCase, environment
from cohesion_tests.coupling.cases import BED, COUPLING, ENGINES
from speed_beside_dpmfoam import seconds

SETTLE, BLOW = 0.05, 0.045  # [s]; the scripts settle for whole thousands of steps
DT, PARTICLES = 1.125e-5, 4000
STEPS = (int(SETTLE / DT / 1000 + 1) * 1000) + round(BLOW / DT)
HAMAKER = {"no cohesion": 0, "Hamaker": 7.49e-19}


def run(build, work, engine, kind):
    """Processor seconds, and the share of the particles in the clock's of the solver [%]."""
    case = FoamCase(BED / "case", Path(work) / f"{engine}-{kind.replace(' ', '-')}",
                    environment(build), overwrite=True)
    case.set(COUPLING, "demEngine", engine)
    for variable, value in (("A", HAMAKER[kind]), ("settle", SETTLE), ("dt", DT)):
        case.set(COUPLING, f"{engine}Coeffs/variables/{variable}", value)
    (case.folder / "constant/schedule").write_text(
        f"superficialVelocity table ((0 (0 1.2 0)) (1 (0 1.2 0)));\nendTime {BLOW};\n")
    case.mesh()
    used = seconds(case, "cohesiveBedFoam")
    log = case.log("cohesiveBedFoam").read_text()
    return used, float(re.search(r"^    particles +\S+ s, (\S+) %", log, re.M)[1])


def main(build, work, repeats="3"):
    runs = {row: [] for row in itertools.product(HAMAKER, ENGINES)}
    for _ in range(int(repeats)):
        for kind, engine in runs:
            runs[kind, engine].append(run(build, work, engine, kind))
    medians = {}
    for (kind, engine), found in runs.items():
        used = medians[kind, engine] = statistics.median(r[0] for r in found)
        share = statistics.median(r[1] for r in found)
        print(f"{kind}, {engine}: {used:.2f} s ({', '.join(f'{r[0]:.2f}' for r in found)}), "
              f"{1e6 * used / (PARTICLES * STEPS):.3f} us per particle and step; in the gas steps the "
              f"engine has {share:.0f} %")
    for kind in HAMAKER:
        print(f"{kind}, LIGGGHTS over LAMMPS: "
              f"{medians[kind, 'liggghts'] / medians[kind, 'lammps']:.2f}")


if __name__ == "__main__":
    main(*sys.argv[1:])
