// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "drag/momentum_exchange.h"

namespace cohesion::drag {

/// Waves of free particles in a gas step: what they displace moves the gas, drag moves the
/// particles with it, and in form A the pressure that it takes to move the gas against them moves
/// them, too.
///
/// Of a wave that all cells see, gas whose own inertia and viscosity are little beside the drag,
/// and per particle of mass 1 and volume 1 in a step 1, so that b is x and n = 1 - eps: with the
/// gas velocity u, the velocity h of the particles at the start of a step, their mean velocity d in
/// it, and g = grad p/x, a gas step with S steps of the particles is (momentum_exchange.h)
///   u' = -(n/eps) d
///   eps x g = -n (c (u - h) + Q + (1 - phi) x (g - r g_last))
///   d = V + m (h - V),  h' = V + E (h - V),  V = u - g
///   Q' = h' - h + x g - c (u - h) - (1 - phi) x (g - r g_last)
/// with E = exp(-x), m = (1 - E)/(S (1 - exp(-x/S))), phi = (1 - E)/x, Q what is deferred; c = x
/// and r = 1 with particles taken to keep their velocity, c = x phi and r = 0 with those taken to
/// follow. Here h is that of leapfrog, half a step of the particles ahead; with many of
/// them in a gas step that is nothing.
///
/// Where the gas's flux stays, u = 0, stiff drag leaves nothing. Held particles, h = d = V = 0 and
/// x g in the last equation not there, have (eps + a) L^2 - (1 + r) a L + r a = 0 for the factor L
/// of a step, a = n (1 - phi): sqrt(a/(eps + a)) or a/(eps + a) in size, below 1 always. Without
/// 1 - phi in the charges free particles have k + sqrt(k^2 + k), k = n/eps, or k, when drag is
/// stiff.
///
/// The particles displace gas a step late: with stiff drag and five steps of the particles or more,
/// L is below -1 where (n/eps) (1 + 4 r n) (1 - 2/S) > 1. With few steps a pair of L may leave the
/// unit circle at larger eps, with drag that is not stiff, too.
///
/// In form B g = 0, and nothing goes with what the gas is charged with. L is below -1 where
/// (n/eps) (1 + E - 2 m) > 1 + E, with either response. A pair of L is outside of the unit circle
/// where (n/eps) (m - E) > 1.
struct PressureStep {
  double step;           ///< x = b dt/m [1] > 0
  double void_fraction;  ///< eps [1], in (0, 1]
  double engine_steps;   ///< S [1] >= 1
  bool free;             ///< whether the gas step takes particles to follow (Response)
  bool felt = true;      ///< whether particles feel the gas's pressure gradient, form A
};

/// h, d, g and Q/x of a wave
using PressureWave = std::array<double, 4>;

/// The wave after a step.
inline PressureWave advanced(const PressureStep& step, const PressureWave& wave) {
  const auto [h, displaced, last, deferred] = wave;
  const double x = step.step, eps = step.void_fraction, n = 1.0 - eps;
  const double gain = -std::expm1(-x);
  const double sampled = gain / (step.engine_steps * -std::expm1(-x / step.engine_steps));
  const double coefficient = step.free ? gain / x : 1.0;
  const double transmitted = transmitted_volume(x, 1.0, 1.0, 1.0);
  const double before = step.free ? 0.0 : transmitted * last;

  const double u = -n / eps * displaced;
  const double by_slip = coefficient * (u - h);
  const double g = step.felt ? -n * (by_slip + deferred - before) / (eps + n * transmitted) : 0.0;
  const double slip = h - (u - g);
  const double felt = g - gain / x * slip;
  return {h - gain * slip, u - g + sampled * slip, g, felt - by_slip - transmitted * g + before};
}

/// Growth in a step, [1], of the wave that grows fastest, to 1e-6: the spectral radius of a step,
/// by squares of it (I. Gelfand, 1941).
inline double pressure_growth(const PressureStep& step) {
  using Matrix = std::array<PressureWave, 4>;
  // Row by row what a step makes of each of the four: transposed, with the same radius.
  Matrix power{};
  for (std::size_t i = 0; i < 4; i++) {
    PressureWave one{};
    one[i] = 1.0;
    power[i] = advanced(step, one);
  }
  // The size of the power 2^k is that of the radius to 2^k, but for some 2^k at most.
  constexpr int squares = 26;
  double log_radius = 0.0, share = 1.0;
  for (int k = 0; k <= squares; k++) {
    double size = 0.0;
    for (const auto& row : power)
      for (const double value : row) size = std::max(size, std::abs(value));
    if (size == 0.0) return 0.0;
    log_radius += share * std::log(size);
    share *= 0.5;
    for (auto& row : power)
      for (double& value : row) value = std::abs(value) > 1e-150 * size ? value / size : 0.0;
    Matrix square{};
    for (std::size_t i = 0; i < 4; i++)
      for (std::size_t j = 0; j < 4; j++)
        for (std::size_t l = 0; l < 4; l++) square[i][j] += power[i][l] * power[l][j];
    power = square;
  }
  return std::exp(log_radius);
}

/// A growth, [1], above 1 by more than what is left of it in rounding.
inline constexpr double pressure_grows = 1.0 + 1e-5;

inline bool pressure_waves_grow(const PressureStep& step) {
  return pressure_growth(step) > pressure_grows;
}

/// The longest x, [1] to 1e-3 of it, up to which nothing grows with as many steps of the particles;
/// that of `step` itself when nothing grows up to it.
inline double longest_pressure_step(const PressureStep& step) {
  const auto grows = [&step](double x) {
    return pressure_waves_grow({x, step.void_fraction, step.engine_steps, step.free, step.felt});
  };
  // With few steps of the particles waves may grow at an x of some units and not with stiffer drag.
  const double stiff = 100.0 * step.engine_steps;
  double low = 0.0, high = std::min(step.step, 1e-3);
  while (!grows(high)) {
    if (high >= step.step) return step.step;
    low = high;
    high = std::min(step.step, (high < stiff ? 1.1 : 10.0) * high);
  }
  // Steps much shorter than any of use would not be found, but for void fractions near 0.
  constexpr double shortest = 1e-9;
  while (high > shortest && high - low > 1e-3 * high) {
    const double middle = 0.5 * (low + high);
    (grows(middle) ? high : low) = middle;
  }
  return low;
}

/// longest_pressure_step() for many particles of one gas step: worked out once for each hundredth
/// of the void fraction, of its lower end, where it is shorter.
class PressureLimits {
 public:
  PressureLimits(double engine_steps, bool free, bool felt)
      : engine_steps_(engine_steps), free_(free), felt_(felt) {}

  double engine_steps() const { return engine_steps_; }

  /// [1]; 1e9, of drag as stiff as any, where nothing grows. void fraction in (0, 1].
  double longest(double void_fraction) {
    constexpr double stiff = 1e9;
    const auto part = static_cast<std::size_t>(void_fraction * parts);
    double& known = known_[part];
    if (known == 0.0)
      known = longest_pressure_step(
          {stiff, std::max<double>(part, 0.5) / parts, engine_steps_, free_, felt_});
    return known;
  }

 private:
  static constexpr int parts = 100;
  double engine_steps_;
  bool free_, felt_;
  std::array<double, parts + 1> known_{};
};

}  // namespace cohesion::drag
