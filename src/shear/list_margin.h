// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

namespace cohesion::shear {

/// The largest principal stretch of a shear of this strain, the factor by which it lengthens a
/// vector at most, and shortens it: the larger singular value of (1 strain; 0 1). The singular
/// values s and 1/s have the sum of squares 2 + strain^2, so s - 1/s = |strain|.
inline double largest_stretch(double strain) {
  const double g = std::abs(strain);
  return 0.5 * (g + std::sqrt(g * g + 4.0));
}

/// The largest nonaffine displacement, beyond what the shear of the whole box does to a particle,
/// before a list of neighbours may miss a pair, [length]; negative: the list may miss one already.
///
/// A list holds all pairs that were closer than list_reach [length] when the box had some strain;
/// since then it was sheared by `strain` more. Forces act up to force_reach [length].
///
/// With A the shear since the list was made, a particle and its images are at x = A x0 + u, where
/// u, the same for all images, is what it moved beyond the shear: |u| <= D. Of a pair that is now
/// within force_reach the list knows the distance then,
///   |x0_j - x0_i| = |A^-1 (x_j - x_i - u_j + u_i)| <= s (force_reach + 2 D),
/// s the largest stretch of A^-1, which is that of A. So none is missed while
///   s (force_reach + 2 D) <= list_reach.
/// No number smaller than s is right for all directions: the bound is attained.
inline double list_margin(double list_reach, double force_reach, double strain) {
  return 0.5 * (list_reach / largest_stretch(strain) - force_reach);
}

}  // namespace cohesion::shear
