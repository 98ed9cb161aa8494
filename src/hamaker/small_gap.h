// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "hamaker/parameters.h"
#include "sphere.h"

namespace cohesion::hamaker {

/// Attraction of two close surfaces, per A/6:
///
///   F(H) = R*/H^2        E(H) = -R*/H        F = dE/dH > 0 attracts
///
/// H > 0 is the gap between the surfaces, R* the reduced radius: spheres of any two radii, and a
/// sphere beside a plane. Valid for H << R*: too large by H/R* of itself, to first order (exact.h).
///
/// Source: Derjaguin's approximation of the attraction of two spheres, H. C. Hamaker, Physica 4
/// (1937) 1058.
struct SmallGap {
  explicit SmallGap(const HamakerParameters& p) { require_smooth(p); }

  /// [force/energy]
  double force(double gap, const PairGeometry& g) const { return g.reduced_radius / (gap * gap); }

  /// Zero at infinite gap; [1].
  double energy(double gap, const PairGeometry& g) const { return -g.reduced_radius / gap; }
};

}  // namespace cohesion::hamaker
