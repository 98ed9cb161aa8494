# SPDX-License-Identifier: BSD-3-Clause
"""A bound cluster in the closest packing, slightly displaced: are discrete forces of several contacts stable?"""

SCRIPT = """plugin load ${{plugin}}
units si
atom_style sphere
boundary f f f
newton off
comm_modify vel yes
lattice fcc {lattice}
region box block -{box} {box} -{box} {box} -{box} {box}
create_box 1 box
region ball sphere 0 0 0 {radius}
create_atoms 1 region ball
set group all diameter {diameter} density {density}
displace_atoms all random 1e-9 1e-9 1e-9 4711
neighbor 2e-4 bin
pair_style gran/hamaker
pair_coeff * * {coefficients}
fix move all nve/sphere
compute motion all ke
compute spins all erotate/sphere
thermo_style custom step c_motion c_spins
timestep {dt}
run {steps}
"""


def script(lattice, box, radius, dt, steps, coefficients, diameter=1e-3, density=2650):
    """lattice [m]: edge of the cubic cell; box (half its edge) and radius of the cluster in such edges."""
    return SCRIPT.format(lattice=lattice, box=box, radius=radius, diameter=diameter, density=density,
                         coefficients=coefficients, dt=dt, steps=steps)
