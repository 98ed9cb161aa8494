// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <limits>

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

/// Size of the gas velocity after a step over that before, [1], between particles that are held,
/// when the gas is solved with particles that follow: what they feel beyond is charged a step late,
/// and from R (x - 2 (1 - exp(-x))) = 2 on the velocity swings and grows.
inline double held_growth(double step, double loading) {
  const double gain = -std::expm1(-step);
  return std::abs(1.0 - loading * (step - gain)) / (1.0 + loading * gain);
}

/// Growth in a step, [1], of what pressure and particles that are free to move can do in form A
/// while the gas's flux stays as it is: the particles take the share 1 - eps of the pressure
/// gradient and hand it to the gas by drag, which the gas is charged with a step late.
///
/// With k = (1 - eps)/eps and, per particle of mass 1, the velocity v, what is pending q, the
/// impulse P that the pressure takes from the particle and the charged coefficient c (x, or g when
/// particles are taken to follow), g = 1 - exp(-x), a step is
///   P' = k (c v - q),  v' = exp(-x) v - g/x P',  q' = v' - v + P' + c v,
/// and this is its spectral radius. It is below 1 for short steps, and goes to k + sqrt(k^2 + k)
/// for stiff ones, k with particles that follow: above 1 where eps is below 3/4, or 1/2.
///
/// step x [1] >= 0, void fraction in (0, 1].
inline double pressure_growth(double step, double void_fraction, bool free) {
  if (step == 0.0) return 1.0;
  const double k = (1.0 - void_fraction) / void_fraction;
  const double gain = -std::expm1(-step);
  const double mean = gain / step;
  const double charged = free ? gain : step;
  const double stays = 1.0 - gain;
  const double half_trace = 0.5 * (stays - mean * k * charged - k * (1.0 - mean));
  const double determinant = -k * ((1.0 - mean) * stays + mean * (charged - gain));
  const double root = half_trace * half_trace - determinant;
  return root < 0.0 ? std::sqrt(determinant) : std::abs(half_trace) + std::sqrt(root);
}

/// The x, [1], up to which pressure_growth() is at most 1; infinite where stiff steps do not grow.
///
/// void fraction in (0, 1].
inline double longest_pressure_step(double void_fraction, bool free) {
  double low = 0.0, high = 1.0;
  // Drag is as stiff as it can be: exp(-x) is lost in 1.
  constexpr double stiff = 1e9;
  // 1 itself is that of no drag at all, and of stiff drag on the limit.
  constexpr double stable = 1.0 + 1e-6;
  while (pressure_growth(high, void_fraction, free) <= stable) {
    if (high > stiff) return std::numeric_limits<double>::infinity();
    low = high;
    high *= 2.0;
  }
  while (high - low > 1e-6 * high) {
    const double middle = 0.5 * (low + high);
    (pressure_growth(middle, void_fraction, free) <= stable ? low : high) = middle;
  }
  return low;
}

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
