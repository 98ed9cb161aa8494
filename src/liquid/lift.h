// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>
#include <string_view>

#include "constants.h"

/// Lift of a sphere that slips through sheared fluid:
///
///   F = C_L rho V (u - v) x omega,   omega = curl u,
///
/// on the sphere; the fluid feels -F. A bubble that rises faster than a liquid whose upward
/// velocity falls towards the wall is driven to the wall.
namespace cohesion::liquid {

/// The flow around one sphere: |omega| [1/time], |u - v| [length/time], diameter [length], density
/// [mass/length^3], viscosity [mass/(length time)].
struct ShearedFlow {
  double vorticity, slip, diameter, density, viscosity;
};

/// C_L = 1/2 [1]: one sphere in weakly sheared fluid without viscosity. T. R. Auton, J. Fluid Mech.
/// 183 (1987) 199; D. A. Drew, R. T. Lahey, Int. J. Multiphase Flow 13 (1987) 113.
inline double inviscid_lift(const ShearedFlow&) { return 0.5; }

/// C_L [1] of a small sphere: Saffman's, F = 1.615 mu d |u - v| sqrt(rho d^2 |omega|/mu), which is
/// C_L = 1.615 6/pi sqrt(mu/(rho d^2 |omega|)), times Mei's
///   (1 - 0.3314 sqrt(a)) exp(-Re/10) + 0.3314 sqrt(a) up to Re = 40, 0.0524 sqrt(a Re) from there,
///   a = d |omega|/(2 |u - v|), Re = rho |u - v| d/mu,
/// fitted for a of 0.005 to 0.4 and Re up to 100. Without vorticity 0, which the force is then.
/// Where there is no slip a is taken for 0.4, the end of the fit: the force vanishes with the slip.
///
/// P. G. Saffman, J. Fluid Mech. 22 (1965) 385, 31 (1968) 624; R. Mei, Int. J. Multiphase Flow 18
/// (1992) 145.
inline double saffman_mei_lift(const ShearedFlow& at) {
  if (!(at.vorticity > 0.0)) return 0.0;
  constexpr double largest_shear = 0.4, highest_fitted = 40.0;
  const double shear_reynolds =
      at.density * at.diameter * at.diameter * at.vorticity / at.viscosity;
  const double saffman = 1.615 * 6.0 / pi / std::sqrt(shear_reynolds);
  const double reynolds = at.density * at.slip * at.diameter / at.viscosity;
  if (reynolds > highest_fitted) return saffman * 0.0524 * std::sqrt(0.5 * shear_reynolds);
  const double across = 0.5 * at.diameter * at.vorticity;
  const double a = across < largest_shear * at.slip ? across / at.slip : largest_shear;
  const double root = 0.3314 * std::sqrt(a);
  return saffman * ((1.0 - root) * std::exp(-0.1 * reynolds) + root);
}

struct LiftLaw {
  std::string_view name;
  double (*coefficient)(const ShearedFlow&);  ///< C_L [1]; none without lift
};

/// The table of lift laws: the one place that knows them all.
inline constexpr std::array lift_laws{LiftLaw{"none", nullptr}, LiftLaw{"inviscid", &inviscid_lift},
                                      LiftLaw{"saffmanMei", &saffman_mei_lift}};

}  // namespace cohesion::liquid
