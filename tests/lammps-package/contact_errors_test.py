# SPDX-License-Identifier: BSD-3-Clause
"""Error of gran/hamaker over the step where contacts last: its order, with and without dashpots, and what a load
presses (cohesion_tests/contact_errors.py)."""
import unittest
from pathlib import Path

from cohesion_tests import csv_table, lammps
from cohesion_tests.contact_errors import Orders
from cohesion_tests.theory import stacked_spheres as theory

SCRIPT = """
plugin load ${{plugin}}
units si
atom_style sphere
atom_modify map array
boundary p p f
newton off
comm_modify vel yes
region box block 0 1e-2 0 1e-2 -1e-3 3e-3
create_box 1 box
{atoms}
set group all diameter {d} density {density}
neighbor 2e-4 bin
pair_style gran/hamaker scheme {scheme}
pair_coeff * * stiffness {k} restitution {e}
fix walls all wall/gran/hamaker stiffness {k} restitution {e} zplane 0 {top} scheme {scheme}
fix move all nve/sphere
fix down all gravity {g} vector 0 0 -1
timestep {dt!r}
{output}
thermo 1000000
run {steps}
"""
SPHERE = "create_atoms 1 single 5e-3 5e-3 {!r}"


def rows(scheme, e, dt, steps, heights, top, output):
    """Of the file that the output writes."""
    script = SCRIPT.format(atoms="\n".join(map(SPHERE.format, heights)), d=theory.DIAMETER, density=theory.DENSITY,
                           k=theory.K, g=theory.GRAVITY, scheme=scheme, e=e, top=top, dt=dt, steps=steps, output=output)
    with lammps.temporary_folder() as folder:
        code, said = lammps.run_text(script, folder)
        if code != 0:
            raise RuntimeError(said[-2000:])
        lines = (Path(folder) / "out.txt").read_text().split("\n")
    return [list(map(float, line.split())) for line in lines if line and not line.startswith("#")]


class Lammps(Orders, unittest.TestCase):
    schemes = ("exact", "sampled")

    def enter(self, quantity, step, value):
        csv_table.enter(csv_table.of_test("contact_motion"),
                        {"measurement": "persistent contacts", "quantity": quantity, "step": step}, value=value)

    def stack(self, scheme, e, dt, every, steps):
        output = ("variable a equal z[1]\nvariable b equal z[2]\n"
                  f"fix out all ave/time {every} 1 {every} v_a v_b file out.txt format ' %.17g'")
        return rows(scheme, e, dt, steps, theory.START, repr(theory.HEIGHT), output)

    def overlap(self, scheme, e, dt, steps):
        start = theory.RADIUS - theory.MASS * theory.GRAVITY / theory.K
        half = steps // 2
        output = (f"variable x equal {theory.RADIUS}-z[1]\n"
                  f"fix out all ave/time 1 {half} {half} v_x file out.txt format ' %.17g'")
        return rows(scheme, e, dt, steps, (start,), "NULL", output)[-1][1]

    def bounces(self, height, dt, every, steps):
        output = (f"variable a equal z[1]-{theory.RADIUS}\nvariable b equal v_a+vz[1]^2/2/{theory.GRAVITY}\n"
                  f"fix out all ave/time {every} 1 {every} v_a v_b file out.txt format ' %.17g'")
        found = rows("exact", 1, dt, steps, (theory.RADIUS + height,), "NULL", output)
        return [row[1:] for row in found]


if __name__ == "__main__":
    unittest.main()
