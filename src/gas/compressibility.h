// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

namespace cohesion::gas {

/// Where a gas condenses at most.
struct CriticalPoint {
  double temperature;  ///< Tc, [K]
  double pressure;     ///< Pc, [Pa]
};

/// How far a gas is from an ideal one, P/(rho R T/M) - 1, [1], at a moderate pressure, of simple
/// molecules:
///
///   Z - 1 = (P/Pc) (Tc/T) (0.083 - 0.422 (Tc/T)^1.6)
///
/// It is good for judging whether a gas is ideal, not for its density. Source: M. M. Abbott's
/// correlation of the second virial coefficient with the acentric factor 0; J. M. Smith,
/// H. C. Van Ness, M. M. Abbott, Introduction to chemical engineering thermodynamics, ch. 3.
inline double departure_from_ideal(const CriticalPoint& c, double pressure, double temperature) {
  const double cold = c.temperature / temperature;
  return pressure / c.pressure * cold * (0.083 - 0.422 * std::pow(cold, 1.6));
}

}  // namespace cohesion::gas
