// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "hard_sphere/impact.h"
#include "mixing.h"
#include "square_well/parameters.h"
#include "validation.h"

namespace cohesion::hard_sphere {

/// Parameters of the impacts of a pair of materials.
struct HardContactParameters {
  double restitution = 1.0;                ///< e, [1]
  double friction = 0.0;                   ///< mu_f, [1]
  square_well::SquareWellParameters well;  ///< around the hard core

  ImpactLaw law() const { return {restitution, friction, well.depth}; }
};

/// Throws InvalidParameter unless core and well are valid, and an attractive well is wider than the
/// core.
inline void require_valid(const HardContactParameters& p) {
  require_valid(p.law());
  square_well::require_valid(p.well);
  require(p.well.depth == 0.0 || p.well.ratio_i > 1.0, "ratio r_out/r of the well", p.well.ratio_i,
          "must be above 1 with a depth above zero: between core and edge in the same place a "
          "captured pair would have infinitely many events in no time");
}

/// Unlike materials: geometric means of restitution and friction; the well as in
/// square_well::mixed.
inline HardContactParameters mixed(const HardContactParameters& a, const HardContactParameters& b) {
  return {geometric_mean(a.restitution, b.restitution), geometric_mean(a.friction, b.friction),
          square_well::mixed(a.well, b.well)};
}

}  // namespace cohesion::hard_sphere
