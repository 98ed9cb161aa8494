// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "hard_sphere/impact.h"
#include "hard_sphere/wall_crossing.h"
#include "momentum_flux.h"

namespace cohesion::hard_sphere {

/// Free flight: x(t) = place + (t - since) velocity.
struct FreeFlight {
  Vector3 position;
  Vector3 velocity;
  double start_time = 0.0;  ///< time of its last event, or of the last change by others, [time]

  Vector3 at(double time) const { return position + (time - start_time) * velocity; }
};

/// The flight of a particle. As large as a line of the cache: predictions read many of them.
struct alignas(64) VersionedFlight : FreeFlight {
  std::uint32_t version = 0;  ///< another one after every change
};

/// What events change in a particle besides its flight, and what they count.
struct EventState {
  Vector3 spin;
  double last_collision = -never;  ///< in this step, [time]
  int causal_depth = -1;  ///< EventKey::causal_depth of the event at Flight::since; -1: none
  int collisions = 0;     ///< in the step
  int events = 0;         ///< in the step
  int step = 0;           ///< the number of that step
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

/// The change of velocity, [length/time], by a force in a step of length `dt`.
inline double speed_increment(const Vector3& force, double inverse_mass, double dt) {
  return dt * inverse_mass * norm(force);
}

struct HardSphere {
  double inverse_mass = 0.0;     ///< [1/mass]; 0: nothing moves it
  double inverse_inertia = 0.0;  ///< [1/(mass length^2)]
  double radius = 0.0;           ///< [length]
  double speed_increment =
      0.0;  ///< change of its velocity by other forces in this step, [length/time]
  std::int64_t tag = 0;
  int material = 0;               ///< of the material
  int group_bits = -1;            ///< bits of the groups that it belongs to
  bool remote = false;            ///< another process has it too, and decides on its flight
  bool shared = true;             ///< if not remote: other processes have it too, or may have
  std::uint32_t last_change = 0;  ///< TimeWarp's
  EventState event_state;
};

/// Whether two bodies are the same but for their motion.
inline bool same_properties(const HardSphere& a, const HardSphere& b) {
  return a.tag == b.tag && a.material == b.material && a.group_bits == b.group_bits &&
         a.remote == b.remote && a.radius == b.radius && a.inverse_mass == b.inverse_mass &&
         a.inverse_inertia == b.inverse_inertia;
}

/// A pair, or a particle and a wall, by tags; as in EventKey.
struct TagPair {
  std::int64_t i, j;
  bool operator<(const TagPair& b) const { return i != b.i ? i < b.i : j < b.j; }
};

/// The place of an event in the order: events go by time; of those at the same instant causes come
/// before what they cause; then they go by the lower, then the higher tag; those with a wall by the
/// tag of the body, then by -1 - number of the wall.
struct EventKey {
  double time;
  int causal_depth;  ///< of the chain of events of that instant that led to it
  std::int64_t tag_i;
  std::int64_t tag_j;

  bool operator<(const EventKey& b) const {
    if (time != b.time) return time < b.time;
    if (causal_depth != b.causal_depth) return causal_depth < b.causal_depth;
    return tag_i != b.tag_i ? tag_i < b.tag_i : tag_j < b.tag_j;
  }
};

/// An event that has been executed.
struct Event {
  EventKey key;
  int i;               ///< body with the lower tag
  int j;               ///< body, or -1 - number of the wall
  int image;           ///< of j
  bool elastic;        ///< a collision made elastic by the rule against inelastic collapse
  bool was_inside;     ///< in the well before
  double distance;     ///< of the centres, of a centre and a wall, [length]
  Vector3 separation;  ///< from i to j, [length]
  Vector3 position;    ///< of i, [length]
  ImpactOutcome impact;

  bool with_wall() const { return j < 0; }
  MomentumFlux momentum_flux() const { return cohesion::momentum_flux(separation, impact.impulse); }
};

}  // namespace cohesion::hard_sphere
