// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace cohesion::liquid {

/// What a particle feels of a liquid beside GasOnParticle (src/drag/gas_on_particle.h), between two
/// exchanges with its solver. Nothing but doubles, in this order, kept by engines likewise, and
/// only where it is used.
struct LiquidOnParticle {
  double added_mass;       ///< C rho V, [mass]
  double drag_per_slip;    ///< q of the drag q |u - v| (u - v), [force time^2/length^2]
  double acceleration[3];  ///< Du/Dt of the liquid, [length/time^2]
  double lift[3];          ///< C_L rho V omega: (u - v) x this is the lift, [force time/length]

  static constexpr int size = 8;
};
static_assert(sizeof(LiquidOnParticle) == LiquidOnParticle::size * sizeof(double));

}  // namespace cohesion::liquid
