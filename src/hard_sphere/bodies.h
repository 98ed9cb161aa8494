// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "hard_sphere/impact.h"
#include "hard_sphere/wall_crossing.h"
#include "momentum_flux.h"

namespace cohesion::hard_sphere {

/// Free flight of a body: x(t) = position + (t - start_time) velocity.
struct FreeFlight {
  Vector3 position;
  Vector3 velocity;
  double start_time = 0.0;  ///< of the last event, or of the last change by the engine, [time]

  Vector3 at(double time) const { return position + (time - start_time) * velocity; }
};

/// Free flight with a version number, by which predictions find out that it has changed. The size
/// is one cache line, since predictions read the flights of many neighbours.
struct alignas(64) VersionedFlight : FreeFlight {
  std::uint32_t version = 0;  ///< increases with every change
};

/// State that events change besides the flight, and counters for the rules of a step
/// (event_rules.h).
struct EventState {
  Vector3 spin;
  double last_collision = -never;  ///< within this step, [time]
  int causal_depth = -1;           ///< of the event at the start of the flight; -1: none
  int collisions = 0;              ///< within the step
  int events = 0;                  ///< within the step
  int step = 0;                    ///< number of the step that the counters belong to
};

inline bool same(const Vector3& a, const Vector3& b) {
  return a.x == b.x && a.y == b.y && a.z == b.z;
}
inline bool same(const FreeFlight& a, const FreeFlight& b) {
  return same(a.position, b.position) && same(a.velocity, b.velocity) &&
         a.start_time == b.start_time;
}
inline bool same(const EventState& a, const EventState& b) {
  return same(a.spin, b.spin) && a.causal_depth == b.causal_depth && a.step == b.step &&
         a.collisions == b.collisions && a.events == b.events &&
         a.last_collision == b.last_collision;
}

/// Magnitude of the velocity change, [length/time], by a force during a step of length `dt`.
inline double speed_increment(const Vector3& force, double inverse_mass, double dt) {
  return dt * inverse_mass * norm(force);
}

/// A body of the simulation. A hard sphere that is immobile has a flight, too, at constant
/// velocity.
struct HardSphere {
  double inverse_mass = 0.0;     ///< [1/mass]; 0: immobile
  double inverse_inertia = 0.0;  ///< [1/(mass length^2)]
  double radius = 0.0;           ///< [length]
  double speed_increment = 0.0;  ///< velocity change by other forces in this step, [length/time]
  std::int64_t tag = 0;
  int material = 0;     ///< index of its material in PairRules
  int group_bits = -1;  ///< bit mask of the groups that it belongs to
  bool remote = false;  ///< a copy; another process owns the body and decides on its flight
  bool shared = true;   ///< an own body of which other processes have, or may have, a copy
  std::uint32_t last_change = 0;  ///< number of its newest change in StateQueue
  EventState event_state;
};

/// Whether two bodies have the same properties apart from their motion.
inline bool same_properties(const HardSphere& a, const HardSphere& b) {
  return a.tag == b.tag && a.material == b.material && a.group_bits == b.group_bits &&
         a.remote == b.remote && a.radius == b.radius && a.inverse_mass == b.inverse_mass &&
         a.inverse_inertia == b.inverse_inertia;
}

/// Tags of a pair, or of a particle and a wall, in the order of EventKey.
struct TagPair {
  std::int64_t i, j;
  bool operator<(const TagPair& b) const { return i != b.i ? i < b.i : j < b.j; }
};

/// Virtual time of an event, which defines a total order. Events are ordered by time. Of events at
/// the same instant, a cause precedes its effects. Remaining ties are resolved by the lower, then
/// the higher tag of the pair; for a wall by the tag of the body, then by -1 - number of the wall.
struct EventKey {
  double time;
  int causal_depth;  ///< length of the chain of events of this instant that led to the event
  std::int64_t tag_i;
  std::int64_t tag_j;

  bool operator<(const EventKey& b) const {
    if (time != b.time) return time < b.time;
    if (causal_depth != b.causal_depth) return causal_depth < b.causal_depth;
    return tag_i != b.tag_i ? tag_i < b.tag_i : tag_j < b.tag_j;
  }
};

/// An executed event.
struct Event {
  EventKey key;
  int i;               ///< body with the lower tag
  int j;               ///< body, or -1 - number of the wall
  int image;           ///< number of the periodic image of j
  bool elastic;        ///< whether the rules against inelastic collapse made the collision elastic
  bool was_inside;     ///< whether the pair was in its well before the event
  double distance;     ///< between the centres, or between centre and wall, [length]
  Vector3 separation;  ///< from i to j, [length]
  Vector3 position;    ///< of i, [length]
  ImpactOutcome impact;

  bool with_wall() const { return j < 0; }
  MomentumFlux momentum_flux() const { return cohesion::momentum_flux(separation, impact.impulse); }
};

}  // namespace cohesion::hard_sphere
