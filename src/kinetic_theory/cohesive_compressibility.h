// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "square_well/parameters.h"

namespace cohesion::kinetic_theory {

/// X of the law below, [1]: what a well adds to the second virial coefficient. Throws
/// InvalidParameter as square_well::require_valid().
inline double gathered_by_well(double lambda, double depth_over_t) {
  square_well::require_valid(square_well::well(depth_over_t, lambda));
  return (lambda * lambda * lambda - 1.0) * std::expm1(depth_over_t);
}

/// Excess compressibility of elastic spheres with square wells over that of hard spheres at the
/// same solid fraction, as measured:
///
///   y/y_HS = 1 - X (1 + 2.764 phi - 0.969 phi^2 - 4.836 phi X),   X = (lambda^3 - 1)(exp(D/T) - 1)
///
/// Symbols: phi solid fraction, lambda r_out/r [1]; D depth of the wells, T = m theta of the motion
/// along one direction [energy]. For few spheres it is the second virial coefficient
/// (second_virial.h), exact.
///
/// Validity: fitted to lambda = 1.05, D/T from 0.3 to 1 and phi from 0.1 to 0.5 (fifteen gases of
/// 512 spheres), which it misses by 0.004 of y_HS in the mean and 0.007 at most, with errors of
/// 0.0034. Of other lambda only its limit of few spheres was tried. Elastic: where pairs lose
/// energy they stay in their wells, and y falls much further, to below zero at phi = 0.1, D/T = 1,
/// e = 0.9.
///
/// Source: examples/compressibility.
struct CohesiveRatio {
  /// What it was fitted to ends here: the densest gas, and X of lambda = 1.05 at D/T = 1.
  static constexpr double measured_lambda = 1.05, measured_depth_over_t = 1.0;
  static constexpr double largest_fraction = 0.5;

  static constexpr double value(double phi, double X) {
    return 1.0 - X * (1.0 + phi * (2.764 - 0.969 * phi - 4.836 * X));
  }

  /// d(y/y_HS)/d phi at the same D/T, [1]
  static constexpr double slope(double phi, double X) {
    return -X * (2.764 - 2.0 * 0.969 * phi - 4.836 * X);
  }
};

}  // namespace cohesion::kinetic_theory
