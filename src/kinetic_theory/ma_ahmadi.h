// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

namespace cohesion::kinetic_theory {

/// Pairs of equal hard spheres at contact over those of strangers, of Ma and Ahmadi:
///
///   chi = (1 + 2.5 phi + 4.5904 phi^2 + 4.515456 phi^3)/(1 - (phi/phi_m)^3)^0.67802
///
/// Symbols: phi solid fraction, phi_m = 0.64356 that of random close packing [1]. Limits: the first
/// virial coefficients for few spheres; diverges at phi_m.
///
/// Source: D. Ma, G. Ahmadi, J. Chem. Phys. 84 (1986) 3449, as M. A. van der Hoef et al., Adv.
/// Chem. Eng. 31 (2006) 65 have it.
struct MaAhmadi {
  static constexpr const char* name = "maAhmadi";
  static constexpr double largest_fraction = 0.64356;  ///< where it diverges

  static double contact_value(double phi) { return numerator(phi) * std::pow(room(phi), -power); }

  /// d chi/d phi
  static double slope(double phi) {
    const double left = room(phi);
    const double loss = 3.0 * phi * phi / (largest_fraction * largest_fraction * largest_fraction);
    const double rise = c1 + phi * (2.0 * c2 + 3.0 * c3 * phi);
    return (rise + power * numerator(phi) * loss / left) * std::pow(left, -power);
  }

 private:
  static constexpr double c1 = 2.5, c2 = 4.5904, c3 = 4.515456, power = 0.67802;

  static constexpr double numerator(double phi) { return 1.0 + phi * (c1 + phi * (c2 + phi * c3)); }
  static constexpr double room(double phi) {
    const double filled = phi / largest_fraction;
    return 1.0 - filled * filled * filled;
  }
};

}  // namespace cohesion::kinetic_theory
