// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef COHESION_SEVERAL_NEIGHBOURS_H
#define COHESION_SEVERAL_NEIGHBOURS_H

#include <mpi.h>

#include <vector>

#include "advice/contact_report.h"
#include "atom.h"
#include "lammps.h"
#include "neigh_list.h"

namespace LAMMPS_NS {

/// Whether a particle of this rank has several neighbours in a list, which may be null. A half list
/// has each pair once.
inline bool has_several_neighbours(const LAMMPS* lmp, const NeighList* list) {
  if (!list || !list->numneigh) return false;
  std::vector<int> neighbours(lmp->atom->nlocal + lmp->atom->nghost, 0);
  for (int ii = 0; ii < list->inum; ii++) {
    const int i = list->ilist[ii], jnum = list->numneigh[i];
    if (jnum > 1 || (neighbours[i] += jnum) > 1) return true;
    if (jnum == 1 && ++neighbours[list->firstneigh[i][0] & NEIGHMASK] > 1) return true;
  }
  return false;
}

/// How many contacts a particle may have. mine: whether one of this rank may have several. All
/// ranks call it.
inline cohesion::advice::Crowd crowd_of_all(const LAMMPS* lmp, bool mine) {
  const int flag = mine;
  int several = 0;
  MPI_Allreduce(&flag, &several, 1, MPI_INT, MPI_MAX, lmp->world);
  if (several) return cohesion::advice::Crowd::several;
  return lmp->atom->natoms > 2 ? cohesion::advice::Crowd::separate : cohesion::advice::Crowd::pair;
}

}  // namespace LAMMPS_NS

#endif
