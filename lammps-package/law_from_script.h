// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_LAW_FROM_SCRIPT_H
#define COHESION_LAW_FROM_SCRIPT_H

#include <string>

#include "error.h"
#include "hamaker/small_gap.h"
#include "lammps.h"

namespace LAMMPS_NS {

/// Builds the law; a parameter that cannot be right stops LAMMPS with `where` (style and types) in
/// front of the law's own message.
inline cohesion::hamaker::SmallGap hamaker_from_script(
    LAMMPS* lmp, const std::string& where, const cohesion::hamaker::SmallGapParameters& given) {
  try {
    return cohesion::hamaker::SmallGap(given);
  } catch (const cohesion::InvalidParameter& bad) {
    lmp->error->all(FLERR, where + ": " + bad.what());
    throw;
  }
}

}  // namespace LAMMPS_NS

#endif
