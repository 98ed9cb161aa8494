// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "validation.h"

namespace cohesion::lattice_boltzmann {

/// Two relaxation times, lattice units: of the even part of the populations, which has the
/// viscosity, and of the odd one, which is free and places the walls,
///
///   nu = (tau_even - 1/2)/3,     (tau_even - 1/2) (tau_odd - 1/2) = Lambda.
///
/// With Lambda fixed what steady flow without inertia looks like does not depend on nu. Source: I.
/// Ginzburg, F. Verhaeghe, D. d'Humieres, Commun. Comput. Phys. 3 (2008) 427.
class Relaxation {
 public:
  /// At which walls half-way between nodes are where they belong in channels along an axis.
  static constexpr double wall_constant = 3.0 / 16.0;

  /// viscosity nu [spacing^2/step]. Throws InvalidParameter unless it is positive and finite.
  explicit Relaxation(double viscosity) : viscosity_(viscosity) {
    require_positive("lattice viscosity", viscosity);
    const double even = 3.0 * viscosity;
    even_ = 1.0 / (even + 0.5);
    odd_ = 1.0 / (wall_constant / even + 0.5);
  }

  double viscosity() const { return viscosity_; }
  /// 1/tau
  double even() const { return even_; }
  double odd() const { return odd_; }

 private:
  double viscosity_, even_, odd_;
};

}  // namespace cohesion::lattice_boltzmann
