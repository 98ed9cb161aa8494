// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_LARGEST_RADII_H
#define COHESION_LARGEST_RADII_H

#include <mpi.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include "atom.h"
#include "error.h"
#include "fix.h"
#include "lammps.h"
#include "modify.h"

namespace LAMMPS_NS {

/// The largest radius of each type [length], index 0 unused, over all ranks. The neighbour range is
/// fixed at init, so particles that fix pour or fix deposit will insert later count too. Of a group
/// alone, if given.
inline std::vector<double> largest_radii(LAMMPS* lmp, int groupbit = 1) {
  const Atom* atom = lmp->atom;
  std::vector<double> mine(atom->ntypes + 1, 0.0);
  for (int i = 0; i < atom->nlocal; i++)
    if (atom->mask[i] & groupbit)
      mine[atom->type[i]] = std::max(mine[atom->type[i]], atom->radius[i]);
  for (int ifix = 0; ifix < lmp->modify->nfix; ifix++) {
    Fix* fix = lmp->modify->fix[ifix];
    if (strcmp(fix->style, "pour") != 0 && strcmp(fix->style, "deposit") != 0) continue;
    if (!((1 | fix->groupbit) & groupbit)) continue;
    for (int type = 1; type <= atom->ntypes; type++) {
      int itype = type;
      if (const auto* radius = static_cast<double*>(fix->extract("radius", itype)))
        mine[type] = std::max(mine[type], *radius);
    }
  }
  std::vector<double> all(mine.size());
  MPI_Allreduce(mine.data(), all.data(), static_cast<int>(mine.size()), MPI_DOUBLE, MPI_MAX,
                lmp->world);
  return all;
}

/// The smallest radius of each type [length], index 0 unused, over all ranks; of a type without
/// particles the `largest` that are to come, 0 where none are. Of a group alone, if given.
inline std::vector<double> smallest_radii(LAMMPS* lmp, const std::vector<double>& largest,
                                          int groupbit = 1) {
  const Atom* atom = lmp->atom;
  constexpr double none = std::numeric_limits<double>::infinity();
  std::vector<double> mine(atom->ntypes + 1, none);
  for (int i = 0; i < atom->nlocal; i++)
    if (atom->mask[i] & groupbit)
      mine[atom->type[i]] = std::min(mine[atom->type[i]], atom->radius[i]);
  std::vector<double> all(mine.size());
  MPI_Allreduce(mine.data(), all.data(), static_cast<int>(mine.size()), MPI_DOUBLE, MPI_MIN,
                lmp->world);
  for (std::size_t type = 0; type < all.size(); type++)
    if (all[type] == none) all[type] = largest[type];
  return all;
}

/// Stops LAMMPS at a particle that outgrew `largest` of its type since a run was set up; `where`
/// stands in front of the message.
inline void check_radii(LAMMPS* lmp, const std::string& where, const std::vector<double>& largest) {
  const Atom* atom = lmp->atom;
  for (int i = 0; i < atom->nlocal; i++)
    if (atom->radius[i] > largest[atom->type[i]])
      lmp->error->one(FLERR,
                      "{}: particle {} of type {} has radius {}, its type had at most {} when the "
                      "run was set up; end the run before particles grow, and start a new one",
                      where, atom->tag[i], atom->type[i], atom->radius[i], largest[atom->type[i]]);
}

}  // namespace LAMMPS_NS

#endif
