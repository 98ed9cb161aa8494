// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

namespace cohesion::drag {

/// Mean drag on a particle over a time step, the coefficient and every other force held constant.
///
///   m dv/dt = b (u - v) + F      has      v(t) = v_inf + (v_0 - v_inf) exp(-b t/m),
///   v_inf = u + F/b, and the drag that takes v_0 to v(dt) together with F is
///   f = b phi (u - v_0) + (phi - 1) F,   phi = (1 - exp(-x))/x,   x = b dt/m.
///
/// Exact at any x, so drag limits no time step; the terminal velocity is exact too. One component.
///
/// coefficient b [force time/length] >= 0, mass [mass], dt [time], slip u - v [length/time],
/// other_force F [force]; results [force].
class ParticleDrag {
 public:
  ParticleDrag(double coefficient, double mass, double dt) : coefficient_(coefficient) {
    const double x = coefficient * dt / mass;
    if (x < 1e-3) {
      // phi - 1 loses its digits for small x; its series, the next term of which is below them,
      // does not, and takes no exponential.
      phi_minus_one_ = -x * (0.5 - x * (1.0 / 6.0 - x * (1.0 / 24.0 - x / 120.0)));
      phi_ = 1.0 + phi_minus_one_;
    } else {
      phi_ = -std::expm1(-x) / x;
      phi_minus_one_ = phi_ - 1.0;
    }
    half_change_ = 0.5 * x * phi_;
  }

  /// `slip` at the start of the step.
  double force(double slip, double other_force) const {
    return coefficient_ * phi_ * slip + phi_minus_one_ * other_force;
  }

  /// The same from the velocity in the middle of the step as leapfrog has it, (v_0 + v(dt))/2.
  double force_about(double middle_slip, double other_force) const {
    const double h = half_change_;
    return (coefficient_ * phi_ * middle_slip + (phi_minus_one_ + h) * other_force) / (1.0 - h);
  }

 private:
  double coefficient_;
  double phi_;
  double phi_minus_one_;
  double half_change_;  // (1 - exp(-x))/2
};

/// Force of the gas pressure on a particle of `volume`, -V_p grad p; one component, [force].
inline double pressure_force(double volume, double pressure_gradient) {
  return -volume * pressure_gradient;
}

}  // namespace cohesion::drag
