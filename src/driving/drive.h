// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>

#include "vector3.h"

/// What keeps a gas of grains in motion that its collisions take away: the velocities of all are
/// changed at once, so that the granular temperature
///
///   theta = sum m v'.v' / (d sum m),   v' = v - sum m v / sum m
///
/// is what it should be and the momentum stays what it is.
///
///   rescaled:  v' <- s v',         s = sqrt(T/theta)
///   kicked:    v' <- v' + b w',    b = sqrt((T - theta)/(sum m w'.w' / (d sum m)))
///
/// w: random numbers of the variance 1 for each particle, w' what is left of them without their
/// mean and without what they have of v': w' = w - <w> - v' sum m w.v' / sum m v'.v'. So kicks add
/// energy and take none, as white noise does in the mean, and theta is T when they have acted.
/// Where theta is above T, or below it by rounding alone, there are no kicks: noise heats, and b
/// would make a root of rounding, 1e-8 of the speeds, that no two orders of adding up share.
///
/// Symbols: m mass, v velocity [length/time], beyond the mean flow of a sheared box; T the
/// temperature that is asked for [length^2/time^2]; d 2 or 3 dimensions.
///
/// Source: D. R. M. Williams, F. C. MacKintosh, Phys. Rev. E 54 (1996) R9 (random kicks); as M. A.
/// van der Hoef et al., Adv. Chem. Eng. 31 (2006) 65 drive theirs, by both.
namespace cohesion::driving {

/// Sums over particles, to be added over processes: plain numbers.
struct Sums {
  enum { mass, momentum, energy = momentum + 3, kick, kick_energy = kick + 3, common, count };
  using Values = std::array<double, count>;

  /// What a particle adds; `w` zero where nothing is kicked.
  static Values of(double m, const Vector3& v, const Vector3& w) {
    return {m,       m * v.x, m * v.y, m * v.z,       m * dot(v, v),
            m * w.x, m * w.y, m * w.z, m * dot(w, w), m * dot(w, v)};
  }
};

/// What is done to every particle.
struct VelocityChange {
  double temperature = 0.0;  ///< theta before, [length^2/time^2]
  double energy = 0.0;       ///< kinetic energy that all together get, [mass length^2/time^2]
  Vector3 mean;              ///< velocity, [length/time]
  Vector3 mean_kick;         ///< [1]
  double along = 0.0;        ///< what w has of v', [time/length]
  double scale = 0.0;        ///< s - 1
  double strength = 0.0;     ///< b, [length/time]

  /// The change of the velocity of a particle, [length/time].
  Vector3 change(const Vector3& v, const Vector3& w) const {
    const Vector3 own = v - mean;
    return (scale - strength * along) * own + strength * (w - mean_kick);
  }
};

namespace detail {

constexpr double rounding = 1e-12;  // of sums over many particles, relative

inline Vector3 mean_of(const Sums::Values& sums, int first) {
  return 1.0 / sums[Sums::mass] * vector(&sums[first]);
}

/// theta and mean velocity.
inline VelocityChange measured(const Sums::Values& sums, int dimensions) {
  VelocityChange action;
  if (!(sums[Sums::mass] > 0.0)) return action;
  action.mean = mean_of(sums, Sums::momentum);
  const double squares = sums[Sums::energy] / sums[Sums::mass] - dot(action.mean, action.mean);
  action.temperature = squares > 0.0 ? squares / dimensions : 0.0;
  return action;
}

inline double energy_between(const Sums::Values& sums, int dimensions, double from, double to) {
  return 0.5 * dimensions * sums[Sums::mass] * (to - from);
}

}  // namespace detail

/// theta of these sums, [length^2/time^2]; 0 without particles.
inline double temperature_of(const Sums::Values& sums, int dimensions) {
  return detail::measured(sums, dimensions).temperature;
}

/// Scales the motion of all to the temperature T > 0; particles that have none keep that.
inline VelocityChange rescaled(const Sums::Values& sums, double T, int dimensions) {
  VelocityChange action = detail::measured(sums, dimensions);
  if (action.temperature == 0.0) return action;
  action.scale = std::sqrt(T / action.temperature) - 1.0;
  action.energy = detail::energy_between(sums, dimensions, action.temperature, T);
  return action;
}

/// Kicks all up to the temperature T > 0. Nothing where theta is there or above, or with fewer than
/// two particles.
inline VelocityChange kicked(const Sums::Values& sums, double T, int dimensions) {
  VelocityChange action = detail::measured(sums, dimensions);
  const double known_to = detail::rounding * (T + dot(action.mean, action.mean));
  if (!(T - action.temperature > known_to) || sums[Sums::mass] == 0.0) return action;
  action.mean_kick = detail::mean_of(sums, Sums::kick);
  const double common = sums[Sums::common] / sums[Sums::mass] - dot(action.mean, action.mean_kick);
  const double spread =
      sums[Sums::kick_energy] / sums[Sums::mass] - dot(action.mean_kick, action.mean_kick);
  const double squares = dimensions * action.temperature;
  if (squares > 0.0) action.along = common / squares;
  const double free = spread - action.along * common;  // sum m w'.w' / sum m
  if (!(free > detail::rounding * spread)) {
    action.along = 0.0;
    return action;
  }
  action.strength = std::sqrt(dimensions * (T - action.temperature) / free);
  action.energy = detail::energy_between(sums, dimensions, action.temperature, T);
  return action;
}

}  // namespace cohesion::driving
