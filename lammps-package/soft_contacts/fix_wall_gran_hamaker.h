// SPDX-License-Identifier: GPL-2.0-only
#ifdef FIX_CLASS
// clang-format off
FixStyle(wall/gran/hamaker,FixWallGranHamaker);
// clang-format on
#else

#ifndef LMP_FIX_WALL_GRAN_HAMAKER_H
#define LMP_FIX_WALL_GRAN_HAMAKER_H

#include "fix_wall_gran_cohesive.h"
#include "hamaker_cohesion.h"

namespace LAMMPS_NS {

/// fix wall/gran/hamaker; doc: docs/lammps-package/fix_wall_gran_hamaker.md
using FixWallGranHamaker = FixWallGranCohesive<HamakerCohesion>;

}  // namespace LAMMPS_NS

#endif
#endif
