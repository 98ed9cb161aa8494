// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

/// Impulses at the edge of a square well of depth D.
///
/// u = k.(v_i - v_j) is the normal speed of approach [speed], negative while the pair parts; k
/// points from i to j. An impulse J acts as v_i -= J k/m_i, v_j += J k/m_j: positive repels. b =
/// 1/m_i + 1/m_j is the inverse of the reduced mass mu [1/mass], D the depth [energy]. The kinetic
/// energy changes by exactly D at an approach, -D at an escape and 0 at a capture. Each formula is
/// written without a difference of nearly equal numbers, and with b where the source has mu: mu
/// would carry the same rounding error into every event.
///
/// Source: M. Weber, thesis, ch. 3 (square-well model).
namespace cohesion::square_well {

/// Inward over the edge, J = mu (u - sqrt(u^2 + 2D/mu)), [momentum].
inline double approach_impulse(double u, double depth, double b) {
  const double root = std::sqrt(u * u + 2.0 * depth * b);
  return u > 0.0 ? -2.0 * depth / (u + root) : (u - root) / b;
}

/// Whether a pair that reaches the edge from inside has the energy to leave: u^2 > 2D/mu.
inline bool escapes(double u, double depth, double b) { return u * u > 2.0 * depth * b; }

/// Outward over the edge, J = mu (u + sqrt(u^2 - 2D/mu)) for u < 0, [momentum].
inline double escape_impulse(double u, double depth, double b) {
  return -2.0 * depth / (std::sqrt(u * u - 2.0 * depth * b) - u);
}

/// Turned back at the edge from inside, J = 2 mu u, [momentum].
inline double capture_impulse(double u, double b) { return 2.0 * u / b; }

}  // namespace cohesion::square_well
