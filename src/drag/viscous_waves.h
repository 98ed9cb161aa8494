// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace cohesion::drag {

/// Waves of free particles in a gas step in form A, without drag: what they displace moves the gas,
/// and the pressure that moves the gas moves the particles, a step late. Light particles in gas
/// whose viscosity reaches over cells within a step swing, and grow from step to step.
///
/// In a wave along x of wave number k in cells of size h, with C = cos^2(k h/2), v the mean
/// velocity of the particles in their step and u that of the gas, both of cells, a step is
///   eps u' = -(1 - eps) C v
///   rho_g ((1 + N) u' - (1 - N C/3) u)/dt = -grad p,   N = M (1 - C),   M = 4 nu dt/h^2
///   rho_s (v' - v)/dt = -(w grad p' + (1 - w) grad p),   w = (1 - 1/S)/2
/// C is what cells see of a wave's flux through their faces, twice: the particles' and the gas's.
/// Of the stress 4/3 nu k^2 u the first part is implicit, the other one, over cells apart, is that
/// of the step before. The engine's S steps of velocity Verlet in a gas step move the particles
/// with w of the pressure of this step; its first half kick is that of the one before.
struct ViscousStep {
  double displaced;     ///< kappa = (1 - eps) rho_g/(eps rho_s) [1]
  double viscous;       ///< M, of all directions: nu dt times the largest k^2 of the cell [1]
  double engine_steps;  ///< S >= 1 [1]
};

/// Whether all roots of l^3 + a l^2 + b l + c are below 1 in size: the conditions of Jury (1962).
inline bool roots_within_unit_circle(double a, double b, double c) {
  return std::abs(c) < 1.0 && 1.0 + a + b + c >= 0.0 && 1.0 - a + b - c >= 0.0 &&
         std::abs(b - a * c) < 1.0 - c * c;
}

/// Whether one wave grows by less than `factor` in a step, seen by cells with the share C of [0,
/// 1].
inline bool viscous_wave_below(const ViscousStep& step, double seen, double factor) {
  const double kappa = step.displaced * seen;
  const double w = 0.5 * (1.0 - 1.0 / step.engine_steps);
  const double n = step.viscous * (1.0 - seen);
  const double now = 1.0 + n, before = 1.0 - n * seen / 3.0;
  // l^3 - l^2 + kappa (w l + 1 - w) (now l - before) = 0
  const double a = (kappa * w * now - 1.0) / factor;
  const double b = kappa * ((1.0 - w) * now - w * before) / (factor * factor);
  const double c = -kappa * (1.0 - w) * before / (factor * factor * factor);
  return roots_within_unit_circle(a, b, c);
}

/// Whether no wave grows by more than `factor` > 1 in a step, C in steps of 1/32.
inline bool viscous_waves_below(const ViscousStep& step, double factor) {
  constexpr int shares = 32;
  for (int i = 1; i <= shares; i++)
    if (!viscous_wave_below(step, static_cast<double>(i) / shares, factor)) return false;
  return true;
}

/// A growth, [1], above 1, which is that of a wave that stays as it is.
inline constexpr double viscous_grows = 1.0 + 1e-6;

inline bool viscous_waves_grow(const ViscousStep& step) {
  return !viscous_waves_below(step, viscous_grows);
}

/// Whether the law has something to say of `step`.
inline bool is_finite(const ViscousStep& step) {
  return std::isfinite(step.displaced) && std::isfinite(step.viscous) &&
         std::isfinite(step.engine_steps);
}

/// Growth in a step, [1] to 1e-6, of the wave that grows fastest; 1 where none grows, infinity
/// where it is no number or `step` is not finite.
inline double viscous_growth(const ViscousStep& step) {
  constexpr double resolution = 1e-6;
  constexpr double without_end = std::numeric_limits<double>::infinity();
  constexpr double largest = 1e100;
  if (!is_finite(step)) return without_end;
  double low = 1.0, high = 1.0 + resolution;
  while (!viscous_waves_below(step, high)) {
    if (high > largest) return without_end;
    low = high;
    high *= 2.0;
  }
  while (high - low > resolution * low) {
    const double middle = 0.5 * (low + high);
    (viscous_waves_below(step, middle) ? high : low) = middle;
  }
  return low;
}

/// A gas step that is `share` of this one, with so many of the engine's steps in it.
inline ViscousStep shortened(const ViscousStep& step, double share, double engine_steps) {
  return {step.displaced, step.viscous * share, engine_steps};
}

/// The engine's steps [1] that a gas step must have at least for no wave to grow in it when it is
/// short enough: kappa < 2 S/(S + 1), by the roots without viscosity. Infinity from a kappa of 2
/// on: no gas step does.
inline double engine_steps_needed(double displaced) {
  if (!(displaced < 2.0)) return std::numeric_limits<double>::infinity();
  return std::max(1.0, std::floor(displaced / (2.0 - displaced)) + 1.0);
}

/// Share of a gas step, [1] to 1e-3, up to which nothing grows in one with the same number of the
/// engine's steps, each shortened by it too; 1 when nothing grows, 0 where engine_steps_needed()
/// are more, or `step` is not finite.
inline double longest_viscous_step(const ViscousStep& step) {
  if (!is_finite(step) || step.engine_steps < engine_steps_needed(step.displaced)) return 0.0;
  const auto grows = [&](double share) {
    return viscous_waves_grow(shortened(step, share, step.engine_steps));
  };
  double low = 1.0;
  // Ends: without viscosity nothing grows.
  while (grows(low)) low *= 0.8;
  if (low == 1.0) return low;
  double high = low / 0.8;
  while (high - low > 1e-3 * high) {
    const double middle = 0.5 * (low + high);
    (grows(middle) ? high : low) = middle;
  }
  return low;
}

/// Whether `step` grows surely not, without looking: kappa (2 + M) < 1/2. Then the coefficients of
/// `now` and `before` are at most kappa (1 + M) and kappa (1 + M/12), 0.55 together, and what the
/// last of Jury's conditions holds against 1, their sum, product and the smaller one's square, is
/// below 0.55 + 0.06 + 0.06.
inline bool surely_no_viscous_waves(const ViscousStep& step) {
  return step.displaced * (2.0 + step.viscous) < 0.5;
}

}  // namespace cohesion::drag
