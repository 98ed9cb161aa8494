// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>
#include <sstream>
#include <string>
#include <string_view>

#include "gas/compressibility.h"
#include "gas/ideal_gas.h"
#include "gas/sutherland.h"
#include "validation.h"

/// Gases by name, with density and viscosity by pressure and temperature. SI units.
namespace cohesion::gas {

struct NamedGas {
  std::string_view name;
  double molar_mass;  ///< [kg/kmol]
  Sutherland law;
  double hottest;  ///< to which the law has been compared with measured viscosities, [K]
  CriticalPoint critical;
};

/// From which temperature on, [K].
inline constexpr double coldest = 200.0;
/// Largest departure from the ideal gas, [1].
inline constexpr double largest_departure = 0.02;

/// mu0, T0 and S: F. M. White, Viscous fluid flow (2006), table 1-2; of helium Z. Tan, Air
/// pollution and greenhouse gases (2014); of carbon dioxide Crane, Flow of fluids (1988).
/// Molar masses and critical points: the reference equations of state of each gas, as CoolProp
/// lists them.
inline constexpr std::array named_gases{
    NamedGas{"air", 28.96546, {1.716e-5, 273.0, 111.0}, 1000.0, {132.531, 3.786e6}},
    NamedGas{"nitrogen", 28.01348, {1.663e-5, 273.0, 107.0}, 1000.0, {126.192, 3.3958e6}},
    NamedGas{"oxygen", 31.9988, {1.919e-5, 273.0, 139.0}, 1000.0, {154.58, 5.043e6}},
    NamedGas{"argon", 39.948, {2.125e-5, 273.0, 144.0}, 1000.0, {150.69, 4.863e6}},
    NamedGas{"helium", 4.0026, {1.9e-5, 273.0, 79.4}, 600.0, {5.2, 0.2276e6}},
    NamedGas{"hydrogen", 2.01588, {8.411e-6, 273.0, 97.0}, 600.0, {33.15, 1.2964e6}},
    NamedGas{"carbon-dioxide", 44.0098, {1.48e-5, 293.15, 240.0}, 1000.0, {304.13, 7.3773e6}}};

struct DensityAndViscosity {
  double density;    ///< [kg/m3]
  double viscosity;  ///< [Pa s]
};

/// Of an ideal gas with Sutherland's viscosity at an absolute pressure [Pa] and a temperature [K].
/// Throws InvalidParameter where the law has not been compared with measurements, and where the
/// density of the gas is more than 2 % from an ideal one's.
inline DensityAndViscosity density_and_viscosity(const NamedGas& gas, double pressure,
                                                 double temperature) {
  const IdealGas ideal(pressure, temperature, gas.molar_mass);
  const std::string of(gas.name);
  std::ostringstream range;
  range << "must lie between " << coldest << " and " << gas.hottest
        << " K, where the law of the viscosity has been compared with measurements: else give "
           "density and viscosity themselves";
  require(temperature >= coldest && temperature <= gas.hottest, ("temperature of " + of).c_str(),
          temperature, range.str());
  require(std::abs(departure_from_ideal(gas.critical, pressure, temperature)) <= largest_departure,
          ("pressure of " + of).c_str(), pressure,
          "must be lower at this temperature: the density is more than 2 % from that of an ideal "
          "gas; give density and viscosity themselves");
  return {ideal.density(), gas.law.at(temperature)};
}

}  // namespace cohesion::gas
