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
  SpherePair(const NormalMotion& motion, double contact_distance)
      : motion_(motion), contact_distance_(contact_distance) {}

  /// Of a tangential force on sphere i.
  static double lever_arm(double distance, double radius_i, double radius_j) {
    return distance * radius_i / (radius_i + radius_j);
  }

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
    if (!inside) inside = starts_inside(now);
    while (left > 0.0) {
      if (!inside) {
        left -= fly(now, left, inside);
        continue;
      }
      left -= turn(now, left, inside, step.normal);
      if (step.normal.unresolved) break;
    }
    step.inside = inside;
    step.overlap_at_end = contact_distance_ - norm(now.separation);
    step.change.velocity = now.velocity - grid.velocity;
    step.change.separation = now.separation - window.after * now.velocity - grid.separation;
    return step;
  }

 private:
  double outer_distance() const { return contact_distance_ + motion_.range(); }

  /// A pair that counts as outside but is inside by now pays at the edge if it approaches, or if it
  /// already overlaps.
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
    const Overlap entered = motion_.enter({0.0, approach});
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

  /// Motion inside the range: along the normal in closed form, around it with constant angular
  /// momentum.
  double turn(RelativeState& now, double time, bool& inside, NormalRecord& record) const {
    const double distance = norm(now.separation);
    const Vector3 normal = (1.0 / distance) * now.separation;
    const double radial = dot(normal, now.velocity);
    const Vector3 sideways = now.velocity - radial * normal;
    const double momentum = distance * norm(sideways);  // per reduced mass
    const double r = contact_distance_;

    Overlap surface{r - distance, -radial};
    double integral = 0.0;
    const double taken =
        motion_.advance(surface, time, momentum * momentum / (r * r * r), inside, integral, record);
    const double distance_after = r - surface.x;

    // Rotation by the angle L times the integral of 1/(R - x)^2, through its half-angle tangent.
    const double angle = momentum / (r * r) * (taken + 2.0 * integral / r);
    const double half = 0.5 * angle * (1.0 + angle * angle / 12.0);
    const double scale = 1.0 / (1.0 + half * half);
    const double cosine = (1.0 - half * half) * scale;
    const double sine = 2.0 * half * scale;
    Vector3 tangent;
    if (momentum > 0.0) tangent = (distance / momentum) * sideways;
    const Vector3 normal_after = cosine * normal + sine * tangent;
    const Vector3 tangent_after = cosine * tangent - sine * normal;
    now.separation = distance_after * normal_after;
    now.velocity = -surface.v * normal_after + (momentum / distance_after) * tangent_after;
    return taken;
  }

  const NormalMotion& motion_;
  double contact_distance_;
};

}  // namespace cohesion::event_stepping
