// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <string_view>

namespace cohesion::advice {

/// What the units of a script are in those of SI. In all of these force is mass times acceleration.
struct SiUnits {
  std::string_view name;
  double length;  ///< [m]
  double mass;    ///< [kg]
  double time;    ///< [s]

  double density() const { return mass / (length * length * length); }        ///< [kg/m^3]
  double energy() const { return mass * (length / time) * (length / time); }  ///< [J]
};

/// Source: manual of LAMMPS, command units. Those of `lj` stand for any.
inline constexpr std::array si_units{SiUnits{"si", 1.0, 1.0, 1.0}, SiUnits{"cgs", 1e-2, 1e-3, 1.0},
                                     SiUnits{"micro", 1e-6, 1e-15, 1e-6},
                                     SiUnits{"nano", 1e-9, 1e-21, 1e-9}};

/// Null: nothing is known of them.
inline const SiUnits* find_si_units(std::string_view name) {
  const auto* const found =
      std::find_if(si_units.begin(), si_units.end(),
                   [name](const SiUnits& units) { return units.name == name; });
  return found == si_units.end() ? nullptr : found;
}

}  // namespace cohesion::advice
