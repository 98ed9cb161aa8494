// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "contact_solver/normal_motion.h"

namespace cohesion::contact_solver {

/// A pair along its normal at the time level n, as engines know it when they compute forces:
/// positions at n, velocities at n - 1/2. Next to a wall `distance` is from the wall.
struct StaggeredMotion {
  double distance;  ///< of the centres, [length]
  double rate;      ///< of the distance, along the normal at n, [length/time]
  double sideways;  ///< speed across the normal, 0 next to a wall, [length/time]

  /// Mean rate of the distance in the last step, of length `step` [time]; the normal turned in it.
  double mean_rate(double step) const { return rate - 0.5 * step * sideways * sideways / distance; }
  /// Whether a pair without a stored state stands nearer than `edge` [length] without having moved
  /// there in the last step, of length `step` [time].
  bool stands_within(double edge, double step) const {
    return distance < edge && std::hypot(distance - step * rate, step * sideways) < edge;
  }
};

/// The same as a persistent contact sees it: how its distance has changed in the last step.
struct DistanceMotion {
  double distance;     ///< [length]
  double rate;         ///< mean over the last step, [length/time]
  double centrifugal;  ///< acceleration of the distance by turning, [length/time^2]

  /// `inverse` [1/length]: over the distance; rate, speed_squared: of the staggered velocity, along
  /// the normal and all of it.
  static DistanceMotion of_pair(double distance, double inverse, double rate, double speed_squared,
                                double step) {
    const double centrifugal = (speed_squared - rate * rate) * inverse;
    return {distance, rate - 0.5 * step * centrifugal, centrifugal};
  }
};

/// What ContactSolver stores of a contact from one time level to the next.
struct ContactState {
  enum Phase {
    outside,     ///< out of range, nothing pending
    persistent,  ///< in contact throughout the last step, by the discrete force
    entered,     ///< in range after a step with an event
    left,        ///< out of range after a step with an event
    inside,      ///< in range without contact, nothing pending but in the account
    touching,    ///< in contact throughout the last step, which was resolved
    settling,    ///< out of range, the energy account is not closed
    unknown      ///< no state was stored: the contact is seen for the first time where it stands
  };
  Phase phase = outside;
  /// True rate of the distance at the time level less the staggered one and half a step of the
  /// external acceleration, after a resolved step, [length/time].
  double velocity_offset = 0.0;
  double last_rate = 0.0;        ///< mean_rate() at the last time level, [length/time]
  double force = 0.0;            ///< of the last step, away from the partner, [force]
  double force_before = 0.0;     ///< of the step before the last, [force]
  double external_before = 0.0;  ///< external acceleration then, [length/time^2]
  double account = 0.0;          ///< energy_account.h, [energy]
  double contact_time = 0.0;     ///< how long the last step was contact, [time]

  /// Values that store() writes. Restart files have them, the phase by its number.
  static constexpr int size = 8;
  void store(double* values) const {
    values[0] = phase;
    values[1] = velocity_offset;
    values[2] = last_rate;
    values[3] = force;
    values[4] = force_before;
    values[5] = external_before;
    values[6] = account;
    values[7] = contact_time;
  }
  /// store() of a contact that was persistent in the last step, too.
  [[gnu::always_inline]] void store_persistent(double* values) const {
    values[2] = last_rate;
    values[3] = force;
    values[4] = force_before;
    values[5] = external_before;
    values[6] = account;
  }
  /// Of stored values: in range without contact, and nothing pending of the last two steps.
  static bool is_idle(const double* values) {
    return values[0] == inside && values[3] == 0.0 && values[4] == 0.0;
  }
  static Phase phase_of(const double* values) {
    return static_cast<Phase>(static_cast<int>(values[0]));
  }
  static ContactState stored(const double* values) {
    return {phase_of(values), values[1], values[2], values[3],
            values[4],        values[5], values[6], values[7]};
  }
  /// Restores the signs of stored values where an engine that exchanges the partners has changed
  /// them, which a phase below 0 says.
  [[gnu::always_inline]] static void restore_signs(double* values) {
    if (!(values[0] < 0.0)) return;
    for (int k = 0; k < size; k++) values[k] = -values[k];
  }

  bool in_range() const { return !is_outside() && phase != left && phase != settling; }
  /// Out of range as far as is known, with nothing pending.
  bool is_outside() const { return phase == outside || phase == unknown; }
  /// Whether it was in contact throughout the last step.
  bool in_contact() const { return phase == persistent || phase == touching; }
  /// Whether position and staggered velocity say all about it.
  bool has_nothing_pending() const { return is_outside() || phase == inside; }
};

/// What a contact does from one time level to the next.
struct ContactStep {
  double force = 0.0;      ///< away from the partner, mean over the step, [force]
  double repulsion = 0.0;  ///< the part of spring and dashpot, [force]
  /// In a resolved step, as far as it is known before the next time level, [energy].
  double dissipated = 0.0;
  NormalRecord normal{};
};

}  // namespace cohesion::contact_solver
