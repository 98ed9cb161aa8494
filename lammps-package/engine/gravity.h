// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_GRAVITY_H
#define COHESION_GRAVITY_H

#include <vector>

#include "lammps.h"

namespace LAMMPS_NS {

/// Returns the weights of the particles of this rank, the forces of the fixes gravity in this step,
/// [force], three numbers each. The fixes do not give their acceleration: they are let act on
/// forces that are zero, and the forces are restored.
std::vector<double> weights(LAMMPS*);

}  // namespace LAMMPS_NS

#endif
