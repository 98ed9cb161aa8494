// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "vector3.h"

namespace cohesion::hard_sphere {

/// Rotates a velocity so that its inward component is at least `least`, but at most that of 45
/// degrees. The speed and the kinetic energy are conserved.
///
/// outwards: unit vector to the wall.
inline Vector3 turn_inwards(const Vector3& v, const Vector3& outwards, double least) {
  const double normal = -dot(outwards, v), vv = dot(v, v);
  const Vector3 along = v + normal * outwards;
  const double tangential = norm(along), inward = std::min(least, std::sqrt(0.5 * vv));
  if (normal >= inward || tangential == 0.0) return v;
  return (std::sqrt(vv - inward * inward) / tangential) * along - inward * outwards;
}

/// Velocity of a particle after an elastic collision inside a cylinder about the z axis. It is
/// rotated away from the wall, in the plane across the axis, so that the next collision is no
/// sooner than `least` [time] later.
///
/// On a circle of radius R the flight between two collisions lasts 2 R u_n/u^2. With e < 1 each
/// flight is e times as long as the previous one: infinitely many collisions in a finite time,
/// after which the particle slides along the wall. Elastic collisions from then on would be
/// arbitrarily frequent, so e = 1 alone does not prevent inelastic collapse here.
///
/// v: velocity after an elastic collision [length/time]; outwards: unit vector to the wall; R:
/// radius at which the centre touches the wall [length].
inline Vector3 velocity_off_concave_wall(const Vector3& v, const Vector3& outwards, double R,
                                         double least) {
  const Vector3 across{v.x, v.y, 0.0};
  return Vector3{0.0, 0.0, v.z} +
         turn_inwards(across, outwards, 0.5 * least * dot(across, across) / R);
}

/// Relative velocity of a pair after a capture at the edge of its well, which acts on the pair as a
/// concave wall. It is rotated inwards until the chord leads back within the edge, to round-off or
/// farther, with a speed of at least `least` [length/time] along the line of centres. A slower
/// chord would stay beyond the edge, and the pair would drift out of its well without an event.
///
/// w: after the capture [length/time]; outwards: unit vector from the body to its partner;
/// distance, edge: between the centres, [length].
inline Vector3 velocity_within_edge(const Vector3& w, const Vector3& outwards, double distance,
                                    double edge, double least = 0.0) {
  constexpr double round_off = 1e-15;
  const double part = edge / distance;
  const double beyond = std::max((1.0 - part) * (1.0 + part), round_off);
  return turn_inwards(w, outwards, std::max(least, norm(w) * std::sqrt(2.0 * beyond)));
}

}  // namespace cohesion::hard_sphere
