// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "event_stepping/loaded_flight.h"
#include "event_stepping/pair_step.h"

namespace cohesion::event_stepping {

/// Two spheres that touch at centre distance `contact_distance`.
///
/// The relative motion at n-1/2 is followed exactly to n+1/2: straight flight, tail edge, gap,
/// contact; then both ends are carried back to the grid point by straight flight. The map is
/// symmetric in time, keeps the angular momentum of the pair exactly and its energy up to what the
/// dashpot takes. Turning of the pair: angular momentum L constant, centrifugal acceleration
/// L^2/R^3 taken at R = contact distance while inside (relative error: overlap/R).
///
/// Source: derived here, see docs/theory/exact_contacts.md.
class SpherePair {
 public:
  using Attraction = contact::Adhesion;

  /// `step` [time]: the usual length of a step.
  SpherePair(const contact::LinearSpringDashpot& spring, const contact::Adhesion& adhesion,
             double contact_distance, double step)
      : motion_(spring, adhesion, step),
        contact_distance_(contact_distance),
        inverse_distance_(1.0 / contact_distance) {}

  double range() const { return motion_.range(); }
  double spring_energy(double overlap) const { return motion_.spring_energy(overlap); }
  double adhesion_energy(double overlap) const { return motion_.adhesion_energy(overlap); }

  /// Whether anything can happen to the pair within the window.
  bool within_reach(const RelativeState& grid, const StepWindow& window) const {
    const double slack = std::max(window.before, window.after) * norm(grid.velocity);
    const double reach = contact_distance_ + motion_.range() + slack;
    return dot(grid.separation, grid.separation) <= reach * reach;
  }

  /// `load` [length/time^2]: constant acceleration of the separation, along it, by all else.
  [[gnu::always_inline]] PairStep advance(const RelativeState& grid, const StepWindow& window,
                                          bool inside, const Vector3& load = {}) const {
    PairStep step;
    RelativeState now{grid.separation - window.before * grid.velocity, grid.velocity};
    if (inside && advance_lasting(now, window.length(), step.overlap_at_end, step.normal, load)) {
      step.inside = true;
    } else {
      Followed followed = follow_events(now, window.length(), inside, load);
      now = followed.state;
      step.normal = followed.normal;
      step.overlap_at_end = followed.overlap;
      step.inside = followed.inside;
    }
    step.set_change(grid, window, load, now);
    return step;
  }

  /// Advances a pair inside the range for at most `time`: along the normal in closed form, around
  /// it with constant angular momentum. Returns the time until the pair left the range (`inside` is
  /// then false), or `time`; `overlap` is where the surfaces are then.
  double advance_inside(RelativeState& now, double time, bool& inside, double& overlap,
                        NormalRecord& record, const Vector3& load = {}) const {
    Start start = along_normal(now, load);
    Overlap surface = start.surface;
    double integral = 0.0;
    double taken = time;
    if (!motion_.advance_lasting(surface, time, start.outward, integral, record))
      taken = motion_.advance(surface, time, start.outward, inside, integral, record);
    overlap = surface.x;
    rotate(now, start, surface, taken, integral);
    return taken;
  }

  /// Advances a contact that certainly lasts for all of `time`, as most contacts in most steps, as
  /// advance_inside() does. Returns false, and does nothing, where that is not certain.
  bool advance_lasting(RelativeState& now, double time, double& overlap, NormalRecord& record,
                       const Vector3& load = {}) const {
    Start start = along_normal(now, load);
    Overlap surface = start.surface;
    double integral = 0.0;
    if (!motion_.advance_lasting(surface, time, start.outward, integral, record)) return false;
    overlap = surface.x;
    rotate(now, start, surface, time, integral);
    return true;
  }

 private:
  /// A pair flies in, turns and flies out again; more often only by rounding at a grazed edge.
  static constexpr int max_segments = 100;

  /// A state as the motion along the normal sees it.
  struct Start {
    double distance;
    double inverse_distance;
    double sideways_squared;  ///< of the speed across the normal
    double outward;           ///< centrifugal acceleration and load, [length/time^2]
    Overlap surface;
  };

  Start along_normal(const RelativeState& now, const Vector3& load) const {
    const double distance = norm(now.separation);
    const double inverse = 1.0 / distance;
    const double radial = inverse * dot(now.separation, now.velocity);
    const double sideways_squared =
        std::max(dot(now.velocity, now.velocity) - radial * radial, 0.0);
    const double leverage = distance * inverse_distance_;
    return {distance,
            inverse,
            sideways_squared,
            leverage * leverage * sideways_squared * inverse_distance_ +
                inverse * dot(now.separation, load),
            {contact_distance_ - distance, -radial}};
  }

  /// Turns the pair by the angle L times the integral of 1/(R - x)^2, through the tangent of half
  /// of it (`half` per sideways speed), and puts its surfaces to `end`. New separation and velocity
  /// are linear in the old ones s and w; so are the normal, s/r, and the velocity across it.
  void rotate(RelativeState& now, const Start& start, const Overlap& end, double time,
              double integral) const {
    const double angle_per_speed = start.distance * inverse_distance_ * inverse_distance_ *
                                   (time + 2.0 * integral * inverse_distance_);
    const double angle_squared = angle_per_speed * angle_per_speed * start.sideways_squared;
    const double half = 0.5 * angle_per_speed * (1.0 + angle_squared * (1.0 / 12.0));
    const double half_squared = half * half * start.sideways_squared;
    const double scale = 1.0 / (1.0 + half_squared);
    const double cosine = (1.0 - half_squared) * scale;
    const double sine = 2.0 * half * scale;  // per sideways speed
    const double distance = contact_distance_ - end.x;
    const double speed_up = start.distance / distance;
    const double radial = -start.surface.v;
    // Of the velocity: along the old velocity across the normal, and along the old normal.
    const double across = speed_up * cosine - end.v * sine;
    const double along = -speed_up * sine * start.sideways_squared - end.v * cosine;
    const Vector3 s = now.separation;
    now.separation = (distance * (cosine - sine * radial) * start.inverse_distance) * s +
                     (distance * sine) * now.velocity;
    now.velocity = across * now.velocity + ((along - across * radial) * start.inverse_distance) * s;
  }

  struct Followed {
    RelativeState state;
    NormalRecord normal;
    double overlap;
    bool inside;
  };

  /// Follows everything that can happen to a pair in `time`, one segment after the other.
  [[gnu::noinline]] Followed follow_events(const RelativeState& start, double time, bool inside,
                                           const Vector3& load) const {
    Followed now{start, {}, 0.0, inside};
    if (!inside) now.inside = starts_inside(now.state);
    double left = time;
    for (int segments = 0; left > 0.0; segments++) {
      if (segments == max_segments) {
        now.normal.unresolved = true;
        break;
      }
      if (!now.inside) {
        left -= fly(now.state, left, load, now.inside);
        continue;
      }
      left -= advance_inside(now.state, left, now.inside, now.overlap, now.normal, load);
      if (now.normal.unresolved) break;
    }
    if (!now.inside) now.overlap = contact_distance_ - norm(now.state.separation);
    return now;
  }

  double outer_distance() const { return contact_distance_ + motion_.range(); }

  /// Lets a pair that counts as outside, but was pushed inside between two steps, enter where it
  /// is, if it approaches or already overlaps.
  bool starts_inside(RelativeState& now) const {
    const double distance = norm(now.separation);
    if (distance >= outer_distance()) return false;
    if (dot(now.separation, now.velocity) >= 0.0 && distance >= contact_distance_) return false;
    cross_inwards(now, distance);
    return true;
  }

  void cross_inwards(RelativeState& now, double distance) const {
    const Vector3 normal = (1.0 / distance) * now.separation;
    const double approach = -dot(normal, now.velocity);
    Overlap entered = motion_.enter({contact_distance_ - distance, approach});
    now.velocity -= (entered.v - approach) * normal;
  }

  /// Flies until the edge is met or the time is over; returns the time it took.
  double fly(RelativeState& now, double time, const Vector3& load, bool& inside) const {
    const double outer = outer_distance();
    double t = time;
    if (dot(now.separation, now.separation) >= outer * outer) {
      const double meet = time_to_fall_to(outer, now, load, time);
      if (meet < time) {
        t = meet;
        inside = true;
      }
    }
    now = flown(now, load, t);
    if (inside) cross_inwards(now, norm(now.separation));
    return t;
  }

  NormalMotion motion_;
  double contact_distance_;
  double inverse_distance_;
};

}  // namespace cohesion::event_stepping
