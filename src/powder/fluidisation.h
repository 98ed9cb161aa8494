// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "drag/drag_law.h"
#include "drag/single_sphere.h"
#include "sphere.h"
#include "validation.h"

/// Speeds at which a gas lifts a powder. Any consistent set of units.
namespace cohesion::powder {

struct Gas {
  double density;    ///< [mass/volume]
  double viscosity;  ///< [mass/(length time)]
};

/// A sphere that weighs down in a gas.
struct Grain {
  double diameter;  ///< [length]
  double density;   ///< [mass/volume]
};

/// Throws InvalidParameter unless the grain is heavier than the gas, and all is positive.
inline void require_lifted(const Grain& grain, const Gas& gas, double gravity) {
  require_positive("diameter", grain.diameter);
  require_positive("density of the gas", gas.density);
  require_positive("viscosity of the gas", gas.viscosity);
  require_positive("gravity", gravity);
  require(grain.density > gas.density, "density of the grains", grain.density,
          "must be above that of the gas");
}

/// Ar = rho (rho_p - rho) g d^3/mu^2, [1].
inline double archimedes(const Grain& grain, const Gas& gas, double gravity) {
  return gas.density * (grain.density - gas.density) * gravity * std::pow(grain.diameter, 3) /
         (gas.viscosity * gas.viscosity);
}

namespace detail {

/// The argument at which a function that rises from below zero is zero, to round-off.
template <class Rising>
double root_of(const Rising& f, double guess) {
  double high = guess;
  while (f(high) < 0.0) high *= 2.0;
  double low = 0.5 * high;
  while (f(low) > 0.0) low *= 0.5;
  for (double middle = 0.5 * (low + high); middle > low && middle < high;
       middle = 0.5 * (low + high))
    (f(middle) < 0.0 ? low : high) = middle;
  return 0.5 * (low + high);
}

}  // namespace detail

/// The superficial speed at which the drag of a closure carries a bed of the void fraction eps,
///
///   beta |u - v|/((1 - eps) eps) = (rho_p - rho) g,   U = eps |u - v|,
///
/// the pressure gradient being the weight (drag/stokes_scaled.h), [length/time]. Of a mixture with
/// the Sauter mean. Throws InvalidParameter as require_lifted(), and unless 0 < eps < 1.
inline double minimum_fluidisation(const drag::Closure& closure, double void_fraction,
                                   const Grain& grain, const Gas& gas, double gravity) {
  require_lifted(grain, gas, gravity);
  require(void_fraction > 0.0 && void_fraction < 1.0, "void fraction", void_fraction,
          "must lie between 0 and 1");
  const drag::DragLaw law(closure);
  const double weight = (grain.density - gas.density) * gravity;
  const double slip = detail::root_of(
      [&](double s) {
        return s *
                   law.per_solid_volume(void_fraction, s, grain.diameter, gas.density,
                                        gas.viscosity) /
                   void_fraction -
               weight;
      },
      1.0);
  return void_fraction * slip;
}

/// That of Wen and Yu for beds of any shape of grain, Re = sqrt(33.7^2 + 0.0408 Ar) - 33.7,
/// [length/time]: C. Y. Wen, Y. H. Yu, AIChE J. 12 (1966) 610. Scatter of their data: 34 %.
inline double wen_yu_minimum_fluidisation(const Grain& grain, const Gas& gas, double gravity) {
  require_lifted(grain, gas, gravity);
  const double reynolds = std::sqrt(33.7 * 33.7 + 0.0408 * archimedes(grain, gas, gravity)) - 33.7;
  return reynolds * gas.viscosity / (gas.density * grain.diameter);
}

/// The speed at which a single sphere falls, with Schiller and Naumann's drag, [length/time].
inline double terminal_speed(const Grain& grain, const Gas& gas, double gravity) {
  require_lifted(grain, gas, gravity);
  const double weight =
      sphere_volume(0.5 * grain.diameter) * (grain.density - gas.density) * gravity;
  return detail::root_of(
      [&](double v) {
        const double reynolds = gas.density * v * grain.diameter / gas.viscosity;
        return 3.0 * pi * gas.viscosity * grain.diameter * v * drag::schiller_naumann(reynolds) -
               weight;
      },
      1.0);
}

}  // namespace cohesion::powder
