// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "drag/validity.h"

namespace cohesion::drag {

/// Drag closure of Syamlal and O'Brien, from the terminal velocity of a settling suspension.
///
///   beta = 3 eps_s eps_g rho_g / (4 V_t^2 d) C_Ds |u - v|
///   C_Ds = (0.63 + 4.8 sqrt(V_t/Re))^2
///   V_t  = 0.5 (A - 0.06 Re + sqrt((0.06 Re)^2 + 0.12 Re (2B - A) + A^2))
///   A    = eps_g^4.14
///   B    = 0.8 eps_g^1.28 (eps_g <= 0.85),  eps_g^2.65 (eps_g > 0.85)
///   Re   = d |u - v| rho_g / mu_g
///
/// Inserting C_Ds shows the limit Re -> 0 without a division by zero:
///   C_Ds |u - v| = (0.63 sqrt(|u - v|) + 4.8 sqrt(V_t mu_g / (d rho_g)))^2.
/// For eps_g -> 1 it is the drag of a single sphere with C_D = (0.63 + 4.8/sqrt(Re))^2
/// (J. M. Dalla Valle), whose Stokes limit is 23.04/Re, 4 % below Stokes' 24/Re.
///
/// beta is that of F_drag (stokes_scaled.h), while Re is that of the slip in the voids here.
///
/// Validity: packed beds up to single spheres; superficial Re as far as the single sphere's
/// formula.
///
/// Source: M. Weber, thesis, chapter 6; M. Syamlal, T. J. O'Brien, AIChE Symp. Ser. 85 (1989) 22.
struct SyamlalOBrien {
  static constexpr const char* name = "syamlalOBrien";
  static constexpr Validity validity{0.36, 1.0, 1e4};
  static constexpr const char* no_exponent =
      "its void fraction enters through the terminal velocity of a suspension";

  /// beta / (eps_s), [mass/(volume time)]: the drag per volume of solid and unit slip, which unlike
  /// beta does not vanish with the last particle.
  /// void_fraction eps_g in (0, 1], slip |u - v| [length/time], diameter [length], density rho_g
  /// [mass/volume], viscosity mu_g [mass/(length time)].
  static double per_solid_volume(double void_fraction, double slip, double diameter, double density,
                                 double viscosity) {
    const double reynolds = diameter * slip * density / viscosity;
    const double a = std::pow(void_fraction, 4.14);
    const double b =
        void_fraction <= 0.85 ? 0.8 * std::pow(void_fraction, 1.28) : std::pow(void_fraction, 2.65);
    const double x = 0.06 * reynolds;
    const double v_t = 0.5 * (a - x + std::sqrt(x * x + 2.0 * x * (2.0 * b - a) + a * a));
    const double root =
        0.63 * std::sqrt(slip) + 4.8 * std::sqrt(v_t * viscosity / (diameter * density));
    return 0.75 * void_fraction * density / (v_t * v_t * diameter) * root * root;
  }
};

}  // namespace cohesion::drag
