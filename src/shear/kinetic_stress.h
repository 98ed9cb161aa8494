// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "shear/mean_profile.h"

namespace cohesion::shear {

/// Momentum carried by the particles' own motion about the mean profile, rho phi <v'v'>:
/// xx, yy, zz, xy, xz, yz, [mass/(length time^2)]; in a plane per area, [mass/time^2].
///
/// A pressure is positive. volume [length^3], in a plane area [length^2], > 0.
/// Source: M. Weber, thesis, chapter 3.
inline std::array<double, 6> kinetic_stress(const MeanProfile& profile, double volume) {
  std::array<double, 6> stress = profile.fluctuation;
  for (double& s : stress) s *= profile.mass / volume;
  return stress;
}

}  // namespace cohesion::shear
