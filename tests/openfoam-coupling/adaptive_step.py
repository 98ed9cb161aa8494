# SPDX-License-Identifier: BSD-3-Clause
"""A gas step that follows the Courant number: always a whole number of particle steps, the times to be
written and the end met, the exchange balanced in every step of whatever length, and the same steps after a
restart."""

import re
import sys

import numpy as np

from cohesion_tests.coupling.cases import Expectations, column, exchange_lines
from packed_bed import field
from restart import numbers

PARTICLE_STEP, END, INTERVAL, MAX_CO, MAX_DT = 1e-5, 0.03, 0.006, 0.05, 1e-3
CELL_HEIGHT = 0.02
# The updraft sets in, and the step has to become shorter.
UPDRAFT = "table ((0 (0 0 0.5)) (0.012 (0 0 0.5)) (0.02 (0 0 4)) (1 (0 0 4)))"
COUPLING, CONTROL = "constant/couplingProperties", "system/controlDict"


def case_of(build, work, name, settings):
    case = column(work, name, build)
    case.set(COUPLING, "lammpsCoeffs/script", '"$FOAM_CASE/continued.lmp"')
    case.set(COUPLING, "voidFraction", "sphereOverlap")
    case.set("0.orig/U", "boundaryField/bottom/superficialVelocity", UPDRAFT)
    case.set("system/fvSolution", 'solvers/"p.*"/tolerance', 1e-13)
    common = {"endTime": END, "writeControl": "adjustableRunTime", "writeInterval": INTERVAL,
              "writePrecision": 17, "timePrecision": 9}
    for entry, value in {**common, **settings}.items():
        case.set(CONTROL, entry, value)
    case.mesh()
    return case


def steps(log):
    """(deltaT, steps of the particles) of every gas step."""
    found = re.findall(r"^deltaT = (\S+), (\d+) steps of the particles", log, re.M)
    return [(float(dt), int(n)) for dt, n in found]


def times(case):
    return sorted(float(x.name) for x in case.folder.iterdir() if re.fullmatch(r"[\d.e-]+", x.name))


def velocity(case):
    cloud = case.folder / f"{END:g}" / "lagrangian/particles"
    return numbers(cloud / "U", 3)[np.argsort(numbers(cloud / "id", 1)[:, 0])]


def main(build, work):
    expect = Expectations()
    adjust = {"adjustTimeStep": "yes", "maxCo": MAX_CO, "maxDeltaT": MAX_DT, "deltaT": 2 * PARTICLE_STEP}
    case = case_of(build, work, "adjusted", adjust)
    log = case.solve()
    found = steps(log)
    lengths = np.array([n for _, n in found])
    expect.below("steps that are no whole number of particle steps, relative error",
                 max(abs(dt / (n * PARTICLE_STEP) - 1) for dt, n in found), 1e-6)
    expect.equal("particle steps in all", int(lengths.sum()), round(END / PARTICLE_STEP))
    # At the end all cells have the whole updraft or more.
    most = MAX_CO * CELL_HEIGHT / 4 / PARTICLE_STEP
    expect.true(f"the step grows, to {lengths.max()}, and shrinks, to {lengths[-1]}, at most {most:g}",
                lengths[0] <= 3 and lengths.max() > most and lengths[-1] <= most)
    expect.true("it grows by a fifth or by one at most",
                bool(np.all(lengths[1:] <= np.maximum(lengths[:-1] + 1, 1.2 * lengths[:-1]))))
    expect.equal("times written", [round(t / INTERVAL, 6) for t in times(case)], [0, 1, 2, 3, 4, 5])
    lines = exchange_lines(log)
    expect.equal("gas steps", len(lines), len(found))
    # As in conservation.py
    expect.below("largest imbalance of the forces", max(x["imbalance"] for x in lines), 1e-12)
    expect.below("largest error of the solid volume", max(x["volume"] for x in lines), 1e-12)
    # The flow of a step is that of its end, the step follows from the flow at its start: above what is
    # asked for by what the updraft grows in the longest step, 3.5 m/s in 8 ms, between the spheres.
    lowest = min(field(case, f"{k * INTERVAL:g}", "voidFraction").min() for k in range(1, 6))
    grown = 3.5 / 8e-3 * MAX_DT**2 / CELL_HEIGHT / lowest
    courant = [float(x) for x in re.findall(r"Courant Number mean: \S+ max: (\S+)", log)]
    expect.below("largest Courant number", max(courant), MAX_CO + grown)

    print("-- a run that is stopped and continued")
    halves = case_of(build, work, "halves", {**adjust, "endTime": 3 * INTERVAL})
    first = steps(halves.solve())
    halves.set(CONTROL, "startFrom", "latestTime")
    halves.set(CONTROL, "endTime", END)
    second = steps(halves.solve())
    expect.equal("steps of the particles in those of the gas", [n for _, n in first + second],
                 [n for _, n in found])

    print("-- a run whose step OpenFOAM writes with six digits")
    step = 1.23457e-5  # its multiples have more digits
    rounded = case_of(build, work, "rounded", {**adjust, "deltaT": 2 * step, "endTime": INTERVAL,
                                               "writeControl": "adjustable", "writePrecision": 6,
                                               "writeFormat": "binary"})
    script = rounded.folder / "continued.lmp"
    script.write_text(script.read_text().replace("${dt}", repr(step)))
    first = steps(rounded.solve())
    rounded.set(CONTROL, "startFrom", "latestTime")
    rounded.set(CONTROL, "endTime", 2 * INTERVAL)
    second = steps(rounded.solve())
    expect.true(f"it goes on with {second[0][1]} steps after {first[-1][1]}",
                first[-1][1] > 2 and second[0][1] > first[-1][1] / 2)
    expect.equal("particle steps in all", sum(n for _, n in first + second), round(2 * INTERVAL / step))

    expect.true("they move", np.abs(velocity(case)).max() > 0.1)
    expect.exit()


if __name__ == "__main__":
    main(*sys.argv[1:])
