// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

namespace cohesion::contact_solver {

/// Overlap x [length] and its rate v [length/time].
struct Overlap {
  double x;
  double v;
};

/// A pair along its normal at the time level n, as engines know it when they compute forces:
/// positions at n, velocities at n - 1/2. Next to a wall `distance` is from the wall.
struct StaggeredMotion {
  double distance;  ///< of the centres, [length]
  double rate;      ///< of the distance, along the normal at n, [length/time]
  double sideways;  ///< speed across the normal, 0 next to a wall, [length/time]

  /// Mean rate of the distance in the last step, of length `step` [time]; the normal turned in it.
  double mean_rate(double step) const { return rate - 0.5 * step * sideways * sideways / distance; }
  /// Whether a pair without a stored state stands at `edge` [length] or nearer without having moved
  /// there in the last step, of length `step` [time].
  bool stands_within(double edge, double step) const {
    return distance <= edge && std::hypot(distance - step * rate, step * sideways) <= edge;
  }
};

/// The same as a persistent contact sees it: how its distance has changed in the last step.
struct DistanceMotion {
  double distance;     ///< [length]
  double inverse;      ///< over the distance, [1/length]
  double rate;         ///< mean over the last step, [length/time]
  double centrifugal;  ///< acceleration of the distance by turning, [length/time^2]

  /// `inverse` [1/length]: over the distance; rate, speed_squared: of the staggered velocity, along
  /// the normal and all of it.
  static DistanceMotion of_pair(double distance, double inverse, double rate, double speed_squared,
                                double step) {
    const double centrifugal = (speed_squared - rate * rate) * inverse;
    return {distance, inverse, rate - 0.5 * step * centrifugal, centrifugal};
  }
};

/// The same of two that touch, as the law of their contact sees it.
struct ContactPoint {
  double overlap;  ///< [length]
  double rate;     ///< of the distance, mean over the last step, [length/time]
};

/// What happened to a pair's normal motion during a step.
struct NormalRecord {
  double contact_time = 0.0;       ///< time in contact, [time]
  double repulsion_impulse = 0.0;  ///< impulse of spring and dashpot, [momentum]; > 0 repels
  double repulsion_at_end = 0.0;   ///< force of both where contact ended last, [force]
  double dissipated = 0.0;         ///< energy lost in the dashpot, [energy]
  bool unresolved = false;         ///< the step ended before its last phase was resolved
};

}  // namespace cohesion::contact_solver
