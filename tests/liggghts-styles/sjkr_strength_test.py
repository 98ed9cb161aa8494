# SPDX-License-Identifier: BSD-3-Clause
"""The page that brings LIGGGHTS' scripts to this package states the pull-off force of the engine's model sjkr: two
spheres that are drawn apart in the stock engine have it, and the page's table of Bond numbers follows from it."""
import os
import re
import unittest
from math import pi

from cohesion_tests import SOURCE, lammps
from cohesion_tests.thermo import thermo_columns

PAGE = SOURCE / "docs/getting-started/from-your-liggghts-case.md"
RADIUS, DENSITY, POISSON, GRAVITY = 5e-4, 2500.0, 0.22, 9.81
REDUCED, WEIGHT = RADIUS / 2, DENSITY * 4 / 3 * pi * RADIUS**3 * GRAVITY
#: Overlap that the spheres lose between two lines of output [m].
GRADE = 2e-9
SCRIPT = """
units        si
atom_style   granular
atom_modify  map array
boundary     f f f
newton       off
communicate  single vel yes
region       box block -3e-3 3e-3 -2e-3 2e-3 -2e-3 2e-3 units box
create_box   1 box
create_atoms 1 single -4.99e-4 0 0 units box
create_atoms 1 single 4.99e-4 0 0 units box
set          group all diameter 1e-3 density 2500
neighbor     2e-4 bin
neigh_modify delay 0
fix          E all property/global youngsModulus peratomtype {modulus}
fix          nu all property/global poissonsRatio peratomtype 0.22
fix          e all property/global coefficientRestitution peratomtypepair 1 1.0
fix          mu all property/global coefficientFriction peratomtypepair 1 0
fix          k all property/global cohesionEnergyDensity peratomtypepair 1 {density}
pair_style   gran model hertz tangential history cohesion sjkr
pair_coeff   * *
group        left id 1
group        right id 2
velocity     left set -1e-4 0 0 units box
velocity     right set 1e-4 0 0 units box
fix          contact all store/force
fix          hold all setforce 0 0 0
fix          move all nve/sphere
timestep     5e-6
compute      pull left reduce sum f_contact[1]
thermo_style custom step c_pull
thermo       2
run          2400
"""


def effective(modulus):
    return modulus / (2 * (1 - POISSON**2))


def strength(density, modulus):
    """As the page has it."""
    return 2 / 3 * pi**3 * REDUCED**2 * density**3 / effective(modulus) ** 2


class SjkrStrength(unittest.TestCase):
    def test_spheres_drawn_apart(self):
        for density, modulus in ((2e5, 2e7), (1e5, 2e7), (1e5, 1e7)):
            with self.subTest(k=density, E=modulus), lammps.temporary_folder() as folder:
                script = SCRIPT.format(density=density, modulus=modulus)
                code, output = lammps.run_text(script, folder, lmp=os.environ["COHESION_STOCK"])
                self.assertEqual(code, 0, output[-500:])
                found = max(thermo_columns(output)["pull"])
                # Overlap x of the largest pull, where c x^(3/2) - b x is least. The area of contact is pi R x less
                # x/(4 R) of it, of which the cube counts; between two lines of output the pull falls by
                # 3/4 (half a grade/x)^2. Six digits are printed.
                x = (2 * 2 * pi * REDUCED * density / (3 * 4 / 3 * effective(modulus) * REDUCED**0.5)) ** 2
                within = 3 * x / (4 * RADIUS) + 0.75 * (GRADE / 2 / x) ** 2 + 1e-6
                self.assertAlmostEqual(found / strength(density, modulus), 1, delta=within)

    def test_the_table_of_the_page(self):
        head = re.search(r"\| k \[J/m3\] \|(.*)\|\n", PAGE.read_text())
        moduli = [float(text) for text in re.findall(r"E = (\S+) Pa", head[1])]
        rows = re.findall(r"^\| (\de\d) \|(.*)\|$", PAGE.read_text(), re.M)
        self.assertGreaterEqual(len(rows) * len(moduli), 12)
        for density, numbers in rows:
            for modulus, number in zip(moduli, numbers.split("|"), strict=True):
                # Two digits and more are printed.
                self.assertAlmostEqual(float(number) / (strength(float(density), modulus) / WEIGHT), 1, delta=0.05)


if __name__ == "__main__":
    unittest.main()
