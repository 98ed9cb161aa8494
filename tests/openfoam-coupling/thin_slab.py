# SPDX-License-Identifier: BSD-3-Clause
"""Spheres in a slab that is periodic across its thickness, in the gas of a 2-D mesh. Those that have just left the slab
are beyond the mesh until the engine takes them back: they count as those inside, on 1 and 2 ranks, whether the mesh is
as thick as the slab, thicker or thinner; their ways are as short as they are; and the case must say how deep the slab
is where the mesh does not."""

import unittest

import numpy as np

from cohesion_tests import dumps
from cohesion_tests.coupling.cases import CONTROL, COUPLING, ENGINE, append, disturb, edit, exchange_lines, use_script
from cohesion_tests.coupling.fields import field, table
from cohesion_tests.coupling.test_case import CoupledTestCase

DEPTH = 8e-3  # of the slab [m]
STEPS, DT = 10, 1e-4
END = f"{STEPS * DT:g}"
# Ends of the mesh across the slab [mm], and what the case says of the slab
AS_THICK, THICKER, THINNER = (0, 8, ""), (-8, 16, f"depth {DEPTH};"), (3, 4, f"depth {DEPTH};")


def make(column, name, low, high, settings):
    """The column, in the place of its depth in y one layer of cells."""
    case = column(name)
    block = "system/blockMeshDict"
    edit(case, block, "(0 0 0) (60 0 0) (60 60 0) (0 60 0)", f"(0 {low} 0) (60 {low} 0) (60 {high} 0) (0 {high} 0)")
    edit(case, block, "(0 0 200) (60 0 200) (60 60 200) (0 60 200)",
         f"(0 {low} 200) (60 {low} 200) (60 {high} 200) (0 {high} 200)")
    edit(case, block, "(3 3 10)", "(3 1 10)")
    edit(case, block, "((0 1 5 4) (1 2 6 5) (2 3 7 6) (3 0 4 7)); }",
         "((1 2 6 5) (3 0 4 7)); }\n    slices { type empty; faces ((0 1 5 4) (2 3 7 6)); }")
    for file in ("U", "p", "voidFraction"):
        edit(case, f"0.orig/{file}", "    top ", "    slices { type empty; }\n    top ")
    use_script(case, "slab")
    append(case, COUPLING, f"voidFraction sphereOverlap; {settings} {ENGINE}Coeffs {{ variables {{ period p; }} }}")
    append(case, CONTROL, f"endTime {END}; writeInterval {END}; writePrecision 17; functions {{ movement {{ type"
           f" particleMovement; libs (cohesionFunctionObjects); interval {END}; writePrecision 12; }} }}")
    append(case, "system/fvSolution", 'solvers { "p.*" { tolerance 1e-14; } }')
    return case


class ThinSlab(CoupledTestCase):
    def run_slab(self, name, mesh, ranks=1, disturbance=0.0):
        """The case, drag in each step [N], void fraction at the end."""
        case = make(self.column, name, *mesh)
        if disturbance:
            disturb(case, "slab", disturbance)
        case.mesh()
        lines = exchange_lines(case.solve(ranks=ranks))
        if ranks > 1:
            case.run("reconstructPar")
        self.expect_equal(f"{name}: gas steps", len(lines), STEPS)
        self.expect_balance(name, lines)
        drag = np.array([line["drag"] for line in lines])
        return case, {"drag": drag, "void fraction": field(case, END, "voidFraction")}

    def check_ways(self, what, case):
        """How far the spheres get, against the engine's own record of what it takes no sphere back in."""
        first, *_, last = (snapshot.sorted() for snapshot in dumps.read(case.folder / "places.dump"))
        way = last[:, 2:] - first[:, 2:]
        (_, _, mean, *rms, _), = table(case, "movement", "particleMovement")
        # Twelve digits of ways of a millimetre, and places of 0.1 m of sixteen
        self.expect_near(f"{what}: mean way [m]", mean, np.linalg.norm(way, axis=1).mean(), 1e-14)
        for axis, found, squares in zip("xyz", rms, way.T**2):
            self.expect_near(f"{what}: {axis} rms [m]", found, np.sqrt(squares.mean()), 1e-14)

    def test_beyond_the_mesh(self):
        _, reference = self.run_slab("thicker", THICKER)
        _, disturbed = self.run_slab("disturbed", THICKER, disturbance=1e-8)
        limits = {name: np.abs(disturbed[name] - values).max() for name, values in reference.items()}
        for name, mesh, ranks in (("as-thick", AS_THICK, 1), ("as-thick-2", AS_THICK, 2), ("thinner-2", THINNER, 2)):
            case, found = self.run_slab(name, mesh, ranks)
            beyond = [((s.sorted()[:, 1] < 0) | (s.sorted()[:, 1] > DEPTH)).sum()
                      for s in dumps.read(case.folder / "places.dump")]
            self.expect_true(f"{name}: gas steps begin with some beyond the slab, {beyond}", np.count_nonzero(beyond) > 2)
            for quantity, values in found.items():
                self.expect_below(f"{name}: {quantity}, largest difference from a mesh that holds them all",
                                  np.abs(values - reference[quantity]).max(), limits[quantity])
            self.check_ways(name, case)

    @unittest.skipUnless(ENGINE == "lammps", "what the solver does by itself, with every engine")
    def test_depth_is_asked_for(self):
        case = make(self.column, "no-depth", -8, 16, "")
        case.mesh()
        self.refused("mesh thicker than the slab", case, "in direction y, which the mesh does not resolve, the box of"
                     " the particle script is periodic and 0.008 m deep, the mesh 0.024 m thick", "'depth 0.008;'",
                     "couplingProperties")

    @unittest.skipUnless(ENGINE == "lammps", "what the solver does by itself, with every engine")
    def test_another_depth_is_warned_of(self):
        said = "depth = 0.004 m, while the box of the particle script is periodic in direction y and 0.008 m deep"
        for depth, warned in ((4e-3, 1), (8.001e-3, 0)):
            case = make(self.column, f"depth-{depth}", 0, 8, f"depth {depth};")
            case.mesh()
            log = " ".join(case.solve().split())
            self.expect_equal(f"depth {depth}: warnings", log.count(said), warned)
            self.expect_equal(f"depth {depth}: warnings of any depth", log.count("depth = "), warned)

    @unittest.skipUnless(ENGINE == "lammps", "what the solver does by itself, with every engine")
    def test_box_that_is_not_periodic(self):
        """There a sphere that the mesh does not reach is outside, as elsewhere."""
        case = make(self.column, "not-periodic", 3, 4, "")
        edit(case, "slab.lmp", "all random 0 0.9e-3 0 15485863", "all move 0 2e-3 0")
        append(case, COUPLING, "lammpsCoeffs { variables { period f; } }")
        case.mesh()
        self.refused("spheres beside the mesh", case, "756 particles are outside the mesh",
                     "its sides of type cyclic where that is periodic")


if __name__ == "__main__":
    unittest.main()
