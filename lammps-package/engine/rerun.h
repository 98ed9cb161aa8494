// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_RERUN_H
#define COHESION_RERUN_H

#include <string>

#include "common/message.h"
#include "update.h"

namespace LAMMPS_NS {

/// Whether the run that is set up is one of the command rerun, which makes no steps: a run begins
/// at its first step, and has as many as it was given.
inline bool is_rerun(const Update* update) {
  constexpr int dynamics = 1;
  return update->whichflag == dynamics && (update->ntimestep != update->firststep ||
                                           update->laststep - update->firststep != update->nsteps);
}

/// Stops at a rerun: frames have places and velocities, and not what contacts remember.
inline void refuse_rerun(const LAMMPS* lmp, const std::string& where) {
  if (is_rerun(lmp->update))
    stop(lmp, FLERR, where,
         ": 'rerun' reads places and velocities, and what contacts remember is not among them: "
         "print energies and stresses in the run itself (thermo_style custom, fix ave/time), or "
         "begin a script for each frame with 'read_dump' and 'run 0'");
}

}  // namespace LAMMPS_NS

#endif
