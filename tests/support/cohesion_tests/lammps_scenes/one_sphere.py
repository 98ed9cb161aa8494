# SPDX-License-Identifier: BSD-3-Clause
"""Beginning and end of scripts with one sphere, for what LAMMPS refuses, warns of and remembers."""
from cohesion_tests.lammps_scenes.small_box import box, spheres

HEAD = box(types=2) + spheres((1, 0.002, 0.005, 0.005)) + """velocity all set 0.01 0 0
neighbor 4e-4 bin
timestep 5e-6
"""
MOVE = "\nfix move all nve/sphere\nrun 2\n"
