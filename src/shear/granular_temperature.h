// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shear/mean_profile.h"

namespace cohesion::shear {

/// Granular temperature T = <v'.v'>/dimensions about the mean profile, weighted by mass,
/// [length^2/time^2]; in a plane (dimensions = 2) <v'x^2 + v'y^2>/2.
///
/// Source: M. Weber, thesis, chapter 4.
inline double granular_temperature(const MeanProfile& profile, int dimensions) {
  double sum = 0.0;
  for (int k = 0; k < dimensions; k++) sum += profile.fluctuation[k];
  return sum / dimensions;
}

}  // namespace cohesion::shear
