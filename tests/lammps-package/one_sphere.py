# SPDX-License-Identifier: BSD-3-Clause
"""Beginning and end of scripts with one sphere, for what LAMMPS refuses, warns of and remembers."""
HEAD = """
plugin load ${plugin}
units si
atom_style sphere
boundary f f f
newton off
comm_modify vel yes
region box block 0 0.01 0 0.01 0 0.01 units box
create_box 2 box
create_atoms 1 single 0.002 0.005 0.005 units box
set group all diameter 1e-3 density 2650
velocity all set 0.01 0 0
neighbor 4e-4 bin
timestep 5e-6
"""
MOVE = "\nfix move all nve/sphere\nrun 2\n"
