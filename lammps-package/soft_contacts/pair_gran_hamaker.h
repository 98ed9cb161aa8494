// SPDX-License-Identifier: GPL-2.0-only
#ifdef PAIR_CLASS
// clang-format off
PairStyle(gran/hamaker,PairGranHamaker);
// clang-format on
#else

#ifndef LMP_PAIR_GRAN_HAMAKER_H
#define LMP_PAIR_GRAN_HAMAKER_H

#include "hamaker_cohesion.h"
#include "pair_gran_cohesive.h"

namespace LAMMPS_NS {

/// pair_style gran/hamaker; doc: docs/lammps-package/pair_gran_hamaker.md
using PairGranHamaker = PairGranCohesive<HamakerCohesion>;

}  // namespace LAMMPS_NS

#endif
#endif
