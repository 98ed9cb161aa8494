// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "mixing.h"
#include "validation.h"

namespace cohesion::hamaker {

/// What a user gives for a pair of materials, in any consistent set of units.
struct HamakerParameters {
  double hamaker_constant;       ///< A, [energy]; 0 switches the law off
  double surface_cutoff;         ///< H_cut, [length]: the force is constant below this gap
  double outer_cutoff;           ///< H_out, [length]: force and energy are zero from this gap on
  double asperity_radius = 0.0;  ///< r_a, [length]: see asperity.h; 0 for smooth surfaces
  double asperity_height = 0.0;  ///< h_a, [length]; 0: r_a, a hemisphere
};

/// How far an asperity holds the bodies apart, [length]; 0 for smooth surfaces.
inline double height_of_asperity(const HamakerParameters& p) {
  return p.asperity_height > 0.0 ? p.asperity_height : p.asperity_radius;
}

/// Of a law that is off.
inline constexpr HamakerParameters none{0.0, 1.0, 2.0};

/// Throws InvalidParameter unless A >= 0, 0 < H_cut < H_out and 0 <= h_a <= r_a, all finite.
inline void require_valid(const HamakerParameters& p) {
  require_non_negative("Hamaker constant A", p.hamaker_constant);
  require_positive("surface cut-off H_cut", p.surface_cutoff);
  require_positive("outer cut-off", p.outer_cutoff);
  require(p.surface_cutoff < p.outer_cutoff, "surface cut-off H_cut", p.surface_cutoff,
          "must be smaller than the outer cut-off");
  require_non_negative("asperity radius", p.asperity_radius);
  require_non_negative("asperity height", p.asperity_height);
  require(p.asperity_height <= p.asperity_radius, "asperity height", p.asperity_height,
          "must not be above the asperity radius: a cap is no higher than a hemisphere");
}

/// Throws InvalidParameter when surfaces are given as rough: a form without asperities would pass
/// over it in silence.
inline void require_smooth(const HamakerParameters& p) {
  require(p.asperity_radius == 0.0, "asperity radius", p.asperity_radius,
          "must be zero for the law of smooth surfaces");
}

/// Unlike materials: the geometric mean of the constants, the larger cut-offs, and the higher
/// asperity, which is the one that touches.
inline HamakerParameters mixed(const HamakerParameters& a, const HamakerParameters& b) {
  const HamakerParameters& higher = height_of_asperity(a) < height_of_asperity(b) ? b : a;
  return {geometric_mean(a.hamaker_constant, b.hamaker_constant),
          std::max(a.surface_cutoff, b.surface_cutoff), std::max(a.outer_cutoff, b.outer_cutoff),
          higher.asperity_radius, higher.asperity_height};
}

}  // namespace cohesion::hamaker
