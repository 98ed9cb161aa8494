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
  double since = 0.0;  ///< time of its last event in this step, [time]
  Vector3 spin;
  int depth = -1;       ///< EventKey::depth of that; -1: none in this step
  int collisions = 0;   ///< in this step
  int events = 0;       ///< in this step
  double hit = -never;  ///< time of its last collision in this step, [time]

  Vector3 at(double left) const { return end - left * velocity; }
  /// Of the chain of events at this time that ends here.
  int depth_at(double time) const { return time == since ? depth : -1; }
};

inline bool same(const Vector3& a, const Vector3& b) {
  return a.x == b.x && a.y == b.y && a.z == b.z;
}
inline bool same(const Flight& a, const Flight& b) {
  return same(a.end, b.end) && same(a.velocity, b.velocity) && same(a.spin, b.spin) &&
         a.since == b.since && a.depth == b.depth && a.collisions == b.collisions &&
         a.events == b.events && a.hit == b.hit;
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

/// Periodic image of a particle: what is added to its position at the end of the step and to its
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
  int law;
  Surfaces at;
  bool inside = false;  ///< in the well
  Surface next = Surface::core;
  unsigned version = 0;  ///< of its prediction

  bool with_wall() const { return j < 0; }
  int wall() const { return -1 - j; }
};

/// Place of an event in the order: by time; of events at the same instant causes before what they
/// cause; then by the lower, then the higher tag. A wall counts as tag -1, -2, ...
struct EventKey {
  double time;
  int depth;  ///< of the chain of events of that instant that led to it
  std::int64_t tag_i;
  std::int64_t tag_j;

  bool operator<(const EventKey& b) const {
    if (time != b.time) return time < b.time;
    if (depth != b.depth) return depth < b.depth;
    return tag_i != b.tag_i ? tag_i < b.tag_i : tag_j < b.tag_j;
  }
};

/// An event that was carried out.
struct Event {
  EventKey key;
  int candidate;
  bool elastic;        ///< a collision made elastic by the rule against inelastic collapse
  bool was_inside;     ///< in the well before
  double distance;     ///< of the centres, of a centre and a wall, [length]
  Vector3 separation;  ///< from i to j, [length]
  Vector3 place;       ///< of i, [length]
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
