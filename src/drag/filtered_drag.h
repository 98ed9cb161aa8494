// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>

/// The drag in cells that are too coarse for what happens in them, over that of any closure.
///
/// Particles cluster, gas goes around the clusters, and a cell that is larger than they are knows
/// their mean alone: a closure then gives too much drag. Radl and Sundaresan measured how much, in
/// simulations of grains in fine cells, averaged over boxes of the size Delta:
///
///   F/F_closure = 1 - h(phi)/(a(phi) L/Delta + 1),   L = (v_t^2/g) Fr^(-2/3),   Fr = v_t^2/(g d)
///
/// Symbols: phi solid fraction [1]; Delta size of the cell, the cube root of its volume, d diameter
/// of the grains, L = (v_t d)^(2/3)/g^(1/3) the length that makes the others alike [length]; v_t
/// the terminal speed of a grain [length/time], g gravity [length/time^2]. a and h are polynomials
/// of the third degree, piece by piece.
///
/// Limits: 1 for fine cells, for few particles and from phi = 0.6 on, where h has its root and is
/// taken as 0; at phi of some 0.3 in cells far larger than L it is 1 - h, 0.053. h is continuous to
/// 0.001. a is not: it falls from 21.5 to 2.5 at phi = 0.016, and by 5 % at 0.4; the factor falls
/// there by 0.031 and 0.010 in cells of the size L, by 0.062 and 0.006 in those of 10 L.
///
/// Not here: their factor for parcels. Validity: the paper was not at hand; coefficients and form
/// are those of CFDEMcoupling-PFM (BeetstraDrag), whose pieces end at phi = 0.6.
///
/// Source: S. Radl, S. Sundaresan, Chem. Eng. Sci. 117 (2014) 416.
namespace cohesion::drag {

/// A polynomial of x = phi - origin, for phi below `end`.
struct FilterPiece {
  double end, origin;
  std::array<double, 4> coefficients;

  constexpr double at(double phi) const {
    const double x = phi - origin;
    const auto& c = coefficients;
    return c[0] + x * (c[1] + x * (c[2] + x * c[3]));
  }
};

struct RadlSundaresan {
  static constexpr double no_end = std::numeric_limits<double>::infinity();

  static constexpr std::array a_pieces{
      FilterPiece{0.016, 0.0, {21.51, 0.0, 0.0, 0.0}},
      FilterPiece{0.1, 0.0, {1.96, 29.40, 164.91, -1923.0}},
      FilterPiece{0.18, 0.1, {4.63, 4.68, -412.04, 2254.0}},
      FilterPiece{0.25, 0.18, {3.52, -17.99, 128.80, -603.0}},
      FilterPiece{0.4, 0.25, {2.68, -8.20, 2.18, 112.33}},
      FilterPiece{no_end, 0.4, {1.79, 0.0, 0.0, 0.0}},
  };
  static constexpr std::array h_pieces{
      FilterPiece{0.03, 0.0, {0.0, 7.97, 0.0, 0.0}},
      FilterPiece{0.08, 0.03, {0.239, 4.640, -4.410, 253.63}},
      FilterPiece{0.12, 0.08, {0.492, 6.100, 33.63, -789.6}},
      FilterPiece{0.18, 0.12, {0.739, 5.010, -61.1, 310.8}},
      FilterPiece{0.34, 0.18, {0.887, 1.03, -5.17, 5.99}},
      FilterPiece{0.48, 0.34, {0.943, -0.17, -2.29, -9.12}},
      FilterPiece{0.55, 0.48, {0.850, -1.35, -6.13, -132.6}},
      FilterPiece{no_end, 0.55, {0.680, -2.34, -225.2, 0.0}},
  };

  /// a and h [1] at the solid fraction phi >= 0 [1]
  static constexpr double a(double phi) { return of(a_pieces, phi); }
  static constexpr double h(double phi) { return std::max(0.0, of(h_pieces, phi)); }

  /// Drag over the closure's, [1], in (0, 1]. filter_over_length Delta/L > 0 [1].
  static constexpr double factor(double phi, double filter_over_length) {
    return 1.0 - h(phi) / (a(phi) / filter_over_length + 1.0);
  }

 private:
  template <class Pieces>
  static constexpr double of(const Pieces& pieces, double phi) {
    for (const FilterPiece& piece : pieces)
      if (phi < piece.end) return piece.at(phi);
    return pieces.back().at(phi);
  }
};

/// L of the formula above, [length]
inline double filter_length(double terminal_speed, double diameter, double gravity) {
  const double product = terminal_speed * diameter;
  return std::cbrt(product * product / gravity);
}

struct DragFilter {
  std::string_view name;
  double (*factor)(double phi, double filter_over_length);  ///< none: the closure as it is
};

inline constexpr std::array drag_filters{
    DragFilter{"none", nullptr},
    DragFilter{"radlSundaresan", &RadlSundaresan::factor},
};

}  // namespace cohesion::drag
