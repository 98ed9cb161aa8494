// SPDX-License-Identifier: GPL-2.0-only
#ifdef FIX_CLASS
// clang-format off
#define COHESION_FIX_STYLE(style, Law) FixStyle(wall/style, FixWallGranCohesive<Law>)
COHESION_CONTACT_LAWS(COHESION_FIX_STYLE)
FixStyle(wall/gran/square_well, FormerFixWallGranSquareWell)
FixStyle(wall/gran/liquid_bridge, FormerFixWallGranLiquidBridge)
// clang-format on
#undef COHESION_FIX_STYLE
#else

#ifndef LMP_FIX_WALL_GRAN_STYLES_H
#define LMP_FIX_WALL_GRAN_STYLES_H

// fix wall/gran/..., a row each in cohesion_laws.h; doc: docs/lammps-package/fix_wall_gran_*.md
#include "common/former_style.h"
#include "soft_contacts/cohesion_laws.h"
#include "soft_contacts/fix_wall_gran_cohesive.h"

namespace LAMMPS_NS {

inline constexpr char former_wall_gran_square_well[] = "wall/gran/square_well";
inline constexpr char former_wall_gran_liquid_bridge[] = "wall/gran/liquid_bridge";
using FormerFixWallGranSquareWell =
    FormerStyle<FixWallGranCohesive<SquareWellCohesion>, former_wall_gran_square_well>;
using FormerFixWallGranLiquidBridge =
    FormerStyle<FixWallGranCohesive<LiquidBridgeCohesion>, former_wall_gran_liquid_bridge>;

}  // namespace LAMMPS_NS

#endif
#endif
