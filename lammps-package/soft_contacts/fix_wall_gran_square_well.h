// SPDX-License-Identifier: GPL-2.0-only
#ifdef FIX_CLASS
// clang-format off
FixStyle(wall/gran/square_well,FixWallGranSquareWell);
// clang-format on
#else

#ifndef LMP_FIX_WALL_GRAN_SQUARE_WELL_H
#define LMP_FIX_WALL_GRAN_SQUARE_WELL_H

#include "fix_wall_gran_cohesive.h"
#include "square_well_cohesion.h"

namespace LAMMPS_NS {

/// fix wall/gran/square_well; doc: docs/lammps-package/fix_wall_gran_square_well.md
using FixWallGranSquareWell = FixWallGranCohesive<SquareWellCohesion>;

}  // namespace LAMMPS_NS

#endif
#endif
