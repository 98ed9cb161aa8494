// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact_solver/contact_state.h"
#include "contact_solver/discrete_spring.h"

namespace cohesion::contact_solver {

/// The state of a contact of two spheres, or of a sphere and a wall, that an engine stores from one
/// step to the next. Sampled contacts (sampled_contact/sampled_contact.h) use the phases `outside`
/// and `inside`, the force and the springs.
struct ContactHistory {
  using Spring = DiscreteSpring::State;

  ContactState normal{};
  Spring sliding{}, rolling{};

  /// Number of stored values: without friction, with friction, with rolling friction, too.
  static constexpr int normal_only = ContactState::size;
  static constexpr int with_friction = normal_only + 6;
  static constexpr int with_rolling = with_friction + 6;

  static ContactHistory unknown() {
    ContactHistory history;
    history.normal.phase = ContactState::unknown;
    return history;
  }

  /// To be called after ContactState::restore_signs(). An engine that exchanges i and j changes the
  /// sign of all values, which is right for the vectors of the springs.
  static ContactHistory stored(const double* values, int size) {
    const auto spring = [values, size](int first, int least) {
      return size >= least ? Spring{vector(values + first), vector(values + first + 3)} : Spring{};
    };
    return {ContactState::stored(values), spring(normal_only, with_friction),
            spring(with_friction, with_rolling)};
  }
  void store(double* values, int size) const {
    normal.store(values);
    if (size >= with_friction) store(sliding, values + normal_only);
    if (size >= with_rolling) store(rolling, values + with_friction);
  }

  /// The state after a script has moved the particles relative to each other: the contact is in
  /// range or not by its position, and in range it keeps its springs. The velocity offset remains.
  ContactHistory moved(bool into_range) const {
    ContactHistory now;
    if (!normal.is_persistent()) now.normal.velocity_offset = normal.velocity_offset;
    if (into_range) {
      now.normal.phase = ContactState::unknown;
      now.sliding = sliding;
      now.rolling = rolling;
    } else if (now.normal.velocity_offset != 0.0) {
      now.normal.phase = ContactState::left;
    }
    return now;
  }

  [[gnu::always_inline]] static void store(const Spring& spring, double* values) {
    for (const Vector3* const a : {&spring.stretch, &spring.impulse}) {
      *values++ = a->x;
      *values++ = a->y;
      *values++ = a->z;
    }
  }
};

}  // namespace cohesion::contact_solver
