// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <limits>

namespace cohesion::contact_solver {

/// Returns a/b, or infinity unless that is a positive number: solvers trap divisions by zero.
inline double positive_ratio(double a, double b) {
  const bool one_sign = (a > 0.0 && b > 0.0) || (a < 0.0 && b < 0.0);
  if (!one_sign || std::abs(a) * 1e-300 >= std::abs(b))
    return std::numeric_limits<double>::infinity();
  return a / b;
}

/// The first t > 0 [time] at which distance + v t + a t^2/2 = 0; infinity if there is none.
///
/// Source: W. H. Press et al., Numerical Recipes, section 5.6 (both roots without cancellation).
inline double first_root(double distance, double v, double a) {
  const double discriminant = v * v - 2.0 * a * distance;
  if (discriminant < 0.0) return std::numeric_limits<double>::infinity();
  const double q = -(v + std::copysign(std::sqrt(discriminant), v));
  double first = std::numeric_limits<double>::infinity();
  for (const double t : {positive_ratio(2.0 * distance, q), positive_ratio(q, a)})
    if (t < first) first = t;
  return first;
}

}  // namespace cohesion::contact_solver
