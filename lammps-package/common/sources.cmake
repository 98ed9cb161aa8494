# SPDX-License-Identifier: GPL-2.0-or-later
# Sets common: the sources that the builds for LAMMPS and for LIGGGHTS take.
set(common
  held_spheres.cpp plausible_sizes.cpp fix_deform_shear.cpp shear_compatibility.cpp compute_shear_profile.cpp fix_agglomerates.cpp
  fragment_exchange.cpp renumbering.cpp fix_gas_coupling.cpp fix_drive.cpp)
list(TRANSFORM common PREPEND ${CMAKE_CURRENT_LIST_DIR}/)
