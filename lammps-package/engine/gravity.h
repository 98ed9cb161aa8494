// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_GRAVITY_H
#define COHESION_GRAVITY_H

#include <vector>

#include "lammps.h"

namespace LAMMPS_NS {

/// What the fixes gravity of this step put on the particles of this rank, [force], three numbers
/// each. The fixes do not tell their acceleration: they are let act on forces that are zero, which
/// are put back.
std::vector<double> weights(LAMMPS*);

}  // namespace LAMMPS_NS

#endif
