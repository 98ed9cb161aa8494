// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace cohesion::kinetic_theory {

/// Pairs of equal hard spheres at contact over those of strangers, of Carnahan and Starling:
///
///   chi = (1 - phi/2)/(1 - phi)^3
///
/// Symbols: phi solid fraction [1]. Limits: 1 for few spheres; it diverges only where spheres would
/// fill all space, so that it is too low near random close packing, by a tenth at phi = 0.55. Above
/// 0.494, where a fluid of spheres freezes when it has the time, it is that of the fluid that has
/// not.
///
/// Source: N. F. Carnahan, K. E. Starling, J. Chem. Phys. 51 (1969) 635.
struct CarnahanStarling {
  static constexpr const char* name = "carnahanStarling";
  static constexpr double largest_fraction = 1.0;  ///< where it diverges

  static constexpr double contact_value(double phi) {
    const double room = 1.0 - phi;
    return (1.0 - 0.5 * phi) / (room * room * room);
  }

  /// d chi/d phi
  static constexpr double slope(double phi) {
    const double room = 1.0 - phi;
    return (2.5 - phi) / (room * room * room * room);
  }
};

}  // namespace cohesion::kinetic_theory
