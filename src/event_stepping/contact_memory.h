// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "event_stepping/spring_on_grid.h"
#include "vector3.h"

namespace cohesion::event_stepping {

/// What TwoPassContact and SampledContact store of a contact from one time level to the next. In
/// one pass it is ContactState (contact_solver/contact_state.h), whose phases are others.
struct ContactMemory {
  /// `beyond`: out of range, known by the grid. `inside`, `left`: in range or out of it after a
  /// step that was followed. `lasting`: in contact after a step of one force, known by the grid;
  /// `leaving`: so far, and to be followed from this grid point.
  enum Phase { beyond, inside, lasting, left, leaving };
  Phase phase = beyond;
  /// Steps since anything but lasting contact happened to it; -1: what went before is not known.
  double age = 0.0;
  /// After a followed step: true radial velocity over the grid's, [length/time]. After one of one
  /// force: the sum of the Slips of that grid point.
  double ahead = 0.0;
  enum Slips { none = 0, in_sliding = 1, in_rolling = 2 };
  using Spring = SpringOnGrid::Memory;
  Spring sliding{}, rolling{};

  /// Of a pair that is first seen in range.
  static ContactMemory seen_inside() { return {inside, -1.0, 0.0, {}, {}}; }
  /// Of a pair that something else than its motion has brought into range, or out of it. What its
  /// last step owes the grid stays.
  ContactMemory moved(bool into_range) const {
    if (phase != inside && phase != left) return into_range ? seen_inside() : ContactMemory();
    ContactMemory now = *this;
    now.phase = into_range ? inside : left;
    return now;
  }
  bool in_range() const { return phase == inside || lasted(); }
  /// Through a step of one force: springs and impulses are of this grid point after
  /// OneForce::advance_lasting().
  bool lasted() const { return phase == lasting || phase == leaving; }

  /// Whether anything but lasting contact happened to it in the step before, or nothing yet.
  bool had_event() const { return age == 0.0; }

  /// Whether a slider slipped at the last grid point of a lasting contact.
  bool slipped(Slips which) const {
    return lasted() && (static_cast<int>(std::abs(ahead)) & which) != 0;
  }

  /// Numbers that an engine keeps: without friction, with it, and with rolling friction.
  enum Size { normal_only = 3, with_friction = 9, with_rolling = 15 };

  static ContactMemory from(const double* values, int size) {
    ContactMemory m = as_stored(values, size);
    if (values[0] >= 0.0) return m;
    // An engine that exchanges i and j changes the sign of all numbers.
    m.phase = static_cast<Phase>(static_cast<int>(-values[0]));
    m.age = -m.age;
    m.ahead = -m.ahead;
    return m;
  }
  /// The same where i and j have not been exchanged since to().
  [[gnu::always_inline]] static ContactMemory as_stored(const double* values, int size) {
    const auto spring = [values, size](int first, Size least) {
      return size >= least ? Spring{vector(values + first), vector(values + first + 3)} : Spring{};
    };
    return {static_cast<Phase>(static_cast<int>(values[0])), values[1], values[2],
            spring(3, with_friction), spring(9, with_rolling)};
  }
  [[gnu::always_inline]] void to(double* values, int size) const {
    values[0] = phase;
    values[1] = age;
    values[2] = ahead;
    if (size >= with_friction) put(sliding, values + 3);
    if (size >= with_rolling) put(rolling, values + 9);
  }

 private:
  static void put(const Spring& spring, double* values) {
    put(spring.stretch, values);
    put(spring.impulse, values + 3);
  }
  static void put(const Vector3& a, double* values) {
    values[0] = a.x;
    values[1] = a.y;
    values[2] = a.z;
  }
};

}  // namespace cohesion::event_stepping
