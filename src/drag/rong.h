// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "drag/single_sphere.h"
#include "drag/stokes_scaled.h"
#include "drag/validity.h"

namespace cohesion::drag {

/// Drag of Rong, Dong and Yu, from lattice-Boltzmann simulations of flow through packed beds of
/// equal spheres: Di Felice's form with an exponent of both void fraction and Reynolds number.
///
///   F_drag = eps^-beta C_D Re/24,   C_D = (0.63 + 4.8/sqrt(Re))^2
///   beta   = 2.65 (eps + 1) - (5.3 - 3.5 eps) eps^2 exp(-(1.5 - log10 Re)^2/2)
///
/// Limits: eps -> 1 is Dalla Valle's single sphere, 4 % below Stokes for Re -> 0. At eps = 0.4 the
/// formula is 8 % below Ergun's F_drag for Re -> 0 and 1 % below at Re = 1000, which says that it
/// is F_drag; as F_total it would be 60 % below. Continuous. Without inertia a suspension settles
/// at eps^(1 + beta) of a single sphere's speed; in dilute ones 1 + beta tends to 6.3, where
/// Richardson and Zaki have 4.65.
///
/// Validity: packed beds, from random close packing on. The paper was not at hand; the formula is
/// that of several public codes, which state no range. The upper void fraction is where the
/// exponent leaves that of suspensions, 5.8 against 4.65; the highest Reynolds number is that of
/// the other simulated arrays. Both are assumptions of this package.
///
/// Source: L. W. Rong, K. J. Dong, A. B. Yu, Chem. Eng. Sci. 99 (2013) 44.
struct Rong {
  static constexpr const char* name = "rong";
  static constexpr Validity validity{0.36, 0.8, 1000.0};
  static constexpr const char* no_exponent =
      "its exponent is a function of void fraction and Reynolds number";

  /// beta [1] at the Reynolds number [1] of the superficial slip, zero included.
  static double exponent(double void_fraction, double reynolds) {
    const double still = 2.65 * (void_fraction + 1.0);
    if (reynolds <= 0.0) return still;
    const double decades = 1.5 - std::log10(reynolds);
    return still - (5.3 - 3.5 * void_fraction) * void_fraction * void_fraction *
                       std::exp(-0.5 * decades * decades);
  }

  /// beta/(1 - eps) as in SyamlalOBrien::per_solid_volume.
  static double per_solid_volume(double void_fraction, double slip, double diameter, double density,
                                 double viscosity) {
    const double reynolds = superficial_reynolds(void_fraction, slip, diameter, density, viscosity);
    const double force =
        std::pow(void_fraction, -exponent(void_fraction, reynolds)) * dalla_valle(reynolds);
    return from_drag(force, void_fraction, diameter, viscosity);
  }
};

}  // namespace cohesion::drag
