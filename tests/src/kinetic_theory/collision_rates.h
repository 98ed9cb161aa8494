// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "constants.h"

/// What smooth hard spheres of one size with Maxwell's velocities do to each other per time, as
/// Enskog counts them: g_0 times as many meet as of strangers.
///
/// Symbols: phi solid fraction, g_0 radial function at contact, e restitution [1]; theta =
/// <v'.v'>/3 [length^2/time^2]; d diameter [length]; rho density of the material [mass/length^3].
namespace cohesion::kinetic_theory {

/// Collisions of a sphere per time, 24 phi g_0 sqrt(theta/pi)/d, [1/time]; half as many pairs meet.
/// Source: S. Chapman, T. G. Cowling, The Mathematical Theory of Non-Uniform Gases, ch. 16.
inline double collision_frequency(double phi, double radial, double theta, double diameter) {
  return 24.0 * phi * radial * std::sqrt(theta / pi) / diameter;
}

/// The excess compressibility of elastic spheres that collide so often: the same formula backwards,
/// with y = 4 phi g_0. Exact where velocities are Maxwell's.
inline double compressibility_of_frequency(double frequency, double theta, double diameter) {
  return frequency * diameter * std::sqrt(pi / theta) / 6.0;
}

/// Energy that collisions take per volume and time, in a flow that is not compressed:
///
///   gamma = 12 (1 - e^2) phi^2 rho g_0 theta^(3/2)/(d sqrt(pi))
///
/// [mass/(length time^3)]. Source: J. T. Jenkins, S. B. Savage, J. Fluid Mech. 130 (1983) 187; C.
/// K. K. Lun et al., J. Fluid Mech. 140 (1984) 223.
inline double dissipation(double phi, double radial, double restitution, double theta,
                          double diameter, double density) {
  return 12.0 * (1.0 - restitution * restitution) * phi * phi * density * radial * theta *
         std::sqrt(theta / pi) / diameter;
}

}  // namespace cohesion::kinetic_theory
