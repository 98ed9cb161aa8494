// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

namespace cohesion::bed {

/// Height of the surface of a bed, [length], from the void fraction of layers of one thickness that
/// are stacked from `bottom` on: the highest level where the void fraction, taken at the middles of
/// the layers and linear between them, rises through `limit`. `bottom` when no layer is below the
/// limit, the top of the highest layer when that is below it. Void fractions and limit [1].
inline double surface_height(const std::vector<double>& void_fractions, double bottom,
                             double thickness, double limit) {
  const auto n = void_fractions.size();
  std::size_t above = n;  // the layers from here on are above the surface
  while (above > 0 && !(void_fractions[above - 1] < limit)) --above;
  if (above == 0) return bottom;
  if (above == n) return bottom + static_cast<double>(n) * thickness;
  const double below = void_fractions[above - 1];
  const double fraction = (limit - below) / (void_fractions[above] - below);
  return bottom + (static_cast<double>(above) - 0.5 + fraction) * thickness;
}

}  // namespace cohesion::bed
