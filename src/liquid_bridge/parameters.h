// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact/adhesion.h"
#include "mixing.h"
#include "validation.h"

namespace cohesion::liquid_bridge {

/// The liquid bridge between two materials. It forms where the surfaces touch, pulls with F_b in
/// contact and in the gap, and breaks at the gap h_r; what approaches without one is not attracted.
///
/// A little liquid of surface tension gamma and contact angle theta (in radians) between spheres of
/// equal radius R, of volume V:
///
///   F_b = 2 pi R gamma cos theta      h_r = (1 + theta/2) V^(1/3)
///
/// Source: C. D. Willett, M. J. Adams, S. A. Johnson, J. P. K. Seville, Langmuir 16 (2000) 9396
/// (force at touch); G. Lian, C. Thornton, M. J. Adams, J. Colloid Interface Sci. 161 (1993) 138
/// (rupture).
struct Parameters {
  double force = 0.0;        ///< F_b, [force]; 0: no bridge
  double rupture_gap = 0.0;  ///< h_r, [length]
};

/// Throws InvalidParameter unless F_b >= 0, h_r >= 0, and h_r > 0 where there is a force, all
/// finite.
inline void require_valid(const Parameters& p) {
  require_non_negative("force F_b of the bridge", p.force);
  require_non_negative("rupture gap h_r of the bridge", p.rupture_gap);
  require(p.force == 0.0 || p.rupture_gap > 0.0, "rupture gap h_r of the bridge", p.rupture_gap,
          "must be greater than zero where the bridge has a force");
}

/// Unlike materials: geometric means of both, so that one that is dry has no bridges.
inline Parameters mixed(const Parameters& a, const Parameters& b) {
  return {geometric_mean(a.force, b.force), geometric_mean(a.rupture_gap, b.rupture_gap)};
}

/// The bridge as an adhesion; whatever the radii.
inline contact::Adhesion adhesion_of(const Parameters& p, double /*radius_i*/,
                                     double /*radius_j*/) {
  if (p.force == 0.0) return {};
  return {p.force, p.rupture_gap, 0.0, true};
}

}  // namespace cohesion::liquid_bridge
