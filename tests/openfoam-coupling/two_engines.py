# SPDX-License-Identifier: BSD-3-Clause
"""One case with both particle engines: cohesive spheres that collide in gas. The same fields and
particles at the end, nearer to each other than to a run whose start is off in the twelfth digit."""

import sys

import numpy as np

from cohesion_tests.coupling.cases import COUPLING, Expectations, column, disturb, exchange_lines, use_script
from packed_bed import field
from restart import difference, numbers

END = "0.01"  # [s], 100 gas steps of ten
HAMAKER = 1e-11  # [J]: 20 times the weight at contact
# Above what the engines round differently, 1e-16 at each operation; collisions make both grow alike.
DISTURBANCE = 1e-12


def run(build, work, name, engine, hamaker=HAMAKER, disturbance=0.0):
    """State at the end, and velocities there less those at the start [m/s]."""
    case = column(work, name, build, engine)
    use_script(case, "cohesive", engine)
    if disturbance:
        disturb(case, "cohesive", disturbance, engine)
    case.set(COUPLING, f"{engine}Coeffs/variables/A", hamaker)
    case.set(COUPLING, "voidFraction", "sphereOverlap")
    case.set("system/fvSolution", 'solvers/"p.*"/tolerance', 1e-13)
    for entry, value in (("endTime", END), ("writeInterval", END), ("writePrecision", 17)):
        case.set("system/controlDict", entry, value)
    case.mesh()
    lines = exchange_lines(case.solve())
    cloud = case.folder / END / "lagrangian/particles"
    order = np.argsort(numbers(cloud / "id", 1)[:, 0])
    found = {name: field(case, END, name) for name in ("U", "p", "voidFraction")}
    found["particle velocity"] = numbers(cloud / "U", 3)[order]
    found["drag"] = np.array([line["drag"] for line in lines])
    return found


def main(build, work):
    expect = Expectations()
    lammps = run(build, work, "lammps", "lammps")
    disturbed = run(build, work, "disturbed", "lammps", disturbance=DISTURBANCE)
    liggghts = run(build, work, "liggghts", "liggghts")
    limits = difference(disturbed, lammps)
    for name, apart in difference(liggghts, lammps).items():
        # The yardstick is one only while it is small.
        expect.below(f"disturbed: {name}, largest difference / largest value", limits[name], 1e-4)
        expect.below(f"LIGGGHTS against LAMMPS: {name}, largest difference / largest value", apart,
                     limits[name])

    # What is compared is a collision of cohesive spheres: without cohesion most move differently.
    free = run(build, work, "free", "liggghts", hamaker=0)
    changed = np.abs(free["particle velocity"] - liggghts["particle velocity"]).max(axis=1)
    expect.below("spheres that cohesion left as they were [1]", np.mean(changed < 1e-3), 0.5)
    expect.exit()


if __name__ == "__main__":
    main(*sys.argv[1:3])
