// SPDX-License-Identifier: GPL-2.0-only
#ifdef FIX_CLASS
// clang-format off
#define COHESION_FIX_STYLE(style, Law) FixStyle(wall/style, FixWallGranCohesive<Law>)
COHESION_CONTACT_LAWS(COHESION_FIX_STYLE)
// clang-format on
#undef COHESION_FIX_STYLE
#else

#ifndef LMP_FIX_WALL_GRAN_STYLES_H
#define LMP_FIX_WALL_GRAN_STYLES_H

// fix wall/gran/..., a row each in cohesion_laws.h; doc: docs/lammps-package/fix_wall_gran_*.md
#include "soft_contacts/cohesion_laws.h"
#include "soft_contacts/fix_wall_gran_cohesive.h"

#endif
#endif
