// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "contact/adhesion.h"
#include "mixing.h"
#include "validation.h"

namespace cohesion::square_well {

/// The well between two materials, as users give it. Its edge is where the centres are
/// ratio_i r_i + ratio_j r_j apart; beside a wall, where the gap is (ratio_i - 1) r_i.
///
/// Source: M. Weber, thesis, ch. 3 (square-well model); unlike ratios: derived here.
struct SquareWellParameters {
  double depth = 0.0;    ///< D, [energy]; 0: no well
  double ratio_i = 1.0;  ///< r_out/r of the particles of the first material, [1]
  double ratio_j = 1.0;  ///< of the second
};

/// The well of `well D ratio`, which has one ratio for both.
inline SquareWellParameters well(double depth, double ratio) { return {depth, ratio, ratio}; }

/// The largest r_out/r: above it, another sphere of the same size fits between a wall and one that
/// it attracts, and two between two that attract each other.
inline constexpr double largest_ratio = 3.0;

/// Throws InvalidParameter unless D >= 0 and both ratios are from 1 to largest_ratio, all finite.
inline void require_valid(const SquareWellParameters& p) {
  require_non_negative("depth D of the well", p.depth);
  for (const double ratio : {p.ratio_i, p.ratio_j}) {
    require(std::isfinite(ratio) && ratio >= 1.0, "ratio r_out/r of the well", ratio,
            "must be a finite number not below 1: the well is outside the core");
    require(
        ratio <= largest_ratio, "ratio r_out/r of the well", ratio,
        "must not be above 3: other spheres would fit between those that attract each other; it "
        "is no length, but the radius of the edge over that of the particle");
  }
}

/// The well of unlike materials: the geometric mean of the depths, and each its own ratio.
inline SquareWellParameters mixed(const SquareWellParameters& a, const SquareWellParameters& b) {
  return {geometric_mean(a.depth, b.depth), a.ratio_i, b.ratio_j};
}

/// The same well seen from the other side.
inline SquareWellParameters reversed(const SquareWellParameters& p) {
  return {p.depth, p.ratio_j, p.ratio_i};
}

/// Distance of the centres at the edge, [length].
inline double edge(const SquareWellParameters& p, double radius_i, double radius_j) {
  return p.ratio_i * radius_i + p.ratio_j * radius_j;
}

/// Gap at the edge, [length]; radius_j = 0 beside a wall.
inline double width(const SquareWellParameters& p, double radius_i, double radius_j) {
  return (p.ratio_i - 1.0) * radius_i + (p.ratio_j - 1.0) * radius_j;
}

/// Squares of distances of two centres over the sum of their radii: below `inside` any pair of
/// these materials is inside, above `outside` it is outside.
struct EdgeBounds {
  double inside;   ///< [1]
  double outside;  ///< [1]
};

/// The bounds of a well. Beside a wall the sum of the radii is that of the one sphere, and the
/// distance that of its centre. Where rounding could decide, neither bound does.
inline EdgeBounds edge_bounds(const SquareWellParameters& p, bool wall) {
  constexpr double rounding = 1e-12;
  const double other = wall ? p.ratio_i : p.ratio_j;
  const double least = std::min(p.ratio_i, other), most = std::max(p.ratio_i, other);
  return {least * least * (1.0 - rounding), most * most * (1.0 + rounding)};
}

/// The well as an adhesion: no force, all of its energy at the edge.
inline contact::Adhesion adhesion_of(const SquareWellParameters& p, double radius_i,
                                     double radius_j) {
  if (p.depth == 0.0) return {};
  return {0.0, width(p, radius_i, radius_j), p.depth};
}

}  // namespace cohesion::square_well
