// SPDX-License-Identifier: GPL-2.0-or-later
// Cohesion model `hamaker` of pair_style gran and fix wall/gran.

#ifdef COHESION_MODEL
COHESION_MODEL(COHESION_HAMAKER, hamaker, 20)
#else

#ifndef COHESION_MODEL_HAMAKER_H_
#define COHESION_MODEL_HAMAKER_H_

#include "cohesion_overlay.h"
#include "hamaker_attraction.h"

namespace LIGGGHTS {
namespace ContactModels {

template <>
class CohesionModel<COHESION_HAMAKER> final : public CohesionOverlay<Cohesion::HamakerAttraction> {
 public:
  using CohesionOverlay::CohesionOverlay;
};

}  // namespace ContactModels
}  // namespace LIGGGHTS

#endif
#endif
