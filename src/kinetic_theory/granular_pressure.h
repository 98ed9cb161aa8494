// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace cohesion::kinetic_theory {

/// Pressure of a gas of grains over its granular temperature, with an excess compressibility y:
///
///   p_s/theta = rho phi (1 + c y),   y = 2 (1 + e) phi g_0 of smooth spheres without cohesion
///
/// Symbols: rho density of the material [mass/length^3]; phi solid fraction, g_0 radial function at
/// contact, e restitution [1]; theta = <v'.v'>/3 [length^2/time^2]; c what cohesion leaves of y, 1
/// without [1]. Positive in compression.
///
/// Source: C. K. K. Lun et al., J. Fluid Mech. 140 (1984) 223; M. A. van der Hoef et al., Adv.
/// Chem. Eng. 31 (2006) 65, eq. 78.
struct GranularPressure {
  /// c at some phi, and its slope d c/d phi
  struct Cohesion {
    double ratio = 1.0, slope = 0.0;
  };

  double density;      ///< rho, [mass/length^3]
  double restitution;  ///< e, [1]

  /// p_s/theta, [mass/length^3]
  constexpr double over_temperature(double phi, double radial, double cohesion_ratio = 1.0) const {
    return density * phi * (1.0 + 2.0 * (1.0 + restitution) * phi * radial * cohesion_ratio);
  }

  /// d(p_s/theta)/d phi with the slope d g_0/d phi, [mass/length^3]
  constexpr double slope(double phi, double radial, double radial_slope,
                         const Cohesion& cohesion) const {
    const double contacts = (2.0 * radial + phi * radial_slope) * cohesion.ratio;
    return density *
           (1.0 + 2.0 * (1.0 + restitution) * phi * (contacts + phi * radial * cohesion.slope));
  }
};

}  // namespace cohesion::kinetic_theory
