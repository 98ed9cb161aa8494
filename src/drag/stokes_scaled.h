// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

/// The conventions of the drag closures, and the one place that converts between them.
///
/// Velocity. u - v is the slip between the gas in the voids and the particles; the superficial slip
/// is U = eps |u - v|. Here forces and Reynolds numbers are those of U.
///
/// Force. A particle in a suspension feels -V_p grad p, with grad p the mean pressure gradient of
/// the gas, and beside it the drag. Steady flow through particles has eps grad p = -n F_drag, with
/// n = (1 - eps)/V_p particles per volume, so that
///
///   F_total = F_drag - V_p grad p = F_drag (1 + (1 - eps)/eps) = F_drag/eps.
///
/// Form A (model_form.h) needs F_drag, form B F_drag/eps; pressure drops through packed beds and
/// simulations of fixed particles give F_total. Each closure says which of the two it states.
///
/// Scale. F = force/(3 pi mu d U), which is 1 for a single sphere without inertia. F_drag is
/// V_p beta/(1 - eps) |u - v|, hence
///
///   beta/(1 - eps) = 18 mu eps F_drag/d^2.
namespace cohesion::drag {

/// rho U d/mu, [1]. void_fraction eps [1], slip |u - v| [length/time], diameter [length], density
/// [mass/volume] and viscosity [mass/(length time)] of the gas.
inline double superficial_reynolds(double void_fraction, double slip, double diameter,
                                   double density, double viscosity) {
  return void_fraction * slip * diameter * density / viscosity;
}

/// F_drag [1] without inertia of random arrays of equal spheres: the first two terms of Beetstra's
/// and Tang's closures.
inline double drag_without_inertia(double void_fraction) {
  const double phi = 1.0 - void_fraction, square = void_fraction * void_fraction;
  return 10.0 * phi / square + square * (1.0 + 1.5 * std::sqrt(phi));
}

/// Why closures have no exponent for the void fraction, as messages have it.
inline constexpr const char* fitted_dependence =
    "its dependence on the void fraction is fitted and no power";

/// beta/(1 - eps) [mass/(volume time)] of a scaled drag [1].
inline double from_drag(double scaled_force, double void_fraction, double diameter,
                        double viscosity) {
  return 18.0 * viscosity * void_fraction * scaled_force / (diameter * diameter);
}

/// beta/(1 - eps) [mass/(volume time)] of a scaled drag together with the mean pressure [1].
inline double from_total(double scaled_force, double void_fraction, double diameter,
                         double viscosity) {
  return from_drag(void_fraction * scaled_force, void_fraction, diameter, viscosity);
}

}  // namespace cohesion::drag
