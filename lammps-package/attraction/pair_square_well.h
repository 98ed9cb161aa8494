// SPDX-License-Identifier: GPL-2.0-only
#ifdef PAIR_CLASS
// clang-format off
PairStyle(square_well,PairSquareWell);
// clang-format on
#else

#ifndef LMP_PAIR_SQUARE_WELL_H
#define LMP_PAIR_SQUARE_WELL_H

#include "pair_gran_cohesive.h"
#include "square_well_cohesion.h"

namespace LAMMPS_NS {

/// pair_style square_well; doc: docs/lammps-package/pair_square_well.md
using PairSquareWell = PairGranCohesive<SquareWellOverlay>;

}  // namespace LAMMPS_NS

#endif
#endif
