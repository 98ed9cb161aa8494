// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "drag/single_sphere.h"
#include "drag/stokes_scaled.h"
#include "drag/validity.h"

namespace cohesion::drag {

/// Di Felice's drag from the expansion of suspensions over all flow regimes, one formula for all
/// void fractions.
///
///   F_drag = eps^-xi C_D Re/24,   C_D = (0.63 + 4.8/sqrt(Re))^2
///   xi     = 3.7 - 0.65 exp(-(1.5 - log10 Re)^2/2)
///
/// xi belongs to F_drag, not to F_total, whose exponent xi + 1 is 4.7 at both ends of Re.
/// Limits: eps -> 1 is Dalla Valle's single sphere, 4 % below Stokes for Re -> 0. Continuous.
///
/// Validity: fluidised and fixed beds, Re from 0.01 to 10^4.
///
/// Source: R. Di Felice, Int. J. Multiphase Flow 20 (1994) 153.
struct DiFelice {
  static constexpr const char* name = "diFelice";
  static constexpr Validity validity{0.4, 1.0, 1e4};
  static constexpr const char* no_exponent = "its exponent is a function of the Reynolds number";

  /// xi [1] at the Reynolds number [1] of the superficial slip, zero included.
  static double exponent(double reynolds) {
    if (reynolds <= 0.0) return 3.7;
    const double decades = 1.5 - std::log10(reynolds);
    return 3.7 - 0.65 * std::exp(-0.5 * decades * decades);
  }

  /// beta/(1 - eps) as in SyamlalOBrien::per_solid_volume.
  static double per_solid_volume(double void_fraction, double slip, double diameter, double density,
                                 double viscosity) {
    const double reynolds = superficial_reynolds(void_fraction, slip, diameter, density, viscosity);
    const double force = std::pow(void_fraction, -exponent(reynolds)) * dalla_valle(reynolds);
    return from_drag(force, void_fraction, diameter, viscosity);
  }
};

}  // namespace cohesion::drag
