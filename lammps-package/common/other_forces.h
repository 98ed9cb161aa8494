// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef COHESION_OTHER_FORCES_H
#define COHESION_OTHER_FORCES_H

#include "common/engine_api.h"
#include "force.h"
#include "modify.h"

// Forces of other styles than contacts, in both engines.

namespace LAMMPS_NS {

/// Whether bonds, long-range forces or a fix act on particles. is_known(fix) is true for fixes that
/// do not count.
template <class IsKnown>
bool other_forces_act(const LAMMPS* lmp, const IsKnown& is_known) {
  const Force* const force = lmp->force;
  if (force->bond || force->angle || force->dihedral || force->improper || force->kspace)
    return true;
  const Modify* const modify = lmp->modify;
  for (int k = 0; k < modify->nfix; k++)
    if ((modify->fmask[k] & engine_api::WITH_FORCES) && !is_known(*modify->fix[k])) return true;
  return false;
}

}  // namespace LAMMPS_NS

#endif
