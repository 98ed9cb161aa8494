// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "constants.h"
#include "contact/adhesion.h"
#include "contact/hertz_spring_dashpot.h"

/// Impacts on a Hertz contact, integrated finely from the formulas alone.
namespace cohesion::hertz_reference {

/// E* [force/length^2], R* [length], restitution, mu [mass].
struct Grains {
  double modulus, radius, restitution, mass;

  contact::HertzSpringDashpot law() const {
    return contact::HertzSpringDashpot::from_restitution(modulus, radius, restitution, mass);
  }
  double coefficient() const { return 4.0 / 3.0 * modulus * std::sqrt(radius); }
  double damping() const {
    const double lost = -std::log(restitution);
    return std::sqrt(5.0 * mass * coefficient()) * lost / std::hypot(pi, lost);
  }
};

/// The speed at which two part that touch at `speed`, under a constant attraction [force]; 0: they
/// do not. `time` [time]: how long they touched. In u = x^(1/4) the law is smooth where contact
/// begins: x = u^4, and t' = 4 u^3/v along the way would be singular where they turn, so that steps
/// of time are taken that grow with the overlap.
struct Impact {
  double speed, time;
};
inline Impact impact(const Grains& g, double attraction, double speed, double per_contact = 20000) {
  const double k = g.coefficient(), c = g.damping(), mu = g.mass;
  const double whole = 2.943275 * std::pow(1.25 * mu / k, 0.4) * std::pow(speed, -0.2);
  const auto accelerate = [&](double x, double v) {
    const double root = std::sqrt(std::max(x, 0.0));
    return (attraction - k * root * x - c * std::sqrt(root) * v) / mu;
  };
  double x = 0.0, v = speed, t = 0.0;
  for (long n = 0; t < 100.0 * whole; n++) {
    const double h =
        std::max(std::min(whole / per_contact, 0.01 * x / std::abs(v)), 1e-4 * whole / per_contact);
    const double x1 = v, v1 = accelerate(x, v);
    const double x2 = v + 0.5 * h * v1, v2 = accelerate(x + 0.5 * h * x1, x2);
    const double x3 = v + 0.5 * h * v2, v3 = accelerate(x + 0.5 * h * x2, x3);
    const double x4 = v + h * v3, v4 = accelerate(x + h * x3, x4);
    const double next = x + h / 6.0 * (x1 + 2.0 * x2 + 2.0 * x3 + x4);
    const double rate = v + h / 6.0 * (v1 + 2.0 * v2 + 2.0 * v3 + v4);
    t += h;
    if (next <= 0.0) return {-(v + (rate - v) * x / (x - next)), t - h * next / (next - x)};
    if (v < 0.0 && rate >= 0.0) return {0.0, t};
    x = next;
    v = rate;
  }
  return {0.0, t};
}

/// The speed far away above which a pair escapes an adhesion, [length/time].
inline double escape_velocity(const Grains& g, const contact::Adhesion& adhesion) {
  const double well = 2.0 * adhesion.well_energy() / g.mass;
  double low = 0.0, high = 1.0;
  const auto escapes = [&](double speed) {
    const double out = impact(g, adhesion.force, std::sqrt(speed * speed + well)).speed;
    return out * out > well;
  };
  while (!escapes(high)) high *= 2.0;
  while (high - low > 1e-7 * high) {
    const double middle = 0.5 * (low + high);
    (escapes(middle) ? high : low) = middle;
  }
  return high;
}

}  // namespace cohesion::hertz_reference
