// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "drag/stokes_scaled.h"
#include "drag/validity.h"
#include "drag/wen_yu.h"

namespace cohesion::drag {

/// Ergun's packed bed below a void fraction of 0.8, Wen and Yu's suspension from there.
///
///   eps <  0.8:  F_total = (150 (1 - eps) + 1.75 Re) / (18 eps^3)
///   eps >= 0.8:  F_total = eps^-n C_D Re/24,   n = 4.65,   C_D of Schiller and Naumann
///
/// as beta: 150 (1-eps)^2 mu/(eps d^2) + 1.75 (1-eps) rho |u - v|/d, and
/// 3/4 C_D eps (1-eps) rho |u - v|/d eps^(2-n), the printed exponent being -2.65. Both were
/// measured as F_total: a pressure drop, and the expansion of a suspension that is held up. Without
/// inertia n is the exponent of Richardson and Zaki, whose suspensions settle at eps^n of a single
/// sphere's speed.
///
/// Limits: eps -> 1 is Schiller and Naumann's single sphere. The two branches do not meet: at 0.8
/// the force falls with rising void fraction by 13 % at Re = 0, 42 % at Re = 100, 73 % at Re = 999.
///
/// Validity: packed beds up to single spheres; Re to the end of Schiller and Naumann's formula, and
/// of Ergun's data, Re/(1 - eps) = 2500, at eps = 0.6.
///
/// Source: S. Ergun, Chem. Eng. Prog. 48 (1952) 89; C. Y. Wen, Y. H. Yu, Chem. Eng. Prog. Symp.
/// Ser. 62 (1966) 100; joined by D. Gidaspow, Multiphase flow and fluidization (1994). As used by
/// M. A. van der Hoef et al., Adv. Chem. Eng. 31 (2006) 65.
struct ErgunWenYu {
  static constexpr const char* name = "ergunWenYu";
  static constexpr Validity validity{0.36, 1.0, 1000.0};
  static constexpr double exponent = WenYu::exponent;

  /// beta/(1 - eps) as in SyamlalOBrien::per_solid_volume, with Wen and Yu's exponent n [1].
  static double with_exponent(double n, double void_fraction, double slip, double diameter,
                              double density, double viscosity) {
    const double reynolds = superficial_reynolds(void_fraction, slip, diameter, density, viscosity);
    const double force = void_fraction < 0.8
                             ? (150.0 * (1.0 - void_fraction) + 1.75 * reynolds) /
                                   (18.0 * void_fraction * void_fraction * void_fraction)
                             : WenYu::scaled_total(n, void_fraction, reynolds);
    return from_total(force, void_fraction, diameter, viscosity);
  }

  /// As with_exponent, n = 4.65.
  static double per_solid_volume(double void_fraction, double slip, double diameter, double density,
                                 double viscosity) {
    return with_exponent(exponent, void_fraction, slip, diameter, density, viscosity);
  }
};

}  // namespace cohesion::drag
