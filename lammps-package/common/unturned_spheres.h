// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef COHESION_UNTURNED_SPHERES_H
#define COHESION_UNTURNED_SPHERES_H

#include <mpi.h>

#include <algorithm>
#include <cstring>
#include <iterator>
#include <vector>

#include "atom.h"
#include "comm.h"
#include "common/message.h"
#include "error.h"
#include "fix.h"
#include "modify.h"

// Spheres that a fix moves and none turns, in both engines.

namespace LAMMPS_NS {

/// Whether a fix that integrates motion leaves spins as they are. Of a style that is not known here
/// none is said to, and neither of fix nve/noforce, which leads particles.
inline bool only_translates(const Fix* fix) {
  static constexpr const char* styles[] = {"nve", "nve/limit", "nvt", "npt", "nph", "nvt/sllod"};
  return std::any_of(std::begin(styles), std::end(styles),
                     [fix](const char* style) { return std::strcmp(fix->style, style) == 0; });
}

/// Warns of particles on which friction acts and that a fix moves and none turns: they slide as if
/// nothing could spin. mobile.is_not_turned(mask): whether a particle moves and nothing turns it;
/// has_friction: by type, whether friction acts on it. Returns whether there are any, on any rank;
/// all ranks call it.
template <class Mobile>
bool warn_of_unturned(const LAMMPS* lmp, const Mobile& mobile,
                      const std::vector<bool>& has_friction) {
  const Atom* const atom = lmp->atom;
  bigint mine = 0, all = 0;
  int my_groups = 0, groups = 0;
  for (int i = 0; i < atom->nlocal; i++) {
    if (!has_friction[atom->type[i]] || !mobile.is_not_turned(atom->mask[i])) continue;
    mine++;
    my_groups |= atom->mask[i];
  }
  MPI_Allreduce(&mine, &all, 1, MPI_LMP_BIGINT, MPI_SUM, lmp->world);
  MPI_Allreduce(&my_groups, &groups, 1, MPI_INT, MPI_BOR, lmp->world);
  if (all == 0) return false;
  const Modify* const modify = lmp->modify;
  const Fix* const mover =
      *std::find_if(modify->fix, modify->fix + modify->nfix, [groups](const Fix* fix) {
        return fix->time_integrate && only_translates(fix) && (fix->groupbit & groups);
      });
  if (lmp->comm->me == 0)
    lmp->error->warning(
        FLERR,
        message("friction acts on ", all, " particles that fix ", mover->id, " ", mover->style,
                " moves and does not turn: their spins stay as they are, and they slide "
                "where spheres roll; use 'fix nve/sphere'")
            .c_str());
  return true;
}

}  // namespace LAMMPS_NS

#endif
