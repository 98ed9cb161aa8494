// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string_view>

#include "kinetic_theory/carnahan_starling.h"
#include "kinetic_theory/ma_ahmadi.h"

/// The table of radial functions of equal hard spheres at contact: the one place that knows them
/// all. To add one: its header beside this file and its row.
namespace cohesion::kinetic_theory {

struct RadialFunction {
  std::string_view name;
  double (*contact_value)(double phi);  ///< chi, g_0 of kinetic theories, [1]
  double (*slope)(double phi);          ///< d chi/d phi, [1]
  /// Where chi diverges: above it there is none, and nearly there pressures are as large as numbers
  /// get. Who solves equations with it stops short of that.
  double largest_fraction;
};

inline constexpr std::array radial_functions{
    RadialFunction{CarnahanStarling::name, &CarnahanStarling::contact_value,
                   &CarnahanStarling::slope, CarnahanStarling::largest_fraction},
    RadialFunction{MaAhmadi::name, &MaAhmadi::contact_value, &MaAhmadi::slope,
                   MaAhmadi::largest_fraction},
};

/// Excess compressibility y_ES = p/(n m theta) - 1 of elastic hard spheres at a solid fraction phi
/// where their contact value is `radial`: the virial theorem for hard cores. [1]
inline constexpr double excess_compressibility(double phi, double radial) {
  return 4.0 * phi * radial;
}

/// Of spheres that rebound with a restitution e: collisions hand on (1 + e)/2 of the momentum that
/// elastic ones do, if they are as many.
inline constexpr double excess_compressibility(double phi, double radial, double restitution) {
  return 0.5 * (1.0 + restitution) * excess_compressibility(phi, radial);
}

}  // namespace cohesion::kinetic_theory
