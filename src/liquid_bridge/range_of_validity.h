// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sstream>
#include <string>

#include "liquid_bridge/parameters.h"
#include "validation.h"

namespace cohesion::liquid_bridge {

/// Volume of a bridge over the cube of a radius up to which its force is meant, [1]: for small
/// volumes (parameters.h).
inline constexpr double largest_volume = 0.1;

/// Throws InvalidParameter where a bridge breaks at a gap above the radius [length] of the smallest
/// particle that has one: most often its volume is in another unit.
inline void require_short(const LiquidBridgeParameters& p, double radius) {
  if (!p.attracts()) return;
  std::ostringstream remedy;
  remedy << "must not be above " << radius << ", the radius of the smallest particle";
  if (p.tension > 0.0)
    remedy << "; it follows from the volume V of the bridge = " << p.volume
           << ", which should be below " << largest_volume * radius * radius * radius
           << ": check its unit, length^3";
  else
    remedy << ": check its unit, length";
  // The limit to the last digit is still the limit.
  require(p.rupture_gap <= (1.0 + 1e-6) * radius, "rupture gap h_r of the bridge", p.rupture_gap,
          remedy.str());
}

/// What to say of a volume that is too large for the force of the bridge; empty: nothing. radius
/// [length]: of the smallest particle that has such a bridge.
inline std::string doubt_of_volume(const LiquidBridgeParameters& p, double radius) {
  const double share = p.volume / (radius * radius * radius);
  if (!(p.tension > 0.0) || share <= (1.0 + 1e-6) * largest_volume) return "";
  std::ostringstream text;
  text << "the volume V of the bridge = " << p.volume << " is " << share
       << " of the cube of the radius of the smallest particle, " << radius
       << "; its force is one of small volumes, up to " << largest_volume
       << ": use a smaller volume, or check its unit, length^3";
  return text.str();
}

}  // namespace cohesion::liquid_bridge
