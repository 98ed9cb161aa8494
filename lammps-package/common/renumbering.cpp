// SPDX-License-Identifier: GPL-2.0-or-later
#include "common/renumbering.h"

#include <mpi.h>
// LIGGGHTS' headers want mpi.h before them.
#include <cstddef>
#include <unordered_map>

#include "atom.h"
#include "comm.h"

using namespace LAMMPS_NS;

Renumbering::Renumbering(LAMMPS* lammps, const std::vector<tagint>& before) : Pointers(lammps) {
  int mine = 0, all = 0;
  for (std::size_t i = 0; i < before.size(); i++) {
    if (before[i] != atom->tag[i]) mine = 1;
    if (before[i] != 0) own_.insert(own_.end(), {before[i], atom->tag[i]});
  }
  MPI_Allreduce(&mine, &all, 1, MPI_INT, MPI_MAX, world);
  any_ = all != 0;
}

/// The processes name their particles one after the other: none has them all at once.
void Renumbering::translate(std::vector<tagint>& ids) const {
  std::unordered_map<tagint, tagint> now;
  for (const tagint id : ids) now[id] = 0;
  for (int process = 0; process < comm->nprocs; process++) {
    std::vector<tagint> changes;
    if (process == comm->me) changes = own_;
    int count = static_cast<int>(changes.size());
    MPI_Bcast(&count, 1, MPI_INT, process, world);
    changes.resize(count);
    MPI_Bcast(changes.data(), count, MPI_LMP_TAGINT, process, world);
    for (int k = 0; k < count; k += 2) {
      const auto found = now.find(changes[k]);
      if (found != now.end()) found->second = changes[k + 1];
    }
  }
  for (tagint& id : ids) id = now[id];
}
