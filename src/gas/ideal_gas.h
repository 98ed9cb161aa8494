// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "validation.h"

namespace cohesion::gas {

/// Of one kilomole [J/(kmol K)]: R of the SI, exact to its digits.
inline constexpr double gas_constant = 8314.46261815324;

/// Ideal gas of one temperature: its density follows its absolute pressure, P = rho R T/M, and it
/// is given by the density rho0 at a reference pressure P0. Particles hold the temperature: their
/// heat capacity per volume is some thousand times that of the gas.
///
/// With the kinematic pressure p = (P - P0)/rho0 its density is rho0 (1 + psi p), psi = M/(R T).
/// Sound travels at 1/sqrt(psi).
class IdealGas {
 public:
  /// Reference pressure P0 [Pa], temperature [K], molar mass [kg/kmol]; throws InvalidParameter
  /// unless all are finite and positive.
  IdealGas(double pressure, double temperature, double molar_mass) {
    require_positive("pressure", pressure);
    require_positive("temperature", temperature);
    require_positive("molWeight", molar_mass);
    psi_ = molar_mass / (gas_constant * temperature);
    density_ = pressure * psi_;
  }

  /// rho0 [kg/m3]
  double density() const { return density_; }

  /// psi [s2/m2]
  double compressibility() const { return psi_; }

  /// Speed of sound at one temperature [m/s]
  double sound_speed() const { return 1.0 / std::sqrt(psi_); }

 private:
  double psi_;
  double density_;
};

}  // namespace cohesion::gas
