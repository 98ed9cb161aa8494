// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "constants.h"

namespace cohesion::kinetic_theory {

/// Viscosity of a gas of few elastic hard spheres, first Sonine polynomial:
///
///   mu_0 = 5/(16 d^2) sqrt(m T/pi) = (5 sqrt(pi)/96) rho d sqrt(theta)
///
/// Symbols: d diameter [length], m mass, T = m theta; rho = m/(pi d^3/6) density of the material
/// [mass/length^3]; theta = <v'.v'>/3 [length^2/time^2]. The exact number is 1.6 % above.
/// Source: S. Chapman, T. G. Cowling, The Mathematical Theory of Non-Uniform Gases, ch. 10.
inline double dilute_viscosity(double density, double diameter, double theta) {
  return 5.0 * std::sqrt(pi * theta) / 96.0 * density * diameter;
}

/// Viscosity of elastic hard spheres, of Enskog, first Sonine polynomial:
///
///   mu = mu_0 [ (1 + 8/5 phi chi)^2/chi + 768/(25 pi) phi^2 chi ]
///
/// phi solid fraction, chi radial function at contact [1]. Simulations bear it out to phi = 0.3 and
/// are up to twice as high at 0.5 (B. J. Alder, D. M. Gass, T. E. Wainwright, J. Chem. Phys. 53
/// (1970) 3813). [mass/(length time)]. Source: as above, ch. 16.
inline double enskog_viscosity(double phi, double radial, double density, double diameter,
                               double theta) {
  const double kinetic = 1.0 + 1.6 * phi * radial;
  return dilute_viscosity(density, diameter, theta) *
         (kinetic * kinetic / radial + 768.0 / (25.0 * pi) * phi * phi * radial);
}

}  // namespace cohesion::kinetic_theory
