// SPDX-License-Identifier: GPL-2.0-only
#ifdef PAIR_CLASS
// clang-format off
#define COHESION_PAIR_STYLE(style, Law) PairStyle(style, PairGranCohesive<Law>)
COHESION_PAIR_LAWS(COHESION_PAIR_STYLE)
// clang-format on
#undef COHESION_PAIR_STYLE
#else

#ifndef LMP_PAIR_GRAN_STYLES_H
#define LMP_PAIR_GRAN_STYLES_H

// pair_style gran/..., a row each in cohesion_laws.h; doc: docs/lammps-package/pair_gran_*.md,
// pair_square_well.md
#include "soft_contacts/cohesion_laws.h"
#include "soft_contacts/pair_gran_cohesive.h"

#endif
#endif
