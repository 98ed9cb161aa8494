// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "event_stepping/pair_step.h"

namespace cohesion::event_stepping {

/// Two spheres that touch at centre distance `contact_distance`.
///
/// The relative motion at n-1/2 is followed exactly to n+1/2: straight flight, tail edge, gap,
/// contact; then both ends are carried back to the grid point by straight flight. The map is
/// symmetric in time, keeps the angular momentum of the pair exactly and its energy up to what the
/// dashpot takes. Turning of the pair: angular momentum L constant, centrifugal acceleration
/// L^2/R^3 taken at R = contact distance while inside (relative error: overlap/R).
class SpherePair {
 public:
  using Attraction = contact::Adhesion;
  /// What a contact does in a step changes the step of its particles' other contacts.
  static constexpr bool acts_within_step = true;

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

  PairStep advance(const RelativeState& grid, const StepWindow& window, bool inside) const {
    PairStep step;
    RelativeState now{grid.separation - window.before * grid.velocity, grid.velocity};
    double left = window.length();
    double overlap = 0.0;
    if (!inside) inside = starts_inside(now);
    for (int stretches = 0; left > 0.0; stretches++) {
      if (stretches == max_stretches) {
        step.normal.unresolved = true;
        break;
      }
      if (!inside) {
        left -= fly(now, left, inside);
        continue;
      }
      left -= turn(now, left, inside, overlap, step.normal);
      if (step.normal.unresolved) break;
    }
    step.inside = inside;
    step.overlap_at_end = inside ? overlap : contact_distance_ - norm(now.separation);
    step.change.velocity = now.velocity - grid.velocity;
    step.change.separation = now.separation - window.after * now.velocity - grid.separation;
    return step;
  }

  /// Motion inside the range for at most `time`: along the normal in closed form, around it with
  /// constant angular momentum. Returns the time until the pair left the range (`inside` is then
  /// false), or `time`; `overlap` is where the surfaces are then.
  double turn(RelativeState& now, double time, bool& inside, double& overlap,
              NormalRecord& record) const {
    const double distance = norm(now.separation);
    const Vector3 normal = (1.0 / distance) * now.separation;
    const double radial = dot(normal, now.velocity);
    const Vector3 sideways = now.velocity - radial * normal;
    const double sideways_squared = dot(sideways, sideways);
    const double leverage = distance * inverse_distance_;
    const double centrifugal = leverage * leverage * sideways_squared * inverse_distance_;

    Overlap surface{contact_distance_ - distance, -radial};
    double integral = 0.0;
    double taken = time;
    if (!motion_.advance_lasting(surface, time, centrifugal, integral, record))
      taken = motion_.advance(surface, time, centrifugal, inside, integral, record);
    overlap = surface.x;
    const double distance_after = contact_distance_ - surface.x;

    // Rotation by the angle L times the integral of 1/(R - x)^2, through its half-angle tangent;
    // `half` is that tangent along `sideways`.
    const double angle_per_speed =
        leverage * inverse_distance_ * (taken + 2.0 * integral * inverse_distance_);
    const double angle_squared = angle_per_speed * angle_per_speed * sideways_squared;
    const double half = 0.5 * angle_per_speed * (1.0 + angle_squared * (1.0 / 12.0));
    const double half_squared = half * half * sideways_squared;
    const double scale = 1.0 / (1.0 + half_squared);
    const double cosine = (1.0 - half_squared) * scale;
    const double sine = 2.0 * half * scale;  // per sideways speed
    const Vector3 normal_after = cosine * normal + sine * sideways;
    const Vector3 sideways_after = cosine * sideways - (sine * sideways_squared) * normal;
    now.separation = distance_after * normal_after;
    now.velocity = (distance / distance_after) * sideways_after - surface.v * normal_after;
    return taken;
  }

 private:
  /// A pair flies in, turns and flies out again; more often only by rounding at a grazed edge.
  static constexpr int max_stretches = 100;

  double outer_distance() const { return contact_distance_ + motion_.range(); }

  /// A pair that counts as outside but was pushed inside between two steps enters where it is, if
  /// it approaches or already overlaps.
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
    const Overlap entered = motion_.enter({contact_distance_ - distance, approach});
    now.velocity -= (entered.v - approach) * normal;
  }

  /// Straight flight until the edge is met or the time is over.
  double fly(RelativeState& now, double time, bool& inside) const {
    const double approach = -dot(now.separation, now.velocity);
    const double speed_squared = dot(now.velocity, now.velocity);
    const double outer = outer_distance();
    const double away = dot(now.separation, now.separation) - outer * outer;
    const double discriminant = approach * approach - speed_squared * away;
    double t = time;
    if (approach > 0.0 && away >= 0.0 && discriminant > 0.0) {
      const double meet = away / (approach + std::sqrt(discriminant));
      if (meet < time) {
        t = meet;
        inside = true;
      }
    }
    now.separation += t * now.velocity;
    if (inside) cross_inwards(now, norm(now.separation));
    return t;
  }

  NormalMotion motion_;
  double contact_distance_;
  double inverse_distance_;
};

}  // namespace cohesion::event_stepping
