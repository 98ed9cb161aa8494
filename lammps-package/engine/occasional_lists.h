// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_OCCASIONAL_LISTS_H
#define COHESION_OCCASIONAL_LISTS_H

#include "neigh_list.h"
#include "neighbor.h"
#include "npair.h"

namespace LAMMPS_NS {

/// To be called after the perpetual neighbour lists were rebuilt: makes the engine rebuild the
/// occasional lists, those of computes, at their next use. LAMMPS before 2022 keeps an occasional
/// list that was built earlier at the same time step, as at the end of the run before, although its
/// indices of particles are obsolete.
inline void discard_occasional_lists(const Neighbor* neighbor) {
  for (int n = 0; n < neighbor->nlist; n++) {
    const NeighList* const list = neighbor->lists[n];
    if (list && list->occasional && list->np) list->np->last_build = -1;
  }
}

}  // namespace LAMMPS_NS

#endif
