// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "event_stepping/first_root.h"
#include "event_stepping/pair_step.h"

namespace cohesion::event_stepping {

/// A sphere and a plane: the limit of SpherePair for an infinite second radius. The separation
/// points from the sphere's centre to the foot of the normal; only its length changes, so nothing
/// turns.
///
/// Source: normal_motion.h.
class PlanePair {
 public:
  using Attraction = contact::Adhesion;

  /// `step` [time]: the usual length of a step.
  PlanePair(const contact::LinearSpringDashpot& spring, const contact::Adhesion& adhesion,
            double radius, double step)
      : motion_(spring, adhesion, step), radius_(radius) {}

  double range() const { return motion_.range(); }
  double spring_energy(double overlap) const { return motion_.spring_energy(overlap); }
  double adhesion_energy(double overlap) const { return motion_.adhesion_energy(overlap); }

  bool within_reach(const RelativeState& grid, const StepWindow& window) const {
    const double slack = std::max(window.before, window.after) * norm(grid.velocity);
    return norm(grid.separation) <= radius_ + motion_.range() + slack;
  }

  /// `load`: as in SpherePair.
  PairStep advance(const RelativeState& grid, const StepWindow& window, bool inside,
                   const Vector3& load = {}) const {
    PairStep step;
    const double distance = norm(grid.separation);
    const Vector3 normal = (1.0 / distance) * grid.separation;
    const double rate = -dot(normal, grid.velocity), outward = dot(normal, load);
    Overlap s{radius_ - distance - window.before * rate, rate};
    if (!inside && s.x > -motion_.range() && (s.v > 0.0 || s.x > 0.0)) {
      s = motion_.enter(s);
      inside = true;
    }
    double left = window.length();
    while (left > 0.0) {
      if (!inside) {
        const double gap = std::max(-motion_.range() - s.x, 0.0);
        const double meet = gap == 0.0 && s.v > 0.0 ? 0.0 : first_root(gap, -s.v, outward);
        const double t = std::min(meet, left);
        s = {s.x + t * (s.v - 0.5 * t * outward), s.v - t * outward};
        const bool meets = meet < left;
        left -= t;
        if (!meets) break;
        s = motion_.enter({gap > 0.0 ? -motion_.range() : s.x, s.v});
        inside = true;
        continue;
      }
      double integral = 0.0;
      left -= motion_.advance(s, left, outward, inside, integral, step.normal);
      if (step.normal.unresolved) break;
    }
    step.inside = inside;
    step.overlap_at_end = s.x;
    step.set_change({grid.separation, -rate * normal}, window, outward * normal,
                    {(radius_ - s.x) * normal, -s.v * normal});
    return step;
  }

 private:
  NormalMotion motion_;
  double radius_;
};

}  // namespace cohesion::event_stepping
