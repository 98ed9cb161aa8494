// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "vector3.h"

namespace cohesion::hard_sphere {

/// A velocity turned so that it leads inwards with a speed of at least `least`, or with that of 45
/// degrees if that is less. Its size is kept, so no energy is gained or lost.
///
/// outwards: unit vector to the wall.
inline Vector3 turn_inwards(const Vector3& v, const Vector3& outwards, double least) {
  const double normal = -dot(outwards, v), vv = dot(v, v);
  const Vector3 along = v + normal * outwards;
  const double tangential = norm(along), wanted = std::min(least, std::sqrt(0.5 * vv));
  if (normal >= wanted || tangential == 0.0) return v;
  return (std::sqrt(vv - wanted * wanted) / tangential) * along - wanted * outwards;
}

/// The velocity with which a particle leaves the inside of a cylinder about the z axis so that it
/// meets it again no sooner than `least` [time] later: turned away from the wall across the axis.
///
/// On a circle of radius R chords take 2 R u_n/u^2. With e < 1 each is e times as long as the one
/// before: infinitely many collisions in a finite time, after which the particle runs along the
/// wall, and elastic collisions from then on would come at once after another. So the rule against
/// inelastic collapse needs this beside e = 1.
///
/// v: velocity after an elastic collision [length/time]; outwards: unit vector to the wall; R:
/// radius on which the centre meets it [length].
inline Vector3 velocity_off_concave_wall(const Vector3& v, const Vector3& outwards, double R,
                                         double least) {
  const Vector3 across{v.x, v.y, 0.0};
  return Vector3{0.0, 0.0, v.z} +
         turn_inwards(across, outwards, 0.5 * least * dot(across, across) / R);
}

/// The relative velocity with which a captured pair leaves the edge of its well, which is a concave
/// wall for it: turned inwards as far as it takes to bring the pair back within the edge that it
/// has come to, to round-off or beyond, and to a speed of at least `least` [length/time] along the
/// line of centres. On a slower chord it would stay beyond, and stray.
///
/// w: after the capture [length/time]; outwards: unit vector from the body to its partner;
/// distance, edge: of the centres, [length].
inline Vector3 velocity_within_edge(const Vector3& w, const Vector3& outwards, double distance,
                                    double edge, double least = 0.0) {
  constexpr double round_off = 1e-15;
  const double part = edge / distance;
  const double beyond = std::max((1.0 - part) * (1.0 + part), round_off);
  return turn_inwards(w, outwards, std::max(least, norm(w) * std::sqrt(2.0 * beyond)));
}

}  // namespace cohesion::hard_sphere
