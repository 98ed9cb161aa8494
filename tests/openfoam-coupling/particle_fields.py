# SPDX-License-Identifier: BSD-3-Clause
"""The function object particleFields on spheres that fly straight, each with its own velocity: the fields of each cell
against sums over the spheres in it, time averages against those of the instants; with a kernel that spreads spheres
over cells, and with smoothing, sums over the mesh. On 1 and 2 ranks."""

import unittest

import numpy as np

from bed_outputs import BOX, D, GAS_STEP, STEP, T, lattice, make
from cohesion_tests.coupling.cases import COUPLING, append
from cohesion_tests.coupling.fields import field
from cohesion_tests.coupling.test_case import CoupledTestCase

MESH = np.array([3, 3, 10])  # cells of the column
CELL = BOX.prod() / MESH.prod()
VOLUME = np.pi / 6 * D**3
FUNCTIONS = f"""
deltaT {GAS_STEP}; endTime {T}; writeInterval {T};
functions
{{
    particles {{ type particleFields; libs (cohesionFunctionObjects); writeControl writeTime; }}
    average
    {{
        type fieldAverage; libs (fieldFunctionObjects); writeControl writeTime;
        fields
        (
            particleVolumeFraction {{ mean on; prime2Mean off; base time; }}
            particleMomentum       {{ mean on; prime2Mean off; base time; }}
        );
    }}
}}
"""
# The engine adds up 200 steps, each rounded by 1e-16 of the box; a velocity is that of the data file.
DIGITS = 1e-11


class ParticleFields(CoupledTestCase):
    def solved(self, what, velocities, ranks, coupling=""):
        """The fields at the end, by their names."""
        case = make(self.column, what.replace(" ", "-"), "flight", lattice(), velocities, 1e12, FUNCTIONS)
        append(case, COUPLING, f"particleGravity any; dragFactor 1e-15; lammpsCoeffs {{ variables {{ dt {STEP};"
                               f" period f; }} }} {coupling}")
        case.solve(ranks=ranks)
        if ranks > 1:
            case.run("reconstructPar", "-latestTime")
        names = ("particleVolumeFraction", "particleNumberDensity", "particleVelocity", "granularTemperature",
                 "particleDiameter", "particleVolumeFractionMean", "particleMomentum", "particleMomentumMean")
        fields = {name: field(case, f"{T:g}", name) for name in names}
        for name in ("particleVelocity", "particleMomentum", "particleMomentumMean"):
            fields[name] = fields[name].reshape(-1, 3)
        return fields

    @staticmethod
    def velocities():
        """Spheres fly towards others' places near them: none comes to a wall, many change cells."""
        random = np.random.default_rng(8)
        start = lattice()
        end = start + random.uniform(-0.02, 0.02, start.shape)
        return (np.clip(end, D, BOX - D) - start) / T

    @staticmethod
    def cells(places):
        """The cell of each place, in the order of blockMesh."""
        index = np.minimum((places / BOX * MESH).astype(int), MESH - 1)
        return index @ np.array([1, MESH[0], MESH[0] * MESH[1]])

    def near(self, what, found, expected, scale):
        self.expect_below(what, np.abs(found - expected).max(), DIGITS * scale)

    def each_cell(self, ranks):
        what = f"centres on {ranks} ranks"
        v = self.velocities()
        found = self.solved(what, v, ranks)
        count = lambda time: np.bincount(self.cells(lattice() + time * v), minlength=MESH.prod())
        number, cell = count(T), self.cells(lattice() + T * v)
        full = number > 0
        self.expect_true(f"{what}: cells with and without spheres", full.any() and not full.all())
        mean, square = np.zeros((MESH.prod(), 3)), np.zeros(MESH.prod())
        np.add.at(mean, cell, v)
        np.add.at(square, cell, (v**2).sum(axis=1))
        mean[full] /= number[full, None]
        variance = np.zeros(MESH.prod())
        variance[full] = square[full] / number[full] - (mean[full] ** 2).sum(axis=1)
        most = (v**2).sum(axis=1).max()
        self.near(f"{what}: volume fraction", found["particleVolumeFraction"], number * VOLUME / CELL, 1)
        self.near(f"{what}: number density", found["particleNumberDensity"], number / CELL, 1 / VOLUME)
        self.near(f"{what}: velocity", found["particleVelocity"], mean, np.sqrt(most))
        self.near(f"{what}: granular temperature", found["granularTemperature"], variance / 3, most)
        self.near(f"{what}: diameter", found["particleDiameter"], D * full, D)
        steps = round(T / GAS_STEP)
        average = sum(count(GAS_STEP * (k + 1)) for k in range(steps)) / steps * VOLUME / CELL
        # One sphere that rounding puts on the other side of a face in one of the steps is 1/steps of one.
        self.near(f"{what}: its time average", found["particleVolumeFractionMean"], average, 1)
        self.mean_velocity(what, found, v)

    def mean_velocity(self, what, found, v):
        """The quotient of the averages is the mean over all spheres of all steps in a cell."""
        steps = round(T / GAS_STEP)
        momentum, numbers = np.zeros((MESH.prod(), 3)), np.zeros((steps, MESH.prod()))
        for k in range(steps):
            cell = self.cells(lattice() + GAS_STEP * (k + 1) * v)
            np.add.at(momentum, cell, v)
            np.add.at(numbers[k], cell, 1)
        self.near(f"{what}: momentum", found["particleMomentum"],
                  found["particleVolumeFraction"][:, None] * found["particleVelocity"], np.abs(v).max())
        number = numbers.sum(axis=0)
        full = number > 0
        self.expect_true(f"{what}: numbers of spheres that change", np.ptp(numbers, axis=0).any())
        mean = found["particleMomentumMean"][full] / found["particleVolumeFractionMean"][full, None]
        self.near(f"{what}: mean velocity", mean, momentum[full] / number[full, None], np.abs(v).max())

    def sums(self, name, coupling, ranks):
        what = f"{name} on {ranks} ranks"
        v = self.velocities()
        found = self.solved(what, v, ranks, coupling)
        alpha, mean = found["particleVolumeFraction"], found["particleVelocity"]
        volume = len(v) * VOLUME
        squares = (mean**2).sum(axis=1) + 3 * found["granularTemperature"]
        self.expect_near(f"{what}: volume", (alpha * CELL).sum() / volume, 1, DIGITS)
        self.expect_near(f"{what}: number", (found["particleNumberDensity"] * CELL).sum() / len(v), 1, DIGITS)
        self.near(f"{what}: momentum", (alpha[:, None] * mean * CELL).sum(axis=0) / volume, v.mean(axis=0),
                  np.abs(v).max())
        self.expect_near(f"{what}: energy", (alpha * squares * CELL).sum() / volume / (v**2).sum(axis=1).mean(), 1,
                         DIGITS)

    def test_each_cell(self):
        for ranks in (1, 2):
            self.each_cell(ranks)

    def test_sums_over_the_mesh(self):
        self.sums("divided", "voidFraction dividedVolume;", 1)
        self.sums("smoothed", f"smoothingWidth {2 * D};", 2)


if __name__ == "__main__":
    unittest.main()
