// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "constants.h"
#include "contact/adhesion.h"
#include "mixing.h"
#include "sphere.h"
#include "validation.h"

namespace cohesion::liquid_bridge {

/// The liquid bridge between two materials. It forms where the surfaces touch, pulls in contact and
/// in the gap, and breaks at the gap h_r; what approaches without one is not attracted. The force
/// is F_b, whatever the gap and the radii, or that of a volume V of liquid of surface tension gamma
/// and contact angle theta between spheres of mean radius R:
///
///   F = 2 pi R gamma cos theta/(1 + 1.05 s + 2.5 s^2),   s = S sqrt(R/V),   S the gap
///   h_r = (1 + theta/2) V^(1/3)
///
/// with R = 2 R_i R_j/(R_i + R_j), 2 R_i next to a wall: Derjaguin's approximation. For small
/// volumes; gravity and viscosity do not act.
///
/// Source: C. D. Willett, M. J. Adams, S. A. Johnson, J. P. K. Seville, Langmuir 16 (2000) 9396
/// (force, pull.h); G. Lian, C. Thornton, M. J. Adams, J. Colloid Interface Sci. 161 (1993) 138
/// (rupture).
struct LiquidBridgeParameters {
  double force = 0.0;        ///< F_b, [force]; 0: no such bridge
  double rupture_gap = 0.0;  ///< h_r, [length]
  double tension = 0.0;      ///< 2 pi gamma cos theta, [force/length]; 0: no such bridge
  double volume = 0.0;       ///< V, [volume]

  bool attracts() const { return force > 0.0 || tension > 0.0; }
};

/// Throws InvalidParameter unless F_b >= 0, h_r >= 0, and h_r > 0 where there is a force, all
/// finite.
inline void require_valid(const LiquidBridgeParameters& p) {
  require_non_negative("force F_b of the bridge", p.force);
  require_non_negative("rupture gap h_r of the bridge", p.rupture_gap);
  require(p.force == 0.0 || p.rupture_gap > 0.0, "rupture gap h_r of the bridge", p.rupture_gap,
          "must be greater than zero where the bridge has a force");
}

/// The bridge of a volume V [volume] of liquid, with gamma [force/length] and theta in radians; no
/// bridge where gamma is 0. Throws InvalidParameter unless gamma >= 0, 0 <= theta < pi/2 and V >=
/// 0, V > 0 where there is a surface tension, all finite.
inline LiquidBridgeParameters capillary(double surface_tension, double contact_angle,
                                        double volume) {
  require_non_negative("surface tension gamma of the bridge", surface_tension);
  require(std::isfinite(contact_angle) && contact_angle >= 0.0 && contact_angle < 0.5 * pi,
          "contact angle theta of the bridge", contact_angle,
          "must be in radians, from 0 to below pi/2");
  require_non_negative("volume V of the bridge", volume);
  require(surface_tension == 0.0 || volume > 0.0, "volume V of the bridge", volume,
          "must be greater than zero where the bridge has a surface tension");
  return {0.0, (1.0 + 0.5 * contact_angle) * std::cbrt(volume),
          2.0 * pi * surface_tension * std::cos(contact_angle), volume};
}

/// Unlike materials: geometric means of both, so that one that is dry has no bridges.
inline LiquidBridgeParameters mixed(const LiquidBridgeParameters& a,
                                    const LiquidBridgeParameters& b) {
  return {geometric_mean(a.force, b.force), geometric_mean(a.rupture_gap, b.rupture_gap),
          geometric_mean(a.tension, b.tension), geometric_mean(a.volume, b.volume)};
}

/// The bridge as an adhesion; radius_j [length] 0: next to a wall.
inline contact::Adhesion adhesion_of(const LiquidBridgeParameters& p, double radius_i,
                                     double radius_j) {
  if (p.tension > 0.0) {
    const double radius = 2.0 * (radius_j > 0.0 ? reduced_radius(radius_i, radius_j) : radius_i);
    return {p.tension * radius, p.rupture_gap, 0.0, true, {}, std::sqrt(p.volume / radius)};
  }
  if (!p.attracts()) return {};
  return {p.force, p.rupture_gap, 0.0, true};
}

}  // namespace cohesion::liquid_bridge
