// SPDX-License-Identifier: GPL-2.0-only
#ifdef PAIR_CLASS
// clang-format off
PairStyle(gran/square_well,PairGranSquareWell);
// clang-format on
#else

#ifndef LMP_PAIR_GRAN_SQUARE_WELL_H
#define LMP_PAIR_GRAN_SQUARE_WELL_H

#include "pair_gran_cohesive.h"
#include "square_well_cohesion.h"

namespace LAMMPS_NS {

/// pair_style gran/square_well; doc: docs/lammps-package/pair_gran_square_well.md
using PairGranSquareWell = PairGranCohesive<SquareWellCohesion>;

}  // namespace LAMMPS_NS

#endif
#endif
