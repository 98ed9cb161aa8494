// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace cohesion::drag {

/// The gas as one particle feels it between two exchanges with the gas solver. Nothing but doubles,
/// in this order: engines keep it as a row of per-particle numbers and move it with the particle.
struct GasOnParticle {
  double drag_coefficient;      ///< b of the drag b (u - v), [force time/length]
  double velocity[3];           ///< u of the gas, [length/time]
  double pressure_gradient[3];  ///< grad p, [force/volume]
  /// Drag impulse, [force time]: the engine adds what the particle feels in each of its steps. Set
  /// to minus what the gas was charged with, it then shows what the gas is yet to be charged with.
  double drag_impulse[3];

  static constexpr int size = 10;
};
static_assert(sizeof(GasOnParticle) == GasOnParticle::size * sizeof(double));

}  // namespace cohesion::drag
