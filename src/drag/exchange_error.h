// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

namespace cohesion::drag {

/// How far the particles' velocity is off after one exchange with the gas, as a share of the slip
/// at its start [1], when nothing but drag acts.
///
/// Gas and free particles with the drag coefficient b per particle come to the same velocity. With
/// x = b dt/m for the step dt of the exchange and R the mass of the particles over that of the gas,
/// the particles gain the share (1 - exp(-x (1 + R)))/(1 + R) of the slip in a step. When the gas
/// is solved with the drag of the particles' velocity at the start, they gain
/// (1 - exp(-x))/(1 + R x) instead. That is stable for any x and R, and off by the order of R x^2 for small x, but late
/// for large ones: by 1/(1 + R) in the first step, and made up in the next x steps.
///
/// step x [1] >= 0, loading R [1] >= 0.
inline double exchange_error(double step, double loading) {
  const double right = -std::expm1(-step * (1.0 + loading)) / (1.0 + loading);
  const double found = -std::expm1(-step) / (1.0 + loading * step);
  return std::abs(right - found);
}

}  // namespace cohesion::drag
