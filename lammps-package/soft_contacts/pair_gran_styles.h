// SPDX-License-Identifier: GPL-2.0-only
#ifdef PAIR_CLASS
// clang-format off
#define COHESION_PAIR_STYLE(style, Law) PairStyle(style, PairGranCohesive<Law>)
COHESION_PAIR_LAWS(COHESION_PAIR_STYLE)
PairStyle(gran/square_well, FormerPairGranSquareWell)
PairStyle(gran/liquid_bridge, FormerPairGranLiquidBridge)
PairStyle(square_well, FormerPairSquareWell)
// clang-format on
#undef COHESION_PAIR_STYLE
#else

#ifndef LMP_PAIR_GRAN_STYLES_H
#define LMP_PAIR_GRAN_STYLES_H

// pair_style gran/..., a row each in cohesion_laws.h; doc: docs/lammps-package/pair_gran_*.md,
// pair_gran_squarewell.md
#include "common/former_style.h"
#include "soft_contacts/cohesion_laws.h"
#include "soft_contacts/pair_gran_cohesive.h"

namespace LAMMPS_NS {

inline constexpr char former_gran_square_well[] = "gran/square_well";
inline constexpr char former_gran_liquid_bridge[] = "gran/liquid_bridge";
inline constexpr char former_square_well[] = "square_well";
using FormerPairGranSquareWell =
    FormerStyle<PairGranCohesive<SquareWellCohesion>, former_gran_square_well>;
using FormerPairGranLiquidBridge =
    FormerStyle<PairGranCohesive<LiquidBridgeCohesion>, former_gran_liquid_bridge>;
using FormerPairSquareWell = FormerStyle<PairGranCohesive<SquareWellOverlay>, former_square_well>;

}  // namespace LAMMPS_NS

#endif
#endif
