// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

#include "validation.h"

/// What cannot be meant of sizes in a box, and would let an engine search itself to death.
namespace cohesion::advice {

struct BoxSize {
  std::array<double, 3> sides;   ///< [length]
  std::array<bool, 3> periodic;  ///< a direction that a flat simulation does not have: false
  bool shrink_wrapped = false;   ///< whether any side follows the particles' centres
};

/// Throws InvalidParameter for a particle whose radius [length] is above the longest side: wherever
/// it is, it fills most of the box. Of a shrink-wrapped one the sides say nothing.
inline void require_radius_in_box(double radius, const BoxSize& box) {
  if (box.shrink_wrapped) return;
  const double longest = *std::max_element(box.sides.begin(), box.sides.end());
  std::ostringstream remedy;
  remedy << "must not be above the longest side of the box, " << longest;
  require(radius <= longest, "radius of a particle", radius, remedy.str());
}

/// How many images of itself a particle meets within `range` [length], itself included.
inline double images_within(double range, const BoxSize& box) {
  double images = 1.0;
  for (int k = 0; k < 3; k++)
    if (box.periodic[k]) images *= 1.0 + 2.0 * std::ceil(range / box.sides[k]);
  return images;
}

/// Of four boxes to each side in three directions, 9^3, no simulation of particles in contact has
/// use; thin boxes, periodic in one or two directions, stay below.
inline constexpr double most_images = 1000.0;

/// Throws InvalidParameter for a distance of two centres [length] up to which partners are to be
/// found, when that would be among very many images of the box.
inline void require_range_in_box(double range, const BoxSize& box) {
  const double images = images_within(range, box);
  std::ostringstream remedy;
  remedy << "would find " << images << " images of each particle in the periodic box of "
         << box.sides[0] << " x " << box.sides[1] << " x " << box.sides[2]
         << ": radii or cut-offs are too large for it";
  require(images <= most_images, "range of radii and attraction", range, remedy.str());
}

}  // namespace cohesion::advice
