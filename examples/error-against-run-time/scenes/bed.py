#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The packed bed of examples/fluidised-bed, the gas faster in steps that leave it at rest. Leaves, in the
present folder, bed.csv: time [s], pressure drop over weight [1], height of the bed [m]; and fluidisation.csv: U_mf
[m/s], where Ergun's curve through the steps reaches the weight.

    bed.py BUILD GAS_STEP KERNEL SMOOTHING_WIDTH SECONDS_PER_STEP

SMOOTHING_WIDTH in m, 0 for none.
"""

from pathlib import Path

import numpy as np

from cohesion_studies import program
from cohesion_studies.bed import analyse
from cohesion_studies.foam_case import FoamCase, environment

BED = Path(__file__).resolve().parents[2] / "fluidised-bed"

VELOCITIES = (0.2, 0.3, 0.4, 0.5, 0.6)  # superficial [m/s]


def schedule(duration):
    """Text of the case's schedule: steps of `duration`, each changed within 1 ms."""
    rows = []
    for k, velocity in enumerate(VELOCITIES):
        start = k * duration + (1e-3 if k else 0)
        rows += [f"({start:.6g} (0 {velocity} 0))", f"({(k + 1) * duration:.6g} (0 {velocity} 0))"]
    return f"superficialVelocity table\n(\n    {' '.join(rows)}\n);\nendTime {len(VELOCITIES) * duration:.6g};\n"


def main(build, step, kernel, smoothing, duration):
    case = FoamCase(BED / "case", "case", environment(build, ["lammps"]))
    (case.folder / "constant/schedule").write_text(schedule(float(duration)))
    case.set("system/controlDict", "deltaT", step)
    case.set("system/controlDict", "writeControl", "adjustableRunTime")
    case.set("system/controlDict", "writeInterval", len(VELOCITIES) * float(duration))
    case.set("constant/couplingProperties", "voidFraction", kernel)
    if float(smoothing):
        case.set("constant/couplingProperties", "smoothingWidth", smoothing)
    case.mesh()
    case.solve()
    traces = analyse.read_traces(case.folder)
    np.savetxt("bed.csv", np.transpose([traces.time, traces.ratio, traces.height]), delimiter=",",
               header="time, drop, height")
    found, _ = analyse.packed_curve_meets_weight(analyse.curve(case.folder))
    np.savetxt("fluidisation.csv", [found], header="U_mf")


if __name__ == "__main__":
    main(*program.words(__doc__, 5))
