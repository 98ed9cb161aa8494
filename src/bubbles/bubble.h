// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>

#include "constants.h"
#include "sphere.h"
#include "vector3.h"

/// Discrete bubbles: what they do to each other beside pushing. Every rule here sees all bubbles at
/// once and goes by their numbers, so that it does the same however they are spread over ranks.
namespace cohesion::bubbles {

/// number: of no other bubble, ever; position [length], velocity [length/time], radius [length],
/// mass [mass]; rests_until: the time [time] up to which it does not merge.
struct Bubble {
  long number;
  Vector3 position, velocity;
  double radius, mass;
  double rests_until = 0.0;

  double volume() const { return sphere_volume(radius); }
};

/// The radius of a sphere of so much volume.
inline double radius_of(double volume) { return std::cbrt(volume / (4.0 / 3.0 * pi)); }

/// The box: `low` and `high` [length], and along which axes it is periodic.
struct BubbleBox {
  std::array<double, 3> low, high;
  std::array<bool, 3> periodic;

  /// b - a, to the nearest image of b.
  Vector3 between(const Vector3& a, const Vector3& b) const {
    return {nearest(0, b.x - a.x), nearest(1, b.y - a.y), nearest(2, b.z - a.z)};
  }

  /// Whether a sphere is inside along the axes that are not periodic.
  bool holds(const Vector3& at, double radius) const {
    return holds(0, at.x, radius) && holds(1, at.y, radius) && holds(2, at.z, radius);
  }

 private:
  double nearest(int axis, double distance) const {
    if (!periodic[axis]) return distance;
    const double length = high[axis] - low[axis];
    return distance - length * std::round(distance / length);
  }
  bool holds(int axis, double at, double radius) const {
    return periodic[axis] || (at - radius >= low[axis] && at + radius <= high[axis]);
  }
};

}  // namespace cohesion::bubbles
