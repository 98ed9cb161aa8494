// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "validation.h"

namespace cohesion::liquid {

/// Added mass: the fluid that a sphere has to move out of its way when it accelerates against it.
///
///   F = C rho V (Du/Dt - dv/dt),   Du/Dt = du/dt + u . grad u at the sphere,
///
/// with u the fluid's velocity, v the sphere's, V its volume, rho the fluid's density. That is
/// F = -(dI/dt + I . grad u) with I = C rho V (v - u) and d/dt along the sphere's path: the terms
/// v . grad u of both cancel. F is on the sphere; the fluid feels -F.
///
/// C = 1/2 is exact for one sphere in fluid without viscosity that is uniform over it. Among others
/// C rises, to first order as (1 + 3 phi)/2 (N. Zuber, 1964): not here, but C may be given.
///
/// Source: T. R. Auton, J. C. R. Hunt, M. Prud'homme, J. Fluid Mech. 197 (1988) 241.
class AddedMass {
 public:
  static constexpr double of_a_sphere = 0.5;

  /// coefficient C [1] > 0. Throws InvalidParameter where it is not.
  explicit AddedMass(double coefficient = of_a_sphere) : coefficient_(coefficient) {
    require_positive("addedMass", coefficient);
  }

  double coefficient() const { return coefficient_; }

  /// C rho V [mass]; density [mass/length^3], volume [length^3].
  double mass(double density, double volume) const { return coefficient_ * density * volume; }

 private:
  double coefficient_;
};

}  // namespace cohesion::liquid
