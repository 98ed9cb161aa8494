// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "vector3.h"

namespace cohesion::agglomerates {

/// The sums over an agglomerate, or over a fragment of it: a connected set of its particles on one
/// rank. They are plain numbers, so that they can be sent as they are.
struct Fragment {
  double label;                      ///< of the agglomerate
  double count = 0;                  ///< particles
  double x = 0.0, y = 0.0, z = 0.0;  ///< sum of positions, unfolded through the bonds, [length]
  double square = 0.0;               ///< sum of their squares, [length^2]
  double wraps = 0.0;                ///< above 0: bound to its own periodic image

  void add(const Vector3& position) {
    count += 1.0;
    x += position.x;
    y += position.y;
    z += position.z;
    square += dot(position, position);
  }

  void add(const Fragment& other) {
    count += other.count;
    x += other.x;
    y += other.y;
    z += other.z;
    square += other.square;
    wraps += other.wraps;
  }
};

/// Radius of gyration of the particles' centres, R_g^2 = <x.x> - <x>.<x>: the root of the mean
/// square of their distances from their mean, [length]. For an agglomerate that is bound to its own
/// image it means nothing.
inline double radius_of_gyration(const Fragment& p) {
  const Vector3 mean = (1.0 / p.count) * Vector3{p.x, p.y, p.z};
  return std::sqrt(std::max(p.square / p.count - dot(mean, mean), 0.0));
}

/// Extent of an agglomerate, which each of its particles stores.
struct Extent {
  /// In the place of the radius of gyration: bound to its own periodic image, without an end.
  static constexpr double endless = -1.0;

  double count;     ///< particles
  double gyration;  ///< radius_of_gyration() [length], or `endless`
};

inline Extent extent(const Fragment& whole) {
  return {whole.count, whole.wraps > 0.0 ? Extent::endless : radius_of_gyration(whole)};
}

/// Merges the fragments with the same label; returns the agglomerates in the order of the labels.
inline std::vector<Fragment> merge_fragments(std::vector<Fragment> fragments) {
  std::stable_sort(fragments.begin(), fragments.end(),
                   [](const Fragment& a, const Fragment& b) { return a.label < b.label; });
  std::vector<Fragment> whole;
  for (const Fragment& p : fragments)
    if (!whole.empty() && whole.back().label == p.label)
      whole.back().add(p);
    else
      whole.push_back(p);
  return whole;
}

}  // namespace cohesion::agglomerates
