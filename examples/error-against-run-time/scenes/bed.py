#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A short run of the bed of examples/fluidised-bed at one gas velocity; leaves bed.csv in the present folder:
time [s], pressure drop over weight [1], height of the bed [m].

    bed.py BUILD GAS_STEP KERNEL SUPERFICIAL_VELOCITY DURATION
"""

import sys
from pathlib import Path

import numpy as np

BED = Path(__file__).resolve().parents[2] / "fluidised-bed"
sys.path[:0] = [str(BED), str(BED.parent / "common")]

import analyse  # noqa: E402
from foam_case import FoamCase, environment  # noqa: E402


def main(build, step, kernel, velocity, duration):
    case = FoamCase(BED / "case", "case", environment(build))
    rows = f"(0 (0 {velocity} 0)) ({duration} (0 {velocity} 0))"
    (case.folder / "constant/schedule").write_text(
        f"superficialVelocity table ({rows});\nendTime {duration};\n")
    case.set("system/controlDict", "deltaT", step)
    case.set("system/controlDict", "writeControl", "adjustableRunTime")
    case.set("system/controlDict", "writeInterval", duration)
    case.set("constant/couplingProperties", "voidFraction", kernel)
    case.mesh()
    case.solve()
    traces = analyse.read_traces(case.folder)
    np.savetxt("bed.csv", np.transpose([traces.time, traces.ratio, traces.height]), delimiter=",",
               header="time, drop, height")


if __name__ == "__main__":
    if len(sys.argv) != 6:
        sys.exit(__doc__)
    main(*sys.argv[1:])
