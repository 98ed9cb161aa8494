// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef COHESION_UNMOVED_SPHERES_H
#define COHESION_UNMOVED_SPHERES_H

#include <mpi.h>

#include <cstring>
#include <vector>

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "fix.h"
#include "modify.h"
#include "update.h"

// Runs of several steps in which nothing moves the spheres, in both engines.

namespace LAMMPS_NS {

/// Bits of the groups that fixes move, or hold deliberately. All of them where fix deform may carry
/// particles along with the box.
inline int moved_or_held_groups(const Modify* modify) {
  static constexpr const char* holding[] = {"freeze", "setforce", "lineforce", "planeforce"};
  int groups = 0;
  for (int k = 0; k < modify->nfix; k++) {
    const Fix* const fix = modify->fix[k];
    if (std::strcmp(fix->style, "deform") == 0) return ~0;
    if (fix->time_integrate || fix->rigid_flag || std::strcmp(fix->style, "multisphere") == 0)
      groups |= fix->groupbit;
    for (const char* const style : holding)
      if (std::strcmp(fix->style, style) == 0) groups |= fix->groupbit;
  }
  return groups;
}

/// Warns of a run of at least one step in which no fix moves or holds any particle: contacts are
/// computed and nothing comes of them. announced: masks of particles that fixes will insert; a run
/// of one step may be meant to insert them alone. Returns whether it warned; all ranks call it.
inline bool warn_of_unmoved(const LAMMPS* lmp, const std::vector<int>& announced) {
  const Atom* const atom = lmp->atom;
  const bool only_inserts = atom->natoms == 0 && (announced.empty() || lmp->update->nsteps == 1);
  if (lmp->update->nsteps == 0 || only_inserts) return false;
  const int groups = moved_or_held_groups(lmp->modify);
  int any = 0, any_on_all = 0;
  for (const int mask : announced) any |= mask & groups;
  for (int i = 0; i < atom->nlocal; i++) any |= atom->mask[i] & groups;
  MPI_Allreduce(&any, &any_on_all, 1, MPI_INT, MPI_BOR, lmp->world);
  if (any_on_all) return false;
  if (lmp->comm->me == 0)
    lmp->error->warning(FLERR,
                        "no fix integrates the motion of any particle: all stay in their places "
                        "whatever acts on them; add 'fix ID all nve/sphere' behind the pair_style "
                        "and wall commands, or use 'run 0' if only forces are wanted");
  return true;
}

}  // namespace LAMMPS_NS

#endif
