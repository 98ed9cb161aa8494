# SPDX-License-Identifier: BSD-3-Clause
"""Beginning and end of scripts with two particles at rest, spheres or points, for what LAMMPS refuses."""
HEAD = """
plugin load ${plugin}
units si
atom_style %(atoms)s
boundary f f p
newton off
region box block 0 0.01 0 0.01 0 0.01 units box
create_box 2 box
create_atoms 1 single 0.002 0.005 0.005 units box
create_atoms 2 single 0.008 0.005 0.005 units box
%(sizes)s
neighbor 1e-4 bin
timestep 1e-7
"""
SPHERES = HEAD % {"atoms": "sphere", "sizes": "set group all diameter 1e-3 density 2650"}
POINTS = HEAD % {"atoms": "atomic", "sizes": "mass * 1e-6\ncomm_modify cutoff 1e-3"}
TAIL = "\nfix move all nve\nrun 1\n"
PAIR = "pair_style hamaker cutoff 4e-10 1e-7\npair_coeff * * hamaker 1e-19\n"
