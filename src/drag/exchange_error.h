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
/// (1 - exp(-x))/(1 + R x) instead. That is stable for any x and R, and off by the order of R x^2
/// for small x, but late for large ones: by 1/(1 + R) in the first step, and made up in the next x
/// steps. When it is solved with particles that follow (Response, momentum_exchange.h), they gain
/// g/(1 + R g) with g = 1 - exp(-x), which is right for large x, too.
///
/// step x [1] >= 0, loading R [1] >= 0.
inline double exchange_error(double step, double loading, bool free) {
  const double right = -std::expm1(-step * (1.0 + loading)) / (1.0 + loading);
  const double gain = -std::expm1(-step);
  const double found = gain / (1.0 + loading * (free ? gain : step));
  return std::abs(right - found);
}

/// exchange_error() of a step that is longer than m/b, x > 1, else 0: shorter steps are off by
/// their first order, as implicit steps are.
inline double late_exchange_error(double step, double loading, bool free) {
  return step > 1.0 ? exchange_error(step, loading, free) : 0.0;
}

/// The late_exchange_error(), [1], above which a step is worth a warning. Implicit steps of the gas
/// are off by some per cent where they are about as long as it takes to follow the particles;
/// beyond is what does not get better with stiffer drag.
inline constexpr double exchange_error_limit = 0.05;

/// Size of the gas velocity after a step over that before, [1], in a bed of fixed particles when
/// the gas is solved with particles that follow, response free. The rest of the drag on them is
/// charged a step late, and from R (x - 2 (1 - exp(-x))) = 2 on the velocity swings and grows.
inline double fixed_bed_growth(double step, double loading) {
  const double gain = -std::expm1(-step);
  return std::abs(1.0 - loading * (step - gain)) / (1.0 + loading * gain);
}

/// The fixed_bed_growth(), [1], above which the gas velocity grows.
inline constexpr double fixed_bed_growth_limit = 1.0;

/// x of a step: dt over the time m/b in which a particle follows the gas, [1]. coefficient b
/// [force time/length], mass [mass] > 0, dt [time].
inline double exchange_step(double coefficient, double mass, double dt) {
  return coefficient * dt / mass;
}

/// R of particles like this one: their mass over that of the gas between them, [1]. void_fraction
/// in (0, 1]; of the particle mass [mass] and volume [length^3]; of the gas density
/// [mass/length^3].
inline double mass_loading(double void_fraction, double mass, double volume, double gas_density) {
  return (1.0 - void_fraction) * mass / (volume * void_fraction * gas_density);
}

}  // namespace cohesion::drag
