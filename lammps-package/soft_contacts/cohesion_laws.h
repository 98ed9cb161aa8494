// SPDX-License-Identifier: GPL-2.0-only
#ifndef COHESION_COHESION_LAWS_H
#define COHESION_COHESION_LAWS_H

#include <string>

#include "soft_contacts/hamaker_cohesion.h"
#include "soft_contacts/jkr_cohesion.h"
#include "soft_contacts/liquid_bridge_cohesion.h"
#include "soft_contacts/square_well_cohesion.h"

// The laws of cohesion: these rows generate the pair styles, the fixes of walls, their explicit
// instantiations and their names in messages. ROW(style, law). The steps of pairs, PairContacts,
// are instantiated in the files NAME_step.cpp.

// clang-format off
/// With a contact, for pairs and, as wall/style, for walls.
#define COHESION_CONTACT_LAWS(ROW) \
  ROW(gran/hamaker, HamakerCohesion) \
  ROW(gran/squarewell, SquareWellCohesion) \
  ROW(gran/liquidbridge, LiquidBridgeCohesion) \
  ROW(gran/jkr, JkrCohesion)

/// All that pairs have: those, and the ones that are laid over another contact.
#define COHESION_PAIR_LAWS(ROW) \
  COHESION_CONTACT_LAWS(ROW) \
  ROW(squarewell, SquareWellOverlay)
// clang-format on

namespace LAMMPS_NS {

/// The pair styles, with commas.
inline std::string cohesive_pair_styles() {
  std::string all;
#define COHESION_NAME(style, Law) all += (all.empty() ? "" : ", ") + std::string(#style);
  COHESION_PAIR_LAWS(COHESION_NAME)
#undef COHESION_NAME
  return all;
}

}  // namespace LAMMPS_NS

#endif
