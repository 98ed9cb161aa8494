// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

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

/// The argument at which a function that rises from below zero is zero, or jumps over it, to
/// round-off: by straight lines through the ends of what encloses it, an end that stays with half
/// its value (the Illinois method; M. Dowell, P. Jarratt, BIT 11 (1971) 168). Some ten values of a
/// smooth function.
template <class Rising>
double root_of(const Rising& f, double guess) {
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  double high = guess, at_high = f(high);
  while (at_high < 0.0) at_high = f(high *= 2.0);
  double low = 0.5 * high, at_low = f(low);
  while (at_low >= 0.0) {
    high = low;
    at_high = at_low;
    at_low = f(low *= 0.5);
  }
  bool low_moved = false, high_moved = false;
  while (high - low > 2.0 * epsilon * high) {
    const double line = low + (high - low) * (at_low / (at_low - at_high));
    const double x = std::clamp(line, low + epsilon * high, high - epsilon * high);
    const double at_x = f(x);
    if (at_x < 0.0) {
      low = x;
      at_low = at_x;
      if (low_moved) at_high *= 0.5;
    } else {
      high = x;
      at_high = at_x;
      if (high_moved) at_low *= 0.5;
    }
    low_moved = at_x < 0.0;
    high_moved = !low_moved;
  }
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
