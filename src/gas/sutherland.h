// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

namespace cohesion::gas {

/// Sutherland's law for the viscosity of a thin gas,
///
///   mu = mu0 (T/T0)^(3/2) (T0 + S)/(T + S)
///
/// mu0 at T0. It tends to T^(3/2) for T << S and to sqrt(T) for T >> S, and does not depend on the
/// pressure. Source: W. Sutherland, Phil. Mag. 36 (1893) 507; F. M. White, Viscous fluid flow
/// (2006), ch. 1.
struct Sutherland {
  double viscosity;    ///< mu0, [Pa s]
  double temperature;  ///< T0, [K]
  double constant;     ///< S, [K]

  /// mu at a temperature [K], [Pa s].
  double at(double kelvin) const {
    const double ratio = kelvin / temperature;
    return viscosity * ratio * std::sqrt(ratio) * (temperature + constant) / (kelvin + constant);
  }
};

}  // namespace cohesion::gas
