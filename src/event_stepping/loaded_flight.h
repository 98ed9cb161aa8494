// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "event_stepping/first_root.h"
#include "event_stepping/pair_step.h"
#include "hard_sphere/crossing.h"

/// Flight of a pair that nothing of its own acts on, under a constant load: the acceleration of its
/// separation by all other forces on its two bodies, [length/time^2]. Without one it is straight.
///
/// Source: derived here; without a load hard_sphere/crossing.h.
namespace cohesion::event_stepping {

inline bool is_none(const Vector3& load) { return load.x == 0.0 && load.y == 0.0 && load.z == 0.0; }

/// The pair after the time t.
inline RelativeState flown(const RelativeState& from, const Vector3& load, double t) {
  return {from.separation + t * (from.velocity + (0.5 * t) * load), from.velocity + t * load};
}

namespace detail {

/// Newton's steps towards the time at which the pair has the distance `of`, from a `guess` below
/// `time`; what it begins with moving in, or out, it does there, too.
inline double refined(const RelativeState& from, const Vector3& load, double of, double guess,
                      double time) {
  constexpr int enough = 4;
  double t = guess;
  bool inwards = false;
  for (int k = 0; k < enough; k++) {
    const RelativeState at = flown(from, load, t);
    const double distance = norm(at.separation);
    const double rate = dot(at.separation, at.velocity) / distance;
    if (k == 0) inwards = rate < 0.0;
    if (rate == 0.0 || inwards != (rate < 0.0)) break;
    t = std::clamp(t + (of - distance) / rate, 0.0, time);
  }
  return t;
}

/// Distance, rate and outward acceleration of a pair whose turning counts as constant.
struct Radial {
  double distance, rate, outward;
};
inline Radial radial(const RelativeState& at, const Vector3& load) {
  const double distance = norm(at.separation);
  const double rate = dot(at.separation, at.velocity) / distance;
  const double across = std::max(dot(at.velocity, at.velocity) - rate * rate, 0.0);
  return {distance, rate, (dot(at.separation, load) + across) / distance};
}

}  // namespace detail

/// When the distance has fallen to `to`, [time]; infinity if it does not within `time`. A pair that
/// is nearer and approaches is there now.
inline double time_to_fall_to(double to, const RelativeState& from, const Vector3& load,
                              double time) {
  const double b = dot(from.separation, from.velocity);
  const double beyond = dot(from.separation, from.separation) - to * to;
  if (is_none(load)) return hard_sphere::time_to_fall(b, dot(from.velocity, from.velocity), beyond);
  if (beyond <= 0.0 && (b < 0.0 || (b == 0.0 && dot(from.separation, load) < 0.0))) return 0.0;
  const detail::Radial r = detail::radial(from, load);
  const double guess = first_root(std::max(r.distance - to, 0.0), r.rate, r.outward);
  return guess < time ? detail::refined(from, load, to, guess, time) : hard_sphere::never;
}

/// When the distance has risen to `to` from below, likewise.
inline double time_to_rise_to(double to, const RelativeState& from, const Vector3& load,
                              double time) {
  const double b = dot(from.separation, from.velocity);
  const double beyond = dot(from.separation, from.separation) - to * to;
  if (is_none(load)) return hard_sphere::time_to_rise(b, dot(from.velocity, from.velocity), beyond);
  if (beyond >= 0.0 && (b > 0.0 || (b == 0.0 && dot(from.separation, load) > 0.0))) return 0.0;
  const detail::Radial r = detail::radial(from, load);
  const double guess = first_root(std::max(to - r.distance, 0.0), -r.rate, -r.outward);
  return guess < time ? detail::refined(from, load, to, guess, time) : hard_sphere::never;
}

}  // namespace cohesion::event_stepping
