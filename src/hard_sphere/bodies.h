// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>

#include "hard_sphere/impact.h"
#include "hard_sphere/wall_crossing.h"
#include "momentum_flux.h"

namespace cohesion::hard_sphere {

/// The free flight of a particle: x(t) = end - (dt - t) velocity, t from the start of the step.
/// `end` is where the engine will find it at the end of the step.
struct Flight {
  Vector3 end;
  Vector3 velocity;
  double last_event = 0.0;  ///< time of its last event in this step, [time]
  Vector3 spin;
  int causal_depth = -1;           ///< EventKey::causal_depth of that; -1: none in this step
  int collisions = 0;              ///< in this step
  int events = 0;                  ///< in this step
  double last_collision = -never;  ///< time of its last collision in this step, [time]
  double kick = 0.0;  ///< change of its velocity by other forces in this step, [length/time]

  Vector3 at(double left) const { return end - left * velocity; }
  /// The length of the chain of events at this time that ends with the last event; -1: none.
  int causal_depth_at(double time) const { return time == last_event ? causal_depth : -1; }
};

inline bool same(const Vector3& a, const Vector3& b) {
  return a.x == b.x && a.y == b.y && a.z == b.z;
}
inline bool same(const Flight& a, const Flight& b) {
  return same(a.end, b.end) && same(a.velocity, b.velocity) && same(a.spin, b.spin) &&
         a.last_event == b.last_event && a.causal_depth == b.causal_depth &&
         a.collisions == b.collisions && a.events == b.events &&
         a.last_collision == b.last_collision;
}

/// The change of velocity, [length/time], by a force in a step of length `dt`.
inline double kick_of(const Vector3& force, double inverse_mass, double dt) {
  return dt * inverse_mass * norm(force);
}

struct Body {
  Flight flight;
  double inverse_mass = 0.0;     ///< [1/mass]; 0: nothing moves it
  double inverse_inertia = 0.0;  ///< [1/(mass length^2)]
  double radius = 0.0;           ///< [length]
  std::int64_t tag = 0;

  Partner partner() const {
    return {flight.velocity, flight.spin, inverse_mass, inverse_inertia, radius};
  }
};

/// Periodic image of a particle: what it adds to the position at the end of the step and to the
/// velocity.
struct Image {
  Vector3 displacement;  ///< [length]
  Vector3 velocity;      ///< [length/time]

  Vector3 at(double left) const { return displacement - left * velocity; }
};

/// Two bodies, or a body and a wall, that may meet in this step.
struct CandidatePair {
  int i;      ///< body with the lower tag
  int j;      ///< body, or -1 - number of the wall
  int image;  ///< of j
  int law;    ///< index into the laws of the simulation
  Surfaces surfaces;
  bool inside = false;  ///< in the well
  Surface next_surface = Surface::core;
  unsigned version = 0;  ///< of its prediction

  bool with_wall() const { return j < 0; }
  int wall() const { return -1 - j; }
};

/// The place of an event in the order: events go by time; of those at the same instant causes come
/// before what they cause; then they go by the lower, then the higher tag. A wall counts as tag -1,
/// -2, ...
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
  int candidate;       ///< index of its candidate pair
  bool elastic;        ///< a collision made elastic by the rule against inelastic collapse
  bool was_inside;     ///< in the well before
  double distance;     ///< of the centres, of a centre and a wall, [length]
  Vector3 separation;  ///< from i to j, [length]
  Vector3 position;    ///< of i, [length]
  Impact impact;

  MomentumFlux momentum_flux() const { return cohesion::momentum_flux(separation, impact.on_j); }
};

/// The flight of a body after an event, as a message to the processes that simulate the body too.
struct RemoteUpdate {
  EventKey key;
  int body;
  int partner;  ///< body or wall
  Flight flight;

  bool operator==(const RemoteUpdate& b) const { return body == b.body && same(flight, b.flight); }
};

}  // namespace cohesion::hard_sphere
