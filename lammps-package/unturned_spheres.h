// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_UNTURNED_SPHERES_H
#define COHESION_UNTURNED_SPHERES_H

#include <vector>

#include "lammps.h"

namespace LAMMPS_NS {

class MobileParticles;

/// Warns of particles on which friction acts and that a fix moves and none turns: they slide as if
/// nothing could spin. `rubs`: by type, whether friction acts on it. Returns whether there are any,
/// on any rank; all ranks call it.
bool warn_of_unturned(LAMMPS*, const MobileParticles&, const std::vector<bool>& rubs);

}  // namespace LAMMPS_NS

#endif
