// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "kinetic_theory/cohesive_compressibility.h"
#include "kinetic_theory/granular_pressure.h"
#include "square_well/parameters.h"
#include "validation.h"

namespace cohesion::kinetic_theory {

/// What square wells leave of the excess compressibility of a gas of equal grains whose granular
/// temperature is a field: CohesiveRatio where it was measured, and at the end of that range beyond
/// it, where it says so.
///
/// Symbols: D depth of the wells [energy], lambda r_out/r [1], m mass of a grain; T = m theta,
/// theta = <v'.v'>/3 [length^2/time^2].
///
/// Range: X no larger than that of lambda = 1.05, D/T = 1, so that wider wells may be less deep,
/// and phi no larger than 0.5. Cold grains, with a larger X, are taken as those of the largest:
/// their pressure is too high. Denser ones have the ratio of 0.5, and no slope. With either the
/// pressure rises with phi everywhere; what the law would give beyond may fall with it, a gas that
/// parts into two by itself, which nobody measured.
class SquareWellGas {
 public:
  struct PressureRatio {
    GranularPressure::Cohesion cohesion;
    bool too_cold, too_dense;  ///< out of the range
  };

  /// Throws InvalidParameter unless D >= 0, lambda is that of a well and m > 0, all finite.
  SquareWellGas(double depth, double lambda, double mass)
      : depth_(depth), lambda_(lambda), mass_(mass) {
    square_well::require_valid(square_well::well(depth, lambda));
    require_positive("mass of a grain", mass);
    most_ = largest_depth_over_t(lambda);
  }

  double depth() const { return depth_; }
  double lambda() const { return lambda_; }
  double mass() const { return mass_; }

  /// D/T, [1]; infinite of grains at rest
  double depth_over_t(double theta) const {
    const double temperature = mass_ * theta;
    // Far beyond any range the division itself would overflow.
    if (depth_ > 0.0 && temperature <= depth_ * 1e-100)
      return std::numeric_limits<double>::infinity();
    return depth_ > 0.0 ? depth_ / temperature : 0.0;
  }

  /// The largest D/T of the range, [1]; infinite where lambda = 1
  double largest_depth_over_t() const { return most_; }

  PressureRatio ratio(double phi, double theta) const {
    const double deep = depth_over_t(theta), within = std::min(deep, most_);
    if (lambda_ == 1.0 || within == 0.0) return {{1.0, 0.0}, false, false};
    const double X = (lambda_ * lambda_ * lambda_ - 1.0) * std::expm1(within);
    const bool dense = phi > CohesiveRatio::largest_fraction;
    const double inside = std::clamp(phi, 0.0, CohesiveRatio::largest_fraction);
    return {{CohesiveRatio::value(inside, X), dense ? 0.0 : CohesiveRatio::slope(inside, X)},
            deep > most_,
            dense};
  }

 private:
  double depth_, lambda_, mass_;
  // Of a well that is valid: of no number it would stop programs that trap these.
  double most_ = 0.0;

  static double largest_depth_over_t(double lambda) {
    if (!(lambda > 1.0)) return std::numeric_limits<double>::infinity();
    const double X =
        gathered_by_well(CohesiveRatio::measured_lambda, CohesiveRatio::measured_depth_over_t);
    return std::log1p(X / (lambda * lambda * lambda - 1.0));
  }
};

}  // namespace cohesion::kinetic_theory
