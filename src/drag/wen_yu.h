// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "drag/single_sphere.h"
#include "drag/stokes_scaled.h"
#include "drag/validity.h"

namespace cohesion::drag {

/// Wen and Yu's suspension at all void fractions, a packed bed included:
///
///   F_total = eps^-n C_D Re/24,   n = 4.65,   C_D of Schiller and Naumann
///
/// as beta: 3/4 C_D eps (1-eps) rho |u - v|/d eps^(2-n). Without inertia n is the exponent of
/// Richardson and Zaki, whose suspensions settle at eps^n of a single sphere's speed. Two-fluid
/// models of fine powders take up to 9.6.
///
/// Limits: eps -> 1 is Schiller and Naumann's single sphere. Without inertia 9 % below Ergun's
/// packed bed at eps = 0.4. Continuous, but for the single sphere's step of 0.4 % at Re = 1000.
///
/// Validity: fluidised beds up to single spheres; Re to the end of Schiller and Naumann's formula.
///
/// Source: C. Y. Wen, Y. H. Yu, Chem. Eng. Prog. Symp. Ser. 62 (1966) 100; with the exponent to
/// choose M. A. van der Hoef et al., Adv. Chem. Eng. 31 (2006) 65.
struct WenYu {
  static constexpr const char* name = "wenYu";
  static constexpr Validity validity{0.4, 1.0, 1000.0};
  static constexpr double exponent = 4.65;

  /// F_total over Stokes' [1] at the Reynolds number of stokes_scaled.h [1].
  static double scaled_total(double n, double void_fraction, double reynolds) {
    return std::pow(void_fraction, -n) * schiller_naumann(reynolds);
  }

  /// beta/(1 - eps) as in SyamlalOBrien::per_solid_volume, with the exponent n [1].
  static double with_exponent(double n, double void_fraction, double slip, double diameter,
                              double density, double viscosity) {
    const double reynolds = superficial_reynolds(void_fraction, slip, diameter, density, viscosity);
    return from_total(scaled_total(n, void_fraction, reynolds), void_fraction, diameter, viscosity);
  }

  /// As with_exponent, n = 4.65.
  static double per_solid_volume(double void_fraction, double slip, double diameter, double density,
                                 double viscosity) {
    return with_exponent(exponent, void_fraction, slip, diameter, density, viscosity);
  }
};

}  // namespace cohesion::drag
