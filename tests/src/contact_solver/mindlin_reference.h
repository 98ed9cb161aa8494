// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "contact_solver/hertz_reference.h"

/// Oblique impacts with Mindlin's tangential spring, integrated finely from the formulas alone.
namespace cohesion::hertz_reference {

/// K_t over dF/dx, mu_f, and the mass m_t that the tangential force moves.
struct Tangential {
  double ratio, friction, mass;
};

/// The velocity of the surfaces across the line of centres, which stays where it is, after an
/// elastic impact with the speed `along` and this velocity `across` [length/time]. The spring
/// carries the force f = K_t s, at most mu_f F:
///
///   f' = K_t u    where the overlap grows,    s' = u    where it falls
inline double across_after(const Grains& g, const Tangential& t, double along, double across,
                           double per_contact = 40000) {
  const double k = g.coefficient();
  const double dt = g.law().contact_time(along) / per_contact;
  struct State {
    double x, v, f, u;  // while the overlap falls, f is the stretch
  };
  bool grows = true;
  const auto stiffness = [&](double x) { return t.ratio * 1.5 * k * std::sqrt(std::max(x, 0.0)); };
  const auto repulsion = [&](double x) { return k * std::pow(std::max(x, 0.0), 1.5); };
  const auto spring = [&](const State& s) { return grows ? s.f : stiffness(s.x) * s.f; };
  const auto rate = [&](const State& s) {
    const double most = t.friction * repulsion(s.x);
    return State{s.v, -repulsion(s.x) / g.mass, grows ? stiffness(s.x) * s.u : s.u,
                 -std::clamp(spring(s), -most, most) / t.mass};
  };
  const auto sum = [](const State& a, double h, const State& b) {
    return State{a.x + h * b.x, a.v + h * b.v, a.f + h * b.f, a.u + h * b.u};
  };
  State s{0.0, along, 0.0, across};
  for (int n = 0; n < 10.0 * per_contact && (n == 0 || s.x > 0.0); n++) {
    if (grows && s.v < 0.0) {
      s.f /= stiffness(s.x);
      grows = false;
    }
    const State a = rate(s), b = rate(sum(s, 0.5 * dt, a)), c = rate(sum(s, 0.5 * dt, b)),
                d = rate(sum(s, dt, c));
    s = sum(sum(sum(sum(s, dt / 6.0, a), dt / 3.0, b), dt / 3.0, c), dt / 6.0, d);
    const double most = t.friction * repulsion(s.x), force = spring(s);
    if (std::abs(force) > most) s.f *= most / std::abs(force);
  }
  return s.u;
}

}  // namespace cohesion::hertz_reference
