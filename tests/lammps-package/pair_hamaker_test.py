# SPDX-License-Identifier: BSD-3-Clause
"""Pair forces and energies of the engine against the law."""
import unittest

import numpy

from cohesion_tests import lammps as engine
from cohesion_tests.test_cases import FolderTestCase
from cohesion_tests.theory import hamaker_reference as law
from cohesion_tests.thermo import thermo_end

RADIUS = {1: 0.5e-3, 2: 0.3e-3}
DIRECTION = numpy.array([2.0, 3.0, 6.0]) / 7.0
SPACING = 4e-3


def couples(gaps):
    """Couples of spheres far from each other, for each pair of types and each gap."""
    atoms = []
    for column, (a, b) in enumerate(((1, 1), (1, 2), (2, 2))):
        for row, gap in enumerate(gaps):
            first = numpy.array([column, row, 0.0]) * SPACING + 1e-3
            second = first + DIRECTION * (RADIUS[a] + RADIUS[b] + gap)
            for kind, x in ((a, first), (b, second)):
                atoms.append({"type": kind, "diameter": 2 * RADIUS[kind], "density": 2650.0,
                              "x": x})
    return atoms


def box(gaps):
    return [(0.0, 3 * SPACING), (0.0, len(gaps) * SPACING), (0.0, SPACING)]


def radii(one, other):
    return one["diameter"] / 2, other["diameter"] / 2


def gap_of(one, other):
    return numpy.linalg.norm(numpy.array(other["x"]) - one["x"]) - sum(radii(one, other))


class PairHamaker(FolderTestCase):
    FORM = "small_gap"
    PARAMETERS = {(1, 1): (1e-19, 4e-10, 1e-7), (2, 2): (7.49e-19, 8e-10, 2e-7)}
    MIXED = ((1e-19 * 7.49e-19) ** 0.5, 8e-10, 2e-7)  # geometric mean, larger of the others
    GIVEN = (5e-19, 6e-10, 3e-8)
    GAPS = [-1e-6, -1e-10, 0.0, 1e-10, 3.9e-10, 5e-10, 7e-10, 1e-9, 1e-8, 2.9e-8, 9e-8, 1.5e-7,
            2.5e-7]
    COEFF11 = "hamaker 1e-19"  # the cut-offs are those of pair_style
    # The data file writes coordinates with 17 digits: nothing is lost, so nothing differs.
    LOST_IN_DATA_FILES = 0.0

    def given(self, gaps, mixing="yes", script="in.pairs", skin=1e-4, **more):
        self.atoms = couples(gaps)
        engine.write_spheres(self.folder, self.atoms, box(gaps), 2)
        return engine.run(script, self.folder, form=self.FORM, coeff11=self.COEFF11,
                          coeff22=law.words(*self.PARAMETERS[2, 2]),
                          coeff12=law.words(*self.GIVEN), mixing=mixing, skin=skin, **more)

    def check_forces(self, forces, parameters):
        for i in range(0, len(self.atoms), 2):
            one, other = self.atoms[i], self.atoms[i + 1]
            p = parameters[one["type"], other["type"]]
            gap = gap_of(one, other)
            expected = law.force(self.FORM, gap, *radii(one, other), *p)
            # Coordinates are at most as large as the box, the gap is their difference.
            tolerance = law.position_tolerance(len(self.GAPS) * SPACING, gap, p[1])
            for atom, sign in ((forces[i], 1), (forces[i + 1], -1)):
                along = sign * atom[4:7] @ DIRECTION
                across = numpy.linalg.norm(atom[4:7] - sign * along * DIRECTION)
                self.assertLessEqual(
                    abs(along - expected), tolerance * expected,
                    f"types {one['type']} {other['type']} gap {gap}: {along} for {expected}")
                # The direction rounds like a coordinate against the distance.
                self.assertLessEqual(across, 1e-12 * expected)
        self.assertGreater(numpy.abs(forces[:, 4:7]).max(), 0.0)

    def test_forces_with_mixed_coefficients(self):
        self.given(self.GAPS)
        self.check_forces(engine.dump(self.folder, "forces.txt"), {**self.PARAMETERS, (1, 2): self.MIXED})

    def test_forces_with_given_coefficients_of_unlike_types(self):
        self.given(self.GAPS, mixing="no")
        self.check_forces(engine.dump(self.folder, "forces.txt"), {**self.PARAMETERS, (1, 2): self.GIVEN})

    def test_neighbour_range_reaches_the_outer_cutoff_by_itself(self):
        self.given(self.GAPS, skin=0.0)
        self.check_forces(engine.dump(self.folder, "forces.txt"), {**self.PARAMETERS, (1, 2): self.MIXED})

    def test_restart_and_data_files_keep_all_coefficients(self):
        self.given(self.GAPS, mixing="no")
        before = engine.dump(self.folder, "forces.txt")
        for source in ("restart", "data"):
            engine.run("in.pairs_again", self.folder, form=self.FORM, **{"from": source})
            again = engine.dump(self.folder, "again.txt")
            lost = self.LOST_IN_DATA_FILES if source == "data" else 0.0
            numpy.testing.assert_allclose(again[:, 4:7], before[:, 4:7], rtol=lost, atol=0, err_msg=source)

    def test_energies_and_single(self):
        output = self.given(self.GAPS)
        energies = engine.dump(self.folder, "forces.txt")[:, 7]
        parameters = {**self.PARAMETERS, (1, 2): self.MIXED}
        local = {tuple(sorted((int(row[0]), int(row[1])))): row[2:]
                 for row in engine.dump(self.folder, "local.txt")}
        total = 0.0
        for i in range(0, len(self.atoms), 2):
            one, other = self.atoms[i], self.atoms[i + 1]
            p = parameters[one["type"], other["type"]]
            gap = gap_of(one, other)
            expected = law.energy(self.FORM, gap, *radii(one, other), *p)
            total += expected
            # The energy is a difference of 1/gap and 1/out: allow the rounding of the larger.
            # That of the small gap is the largest of all forms.
            size = -p[0] / 6 * law.small_gap(max(gap, p[1]), *radii(one, other))[1]
            tolerance = size * law.position_tolerance(len(self.GAPS) * SPACING, max(gap, p[1]),
                                                      p[1])
            self.assertLessEqual(abs(energies[i] + energies[i + 1] - expected), tolerance)
            if gap >= p[2]:
                continue  # beyond the outer cut-off the energy is zero, as checked above
            distance, energy, force = local[i + 1, i + 2]
            self.assertLessEqual(abs(energy - expected), tolerance)
            wanted = -law.force(self.FORM, gap, *radii(one, other), *p)
            self.assertLessEqual(abs(force - wanted), -wanted * law.position_tolerance(
                len(self.GAPS) * SPACING, gap, p[1]))
            self.assertAlmostEqual(distance, numpy.linalg.norm(other["x"] - one["x"]), delta=1e-17)
        # The thermo output prints all digits; rounding as above, the largest term is the total's.
        self.assertLessEqual(abs(thermo_end(output)["PotEng"] - total), 1e-6 * abs(total))

    def test_force_is_the_slope_of_the_energy(self):
        # Central difference with h = gap/1000: its error is h^2/6 F''/F = (h/gap)^2 = 1e-6; the
        # energy's own rounding, 1e-18/gap of its size, gives 1e-18/gap * gap/h = 1e-18/h < 1e-5 for
        # gaps from 1e-9 on.
        gaps = [1.2e-9, 3e-9, 1e-8, 5e-8]
        self.given([gap * (1 + shift) for gap in gaps for shift in (-1e-3, 0.0, 1e-3)])
        table = engine.dump(self.folder, "forces.txt")
        for i in range(2, len(self.atoms), 6):
            low, high = (table[k, 7] + table[k + 1, 7] for k in (i - 2, i + 2))
            step = gap_of(*self.atoms[i + 2:i + 4]) - gap_of(*self.atoms[i - 2:i])
            slope = (high - low) / step
            force = table[i, 4:7] @ DIRECTION
            self.assertGreater(force, 0.0)
            self.assertLess(abs(slope - force), 2e-5 * force)

    def test_pressure_is_the_virial_of_the_forces(self):
        output = self.given(self.GAPS)
        values = thermo_end(output)
        forces = engine.dump(self.folder, "forces.txt")
        volume = numpy.prod([high - low for low, high in box(self.GAPS)])
        terms = []
        for i in range(0, len(self.atoms), 2):
            apart = numpy.array(self.atoms[i + 1]["x"]) - self.atoms[i]["x"]
            terms.append(apart * forces[i + 1, 4:7] / volume)
        for axis, name in enumerate(("Pxx", "Pyy", "Pzz")):
            expected = sum(term[axis] for term in terms)
            # Sums of 39 terms of one sign.
            self.assertLessEqual(abs(values[name] - expected), 1e-13 * abs(expected), name)
            self.assertLess(expected, 0.0)
    def test_fix_adapt_changes_the_constant(self):
        for first in (1e-19, 0.0):
            self.given([1e-9], script="in.adapt", first=first, steps=5)
            changed = {(1, 1): (3e-19, 4e-10, 1e-7), (2, 2): (2 * first, 4e-10, 1e-7),
                       (1, 2): ((6e-19 * first)**0.5, 4e-10, 1e-7)}
            self.check_forces(engine.dump(self.folder, "forces.txt"), changed)


class ExactForm(PairHamaker):
    FORM = "exact"
    PARAMETERS = {(1, 1): (1e-19, 4e-10, 1e-7), (2, 2): (7.49e-19, 8e-10, 6e-4)}
    MIXED = ((1e-19 * 7.49e-19) ** 0.5, 8e-10, 6e-4)
    GIVEN = (5e-19, 6e-10, 3e-4)
    GAPS = [-1e-6, 0.0, 3e-10, 5e-10, 7e-10, 1e-8, 9e-8, 1.5e-7, 1e-6, 1e-5, 1e-4, 4e-4, 7e-4]


class SmallGapWithAsperities(PairHamaker):
    PARAMETERS = {(1, 1): (1e-19, 4e-10, 1e-7, 2e-8), (2, 2): (7.49e-19, 8e-10, 2e-7)}
    MIXED = ((1e-19 * 7.49e-19) ** 0.5, 8e-10, 2e-7, 2e-8)
    GIVEN = (5e-19, 6e-10, 3e-8, 1e-9)
    COEFF11 = "hamaker 1e-19 asperity 2e-8"


class ExactFormWithAsperities(ExactForm):
    PARAMETERS = {(1, 1): (1e-19, 4e-10, 1e-7, 2e-8), (2, 2): (7.49e-19, 8e-10, 6e-4, 1e-8)}
    MIXED = ((1e-19 * 7.49e-19) ** 0.5, 8e-10, 6e-4, 2e-8)
    COEFF11 = "hamaker 1e-19 asperity 2e-8"


class SmallGapOfRoughSurfaces(PairHamaker):
    """The higher asperity is that of an unlike pair, though of a smaller radius: 0.86 against 4.3 um."""
    PARAMETERS = {(1, 1): (1e-19, 4e-10, 1e-7, (5e-9, 5e-7)), (2, 2): (7.49e-19, 8e-10, 2e-7, (1e-9, 5e-7))}
    MIXED = ((1e-19 * 7.49e-19) ** 0.5, 8e-10, 2e-7, (5e-9, 5e-7))
    GIVEN = (5e-19, 6e-10, 3e-8, (2e-9, 1e-6))
    COEFF11 = "hamaker 1e-19 roughness 5e-9 5e-7"
    # Radius and height are found again from the rms and wavelength that are written, but for four roundings and a
    # square of them; the force goes with their first power and minus second.
    LOST_IN_DATA_FILES = 16 * 2.0**-53


class ExactFormOfRoughSurfaces(ExactForm):
    PARAMETERS = {(1, 1): (1e-19, 4e-10, 1e-7, (5e-9, 5e-7)), (2, 2): (7.49e-19, 8e-10, 6e-4, 2e-9)}
    MIXED = ((1e-19 * 7.49e-19) ** 0.5, 8e-10, 6e-4, (5e-9, 5e-7))
    COEFF11 = "hamaker 1e-19 roughness 5e-9 5e-7"
    LOST_IN_DATA_FILES = SmallGapOfRoughSurfaces.LOST_IN_DATA_FILES


if __name__ == "__main__":
    unittest.main()
