// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "vector3.h"

namespace cohesion::hard_sphere {

/// The velocity with which a particle leaves the inside of a cylinder about the z axis so that it
/// meets it again no sooner than `least` [time] later: the speed across the axis is kept, so no
/// energy is gained or lost, and turned away from the wall as far as that takes, but by 45 degrees
/// at most.
///
/// On a circle of radius R chords take 2 R u_n/u^2. With e < 1 each is e times as long as the one
/// before: infinitely many collisions in a finite time, after which the particle runs along the
/// wall, and elastic collisions from then on would come at once after another. So the rule against
/// inelastic collapse needs this beside e = 1.
///
/// v: velocity after an elastic collision [length/time]; outwards: unit vector to the wall; R:
/// radius on which the centre meets it [length].
inline Vector3 leaving_concave_wall(const Vector3& v, const Vector3& outwards, double R,
                                    double least) {
  const Vector3 across{v.x, v.y, 0.0};
  const double normal = -dot(outwards, across);
  const Vector3 along = across + normal * outwards;
  const double uu = dot(across, across), tangential = norm(along);
  const double wanted = std::min(0.5 * least * uu / R, std::sqrt(0.5 * uu));
  if (normal >= wanted || tangential == 0.0) return v;
  const Vector3 turned = (std::sqrt(uu - wanted * wanted) / tangential) * along;
  return Vector3{0.0, 0.0, v.z} + turned - wanted * outwards;
}

}  // namespace cohesion::hard_sphere
