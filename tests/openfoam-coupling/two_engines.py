# SPDX-License-Identifier: BSD-3-Clause
"""One case with both particle engines: cohesive spheres that collide in gas. The same fields and
particles at the end, nearer to each other than to a run whose start is off in the twelfth digit."""

import unittest

import numpy as np

from cohesion_tests.coupling.cases import COUPLING, disturb, exchange_lines, use_script
from cohesion_tests.coupling.fields import field, numbers
from cohesion_tests.coupling.swarm import difference
from cohesion_tests.coupling.test_case import CoupledTestCase

END = "0.01"  # [s], 100 gas steps of ten
HAMAKER = 1e-11  # [J]: 20 times the weight at contact
# Above what the engines round differently, 1e-16 at each operation; collisions make both grow alike.
DISTURBANCE = 1e-12


def run(column, name, engine, hamaker=HAMAKER, disturbance=0.0):
    """State at the end, and velocities there less those at the start [m/s]."""
    case = column(name, engine)
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


class TwoEngines(CoupledTestCase):
    @classmethod
    def setUpClass(cls):
        cls.liggghts = run(cls.column, "liggghts", "liggghts")

    def test_same(self):
        lammps = run(self.column, "lammps", "lammps")
        disturbed = run(self.column, "disturbed", "lammps", disturbance=DISTURBANCE)
        limits = difference(disturbed, lammps)
        for name, apart in difference(self.liggghts, lammps).items():
            # The yardstick is one only while it is small.
            self.expect_below(f"disturbed: {name}, largest difference / largest value", limits[name], 1e-4)
            self.expect_below(f"LIGGGHTS against LAMMPS: {name}, largest difference / largest value", apart,
                              limits[name])

    def test_what_is_compared_is_a_collision_of_cohesive_spheres(self):
        """Without cohesion most move differently."""
        free = run(self.column, "free", "liggghts", hamaker=0)
        changed = np.abs(free["particle velocity"] - self.liggghts["particle velocity"]).max(axis=1)
        self.expect_below("spheres that cohesion left as they were [1]", np.mean(changed < 1e-3), 0.5)


if __name__ == "__main__":
    unittest.main()
