#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Tensile strength of packings of adhesive grains in LAMMPS against the step, both schemes.

  tensile-strength.py LMP_COHESION PLUGIN [--packings N]

350 grains of 75 um settle on a plate that they stick to, a second plate is pressed on them, once for all runs of a
packing, and drawn away slowly. The strength is the largest tension of the plate, as a mean over a hundredth of its way.
Packings differ by the places that the grains fall from. Printed for each packing: the strengths [Pa]; at the end, for
each step, the mean over the packings and that of the strength over the one of the last row, with standard errors.
"""
import argparse
import math
import os
import re

import numpy

from cohesion_tests import lammps
from cohesion_tests.launcher import given_program

STIFFNESS, DIAMETER, DENSITY = 50.0, 75e-6, 1500.0
CONTACT_TIME = math.pi * math.sqrt(DENSITY * math.pi / 6 * DIAMETER**3 / 2 / STIFFNESS)
RUNS = (("exact", 8), ("exact", 10), ("exact", 20), ("exact", 40), ("sampled", 100))

SETTLE = """units si
atom_style sphere
atom_modify map array
boundary p p f
newton off
comm_modify vel yes
region box block 0 4.5e-4 0 4.5e-4 -1e-5 2.5e-3
create_box 1 box
neighbor 2e-5 bin
lattice sc 9e-5
region fill block 0 4.5e-4 0 4.5e-4 4e-5 1.3e-3 units box
create_atoms 1 region fill
displace_atoms all random 6e-6 6e-6 6e-6 ${SEED} units box
set group all diameter 75e-6
set group all density 1500
pair_style gran/hamaker
pair_coeff * * stiffness 50 restitution 0.5 friction 0.4 hamaker $A cutoff 4e-10 1e-7
fix floor all wall/gran/hamaker stiffness 50 restitution 0.5 friction 0.4 hamaker $(5*v_A) cutoff 4e-10 1e-7 zplane 0 NULL
fix g all gravity 100 vector 0 0 -1
fix v all viscous 1e-8
fix move all nve/sphere
timestep 5e-7
thermo 5000
run 40000
unfix g
fix g all gravity 20 vector 0 0 -1
run 20000
unfix g
# Pressed: the plate comes from 2 um above the highest grain to 38 um below, where it meets many, and stays there.
variable z0 equal bound(all,zmax)+37.5e-6-1e-6
variable low equal ${z0}-38e-6
fix top all wall/gran/hamaker stiffness 50 restitution 0.5 friction 0.4 hamaker $(20*v_A) cutoff 4e-10 1e-7 zplane NULL $(v_z0+2e-6) translate z -2.5e-3
run 32000
unfix top
fix top all wall/gran/hamaker stiffness 50 restitution 0.5 friction 0.4 hamaker $(20*v_A) cutoff 4e-10 1e-7 zplane NULL ${low}
run 40000
print "PLATE ${low}"
write_data packing.data
"""

PULL = """units si
atom_style sphere
atom_modify map array
boundary p p f
newton off
comm_modify vel yes
read_data packing.data
neighbor 2e-5 bin
pair_style gran/hamaker scheme ${SCHEME}
pair_coeff * * stiffness 50 restitution 0.5 friction 0.4 hamaker $A cutoff 4e-10 1e-7
fix floor all wall/gran/hamaker stiffness 50 restitution 0.5 friction 0.4 hamaker $(20*v_A) cutoff 4e-10 1e-7 zplane 0 NULL scheme ${SCHEME}
variable n2 equal round(20e-3/${DT})
fix move all nve/sphere
fix v all viscous 2e-9
timestep ${DT}
fix top all wall/gran/hamaker stiffness 50 restitution 0.5 friction 0.4 hamaker $(20*v_A) cutoff 4e-10 1e-7 zplane NULL ${PLATE} translate z 4e-4 scheme ${SCHEME}
variable s equal f_top[3]/(4.5e-4)^2
thermo_style custom step v_s ke
thermo_modify norm no
thermo $(ceil(v_n2/2000))
run $(v_n2)
"""


def go(script, folder):
    code, output = lammps.run_text(script, folder)
    if code != 0:
        raise RuntimeError(output[-3000:])
    return output


def strengths(folder, head, seed):
    """Of one packing [Pa], a row of RUNS each."""
    plate = re.search(r"^PLATE (\S+)", go(f"variable SEED index {seed}\n" + head + SETTLE, folder), re.MULTILINE)[1]
    found = []
    for scheme, division in RUNS:
        dt = CONTACT_TIME / division
        given = f"variable DT index {dt!r}\nvariable SCHEME index {scheme}\nvariable PLATE index {plate}\n"
        output = go(given + head + PULL, folder)
        rows = [tuple(map(float, row)) for row in re.findall(r"^ *(\d+) +(\S+) +(\S+) *$", output, re.MULTILINE)]
        tension = -numpy.array([row[1] for row in rows])
        found.append(numpy.convolve(tension, numpy.full(20, 1 / 20), "valid").max())
    return found


def with_error(values):
    return f"{values.mean():.4g} +- {values.std(ddof=1) / math.sqrt(len(values)):.2g}"


def main():
    words = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    words.add_argument("lmp", type=given_program)
    words.add_argument("plugin", type=given_program)
    words.add_argument("--packings", type=int, default=24, help="at least two")
    words = words.parse_args()
    os.environ["COHESION_LMP"], os.environ["COHESION_PLUGIN"] = words.lmp, words.plugin
    head = f"variable A index 2e-20\nplugin load {words.plugin}\n"
    print("packing " + "".join(f"{f'{scheme} t_c/{division}':>16}" for scheme, division in RUNS), flush=True)
    found = []
    for number in range(words.packings):
        with lammps.temporary_folder() as folder:
            found.append(strengths(folder, head, 4711 + number))
        print(f"{number:7d} " + "".join(f"{strength:16.2f}" for strength in found[-1]), flush=True)
    found = numpy.array(found)
    print(f"\n{'scheme':>8} {'step':>8} {'strength [Pa]':>18} {'over the last':>18}")
    for (scheme, division), values in zip(RUNS, found.T):
        print(f"{scheme:>8} {f't_c/{division}':>8} {with_error(values):>18} {with_error(values / found[:, -1]):>18}")


if __name__ == "__main__":
    main()
