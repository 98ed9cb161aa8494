# SPDX-License-Identifier: BSD-3-Clause
"""Error of LIGGGHTS' contacts over the step where they last: its order, with and without dashpots, and what a load
presses (cohesion_tests/contact_errors.py)."""
import os
import unittest
from pathlib import Path

from cohesion_tests import lammps
from cohesion_tests.contact_errors import Orders
from cohesion_tests.theory import stacked_spheres as theory

SCRIPT = """
units si
atom_style sphere
atom_modify map array
boundary p p f
newton off
communicate single vel yes
region box block 0 1e-2 0 1e-2 -1e-3 3e-3 units box
create_box 2 box
{atoms}
set group all diameter {d} density {density}
neighbor 2e-4 bin
neigh_modify delay 0
fix kn all property/global kn peratomtypepair 2 {k} {k} {k} {k}
fix kt all property/global kt peratomtypepair 2 0 0 0 0
fix gn all property/global gamman_abs peratomtypepair 2 {pair!r} {wall!r} {wall!r} {wall!r}
fix gt all property/global gammat_abs peratomtypepair 2 0 0 0 0
fix D all property/global wellDepth peratomtypepair 2 0 0 0 0
fix ratio all property/global wellRatio peratomtype 1.01 1
pair_style gran model hooke/stiffness tangential off cohesion square_well absolute_damping on scheme {scheme}
pair_coeff * *
{walls}
fix move all nve/sphere
fix down all gravity {g} vector 0 0 -1
timestep {dt!r}
{output}
thermo 1000000
run {steps}
"""
SPHERE = "create_atoms 1 single 5e-3 5e-3 {!r} units box"
WALL = ("fix wall{n} all wall/gran model hooke/stiffness tangential off cohesion square_well primitive type 2 "
        "zplane {z!r} absolute_damping on scheme {scheme}")


def rows(scheme, e, dt, steps, heights, planes, output):
    """Of the file that the output writes."""
    walls = "\n".join(WALL.format(n=n, z=z, scheme=scheme) for n, z in enumerate(planes))
    script = SCRIPT.format(atoms="\n".join(map(SPHERE.format, heights)), d=theory.DIAMETER, density=theory.DENSITY,
                           k=theory.K, g=theory.GRAVITY, scheme=scheme, pair=theory.dashpot(e, theory.MASS / 2),
                           wall=theory.dashpot(e, theory.MASS), walls=walls, dt=dt, steps=steps, output=output)
    with lammps.temporary_folder() as folder:
        code, said = lammps.run_text(script, folder, lmp=os.environ["COHESION_LAUNCHER"])
        if code != 0:
            raise RuntimeError(said[-2000:])
        lines = (Path(folder) / "out.txt").read_text().split("\n")
    return [list(map(float, line.split())) for line in lines if line and not line.startswith("#")]


class Liggghts(Orders, unittest.TestCase):
    schemes = ("exact", "sampled")

    def stack(self, scheme, e, dt, every, steps):
        output = ("variable n equal step\nvariable a equal z[1]\nvariable b equal z[2]\n"
                  f'fix out all print {every} "${{n}} ${{a}} ${{b}}" file out.txt screen no')
        return rows(scheme, e, dt, steps, theory.START, (0.0, theory.HEIGHT), output)

    def overlap(self, scheme, e, dt, steps):
        start = theory.RADIUS - theory.MASS * theory.GRAVITY / theory.K
        output = (f"variable x equal 1e9*({theory.RADIUS}-z[1])\n"
                  'fix out all print 1 "${x}" file out.txt screen no')
        late = rows(scheme, e, dt, steps, (start,), (0.0,), output)[-steps // 2:]
        return sum(row[0] for row in late) / len(late) / 1e9

    def bounces(self, height, dt, every, steps):
        output = (f"variable a equal z[1]-{theory.RADIUS}\nvariable b equal v_a+vz[1]^2/2/{theory.GRAVITY}\n"
                  f'fix out all print {every} "${{a}} ${{b}}" file out.txt screen no')
        return rows("exact", 1, dt, steps, (theory.RADIUS + height,), (0.0,), output)


if __name__ == "__main__":
    unittest.main()
