// SPDX-License-Identifier: GPL-2.0-or-later
// The cohesion models of pair_style gran and fix wall/gran, a row each: the engine's name of the
// model, its name in scripts, its number (free below 64: 1, 2, 7 and 8 are the engine's own), and
// what is its own (cohesion_overlay.h).

#ifndef COHESION_ROWS
// clang-format off
#define COHESION_ROWS(ROW) \
  ROW(COHESION_HAMAKER, hamaker, 20, HamakerAttraction) \
  ROW(COHESION_SQUARE_WELL, square_well, 21, SquareWellAttraction) \
  ROW(COHESION_LIQUID_BRIDGE, liquid_bridge, 22, LiquidBridgeAttraction) \
  ROW(COHESION_JKR, jkr, 23, JkrAttraction)
// clang-format on
#endif

#ifdef COHESION_MODEL
#define COHESION_ROW(model, name, number, Attraction) COHESION_MODEL(model, name, number)
COHESION_ROWS(COHESION_ROW)
#undef COHESION_ROW
#else

#ifndef COHESION_COHESION_MODELS_H
#define COHESION_COHESION_MODELS_H

#include <string_view>

#include "cohesion_overlay.h"
#include "hamaker_attraction.h"
#include "jkr_attraction.h"
#include "liquid_bridge_attraction.h"
#include "square_well_attraction.h"

namespace LIGGGHTS {
namespace ContactModels {

#define COHESION_ROW(model, name, number, Attraction)                               \
  static_assert(std::string_view(Cohesion::Attraction::MODEL) == #name);            \
  template <>                                                                       \
  class CohesionModel<model> final : public CohesionOverlay<Cohesion::Attraction> { \
   public:                                                                          \
    using CohesionOverlay::CohesionOverlay;                                         \
  };
COHESION_ROWS(COHESION_ROW)
#undef COHESION_ROW

}  // namespace ContactModels
}  // namespace LIGGGHTS

#endif
#endif
