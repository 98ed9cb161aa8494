// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact/law_point.h"
#include "contact_solver/motion_along_normal.h"

namespace cohesion::contact_solver {

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
    unknown,     ///< no state was stored: the contact begins at its present position
    taut,        ///< persistent, with the stiffer spring of a contact under tension
    held         ///< in range of a partner, and nothing could move either of them in the last step
  };
  Phase phase = outside;
  /// True rate of the distance at the time level less the staggered one and half a step of the
  /// external acceleration, after a resolved step; in a persistent contact the true rate at the
  /// last time level, where its law needs it, [length/time].
  double velocity_offset = 0.0;
  double last_rate = 0.0;        ///< mean_rate() at the last time level, [length/time]
  double force = 0.0;            ///< of the last step, away from the partner, [force]
  double force_before = 0.0;     ///< of the step before the last, [force]
  double external_before = 0.0;  ///< external acceleration then, [length/time^2]
  double account = 0.0;          ///< energy_account.h, [energy]
  double contact_time = 0.0;     ///< how long the last step was contact, [time]

  /// Numbers that store() writes, in restart files, too; the phase by its number.
  static constexpr int size = 8;
  void store(double* values) const {
    values[0] = phase;
    store_persistent(values);
    values[7] = contact_time;
  }
  /// The same of a contact whose stored phase is persistent already.
  [[gnu::always_inline]] void store_persistent(double* values) const {
    values[1] = velocity_offset;
    values[2] = last_rate;
    values[3] = force;
    values[4] = force_before;
    values[5] = external_before;
    values[6] = account;
  }
  /// Stores the force alone, where a sampled contact keeps nothing else of its normal motion.
  static void store_force(double force, double* values) { values[3] = force; }
  /// As stored(), of a contact whose stored phase is persistent.
  [[gnu::always_inline]] static ContactState stored_persistent(const double* values) {
    return {persistent, values[1], values[2], values[3],
            values[4],  values[5], values[6], values[7]};
  }
  /// Whether stored values are those of a pair in range without contact, with nothing pending of
  /// the last two steps.
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
  /// Restores the signs of stored values. An engine that exchanges the partners changes all signs,
  /// that of the phase, too.
  [[gnu::always_inline]] static void restore_signs(double* values) {
    if (!(values[0] < 0.0)) return;
    for (int k = 0; k < size; k++) values[k] = -values[k];
  }

  bool in_range() const { return !is_outside() && phase != left && phase != settling; }
  /// Whether the pair is out of range, or has no stored state, with nothing pending.
  bool is_outside() const { return phase == outside || phase == unknown; }
  /// Whether what moves the contact is to be seen from its position alone, where it is in range.
  bool is_new() const { return phase == unknown || phase == held; }
  /// After a step in which nothing could move either of the two.
  ContactState hold() const {
    if (phase == unknown) return *this;
    return {in_range() ? held : outside};
  }
  /// Whether the pair was in contact throughout the last step.
  bool in_contact() const { return is_persistent() || phase == touching; }
  bool is_persistent() const { return phase == persistent || phase == taut; }
  /// Whether position and staggered velocity are the whole state.
  bool has_nothing_pending() const { return is_outside() || phase == inside || phase == held; }
};

/// Result of a step of a persistent contact.
struct PersistentStep {
  double force;             ///< away from the partner, [force]
  double repulsion;         ///< the part of spring and dashpot, [force]
  double account;           ///< change of its energy account without exchanged(), [energy]
  double dissipated = 0.0;  ///< by the dashpot since the last time level, [energy]
  double exchanged = 0.0;   ///< EnergyAccount::exchanged(), [energy]
  bool taut = false;        ///< ContactState::taut
  /// True rate of the distance, where the law's account needs it, [length/time].
  double true_rate = 0.0;
  /// Of a law without a closed form: its point at this overlap, and its radius_stiffness at the
  /// last time level, below 0 if unknown.
  contact::LawPoint at{};
  double radius_stiffness_before = -1.0;
};

/// Result of any step of a contact.
struct ContactStep {
  double force = 0.0;      ///< away from the partner, mean over the step, [force]
  double repulsion = 0.0;  ///< the part of spring and dashpot, [force]
  /// Dissipation of a resolved step, as far as it is known before the next time level, [energy].
  double dissipated = 0.0;
  NormalRecord record{};
};

}  // namespace cohesion::contact_solver
