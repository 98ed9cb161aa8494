// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>

#include "hard_sphere/crossing.h"
#include "hard_sphere/periodic_box.h"

namespace cohesion::hard_sphere {

/// The affine flow of a box whose edges change uniformly in time. The centre of the box is at rest.
class BoxFlow {
 public:
  /// `lifetime` [time]: interval over which distances are bounded.
  void set(const PeriodicBox& box, double lifetime) {
    box_ = box;
    lifetime_ = lifetime;
    flows_ = !box.rates.is_zero();
    update_gradient();
  }

  /// Shifts the time origin to `now`.
  void shift_time_origin(double now) {
    box_.edges = box_.edges_at(now);
    update_gradient();
  }

  const PeriodicBox& box() const { return box_; }
  double lifetime() const { return lifetime_; }
  /// Whether the box deforms.
  explicit operator bool() const { return flows_; }

  /// Fractional coordinates of a position [length] at a time.
  Vector3 fraction(const Vector3& position, double now) const {
    return PeriodicBox::fraction(box_.edges_at(now),
                                 position - box_.origin + now * centre_velocity());
  }

  /// Position [length] at time 0 and velocity [length/time] of a point with given fractional
  /// coordinates.
  Vector3 position(const Vector3& fraction) const { return box_.origin + box_.edges * fraction; }
  Vector3 velocity(const Vector3& fraction) const {
    return flows_ ? box_.rates * fraction - centre_velocity() : Vector3{};
  }

  /// Square of the least distance [length^2] during the next lifetime of two points that move with
  /// the flow and have the separation r [length] at time 0.
  double least_squared_distance(const Vector3& r, double now) const {
    return flows_ ? least_squared_distance(gradient_, r, now, lifetime_) : dot(r, r);
  }

  /// Calls f(square), where square(r) is least_squared_distance(r, now). The function passed is the
  /// cheapest one for this flow and reads no memory, for loops over many r.
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

  /// Relative to the origin of the box, [length/time].
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

  /// The same for a flow along x.
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
  PeriodicBox::Edges gradient_;  // velocity gradient in the position at time 0, [1/time]
};

}  // namespace cohesion::hard_sphere
