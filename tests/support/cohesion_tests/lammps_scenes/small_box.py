# SPDX-License-Identifier: BSD-3-Clause
"""Opening of scripts with a few spheres in a small box, for what LAMMPS refuses, warns of and remembers."""


def box(types=1, size=(0.01, 0.01, 0.01), boundary="f f f", ghosts="vel yes"):
    """The box of this size [m] with its lower corner at the origin; ghosts: of comm_modify."""
    sides = " ".join(f"0 {side}" for side in size)
    return f"""
plugin load ${{plugin}}
units si
atom_style sphere
boundary {boundary}
newton off
comm_modify {ghosts}
region box block {sides} units box
create_box {types} box
"""


def spheres(*places):
    """Of 1 mm and 2650 kg/m^3, each at (type, x, y, z) [m]."""
    made = "".join("create_atoms {} single {} {} {} units box\n".format(*place) for place in places)
    return made + "set group all diameter 1e-3 density 2650\n"
