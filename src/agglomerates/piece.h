// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "vector3.h"

namespace cohesion::agglomerates {

/// What is known of an agglomerate, or of the part of it that one rank holds: plain numbers, so
/// that it can be sent as they are.
struct Piece {
  double label;                      ///< of the agglomerate
  double count = 0;                  ///< particles
  double x = 0.0, y = 0.0, z = 0.0;  ///< sum of positions, unfolded through the bonds, [length]
  double square = 0.0;               ///< sum of their squares, [length^2]
  double wraps = 0.0;                ///< above 0: bound to its own periodic image

  void add(const Vector3& place) {
    count += 1.0;
    x += place.x;
    y += place.y;
    z += place.z;
    square += dot(place, place);
  }

  void add(const Piece& other) {
    count += other.count;
    x += other.x;
    y += other.y;
    z += other.z;
    square += other.square;
    wraps += other.wraps;
  }
};

/// Radius of gyration of the particles' centres, the root of the mean square of their distances
/// from their mean, [length]. Of an agglomerate that is bound to its own image it means nothing.
inline double radius_of_gyration(const Piece& p) {
  const Vector3 mean = (1.0 / p.count) * Vector3{p.x, p.y, p.z};
  return std::sqrt(std::max(p.square / p.count - dot(mean, mean), 0.0));
}

/// Pieces with the same label put together, in the order of the labels.
inline std::vector<Piece> put_together(std::vector<Piece> pieces) {
  std::stable_sort(pieces.begin(), pieces.end(),
                   [](const Piece& a, const Piece& b) { return a.label < b.label; });
  std::vector<Piece> whole;
  for (const Piece& p : pieces)
    if (!whole.empty() && whole.back().label == p.label)
      whole.back().add(p);
    else
      whole.push_back(p);
  return whole;
}

}  // namespace cohesion::agglomerates
