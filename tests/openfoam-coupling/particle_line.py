# SPDX-License-Identifier: BSD-3-Clause
"""What the log says of the particles at the start: their number, diameters and densities, with the means where they
differ, and Geldart's group; of a mixture of sizes what the drag of each sphere is. On 1 and 2 ranks."""

import re
import unittest

import numpy as np

from cohesion_tests.coupling.cases import COUPLING, append, use_script
from cohesion_tests.coupling.test_case import CoupledTestCase
from cohesion_tests.refusals import assert_says

NUMBER = 40
MIXTURE = "the drag of each sphere is the closure's for its own diameter and the void fraction of its cells."
WARNING = "may be off by a factor of about three at a size ratio of four"
CURE = "add an entry dragMixture to constant/couplingProperties: carmanKozeny or vanDerHoef"


def lines(column, name, kinds, ranks=1, mixture="none", parcel=1):
    """The log of spheres of `kinds` in turn, (diameter [m], density [kg/m3]): the line, and the one after it if
    it belongs to it."""
    case = column(name)
    use_script(case, "passing")
    atoms = "\n".join(f"{n + 1} 1 {kinds[n % len(kinds)][0]!r} {kinds[n % len(kinds)][1]!r} 0.03 0.03 "
                      f"{0.2 * (n + 0.5) / NUMBER!r}" for n in range(NUMBER))
    (case.folder / "spheres").write_text(
        f"Spheres\n\n{NUMBER} atoms\n1 atom types\n\n0 0.06 xlo xhi\n0 0.06 ylo yhi\n0 0.2 zlo zhi\n\n"
        f"Atoms\n\n{atoms}\n")
    append(case, COUPLING, f"lammpsCoeffs {{ variables {{ data spheres; }} }} dragMixture {mixture};"
           f"coarseGraining {parcel};")
    append(case, "constant/g", "value (0 0 0);")
    append(case, "system/controlDict", "endTime 1e-4; writePrecision 17;")
    case.mesh()
    log = case.solve(ranks=ranks)
    found = re.findall(r"^Particles: (.*)\n(?: +(.*))?", log, re.M)
    assert len(found) == 1, found
    return found[0]


class ParticleLine(CoupledTestCase):
    def check(self, what, found, line, mixture):
        self.expect_equal(f"{what}: the line", found[0], line)
        if mixture is None:
            return self.expect_equal(f"{what}: the next line", found[1], "")
        assert_says(self, found[1], f"A mixture, largest over smallest diameter {mixture:g}: ", MIXTURE, WARNING,
                    CURE)

    def test_alike(self):
        self.check("alike", lines(self.column, "alike", [(3e-4, 1500.0)]),
                   "40, diameter 0.0003 m, density 1500 kg/m3; by both, in ambient air, Geldart's group B", None)

    def test_two_densities(self):
        self.check("densities", lines(self.column, "densities", [(3e-4, 1500.0), (3e-4, 500.0)]),
                   "40, diameter 0.0003 m, density 500 to 1500 kg/m3, mean 1000 kg/m3; by both means, in ambient air,"
                   " Geldart's group B", None)

    def test_nearly_alike(self):
        # Sieved, and of the rounding of radii
        for wide, diameter in (("sieved", 3.1e-4), ("rounded", 3.000001e-4)):
            found = lines(self.column, wide, [(3e-4, 1500.0), (diameter, 1500.0)])
            self.expect_true(f"{wide}: no more than one line: {found}", not found[1])

    def test_mixture(self):
        kinds = [(2e-4, 2000.0), (8e-4, 1000.0), (2e-4, 1000.0), (2e-4, 1000.0)]
        d, rho = np.array(kinds).T
        said = (f"40, diameter 0.0002 to 0.0008 m, Sauter mean {(d**3).sum() / (d**2).sum():.6g} m, density 1000 to"
                f" 2000 kg/m3, mean {(d**3 * rho).sum() / (d**3).sum():.6g} kg/m3; by both means, in ambient air,"
                " Geldart's group B")
        for ranks in (1, 2):
            self.check(f"mixture, {ranks} ranks", lines(self.column, f"mixture-{ranks}", kinds, ranks), said, 4)

    def test_law_for_mixtures(self):
        for name, widest, beyond in (("fitted", 8e-4, False), ("beyond", 10e-4, True)):
            found = lines(self.column, name, [(2e-4, 1500.0), (widest, 1500.0)], mixture="vanDerHoef")[1]
            assert_says(self, found, "that of dragMixture vanDerHoef over the closure, by its diameter over the Sauter"
                        " mean of its cells")
            self.expect_equal(f"{name}: range of the law is in the log", "fitted for ratios up to 4" in found, beyond)

    def test_parcels(self):
        """2 mm of which each stands for 1000 grains of 0.2 mm: group B, where the spheres would be of group D."""
        found = lines(self.column, "parcels", [(2e-3, 2500.0)], parcel=10)
        self.expect_true(f"group of the grains: {found[0]}", found[0].endswith("Geldart's group B"))
        self.expect_equal("the next line", found[1], "coarseGraining 10: each sphere stands for 1000 grains of"
                          " 0.1 of its diameter; drag and Geldart's group are theirs")

    def test_law_for_mixtures_among_equal_spheres(self):
        found = lines(self.column, "equal", [(2e-4, 1500.0)], mixture="vanDerHoef")[1]
        assert_says(self, found, "Largest over smallest diameter 1: the drag of each sphere is that of dragMixture"
                    " vanDerHoef", "of equal ones up to 1.064 times the closure's")


if __name__ == "__main__":
    unittest.main()
