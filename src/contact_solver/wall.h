// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "constants.h"
#include "contact_solver/step_window.h"
#include "validation.h"
#include "vector3.h"

namespace cohesion::contact_solver {

/// Where a wall is in the step that `window` describes, and how fast it moves.
struct WallState {
  Vector3 displacement;    ///< at the grid point, from where the wall was at time 0, [length]
  Vector3 velocity;        ///< [length/time]
  Vector3 acceleration{};  ///< up to the next such step, [length/time^2]
};

/// The motion of a wall:
///
///   X(t) = velocity t + amplitude (1 - cos(2 pi t/period))
///
/// and, for a cylinder, a turning about its axis, positive clockwise as seen from above.
struct WallMotion {
  Vector3 velocity;        ///< [length/time]
  Vector3 amplitude;       ///< [length]
  double period = 1.0;     ///< [time]
  double rim_speed = 0.0;  ///< of the turning, [length/time]

  bool still() const { return dot(velocity, velocity) + dot(amplitude, amplitude) == 0.0; }
  bool swings() const { return dot(amplitude, amplitude) > 0.0; }

  /// Whether X(t) is the same.
  bool displaces_like(const WallMotion& b) const {
    const Vector3 faster = velocity - b.velocity, farther = amplitude - b.amplitude;
    return dot(faster, faster) + dot(farther, farther) == 0.0 && (!swings() || period == b.period);
  }
  /// X(t)
  Vector3 displacement(double time) const {
    const double turn = std::sin(pi * time / period);
    return time * velocity + 2.0 * turn * turn * amplitude;
  }

  /// The chord of X(t) over the window: the step's end is where the next one begins, so that the
  /// wall never jumps; exact for constant velocity.
  WallState over(double time, const StepWindow& window) const {
    const double frequency = 2.0 * pi / period;
    const double length = window.length(), half = 0.5 * length;
    const double middle = time + window.after - half;
    const Vector3 chord = (std::sin(frequency * half) / half) * amplitude;
    const Vector3 swing = std::sin(frequency * middle) * chord;
    const Vector3 next = std::sin(frequency * (middle + length)) * chord;
    const double end = std::sin(0.5 * frequency * (time + window.after));
    return {time * velocity + 2.0 * end * end * amplitude - window.after * swing, velocity + swing,
            (1.0 / length) * (next - swing)};
  }
};

/// How far the walls of a script have come on their motion, step by step: they go on from where
/// they are when the time step, the numbers of the steps or the motion become others.
class WallCourse {
 public:
  WallCourse() = default;
  explicit WallCourse(const WallMotion& motion) : motion_(motion) {}

  const WallMotion& motion() const { return motion_; }
  /// A step of length dt [time] begins.
  void begin_step(double dt) {
    if (dt != dt_) {
      before_ = time();
      steps_ = 0.0;
      dt_ = dt;
    }
    steps_ += 1.0;
  }
  /// Since the motion began, [time].
  double time() const { return before_ + steps_ * dt_; }
  WallState over(const StepWindow& window) const {
    WallState now = motion_.over(time(), window);
    now.displacement += start_;
    return now;
  }

  /// What a restart file holds of it.
  static constexpr int NUMBERS = 13;
  using Numbers = std::array<double, NUMBERS>;
  Numbers numbers() const {
    return {before_,
            steps_,
            dt_,
            start_.x,
            start_.y,
            start_.z,
            motion_.velocity.x,
            motion_.velocity.y,
            motion_.velocity.z,
            motion_.amplitude.x,
            motion_.amplitude.y,
            motion_.amplitude.z,
            motion_.period};
  }
  /// Goes on where the course of these numbers is: with its motion if that is the same, or else
  /// with its own, which begins there and then.
  void continue_from(const Numbers& n) {
    const WallMotion then{{n[6], n[7], n[8]}, {n[9], n[10], n[11]}, n[12], 0.0};
    start_ = {n[3], n[4], n[5]};
    before_ = n[0];
    steps_ = n[1];
    dt_ = n[2];
    if (motion_.displaces_like(then)) return;
    start_ += then.displacement(time());
    before_ = steps_ = 0.0;
  }

 private:
  WallMotion motion_;
  Vector3 start_;  // where it was when the motion began, from where the script has it, [length]
  double before_ = 0.0, steps_ = 0.0, dt_ = 0.0;  // time until the step became dt, steps since then
};

inline void require_valid(const WallMotion& m) {
  for (const double v : {m.velocity.x, m.velocity.y, m.velocity.z, m.rim_speed})
    require(std::isfinite(v), "speed of the wall", v, "must be a finite number");
  for (const double a : {m.amplitude.x, m.amplitude.y, m.amplitude.z})
    require(std::isfinite(a), "amplitude of the wall", a, "must be a finite number");
  require_positive("period of the wall", m.period);
}

/// A wall as the centre of one particle sees it: the tangent plane at the nearest point.
struct WallPoint {
  double distance;     ///< [length]; not positive: the centre is behind the wall
  Vector3 separation;  ///< from the centre to the nearest point, [length]
  Vector3 velocity;    ///< of the wall there, [length/time]
};

/// The motion of a wall relative to a particle beside it.
struct RelativeWallMotion {
  Vector3 separation;    ///< of the nearest point, [length]
  Vector3 velocity;      ///< of it, [length/time]
  Vector3 acceleration;  ///< [length/time^2]

  /// Adds turning_of() a curved face. The relative velocity then has the mean rate of the distance
  /// in the last step, of length `last_step` [time].
  void add(const Vector3& turning, double last_step) {
    velocity += (0.5 * last_step) * turning;
    acceleration -= turning;
  }
};

/// A particle that passes a curved face with the relative velocity v sees its normal n turn: the
/// distance d changes by d'' = v . dn/dt along n, [length/time^2]. `turned`: change of n in `time`.
inline Vector3 turning_of(const Vector3& normal, const Vector3& turned, const Vector3& velocity,
                          double time) {
  return (dot(velocity, turned) / time) * normal;
}

/// Whether a particle does not feel a wall: its centre is behind it, or it `was` behind it and has
/// not been clear of it in front since, at the distance `clear` [length].
inline bool is_behind(bool was, double distance, double clear) {
  return distance <= 0.0 || (was && distance < clear);
}

/// A plane normal to a coordinate axis, or the inside of a cylinder about the z axis.
struct Wall {
  enum Shape { x_plane, y_plane, z_plane, z_cylinder };

  Shape shape = x_plane;
  double side = 1.0;      ///< of a plane: 1 with the particles above, -1 with them below
  double position = 0.0;  ///< of a plane; radius of a cylinder, [length]

  bool is_flat() const { return shape != z_cylinder; }
  /// Of a plane, towards the particles.
  Vector3 normal() const {
    return {side * (shape == x_plane), side * (shape == y_plane), side * (shape == z_plane)};
  }

  WallPoint nearest(const Vector3& centre, const WallState& now, double rim_speed) const {
    if (shape == z_cylinder) {
      const double r = std::hypot(centre.x, centre.y);
      const double distance = position - r;
      if (r == 0.0) return {distance, {distance, 0.0, 0.0}, now.velocity};
      const Vector3 outwards{centre.x / r, centre.y / r, 0.0};
      return {distance, distance * outwards,
              now.velocity + rim_speed * Vector3{outwards.y, -outwards.x, 0.0}};
    }
    const Vector3 away = normal();
    const double distance = dot(away, centre - now.displacement) - side * position;
    return {distance, -distance * away, now.velocity};
  }

  /// The motion of the wall at `point` relative to a particle. turning_of() a cylinder is s^2/r, at
  /// a distance r from its axis and with the speed s across the normal. `last_step`: its length,
  /// [time].
  RelativeWallMotion relative_motion(const Vector3& centre, const Vector3& velocity,
                                     const WallPoint& point, const WallState& now,
                                     double last_step) const {
    RelativeWallMotion motion{point.separation, point.velocity - velocity, now.acceleration};
    const double r = is_flat() ? 0.0 : std::hypot(centre.x, centre.y);
    if (r == 0.0) return motion;
    const Vector3 v = velocity - now.velocity, outwards{centre.x / r, centre.y / r, 0.0};
    const double across = outwards.x * v.y - outwards.y * v.x;
    motion.add((across * across / r) * outwards, last_step);
    return motion;
  }
};

/// The places that are farther than `reach` [length] from each of some walls, and on their inner
/// side: a box, and a cylinder about the z axis.
class FarFromWalls {
 public:
  /// displacement [length]: of the walls, as in WallState.
  template <class Walls>
  FarFromWalls(const Walls& walls, const Vector3& displacement, double reach) {
    const double moved[] = {displacement.x, displacement.y, displacement.z};
    for (const Wall& wall : walls) {
      if (wall.shape == Wall::z_cylinder) {
        const double radius = wall.position - reach;
        square_ = std::min(square_, radius > 0.0 ? radius * radius : 0.0);
        continue;
      }
      const double place = moved[wall.shape] + wall.position + wall.side * reach;
      if (wall.side > 0.0)
        low_[wall.shape] = std::max(low_[wall.shape], place);
      else
        high_[wall.shape] = std::min(high_[wall.shape], place);
    }
  }

  bool contains(const double* centre) const {
    return centre[0] > low_[0] && centre[0] < high_[0] && centre[1] > low_[1] &&
           centre[1] < high_[1] && centre[2] > low_[2] && centre[2] < high_[2] &&
           centre[0] * centre[0] + centre[1] * centre[1] < square_;
  }

 private:
  static constexpr double nowhere = std::numeric_limits<double>::infinity();

  double low_[3] = {-nowhere, -nowhere, -nowhere};
  double high_[3] = {nowhere, nowhere, nowhere};
  double square_ = nowhere;  // of the radius
};

}  // namespace cohesion::contact_solver
