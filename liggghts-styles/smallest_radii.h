// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef COHESION_SMALLEST_RADII_H
#define COHESION_SMALLEST_RADII_H

#include <mpi.h>
// The engine's headers want mpi.h before them.
#include <algorithm>
#include <limits>
#include <vector>

#include "atom.h"
#include "fix.h"
#include "lammps.h"
#include "modify.h"

namespace LIGGGHTS {
namespace Cohesion {

/// By type, of all particles and of those still to be inserted, [length]; infinite: there are none.
inline std::vector<double> smallest_radii(const LAMMPS_NS::LAMMPS* lmp) {
  const LAMMPS_NS::Atom* const atom = lmp->atom;
  std::vector<double> mine(atom->ntypes + 1, std::numeric_limits<double>::infinity());
  const auto take = [&](int type, double radius) { mine[type] = std::min(mine[type], radius); };
  for (int i = 0; i < atom->nlocal; i++) take(atom->type[i], atom->radius[i]);
  for (int k = 0; k < lmp->modify->nfix; k++)
    for (int type = 1; type <= atom->ntypes; type++) {
      const double inserted = lmp->modify->fix[k]->min_rad(type);
      if (inserted > 0.0) take(type, inserted);
    }
  std::vector<double> all(mine.size());
  MPI_Allreduce(mine.data(), all.data(), static_cast<int>(mine.size()), MPI_DOUBLE, MPI_MIN,
                lmp->world);
  return all;
}

}  // namespace Cohesion
}  // namespace LIGGGHTS

#endif
