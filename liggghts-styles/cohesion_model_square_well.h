// SPDX-License-Identifier: GPL-2.0-or-later
// Cohesion model `square_well` of pair_style gran and fix wall/gran.

#ifdef COHESION_MODEL
COHESION_MODEL(COHESION_SQUARE_WELL, square_well, 21)
#else

#ifndef COHESION_MODEL_SQUARE_WELL_H_
#define COHESION_MODEL_SQUARE_WELL_H_

#include "cohesion_overlay.h"
#include "square_well_attraction.h"

namespace LIGGGHTS {
namespace ContactModels {

template <>
class CohesionModel<COHESION_SQUARE_WELL> final
    : public CohesionOverlay<Cohesion::SquareWellAttraction> {
 public:
  using CohesionOverlay::CohesionOverlay;
};

}  // namespace ContactModels
}  // namespace LIGGGHTS

#endif
#endif
