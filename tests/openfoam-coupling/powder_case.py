# SPDX-License-Identifier: BSD-3-Clause
"""A case as cohesion-powder writes it runs unedited to its end, in a box and in a round column, of one size, of a
distribution, of parcels, with square wells and with Hertz's and JKR's contact, for each engine: the pressure drop is
what the gas puts on the grains, and they stay in."""

import os
import subprocess
import unittest
from pathlib import Path

import numpy as np

from cohesion_studies.foam_case import environment
from cohesion_tests.coupling.cases import ENGINE, exchange_lines
from cohesion_tests.coupling.fields import numbers
from cohesion_tests.coupling.test_case import CoupledTestCase
from cohesion_tests.csv_program import CsvProgram

program = CsvProgram("COHESION_POWDER")
G, RHO, MU = 9.81, 1.205, 1.82e-5
BUILD, WORK = os.environ["COHESION_BUILD"], Path(os.environ["COHESION_WORK"])
DENSITY, STIFFNESS = 2500, 100
GRAINS = ("--density", DENSITY, "--stiffness", STIFFNESS, "--hamaker", 6.5e-20, "--engine", ENGINE)
# Hertz's and JKR's contact of glass, at a softer modulus.
YOUNG, POISSON, SOFT = 63e9, 0.22, 1e6
ELASTIC = ("--density", DENSITY, "--young", YOUNG, "--poisson", POISSON, "--soft-young", SOFT, "--engine", ENGINE)


def spring_overlap(speed, d):
    return speed * np.sqrt(DENSITY * np.pi / 6 * d**3 / STIFFNESS)


def elastic_overlap(speed, d):
    """On a wall, by Hertz; an adhesion that keeps the escape velocity adds some thousandths of it."""
    mass, modulus = DENSITY * np.pi / 6 * d**3, SOFT / (2 * (1 - POISSON**2))
    return 1.05 * (15 * mass * speed**2 / (16 * modulus * np.sqrt(d / 2)))**0.4
BOX = ("--width", 0.05, "--depth", 0.05, "--height", 0.08, "--grains", 900)
COLUMN = ("--column", 0.0091, "--height", 0.003, "--grains", 2000)


def entry(case, name):
    return float((case / "constant/powder").read_text().split(f"\n{name} ")[1].split(";")[0])


class PowderCase(CoupledTestCase):
    def check(self, name, *words, across=None, cell=1.5e-3, grains=GRAINS, overlap=spring_overlap):
        case = WORK / name
        subprocess.run(["rm", "-rf", str(case)], check=True)
        code, _, said = program.call(*words, *grains, "--write", case)
        self.expect_equal(f"{name}: code of cohesion-powder: {said}", code, 0)
        done = subprocess.run(["./Allrun"], cwd=case, env=environment(BUILD), capture_output=True, text=True)
        self.expect_equal(f"{name}: code of Allrun\n{done.stdout[-2000:]}", done.returncode, 0)
        log = (case / "log.cohesiveBedFoam").read_text()
        self.expect_true(f"{name}: written with all digits", "fields are written with" not in log)
        self.expect_below(f"{name}: imbalance of momentum [1]",
                          max(line["imbalance"] for line in exchange_lines(log)), 1e-10)
        # The last of the times that are written; Allrun left 0.
        last = max((folder.name for folder in case.glob("0.[0-9]*")), key=float)
        self.expect_equal(f"{name}: time at the end [s]", last, "0.1")
        self.check_drop(name, case, cell)
        self.check_places(name, case, across, overlap)
        return log

    def check_drop(self, name, case, cell):
        """What the gas loses in pressure it puts on the grains, but for what it keeps of momentum and loses at walls."""
        drop = np.loadtxt(case / "postProcessing/drop/0/bedPressureDrop.dat")
        forces = np.loadtxt(case / "postProcessing/forces/0/forceBudget.dat")
        time, over, gravity, gas = forces[:, 0], forces[:, 1], forces[:, 4], forces[:, 7] + forces[:, 10]
        late = time > 0.05
        mean = lambda column: np.average(column[late], weights=over[late])
        weight = drop[-1, 4]
        # The grains' buoyancy in the gas at rest is in the engine's pressure force and not in the drop.
        area = mean(-gravity) * (1 - RHO / DENSITY) / weight
        carried = mean(gas) / area - (mean(-gravity) / area - weight)
        # The superficial flux is the same at all heights and times, and with it the gas's momentum. What leaves with it
        # is as much as comes in but for jets, at the plate those between grains; walls drag on it over half a cell.
        superficial, top = entry(case, "velocity"), entry(case, "top")
        speed = superficial / 0.42
        off = RHO * superficial * speed + MU * speed / (cell / 2) * 4 * top / np.sqrt(area)
        self.expect_near(f"{name}: pressure drop over weight [1]", mean(drop[:, 3]) / weight, carried / weight,
                         off / weight)
        self.expect_below(f"{name}: that limit [1]", off / weight, 0.06)

    def check_places(self, name, case, across, overlap):
        cloud = max(case.glob("0.[0-9]*"), key=lambda folder: float(folder.name)) / "lagrangian/particles"
        places = numbers(cloud / "positions", 4)[:, :3]
        written = (case / "grains.data").read_text().split(" atoms")[0].split()[-1]
        self.expect_equal(f"{name}: grains at the end", len(places), int(written))
        # The gas is slower than any grain falls; one from the top of the vessel presses a wall the farthest.
        speed = np.sqrt(2 * G * entry(case, "top"))
        nearest = lambda d: d / 2 - overlap(speed, d)
        if across:
            self.expect_below(f"{name}: farthest from the axis [m]", np.hypot(places[:, 0], places[:, 1]).max(),
                              across / 2 - nearest(5e-4))
        self.expect_true(f"{name}: all are above the plate", places[:, 2].min() > nearest(4e-4))

    @unittest.skipUnless(ENGINE == "lammps", "cells are the coupling's part; other tests have two sizes in a box")
    def test_two_sizes_in_finer_cells(self):
        self.check("two", "--diameter", 4e-4, 6e-4, "--cell", 2, *BOX, cell=1e-3)

    def test_column(self):
        self.check("column", "--diameter", 5e-4, *COLUMN, across=0.009)

    def check_escape_velocity(self, name, *words):
        """The engine prints that of each two types, which is that of the material."""
        said = program.values(*words)
        rows = [line.split() for line in (WORK / f"{name}/log.{ENGINE}").read_text().split("\n")]
        # The last but one column, of which three digits are printed.
        self.expect_true("the engine's table has the column", any(row[-2:] == ["v_esc", "tail/spring"] for row in rows))
        pairs = [row for row in rows if row[:3] == ["1", "-", "1"]]
        self.expect_true("the engine's table has the pairs of the smallest", len(pairs) > 0)
        self.expect_near("v_esc of the engine's table over the program's [1]",
                         float(pairs[0][-2]) / said["material_escape"], 1, 5e-3)

    def test_square_wells(self):
        words = ("--diameter", 4e-4, 6e-4, "--law", "square_well")
        self.check("wells", *words, *BOX)
        self.check_escape_velocity("wells", *words, *GRAINS)

    def test_hertz(self):
        words = ("--diameter", 4e-4, 6e-4, "--contact", "hertz", "--hamaker", 6.5e-20)
        self.check("hertz", *words, *BOX, grains=ELASTIC, overlap=elastic_overlap)
        self.check_escape_velocity("hertz", *words, *ELASTIC)

    def test_jkr(self):
        words = ("--diameter", 4e-4, 6e-4, "--contact", "jkr", "--surface-energy", 0.02)
        self.check("jkr", *words, *BOX, grains=ELASTIC, overlap=elastic_overlap)
        self.check_escape_velocity("jkr", *words, *ELASTIC)

    @unittest.skipUnless(ENGINE == "lammps", "the coupling's part, with every engine")
    def test_parcels(self):
        log = self.check("parcels", "--diameter", 2.5e-4, "--coarse-graining", 2, *BOX)
        self.expect_true("what spheres stand for is in the log", "coarseGraining 2: each sphere stands for 8 grains" in log)


if __name__ == "__main__":
    unittest.main()
