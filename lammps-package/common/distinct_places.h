// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef COHESION_DISTINCT_PLACES_H
#define COHESION_DISTINCT_PLACES_H

#include <string>

#include "atom.h"
#include "comm.h"
#include "common/engine_api.h"
#include "common/message.h"
#include "neigh_list.h"
#include "vector3.h"

namespace LAMMPS_NS {

/// Stops at two particles in one place; `where` stands in front of the message.
inline void refuse_one_place(const LAMMPS* lmp, const std::string& where, int i, int j) {
  const Atom* const atom = lmp->atom;
  const double* const x = atom->x[i];
  const std::string text =
      message(where, ": particles ", atom->tag[i], " and ", atom->tag[j], " are in one place, (",
              x[0], ", ", x[1], ", ", x[2],
              "), where a contact has no direction: move one of them, or remove it, for "
              "instance by 'delete_atoms overlap'");
  if (lmp->comm->nprocs == 1) engine_api::error_of_all(lmp, FLERR, text);
  engine_api::error_of_one(lmp, FLERR, text);
}

/// That all pairs meet.
struct AllMeet {
  bool operator()(int, int) const { return true; }
};

/// Stops at neighbours whose centres are nearer than a millionth of their distance in contact.
/// meet(i, j): whether they can have a contact.
template <class Meet = AllMeet>
void require_distinct_places(const LAMMPS* lmp, const std::string& where, const NeighList* list,
                             const Meet& meet = {}) {
  constexpr double nearest = 1e-6;
  const Atom* const atom = lmp->atom;
  for (int ii = 0; ii < list->inum; ii++) {
    const int i = list->ilist[ii];
    for (int jj = 0; jj < list->numneigh[i]; jj++) {
      const int j = list->firstneigh[i][jj] & NEIGHMASK;
      const auto d = cohesion::vector(atom->x[j]) - cohesion::vector(atom->x[i]);
      if (norm(d) <= nearest * (atom->radius[i] + atom->radius[j]) && meet(i, j))
        refuse_one_place(lmp, where, i, j);
    }
  }
}

}  // namespace LAMMPS_NS

#endif
