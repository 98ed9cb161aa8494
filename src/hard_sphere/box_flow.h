// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>

#include "hard_sphere/crossing.h"
#include "hard_sphere/periodic_box.h"

namespace cohesion::hard_sphere {

/// The flow of places with a box that changes uniformly in time. The middle of the box is at rest.
class BoxFlow {
 public:
  /// `lifetime` [time]: for how long at a time the flow is looked at.
  void set(const PeriodicBox& box, double lifetime) {
    box_ = box;
    lifetime_ = lifetime;
    flows_ = !box.rates.is_zero();
    update_gradient();
  }

  /// Time 0 is at the time `now` from here on.
  void shift_time_origin(double now) {
    box_.edges = box_.edges_at(now);
    update_gradient();
  }

  const PeriodicBox& box() const { return box_; }
  double lifetime() const { return lifetime_; }
  /// Whether places move.
  explicit operator bool() const { return flows_; }

  /// Where a place [length] is in the box at a time, in edges.
  Vector3 fraction(const Vector3& position, double now) const {
    return PeriodicBox::fraction(box_.edges_at(now),
                                 position - box_.origin + now * centre_velocity());
  }

  /// Where that is at time 0, [length], and its velocity, [length/time].
  Vector3 position(const Vector3& fraction) const { return box_.origin + box_.edges * fraction; }
  Vector3 velocity(const Vector3& fraction) const {
    return flows_ ? box_.rates * fraction - centre_velocity() : Vector3{};
  }

  /// The square of the least distance [length], from now on for a lifetime, of two places that flow
  /// with the box and are r apart at time 0.
  double least_squared_distance(const Vector3& r, double now) const {
    return flows_ ? least_squared_distance(gradient_, r, now, lifetime_) : dot(r, r);
  }

  /// Calls f(square), where square(r) is that: the simplest function that gives it in this flow,
  /// and it reads no memory, for loops over many r.
  template <class F>
  void with_least_squared_distance(double now, const F& f) const {
    const PeriodicBox::Edges gradient = gradient_;
    const double lifetime = lifetime_;
    if (!flows_)
      f([](const Vector3& r) { return dot(r, r); });
    else if (flows_along_x_)
      f([gradient, lifetime, now](const Vector3& r) {
        return least_squared_distance_along_x(gradient, r, now, lifetime);
      });
    else
      f([gradient, lifetime, now](const Vector3& r) {
        return least_squared_distance(gradient, r, now, lifetime);
      });
  }

 private:
  void update_gradient() {
    gradient_ = box_.gradient();
    flows_along_x_ = gradient_.yy == 0.0 && gradient_.zz == 0.0 && gradient_.yz == 0.0;
  }

  /// As seen from the origin, [length/time].
  Vector3 centre_velocity() const { return box_.rates * Vector3{0.5, 0.5, 0.5}; }

  static double least_squared_distance(const PeriodicBox::Edges& gradient, const Vector3& r,
                                       double now, double lifetime) {
    constexpr double not_zero = std::numeric_limits<double>::min();
    const Vector3 u = gradient * r;
    const Vector3 first = r + now * u;
    const double when = -dot(first, u) / (dot(u, u) + not_zero);
    const double after = when > 0.0 ? when : 0.0;
    const Vector3 nearest = first + (after < lifetime ? after : lifetime) * u;
    return dot(nearest, nearest);
  }

  /// The same where places flow along x alone.
  static double least_squared_distance_along_x(const PeriodicBox::Edges& gradient, const Vector3& r,
                                               double now, double lifetime) {
    const double speed = gradient.xx * r.x + gradient.xy * r.y + gradient.xz * r.z;
    const double first = r.x + now * speed, last = first + lifetime * speed;
    const double square = first * first, other = last * last;
    const double least = square < other ? square : other;
    return (first * last > 0.0 ? least : 0.0) + r.y * r.y + r.z * r.z;
  }

  PeriodicBox box_;
  double lifetime_ = never;
  bool flows_ = false;
  bool flows_along_x_ = false;
  PeriodicBox::Edges gradient_;  // of the velocity by the place at time 0, [1/time]
};

}  // namespace cohesion::hard_sphere
